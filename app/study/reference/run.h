// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/study/reference/tick.h"

namespace reference {

/// What one tick of a run came to.
struct Record {
  Pose X_WP = Pose::Identity();
  Wrench wrench;  ///< on the hand
  int contacts = 0;
  double penetration = 0.0;  ///< m, of the deepest point of the shell at X_WP; 0 if all are outside
  std::int64_t samples = 0;  ///< look-ups of F in the tick, without those for `penetration`
};

/// Runs one tick for each device pose; the proxy starts at the first, which must be outside.
std::vector<Record> run(const Scene& scene, std::span<const Pose> device_poses);

/// Whether the tick in contact that led from one pose of proxy and device to the next is frozen:
/// the proxy has moved less than 1e-9 m (translation + radius x rotation) while it is more than
/// 1e-4 m, by the mass metric, from a device that has moved more than that 1e-9 m.
bool isFrozen(const Pose& X_before, const Pose& X_WP, const Pose& X_WD_before, const Pose& X_WD,
              const haptics::PointShell& shell);

/// The share of frozen ticks of those in contact; 0 if there is none. Records and poses belong
/// together, tick by tick.
double frozenShare(std::span<const Record> records, std::span<const Pose> device_poses,
                   const haptics::PointShell& shell);

}  // namespace reference
