// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/scene/scene.h"

namespace app {

/// The pose of the tool before a hand moves it: the tip a little off the first surface on
/// the line of sight of the first picture to the middle of the volume, the handle away from the
/// patient. None if no legal pose is near.
std::optional<haptics::Pose> startPose(const haptics::Scene& scene, double isovalue);

}  // namespace app
