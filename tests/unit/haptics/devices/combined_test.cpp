// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/combined.h"

#include <gtest/gtest.h>

#include <memory>

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Mat3;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;

/// A device in the test's hand: it gives what it is told to.
class Told final : public haptics::Device {
 public:
  const haptics::DeviceRating& rating() const noexcept override { return rated; }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    ++reads;
    if (status == DeviceStatus::Lost)
      reading.trouble = gives.trouble;
    else if (status != DeviceStatus::Stale)
      reading = gives;
    return status;
  }
  DeviceStatus write(const Wrench& wrench) noexcept override {
    ++writes;
    last = wrench;
    return status;
  }
  bool inStep() const noexcept override { return in_step; }
  std::int64_t awaitReading(std::int64_t until_ns) noexcept override {
    awaited_until = until_ns;
    return in_step ? 43 : 0;
  }
  void stop() noexcept override { stopped = true; }
  void resume() noexcept override { stopped = false; }

  DeviceReading gives;
  DeviceStatus status = DeviceStatus::Ok;
  haptics::DeviceRating rated;
  Wrench last;
  int reads = 0, writes = 0;
  bool stopped = false, in_step = false;
  std::int64_t awaited_until = 0;
};

Mat3 turned(double angle) {
  return Eigen::AngleAxisd{angle, Vec3{1, 2, 3}.normalized()}.toRotationMatrix();
}

struct Both : testing::Test {
  Both() {
    auto first = std::make_unique<Told>();
    auto second = std::make_unique<Told>();
    position = first.get();
    rotation = second.get();
    position->rated = *haptics::findRating("falcon");
    rotation->rated = *haptics::findRating("spacemouse");
    position->gives.X_BD.translation() = Vec3{0.01, 0.02, 0.03};
    position->gives.X_BD.linear() = turned(0.3);  // what a device without rotation may say of it
    position->gives.buttons = 0b101;
    position->gives.time_ns = 77;
    rotation->gives.X_BD.translation() = Vec3{9, 9, 9};
    rotation->gives.X_BD.linear() = turned(1.1);
    rotation->gives.buttons = 0b11;
    both = haptics::combined(std::move(first), std::move(second));
  }
  DeviceStatus read() { return both->read(reading); }

  Told *position, *rotation;
  std::unique_ptr<haptics::Device> both;
  DeviceReading reading;
};

using Combined = Both;

TEST_F(Combined, TakesPositionFromTheFirstAndRotationFromTheSecond) {
  EXPECT_EQ(read(), DeviceStatus::Ok);
  EXPECT_EQ(reading.X_BD.translation(), (Vec3{0.01, 0.02, 0.03}));
  EXPECT_EQ(reading.X_BD.linear(), turned(1.1));
  EXPECT_EQ(reading.buttons, 0b11'0000'0101u);
  EXPECT_EQ(reading.time_ns, 77);
  EXPECT_EQ(reading.trouble, Trouble::None);
}

TEST_F(Combined, ButtonsOfTheFirstBeyondTheEighthAreNotTakenForTheSeconds) {
  position->gives.buttons = 0b1'0000'0001;
  rotation->gives.buttons = 0;
  read();
  EXPECT_EQ(reading.buttons, 1u);
}

TEST_F(Combined, IsRatedAsTheFirstWithSixSensedAndNoTorque) {
  auto first = std::make_unique<Told>();
  first->rated = *haptics::findRating("sigma.7");
  const auto strong = haptics::combined(std::move(first), std::make_unique<Told>());
  EXPECT_EQ(strong->rating().torque, 0.0);
  EXPECT_EQ(strong->rating().angular_stiffness, 0.0);
  EXPECT_EQ(strong->rating().actuated, 3);
  EXPECT_GT(haptics::findRating("sigma.7")->lead, 0.0);
  EXPECT_EQ(strong->rating().lead, 0.0);
  EXPECT_EQ(strong->rating().force, haptics::findRating("sigma.7")->force);

  EXPECT_EQ(both->rating().sensed, 6);
  EXPECT_EQ(both->rating().actuated, 3);
  EXPECT_EQ(both->rating().force, haptics::findRating("falcon")->force);
  EXPECT_EQ(both->rating().workspace, haptics::findRating("falcon")->workspace);
}

TEST_F(Combined, ForceGoesToTheFirstAndTorqueNowhere) {
  EXPECT_EQ(both->write({Vec3{1, 2, 3}, Vec3{4, 5, 6}}), DeviceStatus::Ok);
  EXPECT_EQ(position->last.force, (Vec3{1, 2, 3}));
  EXPECT_TRUE(position->last.torque.isZero(0.0));
  EXPECT_EQ(rotation->writes, 0);
  position->status = DeviceStatus::Lost;
  EXPECT_EQ(both->write({}), DeviceStatus::Lost);
}

TEST_F(Combined, StopAndResumeGoToBoth) {
  both->stop();
  EXPECT_TRUE(position->stopped && rotation->stopped);
  both->resume();
  EXPECT_FALSE(position->stopped || rotation->stopped);
}

TEST_F(Combined, AStaleRotationStandsWhileThePositionGoesOnAndALostOneEndsBoth) {
  read();
  rotation->status = DeviceStatus::Stale;
  position->gives.X_BD.translation().x() = 0.04;
  for (int n = 0; n < 10; ++n) EXPECT_EQ(read(), DeviceStatus::Stale);
  EXPECT_EQ(reading.X_BD.translation().x(), 0.04);
  EXPECT_EQ(reading.X_BD.linear(), turned(1.1));
  EXPECT_EQ(both->write({Vec3{1, 0, 0}, Vec3::Zero()}), DeviceStatus::Ok);
  rotation->status = DeviceStatus::Lost;
  rotation->gives.trouble = Trouble::Lost;
  EXPECT_EQ(read(), DeviceStatus::Lost);
  EXPECT_EQ(reading.trouble, Trouble::Lost);
}

TEST_F(Combined, IsTheWorseOfTheTwo) {
  using enum DeviceStatus;
  struct {
    DeviceStatus position, rotation, both;
  } constexpr kTable[] = {
      {Ok, Ok, Ok},
      {Stale, Ok, Stale},
      {NotReady, Ok, NotReady},
      {Lost, Ok, Lost},
      {Ok, Stale, Stale},
      {Stale, Stale, Stale},
      {Ok, Lost, Lost},
      {NotReady, Stale, NotReady},
      {Lost, Stale, Lost},
      {Ok, NotReady, NotReady},
      {Stale, NotReady, NotReady},
      {NotReady, NotReady, NotReady},
      {Lost, NotReady, Lost},
      {Stale, Lost, Lost},
      {NotReady, Lost, Lost},
      {Lost, Lost, Lost},
  };
  for (const auto& row : kTable) {
    position->status = row.position;
    rotation->status = row.rotation;
    EXPECT_EQ(read(), row.both) << int(row.position) << " " << int(row.rotation);
  }
  // both are asked each time: a device that is not read does not go on
  EXPECT_EQ(position->reads, int(std::size(kTable)));
  EXPECT_EQ(rotation->reads, int(std::size(kTable)));
}

TEST_F(Combined, AfterTheFirstIsLostTheReadingStands) {
  read();
  position->status = DeviceStatus::Lost;
  position->gives.trouble = Trouble::Lost;
  rotation->gives.X_BD.linear() = turned(2.0);
  EXPECT_EQ(read(), DeviceStatus::Lost);
  EXPECT_EQ(reading.X_BD.linear(), turned(1.1));
  EXPECT_EQ(reading.trouble, Trouble::Lost);
}

TEST_F(Combined, TheFirstsTroubleComesBeforeTheSeconds) {
  rotation->gives.trouble = Trouble::NeedsCalibration;
  EXPECT_EQ(read(), DeviceStatus::Ok);
  EXPECT_EQ(reading.trouble, Trouble::NeedsCalibration);
  position->gives.trouble = Trouble::MotorsHot;
  read();
  EXPECT_EQ(reading.trouble, Trouble::MotorsHot);
}

TEST_F(Combined, IsInStepWithTheFirst) {
  EXPECT_FALSE(both->inStep());
  position->in_step = true;
  EXPECT_TRUE(both->inStep());
  EXPECT_EQ(both->awaitReading(42), 43);
  EXPECT_EQ(position->awaited_until, 42);
  EXPECT_EQ(rotation->awaited_until, 0);
}

}  // namespace
