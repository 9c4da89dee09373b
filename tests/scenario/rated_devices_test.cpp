// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/penetration.h"
#include "tests/scenario/trial.h"

// Every device of the table at its rated stiffness, in a hand's grip, in closed loop.

namespace {

using haptics::DeviceModel;
using haptics::HandMotion;
using haptics::TraceRow;
using haptics::Vec3;

/// What a hand made of a device.
struct Felt {
  double most_force = 0.0, most_torque = 0.0;  ///< N, N·m
  double shaking = 0.0;  ///< m/s, rms of the handle above 20 Hz, while something is touched
  double share = 1.0;    ///< of the stiffness that the guard of passivity left
  double energy = 0.0;   ///< J that the hand was given in all
  int contact = 0;       ///< ticks
  bool finite = true;
};

Felt feel(const DeviceModel& device, HandMotion motion, double stiffness, bool guarded = true) {
  static const Stage stage = stageOf("demo", namedTool("drill"));
  Felt felt;
  haptics::ClosedLoop loop;
  loop.scene = stage.scene;
  loop.isovalue = stage.isovalue;
  loop.coupling.stiffness = stiffness;
  loop.limits = haptics::limitsOf(device.rating);
  loop.limits.guard_passivity = guarded;
  // as a session does: no more in rotation than is rated
  const double angular =
      stiffness * stage.scene->tool.shell.inertia.eigenvalues().real().maxCoeff();
  if (device.rating.torque > 0.0 && angular > device.rating.angular_stiffness)
    loop.coupling.angular_stiffness = device.rating.angular_stiffness;
  loop.grip = device.heldBy({}, std::sqrt(stage.scene->tool.shell.inertia.trace() / 3.0));
  loop.linkage = device.linkage;
  const double depth = 0.5 * device.rating.force / stiffness;  // half of what it may push
  auto hand =
      haptics::Hand::aimed(motion, *stage.scene, stage.isovalue,
                           haptics::Hand::reachFor(depth, stiffness, loop.grip.stiffness), 1);
  if (!hand) throw std::runtime_error{hand.error().what};
  Vec3 slow = Vec3::Zero(), last = hand->at(0.0).translation();
  double squares = 0.0;
  const auto ran = loop.run(*hand, 4000, [&](const TraceRow& row) {
    felt.finite = felt.finite && row.sent_W.force.allFinite() && row.sent_W.torque.allFinite() &&
                  row.X_WH.matrix().allFinite();
    felt.most_force = std::max(felt.most_force, row.sent_W.force.norm());
    felt.most_torque = std::max(felt.most_torque, row.sent_W.torque.norm());
    const Vec3 velocity = (row.X_WH.translation() - last) / loop.period;
    last = row.X_WH.translation();
    slow += loop.period / 0.008 * (velocity - slow);
    if (row.contacts > 0 && row.time > 1.5) {  // beyond the ramp
      squares += (velocity - slow).squaredNorm();
      ++felt.contact;
    }
    felt.share = row.stiffness_share;
    felt.energy = row.energy;
    return true;
  });
  if (!ran) throw std::runtime_error{ran.error().what};
  felt.shaking = std::sqrt(squares / std::max(1, felt.contact));
  return felt;
}

class Rated : public testing::TestWithParam<DeviceModel> {};

TEST_P(Rated, IsStableAtItsRatedStiffnessThroughTapWedgePryAndHook) {
  const DeviceModel& device = GetParam();
  for (const HandMotion motion :
       {HandMotion::Tap, HandMotion::Wedge, HandMotion::Pry, HandMotion::Hook}) {
    SCOPED_TRACE(static_cast<int>(motion));
    const Felt felt = feel(device, motion, device.rating.stiffness);
    printf(
        "%-14s motion %d: force %.2f N, shaking %.4f m/s, share %.2f, energy %.2g J, contact %d\n",
        device.name.c_str(), int(motion), felt.most_force, felt.shaking, felt.share, felt.energy,
        felt.contact);
    EXPECT_TRUE(felt.finite);
    EXPECT_GT(felt.contact, 200);
    EXPECT_LE(felt.most_force, device.rating.force * (1.0 + 1e-12));
    EXPECT_LE(felt.most_torque, device.rating.torque * (1.0 + 1e-12));
    EXPECT_LT(felt.shaking, 0.02);
    EXPECT_EQ(felt.share, 1.0);
  }
}

std::vector<DeviceModel> rated() {
  std::vector<DeviceModel> models = haptics::deviceModels();
  std::erase_if(models, [](const DeviceModel& model) { return model.name != model.rating.id; });
  return models;
}

INSTANTIATE_TEST_SUITE_P(Devices, Rated, testing::ValuesIn(rated()), [](const auto& tested) {
  std::string name = tested.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

// the loop that this would find: four times as stiff as a sampled spring may be
TEST(Rated, AStifferLoopShakesAndIsEased) {
  DeviceModel device = *haptics::findDeviceModel("sigma.7");
  const Felt felt = feel(device, HandMotion::Tap, 30'000.0);
  printf("shaking %.4f share %.2f\n", felt.shaking, felt.share);
  EXPECT_GT(felt.shaking, 0.02);
  EXPECT_LT(felt.share, 0.6);
}

}  // namespace
