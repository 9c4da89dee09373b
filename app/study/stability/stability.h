// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/study/report/outcome.h"

namespace study::stability {

/// Does it stay calm, and outside, whatever it is given? The stiffest wall for each device; presses
/// on analytic scenes through the tick; hands that wedge, pry and hook at 5000 N/m; an arm without
/// torque motors; and every situation known to be the downfall of such a method.
Study stabilityStudy(Depth depth);

/// Situations in which the paper's method, or a plausible step beyond it, fails: each a case with
/// its bound. A quick study makes a tenth of the tries.
std::vector<Job> failureJobs(Depth depth);
/// The limits of every rated device at 1 and 4 kHz, with and without virtual damping and passivity
/// controller. On the wall also with dry friction, and with no and one period of delay; in full two
/// and four as well. Through the tick three devices at 1 kHz where it is quick.
std::vector<Job> limitJobs(Depth depth);
/// Every device, stage, stiffness, delay and noise through the tick itself, at 1 and 4 kHz. A case
/// is the program as shipped, up to what is allowed; rows of a table are what is stiffer, and for
/// some devices what the guard, virtual damping and the passivity controller each do.
std::vector<Job> pressJobs(Depth depth);
/// Hands that move while they press: wedge, pry and hook at 5000 N/m on phantoms and the
/// paper's scenes, and a handle that
/// is turned while a long arm touches, with and without torque motors ([Chan 2011], 3.1).
std::vector<Job> handJobs(Depth depth);

}  // namespace study::stability
