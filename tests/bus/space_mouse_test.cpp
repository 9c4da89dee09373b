// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "haptics/devices/catalogue.h"
#include "tests/bus/child.h"
#include "tests/bus/felt_sphere.h"
#include "tests/bus/space_mice.h"
#include "tests/support/sentence.h"

namespace {

using bus::As;
using bus::CapAxes;
using bus::Child;
using bus::comesTrue;
using bus::FeltSphere;
using bus::lineOf;
using haptics::ForceReason;
using haptics::ForceState;
using haptics::Pose;
using haptics::Vec3;

TEST(SpaceMouse, IsNotThereUntilItIsPluggedIn) {
  EXPECT_NE(lineOf(Child{As::Root, {"survey"}}.said(), "spacemouse").find("not-plugged-in"),
            std::string::npos);
  const auto refused = haptics::openDevice({"spacemouse"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "not-plugged-in");
}

TEST(SpaceMouse, AUserWithoutTheRuleIsToldOfItAndWithItOpensTheDevice) {
  const bus::UhidSpaceMouse mouse;
  const std::string line = lineOf(Child{As::User, {"survey"}}.said(), "spacemouse");
  EXPECT_NE(line.find("no-permission"), std::string::npos) << line;
  EXPECT_NE(line.find("70-palpate.rules"), std::string::npos) << line;
  const std::string refused = Child{As::User, {"open", "spacemouse"}}.said();
  EXPECT_TRUE(refused.starts_with("no-permission ")) << refused;

  ASSERT_EQ(chmod(mouse.node().c_str(), 0666), 0);
  const std::string granted = lineOf(Child{As::User, {"survey"}}.said(), "spacemouse");
  EXPECT_NE(granted.find(" none "), std::string::npos) << granted;
  EXPECT_EQ(Child(As::User, {"open", "spacemouse"}).said(), "opened\n");
}

TEST(SpaceMouse, WhatOnePalpateHasOpenAnotherDoesNotOpen) {
  const bus::UhidSpaceMouse mouse;
  auto device = haptics::openDevice({"spacemouse"});
  ASSERT_TRUE(device) << sentence(device.error());
  const std::string refused = Child{As::Root, {"open", "spacemouse"}}.said();
  EXPECT_TRUE(refused.starts_with("in-use ")) << refused;
  const auto twice = haptics::openDevice({"spacemouse"});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().reason, "in-use");
  device->reset();
  EXPECT_EQ(Child(As::Root, {"open", "spacemouse"}).said(), "opened\n");
}

/// Pushes the cap, again and again as a cap does, until the pose has gone `way` or longer.
template <class Mouse>
void movesThePose(Mouse& mouse, FeltSphere& sphere, const CapAxes& axes, const Vec3& way_W,
                  const Vec3& turn_W) {
  const Pose before = sphere.snapshot().X_WD;
  const auto gone = [&] { return Pose{before.inverse() * sphere.snapshot().X_WD}; };
  const Vec3 shift = before.linear().transpose() * way_W;
  const Eigen::AngleAxisd turn{
      turn_W.norm(), turn_W.norm() > 0.0 ? Vec3{turn_W.normalized()} : Vec3{Vec3::UnitX()}};
  EXPECT_TRUE(comesTrue([&] {
    mouse.move(axes);
    const Eigen::AngleAxisd turned{before.linear().transpose() * sphere.snapshot().X_WD.linear()};
    return gone().translation().dot(shift) >= shift.squaredNorm() && turned.angle() >= turn.angle();
  })) << axes[0]
      << ' ' << axes[1] << ' ' << axes[2];
  mouse.move({});
  EXPECT_TRUE(sphere.runs(50));
  // at rest again; across, nothing to speak of
  const Vec3 moved = sphere.snapshot().X_WD.translation() - before.translation();
  if (way_W.norm() > 0.0) {
    EXPECT_GT(moved.normalized().dot(way_W.normalized()), 0.999);
  }
  if (turn_W.norm() > 0.0) {
    const Eigen::AngleAxisd turned{sphere.snapshot().X_WD.linear() * before.linear().transpose()};
    EXPECT_GT(turned.axis().dot(turn_W.normalized()), 0.999);
    EXPECT_LT(moved.norm(), 1e-9);
  }
}

template <class Mouse>
void isFelt(Mouse& mouse) {
  auto device = haptics::openDevice({"spacemouse"});
  ASSERT_TRUE(device) << sentence(device.error());
  EXPECT_TRUE(comesTrue([&] { return mouse.lit() == 1; }));
  FeltSphere sphere{std::move(*device), Vec3::Zero()};
  sphere.arm();
  ASSERT_TRUE(sphere.runs(100));
  // the cap's Y is towards the user and its Z down; the base's y is up and its z to the user
  movesThePose(mouse, sphere, {350, 0, 0, 0, 0, 0}, {0.01, 0, 0}, {0, 0, 0});
  movesThePose(mouse, sphere, {0, 350, 0, 0, 0, 0}, {0, 0, 0.01}, {0, 0, 0});
  movesThePose(mouse, sphere, {0, 0, 350, 0, 0, 0}, {0, -0.01, 0}, {0, 0, 0});
  movesThePose(mouse, sphere, {0, 0, 0, 350, 0, 0}, {0, 0, 0}, {0.1, 0, 0});
  movesThePose(mouse, sphere, {0, 0, 0, 0, 0, -350}, {0, 0, 0}, {0, 0.1, 0});
  EXPECT_TRUE(sphere.runs(1000));
  EXPECT_TRUE(sphere.isArmed());
  EXPECT_EQ(sphere.snapshot().felt_W.force.norm(), 0.0);  // it has no motors
}

TEST(SpaceMouse, ACompactMovesThePoseOfTheServoLoop) {
  bus::UhidSpaceMouse mouse;
  isFelt(mouse);
}

TEST(SpaceMouse, ASpaceNavigatorMovesThePoseOfTheServoLoop) {
  bus::SpaceNavigatorEmulator mouse;
  const bus::UsbPort port{1, mouse};
  ASSERT_TRUE(comesTrue([] { return !bus::hidNode(0x046D, 0xC626).empty(); }));
  isFelt(mouse);
}

TEST(SpaceMouse, ButtonsArriveAndBytesThatAreNoReportDoNothing) {
  bus::UhidSpaceMouse mouse;
  auto device = haptics::openDevice({"spacemouse"});
  ASSERT_TRUE(device) << sentence(device.error());
  haptics::DeviceReading reading;
  const auto reads = [&](auto condition) {
    return comesTrue([&] { return (*device)->read(reading), condition(); });
  };
  mouse.report({});
  mouse.report({1});
  mouse.report({1, 0xFF, 0x7F, 0xFF, 0x7F, 0xFF, 0x7F});
  mouse.report(bus::Bytes(300, 0xFF));
  mouse.press(0b10);
  EXPECT_TRUE(reads([&] { return reading.buttons == 0b10; }));
  EXPECT_TRUE(reading.X_BD.isApprox(Pose::Identity(), 1e-12));
  mouse.press(0);
  EXPECT_TRUE(reads([&] { return reading.buttons == 0; }));
}

TEST(SpaceMouse, PulledOutItIsLostAndUsedAgainOnceReplugged) {
  std::optional<bus::UhidSpaceMouse> mouse{std::in_place};
  auto device = haptics::openDevice({"spacemouse"});
  ASSERT_TRUE(device) << sentence(device.error());
  auto sphere = std::make_unique<FeltSphere>(std::move(*device), Vec3::Zero());
  sphere->arm();
  ASSERT_TRUE(sphere->runs(50));
  mouse->move({350, 0, 0, 0, 0, 0});
  mouse.reset();
  EXPECT_TRUE(comesTrue([&] { return sphere->snapshot().force_state == ForceState::Fault; }));
  EXPECT_EQ(sphere->snapshot().reason, ForceReason::Lost);
  EXPECT_EQ(sphere->snapshot().trouble, haptics::Trouble::Lost);
  EXPECT_FALSE(sphere->isArmed());
  const Vec3 there = sphere->snapshot().X_WD.translation();
  EXPECT_TRUE(sphere->runs(50));
  EXPECT_EQ(sphere->snapshot().X_WD.translation(), there);
  sphere.reset();
  EXPECT_FALSE(haptics::openDevice({"spacemouse"}));

  mouse.emplace();
  EXPECT_TRUE(haptics::openDevice({"spacemouse"}));
}

}  // namespace
