// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/report/outcome.h"

namespace study {

/// Error of the picture against frame time, a job for each scene. Where nothing can be drawn,
/// because there is no display or the build has no VTK, their outcome is an omission that says so.
std::vector<Job> renderingJobs(Depth depth);

/// Draws a scene ("sphere", "head") with every back-end and judges the pictures.
Outcome drawScene(const std::string& scene, Depth depth);

/// A row for the omissions.
Outcome notDrawn(const std::string& scene, const std::string& why);

}  // namespace study
