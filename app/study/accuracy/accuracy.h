// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/study/report/outcome.h"

namespace study::accuracy {

/// Error against run time: pose and force against closed forms, collisions against dense sampling,
/// projections against enumeration, fields against solids, the paper's scenes against its own
/// algorithm, and what many points cost.
Study accuracyStudy(Depth depth);

}  // namespace study::accuracy
