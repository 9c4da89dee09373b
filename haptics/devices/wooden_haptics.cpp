// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/wooden_haptics.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace haptics {
namespace {

constexpr double kLa = 0.080, kLb = 0.205, kLc = 0.245;  // m
constexpr double kOriginOut = 0.220, kOriginUp = 0.080;  // m, the workspace's middle
constexpr double kRadianPerCount = 2.0 * std::numbers::pi / 2000.0;
// capstan over sector, by the diameters in mm
constexpr std::array<double, 3> kRatio{10.0 / 160.0, 10.0 / 120.0, 10.0 / 120.0};
constexpr int kNoGimbal = 100;  // counts

constexpr std::array kBoards{kMbedBoard, kTeensyBoard};
constexpr CapstanArm kWooden{
    .driver = "woodenhaptics",
    .boards = kBoards,
    .rest = kWoodenRest,
    .ratio = kRatio,
    .torque_constant = {0.0603, 0.0603, 0.0603},
    .state = woodenArm,
};

}  // namespace

std::optional<ArmState> woodenArm(const BoardCounts& counts) noexcept {
  for (std::size_t i = 3; i < counts.size(); ++i)
    if (std::abs(counts[i]) > kNoGimbal) return std::nullopt;
  const double a = counts[0] * kRadianPerCount * kRatio[0];
  const double b = counts[1] * kRadianPerCount * kRatio[1];
  const double c = counts[2] * kRadianPerCount * kRatio[2];

  const double r = kLb * std::sin(b) + kLc * std::sin(c);
  const double z = kLa + kLb * std::cos(b) - kLc * std::cos(c);
  const Vec3 out{std::cos(a), std::sin(a), 0.0};
  Mat3 J;
  J.col(0) = r * Vec3{-std::sin(a), std::cos(a), 0.0};
  J.col(1) = kLb * (std::cos(b) * out - std::sin(b) * Vec3::UnitZ());
  J.col(2) = kLc * (std::cos(c) * out + std::sin(c) * Vec3::UnitZ());

  const Mat3 R_BH = makersAxes();
  ArmState state;
  state.X_BD = poseOf(R_BH * (r * out + Vec3{-kOriginOut, 0.0, z - kOriginUp}), Quat::Identity());
  state.J_B = R_BH * J;
  return state;
}

const CapstanArm& woodenHaptics() { return kWooden; }

std::vector<DeviceEntry> surveyWoodenHaptics() { return surveyArms(kWooden); }

Expected<std::unique_ptr<Device>> openWoodenHaptics(const OpenRequest& request) {
  return openArm(kWooden, request);
}

}  // namespace haptics
