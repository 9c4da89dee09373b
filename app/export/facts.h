// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "haptics/recording/recording.h"

namespace app::exporting {

/// Metadata of a recording: texts and numbers.
nlohmann::ordered_json factsOf(const haptics::Recording& recording);
/// Metadata of a scene: texts, booleans, numbers, and lists of numbers, also as the rows of a
/// matrix.
nlohmann::ordered_json factsOf(const haptics::RecordedScene& scene);

}  // namespace app::exporting
