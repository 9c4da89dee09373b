// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/recording/recording.h"
#include "app/recording/replay.h"
#include "haptics/simulation/closed_loop.h"

namespace recording_tests {

using namespace app;
using namespace datasets;
using namespace haptics;

constexpr double kEver = 1e9;  // s

/// A ball of 15 mm in a volume of 48 mm, rippled so that contacts come and go.
std::shared_ptr<const Scene> scene(double radius = 0.015);

/// What moves and reads the hand.
struct HandAtWork {
  HandMotion motion = HandMotion::Slide;
  std::int64_t ticks = 0;
  double friction = 0.0;
  double stiffness = Settings{}.stiffness;
  ServoRate rate = {};
  Linkage linkage = {};
  ForceLimits limits = {};
  std::optional<ServoRate> rate_of_recorder = {};        ///< if it is another
  std::function<void(Step&, std::int64_t)> change = {};  ///< of step n before it is recorded
};

/// The steps of the hand at work on the ball. Two runs give the same.
std::vector<Step> worked(const HandAtWork& hand);

/// The hand at work on the ball, in closed loop, every tick kept and recorded.
std::vector<TraceRow> recorded(const std::filesystem::path& path, const HandAtWork& hand,
                               std::shared_ptr<const Scene> touched = scene());
inline std::vector<TraceRow> recorded(const std::filesystem::path& path, HandMotion motion,
                                      std::int64_t ticks, double friction = 0.0,
                                      std::shared_ptr<const Scene> touched = scene()) {
  return recorded(path, {.motion = motion, .ticks = ticks, .friction = friction},
                  std::move(touched));
}

std::vector<RecordedStep> stepsIn(Recording& recording);

/// Replays over a volume of its own making, as a later program would.
ReplayDifference replayed(Recording& recording, std::shared_ptr<const Volume> volume);

bool same(const Pose& a, const Pose& b);

/// user_version, where SQLite has it.
int formatOf(const std::filesystem::path& path);

}  // namespace recording_tests
