// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "app/recording/recording.h"

namespace app::exporting {

/// What the numbers mean, a sentence for each: the quaternion's direction, the tool's origin, the
/// law of the force.
nlohmann::ordered_json conventions();
/// Metadata of a recording: texts and numbers.
nlohmann::ordered_json factsOf(const Recording& recording);
/// Metadata of a scene: texts, booleans, numbers, and lists of numbers, also as the rows of a
/// matrix.
nlohmann::ordered_json factsOf(const RecordedScene& scene);

}  // namespace app::exporting
