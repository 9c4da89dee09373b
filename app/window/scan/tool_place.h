// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/scene/scene.h"
#include "ui/views/touched_surface.h"

namespace app {

/// The place of the surface that is nearest to `p_W`, inside or outside of the solid, up to 30 mm
/// away; none if there is none.
std::optional<ui::SurfacePlace> nearestSurface(const haptics::Scene& scene, double isovalue,
                                               const haptics::Vec3& p_W);

/// A legal pose with the tip just off a place of the surface and the tool along its normal, turned
/// about it as little as possible from `X_now`. Where other parts of the solid leave no room along
/// the normal, the tool leans away from it, as little as needed; the tip never passes through the
/// solid. None if there is no room.
std::optional<haptics::Pose> poseAt(const haptics::Scene& scene, double isovalue,
                                    const ui::SurfacePlace& place, const haptics::Pose& X_now);

}  // namespace app
