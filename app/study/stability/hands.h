// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/report/outcome.h"

namespace study::stability {

/// Hands that move while they press: wedge, pry and hook at 5000 N/m on phantoms and the
/// paper's scenes, and a handle that
/// is turned while a long arm touches, with and without torque motors ([Chan 2011], 3.1).
std::vector<Job> handJobs(Depth depth);

}  // namespace study::stability
