// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/core/geometry.h"

/// The solids of the analytic phantoms in closed form, in W, in metres. `distance` is signed,
/// positive outside; `normal` is its unit gradient, pointing out of the solid. Each shape states
/// where its distance is exact. Elsewhere the distance is correct to first order at the surface.
namespace datasets::shapes {

using haptics::Vec3;

/// A ball about the origin. Exact everywhere.
struct Sphere {
  double radius = 0.020;  ///< m
  double distance(const Vec3& p) const { return p.norm() - radius; }
  Vec3 normal(const Vec3& p) const { return p.normalized(); }
};

/// Solid where z < 0. Exact everywhere.
struct HalfSpace {
  double distance(const Vec3& p) const { return p.z(); }
  Vec3 normal(const Vec3&) const { return Vec3::UnitZ(); }
};

/// A ring about z. Exact everywhere.
struct Torus {
  double ring = 0.020;  ///< m, of the circle that is the tube's axis
  double tube = 0.008;  ///< m
  double distance(const Vec3& p) const {
    return std::hypot(std::hypot(p.x(), p.y()) - ring, p.z()) - tube;
  }
  Vec3 normal(const Vec3& p) const {
    const double rho = std::hypot(p.x(), p.y());
    return (p - Vec3{p.x() * ring / rho, p.y() * ring / rho, 0.0}).normalized();
  }
};

/// An endless rod along x. Exact everywhere.
struct Cylinder {
  double radius = 0.012;  ///< m
  double distance(const Vec3& p) const { return std::hypot(p.y(), p.z()) - radius; }
  Vec3 normal(const Vec3& p) const { return Vec3{0.0, p.y(), p.z()}.normalized(); }
};

/// Solid where sin X cos Y + sin Y cos Z + sin Z cos X < 0, with X = 2 pi x / period. The surface
/// is exact; the distance is g / |grad g|, right to first order and infinite where that vanishes.
struct Gyroid {
  double period = 0.032;  ///< m
  double wave() const { return 2.0 * std::numbers::pi / period; }
  double level(const Vec3& p) const {
    const Vec3 q = wave() * p;
    return std::sin(q.x()) * std::cos(q.y()) + std::sin(q.y()) * std::cos(q.z()) +
           std::sin(q.z()) * std::cos(q.x());
  }
  /// Gradient of `level`, per metre.
  Vec3 gradient(const Vec3& p) const {
    const Vec3 q = wave() * p, s = q.array().sin(), c = q.array().cos();
    return wave() * Vec3{c.x() * c.y() - s.z() * s.x(), c.y() * c.z() - s.x() * s.y(),
                         c.z() * c.x() - s.y() * s.z()};
  }
  double distance(const Vec3& p) const { return level(p) / gradient(p).norm(); }
  Vec3 normal(const Vec3& p) const { return gradient(p).normalized(); }
};

/// A V-groove along y, open towards +z, its edge on the line x = 0, z = bottom. Exact in the
/// groove and in the walls; beneath the edge the distance to the nearer wall's plane.
struct Wedge {
  double half_angle = std::numbers::pi / 6.0;  ///< rad, between a wall and the z axis
  double bottom = -0.016;                      ///< m
  double distance(const Vec3& p) const {
    return (p.z() - bottom) * std::sin(half_angle) - std::abs(p.x()) * std::cos(half_angle);
  }
  Vec3 normal(const Vec3& p) const {
    return {p.x() < 0.0 ? std::cos(half_angle) : -std::cos(half_angle), 0.0, std::sin(half_angle)};
  }
};

/// A groove along y with upright walls and a flat floor, open towards +z. Exact in the free
/// space and, but for the two edges, in the solid.
struct Slot {
  double half_width = 0.004;  ///< m
  double floor = -0.012;      ///< m
  double distance(const Vec3& p) const {
    return std::min(half_width - std::abs(p.x()), p.z() - floor);
  }
  Vec3 normal(const Vec3& p) const {
    if (p.z() - floor < half_width - std::abs(p.x())) return Vec3::UnitZ();
    return p.x() < 0.0 ? Vec3::UnitX() : Vec3{-Vec3::UnitX()};
  }
};

/// A box about the origin. Exact everywhere.
struct Box {
  Vec3 half;  ///< m
  double distance(const Vec3& p) const {
    const Vec3 d = p.cwiseAbs() - half;
    return d.cwiseMax(0.0).norm() + std::min(d.maxCoeff(), 0.0);
  }
};

/// A block with a square hole through it along z: the paper's scene for the peg. The walls are
/// exact; at the block's rims the larger of the two distances.
struct Hole {
  double half_width = 0.00765;                 ///< m: the 15 mm peg and 0.15 mm on each side
  Vec3 half_block{0.02535, 0.02535, 0.01995};  ///< m
  double distance(const Vec3& p) const {
    const double wall = half_width - std::max(std::abs(p.x()), std::abs(p.y()));
    return std::max(Box{half_block}.distance(p), wall);
  }
};

/// A box that tells left from right: a ball on the patient's left (+x), a smaller one in front
/// (-y), the smallest on top (+z). Exact outside.
struct Marker {
  double half_box = 0.015;                                   ///< m
  double left = 0.006, anterior = 0.004, superior = 0.0025;  ///< m, radii; centres on the faces
  double distance(const Vec3& p) const {
    const double box = Box{Vec3::Constant(half_box)}.distance(p);
    const double balls = std::min({(p - half_box * Vec3::UnitX()).norm() - left,
                                   (p + half_box * Vec3::UnitY()).norm() - anterior,
                                   (p - half_box * Vec3::UnitZ()).norm() - superior});
    return std::min(box, balls);
  }
};

}  // namespace datasets::shapes
