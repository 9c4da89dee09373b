// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/rate.h"

namespace measurement {

/// Where a hand leads the device: one pose a tick, off the surface at first.
struct Path {
  std::vector<haptics::Pose> poses;
  std::size_t lead_in = 0;  ///< ticks at the start that are gone through and not counted; not all
};

/// What a tick may spend, as in the live loop.
struct Allowance {
  std::int64_t nanoseconds = haptics::ServoRate{}.budget_ns();  ///< CPU time of the thread
  std::int64_t work = 0;  ///< > 0 takes this instead of the time: counted, so that it repeats
  double period = haptics::ServoRate{}.period();  ///< s: a tick that takes longer is a miss
  haptics::ServoRate rate = {};                   ///< of the poses of the paths
};

/// A machine carries a tool if, on the paths, no larger share of ticks is longer than the period,
/// and the lag is no more than so many voxels: as much as the touch's own tolerance, below what a
/// hand can tell. How many ticks the budget ends is told and not judged: a cut tick does nothing
/// wrong and leaves the rest to the next, so what counts is how far behind the proxy is.
inline constexpr double kMostMissed = 0.001, kMostLag = 0.05;

/// What one tool cost on the paths. Times are CPU time of the measuring thread.
struct Load {
  int points = 0;
  std::int64_t ticks = 0;
  double median = 0.0, p99 = 0.0, longest = 0.0;  ///< s
  std::int64_t cut = 0;                           ///< ticks that the budget ended
  std::int64_t missed = 0;                        ///< ticks longer than the period
  /// m: how much nearer to the device the proxy would be, in the mass metric, had its tick not been
  /// ended by the budget; mean over every fiftieth tick. If fifty times the budget would not have
  /// let it end either, all of the distance counts.
  double lag = 0.0;
  bool carried = false;
};

/// Leads a tool along the paths, a pose a tick, as fast as it goes by the clock. `goOn`
/// is asked every few milliseconds; once it says no, there is no load.
std::optional<Load> loadOf(const haptics::Scene& scene, double isovalue,
                           const haptics::VirtualCoupling& coupling, const std::vector<Path>& paths,
                           const Allowance& allowance, const std::function<bool()>& goOn);

}  // namespace measurement
