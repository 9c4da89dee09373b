// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/study/report/outcome.h"

namespace study::plan {

/// What each scene leaves out, why, what it saves, and the proof that nothing changes: every
/// omission of haptics/omissions.h switched off against on, side by side in one process.
Study planStudy(Depth depth);

}  // namespace study::plan
