// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/scene/scene.h"

namespace app {

/// Where the tool waits for the hand: in front of the patient, a little off the first surface
/// that the line towards the middle of the volume meets. None if no legal pose is near.
std::optional<haptics::Pose> startPose(const haptics::Scene& scene, double isovalue);

}  // namespace app
