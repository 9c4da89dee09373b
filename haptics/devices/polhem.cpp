// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/polhem.h"

#include <cmath>
#include <numbers>

namespace haptics {
namespace {

using Vec2 = Eigen::Vector2d;

// m; the letters are those of the header
constexpr double kL0 = 0.034, kL1 = 0.165, kL2 = 0.025, kL3 = 0.190, kL4 = 0.034, kL5 = 0.1308;
constexpr double kOriginOut = 0.2045, kOriginUp = 0.0325;  // m, the workspace's middle
constexpr double kDeadPoint = 0.02;                        // sine of the forearm's angle to the rod

constexpr double kTurn = 2.0 * std::numbers::pi;
// capstan over sector, by the diameters in mm, and which way the body turns with its motor
constexpr std::array<double, 3> kRatio{28.8534 / 175.0, -13.6981 / 100.0, 13.7281 / 100.0};
constexpr double kMotorCounts = 4096.0, kGimbalCounts = 1024.0;  // a turn

Vec2 along(double angle) noexcept { return {std::cos(angle), std::sin(angle)}; }
Vec2 across(const Vec2& v) noexcept { return {-v.y(), v.x()}; }

std::optional<ArmState> stateOf(const BoardCounts& counts) noexcept {
  return polhemArm(polhemAngles(counts));
}

constexpr std::array kBoards{kTeensyBoard};
constexpr CapstanArm kPolhem{
    .driver = "polhem",
    .boards = kBoards,
    .rest = kPolhemRest,
    .ratio = kRatio,
    .torque_constant = {0.0603, 0.0538, 0.0538},
    .state = stateOf,
};

}  // namespace

const CapstanArm& polhem() { return kPolhem; }

PolhemAngles polhemAngles(const BoardCounts& counts) noexcept {
  PolhemAngles angles{};
  for (std::size_t i = 0; i < 3; ++i) angles[i] = counts[i] * (kTurn / kMotorCounts) * kRatio[i];
  // the gimbal's encoders come in reverse order, and turn against their bodies
  for (std::size_t i = 0; i < 3; ++i) angles[3 + i] = -counts[5 - i] * (kTurn / kGimbalCounts);
  return angles;
}

std::optional<ArmState> polhemArm(const PolhemAngles& angles) noexcept {
  const Vec2 u_b = along(angles[1]), u_c = along(angles[2]);
  const Vec2 E = Vec2{kL0 / 2, 0.0} + kL1 * u_b;
  const Vec2 K = Vec2{-kL0 / 2, 0.0} + kL2 * u_c;

  // the triangle of elbow, crank's end and forearm's end, by its angle at the elbow
  const Vec2 EK = K - E;
  const double s = EK.norm();
  const double cosine = (kL4 * kL4 + s * s - kL3 * kL3) / (2.0 * kL4 * s);
  if (!(std::abs(cosine) < 1.0)) return std::nullopt;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const Vec2 e = EK / s;
  const Vec2 u_l = -(cosine * e - sine * across(e));
  const Vec2 w = E - kL4 * u_l - K;
  const double lever = w.dot(across(u_l));
  if (!(std::abs(lever) > kDeadPoint * kL3)) return std::nullopt;

  const Vec2 G = E + kL5 * u_l;
  const double dl_db = kL1 * w.dot(across(u_b)) / (kL4 * lever);
  const double dl_dc = -kL2 * w.dot(across(u_c)) / (kL4 * lever);
  const Vec2 dG_db = kL1 * across(u_b) + kL5 * across(u_l) * dl_db;
  const Vec2 dG_dc = kL5 * across(u_l) * dl_dc;

  // out of the arm's plane
  const Vec2 u_a = along(angles[0]);
  const auto out = [&](const Vec2& v) { return Vec3{v.x() * u_a.x(), v.x() * u_a.y(), v.y()}; };
  Mat3 J;
  J.col(0) = G.x() * Vec3{-u_a.y(), u_a.x(), 0.0};
  J.col(1) = out(dG_db);
  J.col(2) = out(dG_dc);

  using Eigen::AngleAxisd;
  const double l = std::atan2(u_l.y(), u_l.x());
  const Quat rotation = AngleAxisd{angles[0], Vec3::UnitZ()} * AngleAxisd{-l, Vec3::UnitY()} *
                        AngleAxisd{angles[3], Vec3::UnitX()} *
                        AngleAxisd{angles[4], Vec3::UnitY()} * AngleAxisd{angles[5], Vec3::UnitX()};
  const Mat3 R_BH = makersAxes();
  ArmState state;
  state.X_BD = poseOf(R_BH * (out(G) - Vec3{kOriginOut, 0.0, kOriginUp}),
                      Quat{R_BH * rotation.toRotationMatrix() * R_BH.transpose()});
  state.J_B = R_BH * J;
  return state;
}

std::vector<DeviceEntry> surveyPolhem() { return surveyArms(kPolhem); }

Expected<std::unique_ptr<Device>> openPolhem(const OpenRequest& request) {
  return openArm(kPolhem, request);
}

}  // namespace haptics
