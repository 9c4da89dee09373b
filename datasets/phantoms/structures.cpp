// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/structures.h"

#include "datasets/phantoms/mastoid.h"
#include "datasets/phantoms/skull_shape.h"
#include "datasets/phantoms/tube.h"

namespace datasets {
namespace {

using haptics::Vec3;

std::vector<PhantomStructure> skullStructures() {
  std::vector<PhantomStructure> structures;
  const auto add = [&](const char* name, const std::array<double, 3>& colour, const skull::Rod& rod,
                       double side = 1.0) {
    const auto inW = [side](const skull::Vec3f& p) {
      const Vec3 on_side = p.cast<double>().cwiseProduct(Vec3{side, 1.0, 1.0});
      return Vec3{1e-3 * (on_side - skull::kMiddle.cast<double>())};
    };
    structures.push_back(
        {name, colour,
         [tube = shapes::Tube{{inW(rod.from), inW(rod.to)}, 1e-3 * double(rod.radius)}](
             const Vec3& p_W) { return tube.distance(p_W); }});
  };
  structures.push_back(
      {"Brain",
       {0.93, 0.70, 0.68},
       [](const Vec3& p_W) {
         return 1e-3 * double(skull::cavityDistance((1e3 * p_W).cast<float>() + skull::kMiddle));
       },
       false});
  const skull::Rods rods;
  add("Left eye", {0.45, 0.75, 0.95}, rods.left_eye);
  add("Right eye", {0.45, 0.75, 0.95}, rods.left_eye, -1.0);
  add("Left carotid canal", {0.90, 0.25, 0.20}, rods.left_carotid);
  add("Right carotid canal", {0.90, 0.25, 0.20}, rods.left_carotid, -1.0);
  add("Left jugular canal", {0.25, 0.42, 0.85}, rods.left_jugular);
  add("Right jugular canal", {0.25, 0.42, 0.85}, rods.left_jugular, -1.0);
  add("Spinal canal", {0.96, 0.86, 0.20}, rods.spine);
  add("Burr hole", {0.45, 0.80, 0.45}, rods.burr_hole);
  return structures;
}

}  // namespace

std::vector<PhantomStructure> phantomStructures(const std::string& phantom) {
  if (phantom == "mastoid") return mastoid::structures();
  if (phantom == "demo") return skullStructures();
  return {};
}

}  // namespace datasets
