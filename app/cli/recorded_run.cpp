// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/recorded_run.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "app/cli/interrupts.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "app/recording/cut_words.h"
#include "app/recording/facts.h"
#include "app/recording/felt_words.h"
#ifdef PALPATE_READERS
#include "app/recording/volume_hash.h"
#include "resources/messages/messages.h"
#endif

namespace app::cli {

using haptics::Expected;

std::optional<VolumeHash> hashHere(const haptics::Volume& volume) {
#ifdef PALPATE_READERS
  const auto key = installationKey();
  if (!key) {
    tell(resources::sentence(key.error()));
    return {};
  }
  return hashOf(volume, *key, interruption());
#else
  (void)volume;
  return {};
#endif
}

std::optional<std::string> openHashOf(const haptics::Volume& volume) {
#ifdef PALPATE_READERS
  return openHashOfVoxels(volume, interruption());
#else
  (void)volume;
  return {};
#endif
}

Expected<std::unique_ptr<RecordedRun>> RecordedRun::begin(const std::string& path,
                                                          haptics::ClosedLoop& loop,
                                                          std::string tool,
                                                          const nlohmann::ordered_json& about) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error || (fs::exists(target, error) && !fs::is_regular_file(target, error)))
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"output-no-regular-file", {path}}, "unwritable"});
  auto recorder =
      Recorder::create(target, recordingFacts("palpate-cli", about), {.rate = loop.rate});
  if (!recorder) return tl::unexpected(recorder.error());
  const auto id = static_cast<std::uint32_t>(loop.scene->id);
  (*recorder)->describe(loop.scene, std::move(tool));
  if (const auto hash = hashHere(*loop.scene->volume)) (*recorder)->identify(id, *hash);
  if (loop.watch && loop.watch->isFelt()) (*recorder)->note(kFeltEvent, wordsOf(*loop.watch), 1.0);
  if (loop.cut) (*recorder)->note(kCutLawEvent, wordsOf(*loop.cut), double(id));
  loop.on_start = [&ring = (*recorder)->ring(), id, limits = loop.limits,
                   rate = loop.rate](const haptics::Pose& X) {
    ring.start({.scene = id, .X_WP = X, .limits = limits, .safety = {}, .rate = rate});
  };
  return std::unique_ptr<RecordedRun>(new RecordedRun(std::move(*recorder), loop));
}

void RecordedRun::write(const haptics::TraceRow& row) {
  haptics::StepRing& ring = recorder_->ring();
  while (ring.full() && recorder_->status().failure.empty()) {
    recorder_->hurry();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  haptics::Step step;
  step.time_ns = std::llround(double(ticks_++) * loop_.rate.period() * 1e9);
  step.X_WD = row.X_WD;
  step.X_WP = row.X_WP;
  step.sent_W = row.sent_W;
  step.settings = loop_.settings;
  step.scene = static_cast<std::uint32_t>(loop_.scene->id);
  step.cut_at = row.cut_at;
  step.cpu_ns = row.cpu_ns;
  step.force_state = row.force_state;
  step.flags = haptics::StepFlags::kArmed;
  if (row.cutting != nullptr) {
    step.flags |= haptics::StepFlags::kCut;
    step.cut = row.cutting->begun();
  }
  step.contacts = row.bearing;
  step.near = row.near;
  ring.push(step);
}

Expected<nlohmann::ordered_json> RecordedRun::finish() {
  const auto finished = recorder_->finish();
  if (!finished) return tl::unexpected(finished.error());
  const RecorderStatus status = recorder_->status();
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(*finished, ignored);
  return nlohmann::ordered_json{
      {"steps", status.steps},
      {"lost", status.lost},
      {"bytes", bytes},
      {"bytes_per_step", status.steps > 0 ? double(bytes) / double(status.steps) : 0.0}};
}

}  // namespace app::cli
