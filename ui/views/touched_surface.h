// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "haptics/core/geometry.h"

namespace ui {

/// A place on the surface that is touched.
struct SurfacePlace {
  haptics::Vec3 p_W;       ///< m
  haptics::Vec3 normal_W;  ///< unit, out of the solid
};

/// The surface that is touched, as views ask for it: the very field that the servo uses, whatever
/// its kind. `app` gives it; its functions are empty before the first volume. GUI thread.
struct TouchedSurface {
  /// The field at a place [m], in the volume's unit.
  std::function<double(const haptics::Vec3& p_W)> value = {};
  /// The field half a voxel behind the surface at a place of it [m]: of what is touched there.
  std::function<double(const haptics::Vec3& p_W)> behind = {};
  /// Where the segment first meets the surface at this isovalue; none: nowhere.
  std::function<std::optional<SurfacePlace>(const haptics::Vec3& from_W, const haptics::Vec3& to_W,
                                            double isovalue)>
      firstMet = {};
};

}  // namespace ui
