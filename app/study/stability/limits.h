// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/wall.h"

namespace study::stability {

/// "1 kHz".
std::string rateOf(double period);

/// What is added to the spring, as shares of the rated damping.
struct Loop {
  const char* name;
  const char* unguarded;  ///< its name where the guard of passivity is off
  double damping, controller;
};
/// Those that every limit is found for.
inline constexpr Loop kLoops[] = {
    {"plain", "no guard", 0.0, 0.0},
    {"virtual damping", "no guard, virtual damping", 0.25, 0.0},
    {"passivity controller", "no guard, passivity controller", 0.0, 1.0}};
Wall withLoop(Wall plain, const Loop& loop);

/// The measured limit of stiffness of a device on a wall over 2 (b + b_hand) / T, which must be at
/// least 0.85 where the damping is 5 N·s/m or more. `lag`: periods by which a planted error brings
/// the force late, and of which the theory knows nothing.
Case limitCase(const haptics::DeviceModel& device, double period, int lag);

/// The press of wall.h with everything in the loop: the tick with a plate of points on a
/// half-space, six degrees of freedom, the limits of the device. Same arrival, same verdict, by the
/// handle's translation; no more than half of the rated force.
Pressed pressOnPlane(const Wall& wall, double stiffness);

/// The stiffness up to which its shaking dies, to 1 %; between 0.7 and twice of what the same wall
/// carries in one degree of freedom. In steps of 3 %: near the limit a press now
/// shakes on and now does not.
Limit planeLimit(const Wall& wall);

}  // namespace study::stability
