// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "app/recording/recording.h"

namespace app::exporting {

/// N: the tangential force of all contacts together on the tool: the coupling's force without its
/// part along the sum of their pushes. Zero without friction or contact.
haptics::Vec3 frictionOf(const haptics::Step& step);
inline constexpr const char* kFrictionMeaning =
    "tangential force of all contacts together on the tool: the coupling's force, before the "
    "device's "
    "limits, without its part along the sum of the contacts' pushes; 0 without friction";

/// What the numbers mean, a sentence for each: the quaternion's direction, the tool's origin, the
/// law of the force.
nlohmann::ordered_json conventions();
/// Metadata of a recording: texts and numbers.
nlohmann::ordered_json factsOf(const Recording& recording);
/// Metadata of a scene: texts, booleans, numbers, and lists of numbers, also as the rows of a
/// matrix.
nlohmann::ordered_json factsOf(const RecordedScene& scene);

}  // namespace app::exporting
