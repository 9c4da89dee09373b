// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "datasets/phantoms/noise.h"
#include "datasets/phantoms/skull_shape.h"

namespace datasets::skull {
namespace {

Primitive ellipsoid(Vec3f centre, Vec3f radii, float blend = 0, float yaw_deg = 0) {
  const float yaw = yaw_deg * std::numbers::pi_v<float> / 180.0f;
  return {.kind = Primitive::Kind::Ellipsoid,
          .a = centre,
          .b = radii,
          .yaw_cos = std::cos(yaw),
          .yaw_sin = yaw_deg == 0 ? 0.0f : std::sin(yaw),
          .blend = blend};
}

Primitive cone(Vec3f from, float r_from, Vec3f to, float r_to, float blend = 0,
               Vec3f squash = Vec3f::Ones()) {
  return {.kind = Primitive::Kind::Cone,
          .a = from,
          .b = to,
          .ra = r_from,
          .rb = r_to,
          .squash = squash,
          .blend = blend};
}

Primitive cone(const Rod& rod) { return cone(rod.from, rod.radius, rod.to, rod.radius); }

Primitive arch(Vec3f centre, float half_x, float half_y, float back, float half_width,
               float half_height, float blend = 0) {
  return {.kind = Primitive::Kind::Arch,
          .a = centre,
          .b = {half_x, half_y, back},
          .ra = half_width,
          .rb = half_height,
          .blend = blend};
}

/// Adds a primitive of the left side (+x) and its mirror image.
void both(Solid& solid, const Primitive& left) {
  solid.push_back(left);
  Primitive right = left;
  right.a.x() = -right.a.x();
  if (right.kind == Primitive::Kind::Cone) right.b.x() = -right.b.x();
  right.yaw_sin = -right.yaw_sin;
  solid.push_back(right);
}

Solid bones() {
  Solid s;
  // braincase
  s.push_back(ellipsoid({0, 12, 32}, {71, 84, 66}));
  s.push_back(ellipsoid({0, -40, 30}, {53, 47, 48}, 14));
  s.push_back(ellipsoid({0, 52, 2}, {54, 42, 40}, 14));
  s.push_back(ellipsoid({0, 2, -6}, {56, 50, 28}, 14));
  both(s, ellipsoid({42, 30, 48}, {23, 30, 26}, 14));  // parietal bosses
  // base: clivus, condyles, mastoids, root of the arches, styloids
  s.push_back(ellipsoid({0, 0, -22}, {24, 26, 14}, 8));
  both(s, ellipsoid({14, 22, -38}, {6, 10, 6}, 4));
  both(s, ellipsoid({57, 6, -16}, {11, 20, 14}, 8));
  both(s, ellipsoid({54, 21, -34}, {11, 13, 20}, 6, 10));
  both(s, cone({45, 10, -34}, 2.6f, {40, 2, -60}, 1.0f, 3));
  // brow, rims of the orbits, bridge of the nose
  both(s, ellipsoid({25, -78, 15}, {24, 8, 7}, 8, 20));
  both(s, cone({48, -68, 17}, 5, {51, -63, -14}, 4.8f, 5));
  both(s, cone({49, -64, -18}, 5, {17, -81, -22}, 4.2f, 5));
  both(s, cone({12, -84, 12}, 4.5f, {16, -80, -18}, 3.6f, 5));
  s.push_back(cone({0, -84, 10}, 7, {0, -96, -13}, 3.2f, 5));
  both(s, cone({6, -88, 4}, 4, {12, -86, -24}, 3, 5));
  // side walls of the orbits: the wings of the sphenoid
  both(s, ellipsoid({39, -49, -3}, {3.6f, 21, 21}, 4, 43));
  // cheekbones and their arches
  both(s, ellipsoid({46, -62, -27}, {14, 11, 11}, 7, 30));
  both(s, cone({52, -55, -28}, 5, {64, -30, -26}, 3.4f, 5, {1, 1, 0.62f}));
  both(s, cone({64, -30, -26}, 3.4f, {66, -8, -23}, 3.0f, 3, {1, 1, 0.62f}));
  both(s, cone({66, -8, -23}, 3.0f, {61, 8, -20}, 4.5f, 4, {1, 1, 0.7f}));
  // upper jaw, palate, pterygoid plates
  s.push_back(ellipsoid({0, -54, -32}, {36, 31, 26}, 7));
  s.push_back(arch({0, -50, -51}, 25, 37, 8, 6, 8, 6));
  s.push_back(ellipsoid({0, -58, -49}, {24, 30, 3}, 3));
  s.push_back(ellipsoid({0, -91, -43}, {3, 4, 4}, 3));
  both(s, ellipsoid({14, -33, -42}, {2.4f, 8, 17}, 3, 12));
  // lower jaw: tooth-bearing rim, body, angle, the two processes
  s.push_back(arch({0, -48, -83}, 26, 36, 10, 5, 8));
  both(s, cone({0, -85, -95}, 6, {21, -80, -94}, 6, 5, {1, 1, 0.62f}));
  both(s, cone({21, -80, -94}, 6, {37, -52, -90}, 5.5f, 5, {1, 1, 0.55f}));
  both(s, cone({37, -52, -90}, 5.5f, {48, -14, -80}, 5, 5, {1, 1, 0.5f}));
  both(s, cone({48, -14, -78}, 4.5f, {51, -8, -46}, 3.6f, 5, {1, 0.33f, 1}));
  both(s, ellipsoid({48, -18, -72}, {4.5f, 13, 15}, 6));
  both(s, cone({50, -18, -54}, 3.4f, {49, -26, -30}, 1.6f, 4, {1, 0.6f, 1}));
  both(s, cone({51, -3, -52}, 3.8f, {53, -2, -33}, 4.0f, 4));
  both(s, ellipsoid({53, -2, -31}, {9, 4.5f, 4}, 2));
  s.push_back(ellipsoid({0, -86, -98}, {15, 7, 7}, 9));
  // neck: bodies, arches and processes of the upper vertebrae
  for (int level = 0; level < 4; ++level) {
    const float z = -58.0f - 17.0f * static_cast<float>(level),
                y = 18.0f + 2.0f * static_cast<float>(level);
    s.push_back(ellipsoid({0, y, z}, {11, 9, 7.5f}, 1));
    both(s, ellipsoid({20, y + 8, z}, {8, 7, 8.5f}, 2));
    both(s, cone({18, y + 12, z}, 4.5f, {4, y + 30, z - 2}, 3.5f, 3));
    s.push_back(cone({0, y + 30, z - 2}, 3.5f, {0, y + 42, z - 8}, 3.0f, 3));
  }
  s.push_back(cone({0, 16, -38}, 4, {0, 17, -52}, 5, 2));  // the dens
  return s;
}

/// Sixteen teeth a row along the arch, each a stout ellipsoid with a root.
void addTeeth(Solid& s, float half_x, float half_y, float crown, float root, int missing) {
  constexpr float kWidths[] = {8.4f, 6.8f, 7.6f, 7.0f, 6.8f, 9.6f, 9.2f, 8.2f};
  for (const float side : {1.0f, -1.0f}) {
    float angle = 0.0f;  // from the front
    for (int k = 0; k < 8; ++k) {
      const auto at = [&](float t) {
        return Vec3f{side * half_x * std::sin(t), -50.0f - half_y * std::cos(t), crown};
      };
      const auto speed = [&](float t) {
        return std::hypot(half_x * std::cos(t), half_y * std::sin(t));
      };
      const float width = 0.80f * kWidths[k];
      const float middle = angle + 0.5f * width / speed(angle);
      angle = middle + 0.5f * width / speed(middle);
      if (side > 0 && k == missing) continue;
      const Vec3f centre = at(middle);
      const float stout = k < 3 ? 3.2f : k < 5 ? 4.2f : 5.0f;
      // the width runs along the arch
      const float yaw_deg = side *
                            std::atan2(half_y * std::sin(middle), half_x * std::cos(middle)) *
                            180.0f / std::numbers::pi_v<float>;
      s.push_back(ellipsoid(centre, {0.54f * width, stout, 6.0f}, 0.0f, yaw_deg));
      Vec3f tip = centre;
      tip.z() = root;
      s.push_back(cone(centre, 0.4f * width, tip, 0.8f, 1.0f));
    }
  }
}

/// Small bubbles in a box, by hash; kept where they fit in an ellipsoid of that size.
void addCells(Solid& s, const Vec3f& centre, const Vec3f& half, int tries, float r_least,
              float r_most, std::uint64_t seed) {
  const std::size_t first = s.size();
  for (int n = 0; n < tries; ++n) {
    const auto draw = [&](int c) { return noise::uniform(noise::hashed(n, c, 0, seed)); };
    const Vec3f unit{2 * draw(0) - 1, 2 * draw(1) - 1, 2 * draw(2) - 1};
    const float r = r_least + (r_most - r_least) * draw(3) * draw(3);
    const Vec3f at = centre + unit.cwiseProduct(half);
    if (unit.norm() > 1.0f) continue;
    // a wall of at least 0.9 mm to its neighbours
    bool free = true;
    for (std::size_t q = first; q < s.size(); ++q)
      free = free && (s[q].a - at).norm() > s[q].b.x() + r + 0.9f;
    if (free) s.push_back(ellipsoid(at, Vec3f::Constant(r)));
  }
}

Solid airSpaces() {
  Solid s;
  // the nose: a pear at the front, a passage to the throat
  s.push_back(cone({0, -89, -20}, 4.5f, {0, -87, -35}, 11.5f));
  s.push_back(ellipsoid({0, -60, -30}, {13, 38, 17}, 6));
  // sinuses: of the upper jaw, forehead, sphenoid and ethmoid
  both(s, ellipsoid({29, -56, -31}, {11.5f, 16, 15}));
  s.push_back(ellipsoid({9, -80, 17}, {9, 3.6f, 8}, 2, -14));
  s.push_back(ellipsoid({-11, -80, 15}, {8, 3.4f, 6}, 2, 14));
  s.push_back(ellipsoid({5, -20, -13}, {8, 10, 8}));
  s.push_back(ellipsoid({-8, -20, -14}, {5.5f, 9, 7}));
  addCells(s, {0, -58, -5}, {11, 18, 9}, 400, 1.6f, 3.6f, 21);
  // ears: canal, drum, and the honeycomb of the mastoids
  both(s, cone({95, 10, -24}, 3.4f, {46, 7, -22}, 3.2f));
  both(s, ellipsoid({42, 6, -20}, {4.5f, 5, 6}, 2));
  addCells(s, {54, 21, -33}, {9, 11, 17}, 900, 1.1f, 2.6f, 22);
  addCells(s, {-54, 21, -33}, {9, 11, 17}, 900, 1.1f, 2.6f, 23);
  // throat
  s.push_back(cone({0, -18, -38}, 9, {0, -6, -120}, 8, 4, {0.7f, 1, 1}));
  return s;
}

Solid softHollows() {
  const Rods rods;
  Solid s;
  both(s, ellipsoid({33, -76, -3}, {19.5f, 30, 17.5f}, 0, 16));  // orbits, and their apex
  both(s, cone({29, -62, -3}, 13, {13, -38, 0}, 2.6f, 4));
  s.push_back(cone({0, 30, -14}, 15, {0, 32, -60}, 14));  // foramen magnum
  s.push_back(cone(rods.spine));
  both(s, cone({27, -95, -28}, 1.7f, {28, -70, -26}, 1.5f));   // below the orbit
  both(s, cone({25, -92, 18}, 1.5f, {25, -74, 15}, 1.4f));     // above it
  both(s, ellipsoid({27, -82, -92}, {1.6f, 4, 1.6f}, 0, 30));  // chin
  both(s, cone(rods.left_carotid));                            // with the foramen ovale
  both(s, cone(rods.left_jugular));
  s.push_back(cone(rods.burr_hole));
  return s;
}

Solid skinSurface() {
  Solid s;
  s.push_back(ellipsoid({0, 12, 32}, {77, 90, 72}));
  s.push_back(ellipsoid({0, -40, 30}, {59, 52, 54}, 14));
  s.push_back(ellipsoid({0, 52, 0}, {60, 48, 46}, 14));
  s.push_back(ellipsoid({0, 0, -20}, {69, 60, 44}, 14));
  both(s, ellipsoid({50, 30, 52}, {27, 33, 29}, 20));
  s.push_back(ellipsoid({0, -44, -36}, {61, 49, 54}, 16));
  both(s, ellipsoid({40, -62, -30}, {21, 18, 19}, 14));
  s.push_back(ellipsoid({0, -44, -80}, {53, 48, 30}, 14));
  both(s, ellipsoid({44, -20, -74}, {16, 24, 24}, 14));
  s.push_back(ellipsoid({0, -86, -96}, {25, 15, 15}, 14));
  s.push_back(cone({0, 16, -40}, 52, {0, 26, -150}, 55, 20, {1, 0.95f, 1}));
  // over cheek arches, rims of the orbits, mastoids
  both(s, cone({50, -58, -28}, 13, {63, -10, -24}, 13, 12));
  both(s, ellipsoid({50, -62, 2}, {10, 11, 24}, 10));
  both(s, ellipsoid({57, 20, -34}, {15, 19, 24}, 10));
  // nose
  s.push_back(ellipsoid({0, -84, -36}, {22, 17, 20}, 14));
  s.push_back(cone({0, -90, 8}, 7, {0, -112, -30}, 8, 14));
  both(s, ellipsoid({10, -103, -34}, {8, 9, 7}, 7));
  // mouth, brow, lids
  s.push_back(ellipsoid({0, -78, -68}, {32, 19, 20}, 14));
  s.push_back(ellipsoid({0, -92, -62}, {23, 9, 5.5f}, 8));
  s.push_back(ellipsoid({0, -91, -73}, {20, 9, 6}, 8));
  both(s, ellipsoid({26, -80, 15}, {25, 11, 8}, 8, 20));
  both(s, ellipsoid({33, -77, -4}, {14.5f, 13.5f, 12.5f}, 5));
  // ears
  both(s, ellipsoid({79, 20, -16}, {4.5f, 17, 30}, 5, -28));
  both(s, ellipsoid({80, 13, -40}, {4.5f, 8, 9}, 4, -20));
  return s;
}

Solid skinCuts() {
  Solid s;
  both(s, ellipsoid({7, -103, -42}, {3, 5.5f, 6}, 2));
  s.push_back(ellipsoid({0, -104, -67.5f}, {22, 8, 1.2f}, 2));
  both(s, ellipsoid({87, 13, -20}, {7, 9, 14}, 4, -28));
  return s;
}

Solid septa() {
  Solid s;
  // the nose's own walls: a septum that leans to one side, and the turbinates
  s.push_back(cone({1, -82, -22}, 0.9f, {-2, -34, -26}, 0.9f, 0, {1, 1, 0.06f}));
  both(s, ellipsoid({8, -62, -36}, {1.8f, 20, 4}, 1, 4));
  both(s, ellipsoid({8, -60, -25}, {1.5f, 16, 3.4f}, 1, 4));
  return s;
}

}  // namespace

Anatomy anatomy() {
  Anatomy head;
  head.bone = bones();
  addTeeth(head.teeth, 25, 38, -62.5f, -47, -1);
  addTeeth(head.teeth, 24, 36, -73.5f, -88, 5);
  head.septa = septa();
  head.fat = softHollows();
  head.air = airSpaces();
  const Rod eye = Rods{}.left_eye;
  both(head.eyes, ellipsoid(eye.from, Vec3f::Constant(eye.radius)));
  head.skin = skinSurface();
  head.skin_cuts = skinCuts();
  return head;
}

}  // namespace datasets::skull
