// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/wall.h"

namespace study::stability {

/// The press of wall.h with everything in the loop: the tick with a plate of points on a
/// half-space, six degrees of freedom, the limits of the device. Same arrival, same verdict, by the
/// handle's translation; no more than half of the rated force.
Pressed pressOnPlane(const Wall& wall, double stiffness);

/// The stiffness up to which its shaking dies, to 1 %; between 0.7 and twice of what the same wall
/// carries in one degree of freedom. In steps of 3 %: near the limit a press now
/// shakes on and now does not.
Limit planeLimit(const Wall& wall);

/// Every device at 1 and 4 kHz; three of them at 1 kHz where it is quick.
std::vector<Job> planeLimitJobs(Depth depth);

}  // namespace study::stability
