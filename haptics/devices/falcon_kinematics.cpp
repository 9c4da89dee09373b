// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/falcon_kinematics.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

namespace haptics::falcon {
namespace {

// m: driven arm, rods, and the offsets of their joints
constexpr double kArm = 0.060, kRod = 0.1025, kGripOffset = 0.01443, kRodEnds = 2 * 0.01125;
constexpr double kSide = -0.025, kBaseOut = 0.0400, kBaseSide = -0.02309;
constexpr double kCentre = 0.125;  // m: B's origin before the plane of the arms' axes

// the legs stand at 105, -15 and -135 degrees about z
struct Azimuth {
  double cos, sin;
};
constexpr std::array<Azimuth, 3> kAzimuths{{{-0.25881904510252076, 0.96592582628906829},
                                            {0.96592582628906829, -0.25881904510252076},
                                            {-0.70710678118654752, -0.70710678118654752}}};

// what the grip can reach, with room to spare for a mechanism that is not quite as drawn
constexpr double kReachAcross = 0.075, kReachAlong = 0.062;  // m, from B's origin

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr double kSolved = 1e-10;        // rad
constexpr double kLongestStep = 0.03;    // m, of Newton's
constexpr double kWorstCondition = 300;  // of J, by Frobenius norms

bool isReachable(const Vec3& p_B) noexcept {
  return std::hypot(p_B.x(), p_B.y()) <= kReachAcross && std::abs(p_B.z()) <= kReachAlong;
}

}  // namespace

double angleOf(std::int16_t encoder) noexcept {
  // 1280 counts a turn of a shaft of 14.25 mm, which drives a sector of 110 mm
  constexpr double kCount = 360.0 / 1280.0 * 14.25 / 110.0, kAtZero = 35.0;  // degrees
  return (kCount * encoder + kAtZero) * kRadians;
}

std::optional<LegAngles> legsAt(const Vec3& p_B) noexcept {
  LegAngles legs;
  for (int i = 0; i < 3; ++i) {
    // the grip in the leg's frame: u out, v across, w along z
    const auto [cos, sin] = kAzimuths[std::size_t(i)];
    const double u = p_B.x() * cos + p_B.y() * sin - kBaseOut;
    const double v = -p_B.x() * sin + p_B.y() * cos - kBaseSide;
    const double w = p_B.z() + kCentre;
    const double across = (v + kSide) / kRod;
    if (!(std::abs(across) < 1.0) || !(w > 0.0)) return std::nullopt;
    const double rods = kRodEnds + kRod * std::sqrt(1.0 - across * across);

    // a quadratic in tan(theta1 / 2); this form of its root does not cancel where the leading
    // coefficient is zero, which it is in the middle of the workspace
    const double out = u + kGripOffset;
    const double square = w * w + out * out + kArm * kArm - rods * rods;
    const double constant = square - 2.0 * kArm * out, leading = square + 2.0 * kArm * out;
    const double half = 2.0 * kArm * w;
    const double discriminant = half * half - constant * leading;
    if (!(discriminant >= 0.0)) return std::nullopt;
    legs.theta1[i] = 2.0 * std::atan(constant / (half + std::sqrt(discriminant)));
    legs.theta2[i] =
        std::atan2(w - kArm * std::sin(legs.theta1[i]), out - kArm * std::cos(legs.theta1[i]));
    legs.theta3[i] = std::acos(across);
  }
  return legs;
}

Mat3 velocityJacobian(const LegAngles& legs) noexcept {
  Mat3 J;
  for (int i = 0; i < 3; ++i) {
    const auto [cos, sin] = kAzimuths[std::size_t(i)];
    const double S = std::sin(legs.theta3[i]), C = std::cos(legs.theta3[i]);
    const double c2 = std::cos(legs.theta2[i]), s2 = std::sin(legs.theta2[i]);
    const Vec3 along{cos * c2 * S - sin * C, sin * c2 * S + cos * C, s2 * S};
    J.row(i) = along.transpose() / (-kArm * S * std::sin(legs.theta1[i] - legs.theta2[i]));
  }
  return J;
}

namespace {

/// A Newton iteration.
std::optional<Vec3> solve(const Vec3& theta1, const Vec3& start_B) noexcept {
  Vec3 p = start_B;
  auto legs = legsAt(p);
  if (!legs) return std::nullopt;
  double error = (theta1 - legs->theta1).norm();
  for (int i = 0; i < 20; ++i) {
    if (error < kSolved) return p;
    Vec3 step = velocityJacobian(*legs).inverse() * (theta1 - legs->theta1);
    if (!step.allFinite()) return std::nullopt;
    if (const double length = step.norm(); length > kLongestStep) step *= kLongestStep / length;

    // a step that brings nothing, or leads where the legs do not reach, is halved
    bool nearer = false;
    for (int half = 0; half < 6 && !nearer; ++half, step *= 0.5) {
      const Vec3 tried = p + step;
      const auto there = legsAt(tried);
      if (!there) continue;
      const double left = (theta1 - there->theta1).norm();
      if (!(left < error)) continue;
      nearer = true;
      p = tried;
      legs = there;
      error = left;
    }
    if (!nearer) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> positionOf(const Vec3& theta1, const Vec3& start_B) noexcept {
  // from a start far off the iteration may run aground at the brink of the reach
  auto p_B = solve(theta1, start_B);
  if (!p_B) p_B = solve(theta1, Vec3::Zero());
  return p_B && isReachable(*p_B) ? p_B : std::nullopt;
}

Vec3 torquesFor(const LegAngles& legs, const Vec3& force_B) noexcept {
  const Mat3 J = velocityJacobian(legs), inverse = J.inverse();
  if (!(J.norm() * inverse.norm() <= kWorstCondition)) return Vec3::Zero();
  const Vec3 torques = inverse.transpose() * force_B;
  const double norm = torques.norm();
  if (!std::isfinite(norm)) return Vec3::Zero();
  return norm > kMostTorque ? Vec3{torques * (kMostTorque / norm)} : torques;
}

}  // namespace haptics::falcon
