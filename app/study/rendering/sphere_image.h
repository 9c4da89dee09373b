// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/study/rendering/image.h"
#include "haptics/core/geometry.h"

namespace study {

/// A pinhole camera in W, millimetres; up is nowhere along the line of sight.
struct Camera {
  haptics::Vec3 eye_mm = haptics::Vec3::Zero(), focus_mm = haptics::Vec3::UnitY();
  haptics::Vec3 up = haptics::Vec3::UnitZ();
  double angle_deg = 30.0;  ///< from the lower to the upper edge of the picture
};

/// How a surface answers the light, after Phong.
struct Look {
  haptics::Vec3 colour = haptics::Vec3::Ones();  ///< red, green, blue, 0 to 1
  double ambient = 0.0, diffuse = 1.0, specular = 0.0, power = 1.0;
};

struct Sphere {
  haptics::Vec3 centre_mm = haptics::Vec3::Zero();
  double radius_mm = 1.0;
};

/// How far the ray through a pixel's middle passes from a sphere's surface, mm; less than zero
/// where it meets the sphere.
double clearance_mm(const Sphere& sphere, const Camera& camera, int side, int x, int y);

/// The picture of a sphere lit from the eye, side x side pixels, one ray through the middle of
/// each: the quadratic's nearer root, and the formula's own normal. Shares no code with VTK.
Image imageOf(const Sphere& sphere, const Look& look, const Camera& camera, int side);

}  // namespace study
