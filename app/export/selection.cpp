// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/selection.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/export/text.h"

namespace app::exporting {

using haptics::Error;
using haptics::Message;

namespace {

constexpr std::int64_t kStepsBetweenQuestions = 512;

std::int64_t nanoseconds(double time) {
  constexpr double kMost = 9.2e9;  // s: what 64 bits of ns hold
  return std::llround(std::clamp(time, -kMost, kMost) * 1e9);
}

/// The first multiple of 1/rate at or after a time, both in whole ns.
std::int64_t dueAt(std::int64_t time_ns, double rate) {
  const double n = std::ceil((double(time_ns) - 0.5) * rate * 1e-9);
  return std::llround(n * 1e9 / rate);
}

tl::unexpected<Error> nothingChosen(const Recording& recording) {
  return tl::unexpected(
      Error{Error::Kind::NotFound,
            {"recording-not-then", {numberOf(recording.begin()), numberOf(recording.end())}},
            "empty"});
}

}  // namespace

Window windowOf(const ExportOptions& options) {
  return {nanoseconds(options.from), nanoseconds(options.to)};
}

haptics::Expected<void> forEachChosen(Recording& recording, const ExportOptions& options,
                                      const std::function<bool(const RecordedStep&)>& each) {
  const Window window = windowOf(options);
  const double begin = std::max(options.from, recording.begin());
  const double length = std::min(options.to, recording.end()) - begin;
  const std::int64_t last_due = std::min(window.to, nanoseconds(recording.end()));

  std::int64_t read = 0, chosen = 0, before = 0;
  bool cancelled = false, damaged = false, wanted = true;
  std::optional<RecordedStep> pending;  // the newest, which is chosen if nothing comes before due
  double removed = 0.0;                 // m3, by all cuts, also those of steps that are not chosen
  const auto take = [&](const RecordedStep& step) {
    ++chosen;
    return wanted = each(step);
  };
  // a little more than is asked for, since what is asked for is decided in whole ns
  constexpr double kMargin = 1e-3;  // s
  const auto done = recording.forEach(
      options.from - kMargin, options.to + kMargin, [&](const RecordedStep& step) {
        const std::int64_t time = step.step.time_ns;
        damaged = time < before;
        before = time;
        if (damaged) return false;
        if (read++ % kStepsBetweenQuestions == 0 && options.goes_on) {
          const double part = length > 0.0 ? (double(time) * 1e-9 - begin) / length : 1.0;
          cancelled = !options.goes_on(std::clamp(part, 0.0, 1.0));
          if (cancelled) return false;
        }
        if (time < window.from) return true;
        if (time > window.to) return false;
        const bool due =
            options.rate > 0.0 && pending && dueAt(pending->step.time_ns, options.rate) < time;
        if (due && !take(*pending)) return false;
        pending = step;
        pending->step.removed = removed += step.step.removed;
        return options.rate > 0.0 || take(*pending);
      });
  if (!done) return done;
  if (damaged)
    return tl::unexpected(Error{Error::Kind::Malformed, {"recording-damaged", {}}, "damaged"});
  if (cancelled)
    return tl::unexpected(Error{Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  if (options.rate > 0.0 && wanted && pending &&
      dueAt(pending->step.time_ns, options.rate) <= last_due)
    take(*pending);
  if (chosen == 0) return nothingChosen(recording);
  return {};
}

std::span<const RecordedEvent> eventsChosen(const Recording& recording,
                                            const ExportOptions& options) {
  const Window window = windowOf(options);
  const auto& events = recording.events();
  const auto first = std::lower_bound(
      events.begin(), events.end(), window.from,
      [](const RecordedEvent& event, std::int64_t time) { return event.time_ns < time; });
  const auto end = std::upper_bound(
      first, events.end(), window.to,
      [](std::int64_t time, const RecordedEvent& event) { return time < event.time_ns; });
  return {first, end};
}

}  // namespace app::exporting
