// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "app/study/comparison/methods.h"
#include "app/study/stability/stability.h"
#include "haptics/simulation/device_model.h"
#include "haptics/simulation/hand.h"

namespace study::stability {

/// What a device in a hand does on a method.
struct RivalRun {
  double shaking = 0.0;     ///< m: rms of the handle's place less its mean over 20 ms, in contact
  double force_step = 0.0;  ///< N, the largest in a tick
  double given = 0.0;       ///< J given to the hand, the most at any time
  double beyond_damping = 0.0;  ///< J, what of it device and hand do not damp
  double penetration = 0.0;     ///< m, the deepest of every tenth tick
  int contact = 0;              ///< ticks
};

/// Any method in a closed loop with device and hand: no ramp, guard or delay, within the rating.
RivalRun runRival(comparison::Method& method, const haptics::DeviceModel& device,
                  const haptics::Hand& hand, const comparison::Touched& touched,
                  const haptics::PointShell& shell, haptics::ServoRate rate, double stiffness,
                  std::int64_t ticks);

/// Rivals beside ours, at the same stiffness, hand and rate: rows of a table and no cases.
std::vector<Job> rivalJobs(Depth depth);

}  // namespace study::stability
