// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "haptics/recording/recording.h"

namespace app::exporting {

/// What a recording says of itself: words, and numbers.
nlohmann::ordered_json factsOf(const haptics::Recording& recording);
/// What it says of a scene: words, truths, numbers, and lists of numbers, which may be a matrix's
/// rows.
nlohmann::ordered_json factsOf(const haptics::RecordedScene& scene);

}  // namespace app::exporting
