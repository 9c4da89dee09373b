// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/read_ahead.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace app {
namespace {

constexpr std::chrono::milliseconds kLook{20};  // between looks at Cancel

}  // namespace

ReadAhead::ReadAhead(std::filesystem::path file) {
  try {
    volume_ = std::async(std::launch::async,
                         [this, file = std::move(file)]() -> std::optional<haptics::Volume> {
                           const datasets::ReadProgress progress{
                               .advanced = [this](double f) { fraction_ = f; }, .cancel = &cancel_};
                           const auto survey = datasets::survey(file, progress);
                           if (!survey || survey->series.size() != 1 ||
                               survey->series.front().verdict != datasets::Verdict::Sound)
                             return {};
                           auto volume = datasets::readVolume(survey->series.front(), {}, progress);
                           if (!volume) return {};
                           return std::move(*volume);
                         });
  } catch (const std::system_error&) {
    // no thread: the loader reads
  }
}

ReadAhead::~ReadAhead() { cancel_ = true; }

std::optional<haptics::Volume> ReadAhead::take(const datasets::ReadProgress& progress) {
  if (!volume_.valid()) return {};
  while (volume_.wait_for(kLook) != std::future_status::ready) {
    if (progress.isCancelled()) return {};
    progress.advanced(fraction_);
  }
  return volume_.get();
}

}  // namespace app
