// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "haptics/core/error.h"
#include "haptics/recording/recording.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// How far today's algorithm, given the recorded device path, goes from what was recorded.
struct ReplayDifference {
  std::int64_t steps = 0;      ///< compared
  std::int64_t skipped = 0;    ///< of no scene, or of one that is not at hand, or without a start
  std::int64_t differing = 0;  ///< steps of which any number differs in any bit
  std::optional<std::uint64_t> first;  ///< the first of them
  double distance = 0.0;               ///< m: greatest between proxy and recorded proxy
  double angle = 0.0;                  ///< rad
  double force = 0.0;                  ///< N
  double torque = 0.0;                 ///< N·m
};

/// Drives the algorithm with the recorded device path, settings and cuts. `scene` gives the scene
/// of a number, or null where it is not at hand; each is asked for once. `goes_on` is told the
/// fraction that is done and ends it, reason "cancelled", where it says false.
Expected<ReplayDifference> replay(
    Recording& recording, const std::function<std::shared_ptr<const Scene>(std::uint32_t)>& scene,
    const std::function<bool(double)>& goes_on);

}  // namespace haptics
