// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"

namespace study {

/// accuracy, stability, plan.
std::vector<std::string> studyNames();

/// A study by name; none for a name that is not there.
std::optional<Study> makeStudy(const std::string& name, Depth depth);

}  // namespace study
