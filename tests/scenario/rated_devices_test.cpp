// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/penetration.h"
#include "tests/scenario/trial.h"
#include "tests/support/made.h"
#include "tests/support/sentence.h"

// Every device of the table at its rated stiffness, in a hand's grip, in closed loop.

namespace {

using haptics::DeviceModel;
using haptics::HandMotion;
using haptics::TraceRow;
using haptics::Vec3;

/// What a hand made of a device.
struct Felt {
  double most_force = 0.0, most_torque = 0.0;  ///< N, N·m
  /// m/s, rms of the handle above 20 Hz while something is touched, in two halves of the time.
  double shaking[2] = {0.0, 0.0};
  double share = 1.0;   ///< of the stiffness that the guard of passivity left
  double energy = 0.0;  ///< J that the hand was given in all
  int contact = 0;      ///< ticks
  bool finite = true;
};

Felt feel(const DeviceModel& device, HandMotion motion, double stiffness, bool guarded,
          haptics::ServoRate rate = {}) {
  static const Stage stage = stageOf("demo", namedTool("drill"));
  Felt felt;
  haptics::ClosedLoop loop;
  loop.scene = stage.scene;
  loop.settings.isovalue = stage.isovalue;
  loop.settings.stiffness = stiffness;
  loop.limits = haptics::limitsOf(device.rating);
  loop.limits.guard_passivity = guarded;
  // as a session does: no more in rotation than is rated
  const double inertia = haptics::largestInertia(stage.scene->tool.shell.inertia);
  if (device.rating.torque > 0.0 && stiffness * inertia > device.rating.angular_stiffness)
    loop.settings.angular_stiffness = device.rating.angular_stiffness;
  loop.grip = device.heldBy({}, std::sqrt(stage.scene->tool.shell.inertia.trace() / 3.0));
  loop.linkage = device.linkage;
  loop.rate = rate;
  // half of what it may push, but for the Premiums, whose tools slip by millimetres then
  const double depth = std::min(0.5 * device.rating.force / stiffness, 3e-3);
  const auto hand =
      haptics::Hand::aimed(motion, *stage.scene, stage.isovalue,
                           haptics::Hand::reachFor(depth, stiffness, loop.grip.stiffness), 1);
  if (!hand) throw std::runtime_error{sentence(hand.error())};
  Vec3 slow = Vec3::Zero(), last = hand->at(0.0).translation();
  int ticks[2] = {0, 0};
  const auto ran = loop.run(*hand, 5 * rate.hz, [&](const TraceRow& row) {
    felt.finite = felt.finite && row.sent_W.force.allFinite() && row.sent_W.torque.allFinite() &&
                  row.X_WH.matrix().allFinite();
    felt.most_force = std::max(felt.most_force, row.sent_W.force.norm());
    felt.most_torque = std::max(felt.most_torque, row.sent_W.torque.norm());
    const Vec3 velocity = (row.X_WH.translation() - last) / loop.rate.period();
    last = row.X_WH.translation();
    slow += loop.rate.period() / 0.008 * (velocity - slow);
    if (row.contacts > 0 && row.time > 1.0) {  // beyond the ramp
      const int half = row.time > 3.0 ? 1 : 0;
      felt.shaking[half] += (velocity - slow).squaredNorm();
      ++ticks[half];
    }
    felt.share = row.stiffness_share;
    felt.energy = row.energy;
    return true;
  });
  if (!ran) throw std::runtime_error{sentence(ran.error())};
  for (int half = 0; half < 2; ++half)
    felt.shaking[half] = std::sqrt(felt.shaking[half] / std::max(1, ticks[half]));
  felt.contact = ticks[0] + ticks[1];
  return felt;
}

/// A device at one of the rates that its link carries.
struct AtRate {
  DeviceModel device;
  haptics::ServoRate rate;

  friend void PrintTo(const AtRate& tested, std::ostream* out) {
    *out << tested.device.name << " at " << tested.rate.hz << " Hz";
  }
};

class Rated : public testing::TestWithParam<AtRate> {};

// what it shakes is what a tap and a slip strike up, in either half of the time; it does not grow
TEST_P(Rated, IsStableAtItsRatedStiffnessThroughTapWedgePryAndHook) {
  const auto& [device, rate] = GetParam();
  for (const HandMotion motion :
       {HandMotion::Tap, HandMotion::Wedge, HandMotion::Pry, HandMotion::Hook}) {
    SCOPED_TRACE(static_cast<int>(motion));
    const Felt felt = feel(device, motion, device.rating.stiffness, false, rate);
    std::printf("%-13s %d: %.2f N, shaking %.1f and %.1f mm/s, %.2g mJ\n", device.name.c_str(),
                static_cast<int>(motion), felt.most_force, 1e3 * felt.shaking[0],
                1e3 * felt.shaking[1], 1e3 * felt.energy);
    EXPECT_TRUE(felt.finite);
    EXPECT_GT(felt.contact, 400 * rate.hz / 1000);
    EXPECT_LE(felt.most_force, device.rating.force * (1.0 + 1e-12));
    EXPECT_LE(felt.most_torque, device.rating.torque * (1.0 + 1e-12));
    EXPECT_LT(felt.shaking[0], 0.07);
    EXPECT_LT(felt.shaking[1], 1.5 * felt.shaking[0] + 0.006);
  }
}

// and the guard has nothing to do where the hand only pries or hooks
TEST_P(Rated, KeepsItsStiffnessWhenPryingAndHooking) {
  const auto& [device, rate] = GetParam();
  for (const HandMotion motion : {HandMotion::Pry, HandMotion::Hook}) {
    const Felt felt = feel(device, motion, device.rating.stiffness, true, rate);
    EXPECT_EQ(felt.share, 1.0) << static_cast<int>(motion);
  }
}

// Under a sanitizer one without motors for torque, and one with them. At 4 kHz a force is as late
// as the link's thread may bring it, at 1 kHz in time.
std::vector<AtRate> rated() {
  std::vector<AtRate> all;
  for (const DeviceModel& model : haptics::deviceModels()) {
    if (model.name != model.rating.id ||
        (made::fewDevices() && model.name != "falcon" && model.name != "sigma.7"))
      continue;
    all.push_back({model, {}});
    const haptics::ServoRate most = rateOf(model.rating);
    if (most.hz == 1000 || made::fewDevices()) continue;
    all.push_back({model, most});
    all.back().device.linkage.delay = model.rating.delay / most.period();
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Devices, Rated, testing::ValuesIn(rated()), [](const auto& tested) {
  std::string name = tested.param.device.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  if (tested.param.rate.hz > 1000) name += "At" + std::to_string(tested.param.rate.hz);
  return name;
});

// What the tests above would find, and the guard eases: three times as stiff as a sampled spring
// may be.
TEST(Rated, AStifferLoopShakesAndItsGuardEasesIt) {
  const DeviceModel device = *haptics::findDeviceModel("omega.6");
  for (const HandMotion motion : {HandMotion::Tap, HandMotion::Wedge}) {
    SCOPED_TRACE(static_cast<int>(motion));
    const Felt bare = feel(device, motion, 15'000.0, false);
    const Felt eased = feel(device, motion, 15'000.0, true);
    std::printf("bare %.1f and %.1f, eased %.1f and %.1f mm/s, share %.2f\n", 1e3 * bare.shaking[0],
                1e3 * bare.shaking[1], 1e3 * eased.shaking[0], 1e3 * eased.shaking[1], eased.share);
    if (motion == HandMotion::Tap) {
      EXPECT_GT(bare.shaking[0], 0.07);
    } else {  // not of a tap: each blow shakes the handle anew, with any stiffness
      EXPECT_GT(bare.shaking[1], 0.04);
      EXPECT_LT(eased.shaking[1], 0.4 * bare.shaking[1]);
    }
    EXPECT_LT(eased.share, 0.6);
  }
}

// The tests above would also find a rotation that is stiffer than a session allows. With the
// session's cap the same stiffness is calm: the tip of the drill gives way by turning.
TEST(Rated, AStifferRotationShakesAndItsGuardEasesIt) {
  const DeviceModel device = *haptics::findDeviceModel("sigma.7");
  DeviceModel stiffer = device;
  stiffer.rating.angular_stiffness *= 10.0;
  const Felt capped = feel(device, HandMotion::Wedge, 30'000.0, false);
  const Felt bare = feel(stiffer, HandMotion::Wedge, 30'000.0, false);
  const Felt eased = feel(stiffer, HandMotion::Wedge, 30'000.0, true);
  std::printf("capped %.1f, bare %.1f, eased %.1f mm/s, share %.2f\n", 1e3 * capped.shaking[0],
              1e3 * bare.shaking[0], 1e3 * eased.shaking[0], eased.share);
  EXPECT_LT(capped.shaking[0], 0.02);
  EXPECT_GT(bare.shaking[0], 0.07);
  EXPECT_LT(eased.shaking[1], 0.4 * bare.shaking[1]);
  EXPECT_LT(eased.share, 0.6);
}

}  // namespace
