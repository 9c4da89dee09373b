// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/skull_shape.h"

#include <algorithm>
#include <cmath>

#include "datasets/phantoms/noise.h"

namespace datasets::skull {
namespace {

constexpr float kFar = 1e3f;  // mm: further than anything in the head

/// The smaller of two distances, rounded off over `blend` where they meet.
float united(float a, float b, float blend) {
  const float gap = std::abs(a - b);
  if (gap >= blend) return std::min(a, b);
  const float h = blend - gap;
  return std::min(a, b) - h * h / (4.0f * blend);
}

float ellipsoidDistance(const Vec3f& p, const Vec3f& radii) {
  const Vec3f inverse = radii.cwiseInverse(), q = p.cwiseProduct(inverse);
  const float k0 = q.norm();
  if (k0 < 1e-3f) return -radii.minCoeff();
  return k0 * (k0 - 1.0f) / q.cwiseProduct(inverse).norm();
}

float length(float x, float y) { return std::sqrt(x * x + y * y); }

}  // namespace

float Primitive::distance(const Vec3f& p) const {
  const Vec3f q = p - a;
  switch (kind) {
    case Kind::Ellipsoid:
      return ellipsoidDistance(
          {yaw_cos * q.x() + yaw_sin * q.y(), yaw_cos * q.y() - yaw_sin * q.x(), q.z()}, b);
    case Kind::Cone: {
      const Vec3f axis = (b - a).cwiseProduct(squash), r = q.cwiseProduct(squash);
      const float t = std::clamp(r.dot(axis) / axis.squaredNorm(), 0.0f, 1.0f);
      return (r - t * axis).norm() - (ra + t * (rb - ra));
    }
    case Kind::Arch:
      break;
  }
  // a horseshoe open to the back: an ellipse's rim b.x by b.y, ra to either side, rb up and down
  const float rho = length(q.x() / b.x(), q.y() / b.y());
  const float steep = length(q.x() / (b.x() * b.x()), q.y() / (b.y() * b.y()));
  const float aside = std::abs(rho * (rho - 1.0f) / std::max(steep, 1e-4f));
  const float u = aside - ra + 1.5f, v = std::abs(q.z()) - rb + 1.5f;
  const float slab =
      length(std::max(u, 0.0f), std::max(v, 0.0f)) + std::min(std::max(u, v), 0.0f) - 1.5f;
  return std::max(slab, q.y() - b.z());
}

void Primitive::bounds(Vec3f& middle, Vec3f& half) const {
  switch (kind) {
    case Kind::Ellipsoid: {
      const float wide = std::max(b.x(), b.y());
      middle = a;
      half = yaw_sin == 0.0f ? b : Vec3f{wide, wide, b.z()};
      return;
    }
    case Kind::Cone:
      middle = 0.5f * (a + b);
      half = 0.5f * (b - a).cwiseAbs() + std::max(ra, rb) * squash.cwiseInverse();
      return;
    case Kind::Arch:
      middle = a;
      half = {b.x() + ra, std::max(b.y() + ra, b.z()), rb};
      return;
  }
}

float distanceTo(const Solid& solid, const Vec3f& p) {
  float least = kFar;
  for (const Primitive& primitive : solid)
    least = united(least, primitive.distance(p), primitive.blend);
  return least;
}

Solid near(const Solid& solid, const Vec3f& middle, const Vec3f& half, float margin) {
  Solid kept;
  for (const Primitive& primitive : solid) {
    Vec3f centre, reach;
    primitive.bounds(centre, reach);
    const Vec3f gap = (centre - middle).cwiseAbs() - reach - half;
    if (gap.maxCoeff() <= margin + primitive.blend) kept.push_back(primitive);
  }
  return kept;
}

float cavityDistance(const Vec3f& p) {
  // the vault's inside: cerebrum, forehead, cerebellum
  float vault = ellipsoidDistance(p - Vec3f{0, 12, 34}, {65, 77.5f, 58.5f});
  vault = united(vault, ellipsoidDistance(p - Vec3f{0, -36, 42}, {45, 42, 30}), 12.0f);
  vault = united(vault, ellipsoidDistance(p - Vec3f{0, 50, 4}, {47, 37, 33}), 10.0f);
  // its floor falls in three steps from front to back, over the petrous ridge
  const auto step = [&](float at, float width) {
    const float t = std::clamp((p.y() - at) / width + 0.5f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
  };
  const float sella = 10.0f * std::exp(-p.x() * p.x() / 150.0f);
  const float ridge = 12.0f * std::exp(-(p.y() - 12.0f) * (p.y() - 12.0f) / 40.0f);
  const float floor = 15.0f - (34.0f - sella) * step(-26, 16) - 8.0f * step(16, 14) + ridge;
  return std::max(vault, 0.7f * (floor - p.z()));
}

float relief(const Vec3f& p) {
  const float rough = 0.35f * noise::smooth(p.x() / 6, p.y() / 6, p.z() / 6, 11) +
                      0.15f * noise::smooth(p.x() / 2, p.y() / 2, p.z() / 2, 12);
  if (p.z() < 20.0f) return rough;
  // the sutures wander; each is a groove about a millimetre wide and deep
  const float wander = 2.2f * noise::smooth(p.x() / 4, p.y() / 4, p.z() / 4, 13) +
                       1.2f * noise::smooth(p.x() / 1.7f, p.y() / 1.7f, p.z() / 1.7f, 14);
  const auto groove = [](float d) { return 1.1f * std::exp(-d * d / 0.8f); };
  const float crown = p.y() + 14.0f - 0.12f * (p.z() - 60.0f) + wander;
  const float lambda = p.y() - 78.0f + 0.45f * std::abs(p.x()) + 0.5f * (p.z() - 62.0f) + wander;
  float depth = groove(crown);
  if (crown > 0.0f && lambda < 0.0f && p.z() > 50.0f) depth += groove(p.x() + wander);
  if (p.y() > 30.0f) depth += groove(lambda * 0.8f);
  return rough + depth;
}

}  // namespace datasets::skull
