// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/sphere_image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace study {
namespace {

using haptics::Vec3;

/// The unit direction from the eye through a pixel's middle.
Vec3 rayThrough(const Camera& camera, int side, int x, int y) {
  const Vec3 ahead = (camera.focus_mm - camera.eye_mm).normalized();
  const Vec3 right = ahead.cross(camera.up).normalized();
  const Vec3 up = right.cross(ahead);
  const double half = std::tan(0.5 * camera.angle_deg * std::numbers::pi / 180.0);
  return (ahead + half * ((2.0 * x + 1.0) / side - 1.0) * right +
          half * ((2.0 * y + 1.0) / side - 1.0) * up)
      .normalized();
}

}  // namespace

double clearance_mm(const Sphere& sphere, const Camera& camera, int side, int x, int y) {
  return rayThrough(camera, side, x, y).cross(sphere.centre_mm - camera.eye_mm).norm() -
         sphere.radius_mm;
}

Image imageOf(const Sphere& sphere, const Look& look, const Camera& camera, int side) {
  Image image{side, side};
  image.grey.reserve(static_cast<std::size_t>(side) * side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Vec3 ray = rayThrough(camera, side, x, y);
      const Vec3 to_centre = sphere.centre_mm - camera.eye_mm;
      const double along = ray.dot(to_centre);
      const double aside = ray.cross(to_centre).norm();
      const double inside = sphere.radius_mm * sphere.radius_mm - aside * aside;
      if (inside < 0.0 || along < 0.0) {
        image.grey.push_back(0.0);
        continue;
      }
      const Vec3 hit = camera.eye_mm + (along - std::sqrt(inside)) * ray;
      const Vec3 normal = (hit - sphere.centre_mm) / sphere.radius_mm;
      const double facing = std::max(0.0, -normal.dot(ray));
      const double shine = look.specular * std::pow(facing, look.power);
      double grey = 0.0;
      for (int c = 0; c < 3; ++c)
        grey += std::round(255.0 *
                           std::min(1.0, look.colour[c] * (look.ambient + look.diffuse * facing) +
                                             shine)) /
                3.0;
      image.grey.push_back(grey);
    }
  return image;
}

}  // namespace study
