// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/study/report/outcome.h"

namespace study::stability {

/// Does it stay calm, and outside, whatever it is given? The stiffest wall for each device; presses
/// on analytic scenes through the tick; hands that wedge, pry and hook at 5000 N/m; an arm without
/// torque motors; and every situation known to be the downfall of such a method.
Study stabilityStudy(Depth depth);

}  // namespace study::stability
