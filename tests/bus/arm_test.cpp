// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <optional>

#include "haptics/devices/catalogue.h"
#include "tests/bus/arm_board.h"
#include "tests/bus/child.h"
#include "tests/bus/felt_sphere.h"
#include "tests/support/sentence.h"

namespace {

using bus::ArmBoardEmulator;
using bus::As;
using bus::Child;
using bus::comesTrue;
using bus::FeltSphere;
using bus::lineOf;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::ForceReason;
using haptics::ForceState;
using haptics::Trouble;
using haptics::Vec3;

const Vec3 kPressed{0.0, 0.0, FeltSphere::kTouch - 0.003};

/// Opened, zeroed by its user, and held above the sphere.
std::unique_ptr<haptics::Device> openedArm(ArmBoardEmulator& arm) {
  auto device = haptics::openDevice({"woodenhaptics"});
  if (!device) {
    ADD_FAILURE() << sentence(device.error());
    return nullptr;
  }
  DeviceReading reading;
  const auto reads = [&](const Vec3& force_B, auto&& done) {
    return comesTrue([&] {
      const DeviceStatus status = (*device)->read(reading);
      (*device)->write({.force = force_B});
      return done(status);
    });
  };
  const Vec3 push{1.0, 1.0, 1.0};
  EXPECT_TRUE(reads(push, [&](DeviceStatus status) {
    return status == DeviceStatus::NotReady && reading.trouble == Trouble::NeedsCalibration;
  }));
  EXPECT_TRUE(reads(push, [&](DeviceStatus) { return arm.commands() > 100; }));
  EXPECT_EQ(arm.forced(), 0);  // its counts are nobody's yet
  arm.askForZero();
  EXPECT_TRUE(reads(Vec3::Zero(), [](DeviceStatus status) { return status == DeviceStatus::Ok; }));
  EXPECT_LT((reading.X_BD.translation() - Vec3(0.0, 0.205, 0.025)).norm(), 1e-4);
  arm.lead(FeltSphere::kAbove);
  EXPECT_TRUE(reads(Vec3::Zero(), [&](DeviceStatus) { return arm.isThere(); }));
  return std::move(*device);
}

TEST(Arm, IsListedWhereItIsAndOpenedWithTheRule) {
  EXPECT_NE(lineOf(Child{As::Root, {"survey"}}.said(), "woodenhaptics").find("not-plugged-in"),
            std::string::npos);
  const ArmBoardEmulator arm;
  const std::string line = lineOf(Child{As::User, {"survey"}}.said(), "woodenhaptics");
  EXPECT_NE(line.find("no-permission"), std::string::npos) << line;
  EXPECT_NE(line.find("70-palpate.rules"), std::string::npos) << line;
  ASSERT_EQ(chmod(arm.node().c_str(), 0666), 0);
  const std::string granted = lineOf(Child{As::User, {"survey"}}.said(), "woodenhaptics");
  EXPECT_NE(granted.find(arm.node() + " none "), std::string::npos) << granted;
  EXPECT_EQ(Child(As::User, {"open", "woodenhaptics"}).said(), "opened\n");
}

TEST(Arm, IsPushedOutOfTheSphereAsTheServoLoopWants) {
  std::optional<ArmBoardEmulator> arm{std::in_place};
  auto device = openedArm(*arm);
  ASSERT_NE(device, nullptr);
  FeltSphere sphere{std::move(device)};
  ASSERT_TRUE(sphere.runs(200));
  EXPECT_EQ(arm->forced(), 0);  // nobody has armed it
  sphere.arm();
  arm->lead(kPressed);
  ASSERT_TRUE(comesTrue([&] {
    return arm->isThere() && sphere.snapshot().force_state == ForceState::On &&
           arm->force_B().z() > 2.5;
  }));
  // a thousand ticks at rest: 3 N towards the user, by what the emulator makes of the currents
  const std::uint64_t until = sphere.snapshot().tick + 1000;
  double worst = 0.0;
  while (sphere.snapshot().tick < until) {
    const Vec3 force = arm->force_B();
    worst = std::max(worst, (force - Vec3(0.0, 0.0, 3.0)).norm());
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  EXPECT_LT(worst, 0.25);  // its counts are 0.06 mm apart, and the spring has 1000 N/m
  const haptics::Snapshot last = sphere.snapshot();
  EXPECT_EQ(last.late_ticks, 0u);
  // out of the sphere there is nothing
  arm->lead(FeltSphere::kAbove);
  ASSERT_TRUE(comesTrue([&] { return arm->isThere(); }));
  EXPECT_TRUE(comesTrue([&] { return arm->force_B().norm() == 0.0; }));
  // and pulled out under force it is lost for good
  arm->lead(kPressed);
  ASSERT_TRUE(comesTrue([&] { return arm->isThere() && arm->force_B().z() > 2.5; }));
  arm.reset();
  ASSERT_TRUE(comesTrue([&] { return sphere.snapshot().force_state == ForceState::Fault; }));
  EXPECT_EQ(sphere.snapshot().reason, ForceReason::Lost);
  EXPECT_FALSE(sphere.isArmed());
}

TEST(Arm, ClosedItLeavesTheMotorsAtZero) {
  ArmBoardEmulator arm;
  auto device = openedArm(arm);
  ASSERT_NE(device, nullptr);
  {
    FeltSphere sphere{std::move(device)};
    sphere.arm();
    arm.lead(kPressed);
    ASSERT_TRUE(comesTrue([&] { return arm.isThere() && arm.force_B().z() > 2.5; }));
  }
  // the kernel hands a board its reports later than it takes them
  EXPECT_TRUE(comesTrue([&] { return arm.force_B().norm() == 0.0; }));
}

}  // namespace
