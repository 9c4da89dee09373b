// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/force_dimension.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <set>

#include "haptics/core/clock.h"
#include "tests/support/sentence.h"
#include "tests/unit/haptics/devices/stub_dhd.h"
#include "tests/unit/haptics/devices/stub_library.h"

namespace {

using haptics::Device;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Mat3;
using haptics::Pose;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using stubs::comes;

const std::vector<std::string> kStub{stubs::dhd()};

class ForceDimension : public testing::Test {
 protected:
  void SetUp() override {
    stub.major = 3, stub.minor = 17, stub.release = 5;
    stub.count = 1, stub.model = 104;
    for (auto* result : {&stub.open_result, &stub.last_error, &stub.expert_result,
                         &stub.watchdog_result, &stub.enable_result, &stub.weight_result,
                         &stub.state_result, &stub.pose_result, &stub.wrench_result, &stub.reset,
                         &stub.force, &stub.cause, &stub.closes, &stub.brakes, &stub.enables})
      *result = 0;
    stub.active_wrist = stub.initialised = true;
    stub.connected = 1;
    stub.buttons = 0;
    stub.rounds = stub.wrenches_unlike_zero = 0;
    stub.not_finite = stub.asked_after_close = false;
    stub.watchdog = stub.weight = stub.opened = -1;
    handle(Vec3{0.01, 0.02, 0.03}, Mat3::Identity());
  }
  void TearDown() override {
    EXPECT_FALSE(stub.not_finite);
    EXPECT_FALSE(stub.asked_after_close);
  }

  void handle(const Vec3& p_F, const Mat3& R_FD) {
    for (int n = 0; n < 3; ++n) stub.p_F[static_cast<std::size_t>(n)] = p_F[n];
    for (int n = 0; n < 9; ++n) stub.R_FD[static_cast<std::size_t>(n)] = R_FD(n / 3, n % 3);
  }

  static auto tryToOpen(const std::string& id = "force-dimension") {
    return haptics::openForceDimension({.id = id}, kStub);
  }
  std::unique_ptr<Device> open() {
    auto device = tryToOpen();
    EXPECT_TRUE(device) << sentence(device.error());
    if (!device) return nullptr;
    EXPECT_TRUE(reads(**device, DeviceStatus::Ok));
    return std::move(*device);
  }

  /// Whether reading comes to this status while the wrench is written anew.
  bool reads(Device& device, DeviceStatus status, const Wrench& wrench_B = {}) {
    return comes([&] {
      const DeviceStatus now = device.read(reading);
      device.write(wrench_B);
      return now == status;
    });
  }
  /// Writes the wrench until the device has it; false: it does not come.
  bool arrives(Device& device, const Wrench& wrench_B, const std::array<double, 7>& expected) {
    return comes([&] {
      device.write(wrench_B);
      const std::array<double, 7> sent = stub.wrench();
      for (std::size_t n = 0; n < 7; ++n)
        if (std::abs(sent[n] - expected[n]) > 1e-12) return false;
      return true;
    });
  }
  /// A full second of rounds at most, while the wrench is written: whether any was unlike zero.
  bool anyForce(Device& device, const Wrench& wrench_B) {
    const long before = stub.wrenches_unlike_zero, first = stub.rounds;
    EXPECT_TRUE(comes([&] {
      device.write(wrench_B);
      return stub.rounds > first + 300;
    }));
    return stub.wrenches_unlike_zero != before;
  }

  StubDhd& stub = stubs::control<StubDhd>(stubs::dhd(), "stubDhd");
  DeviceReading reading;
  const Wrench push{.force = {1.0, 2.0, 3.0}, .torque = {0.01, 0.02, 0.03}};
};

constexpr std::array<double, 7> kZero{};

TEST_F(ForceDimension, SaysWhatIsMissingWhereTheLibraryIsNot) {
  const std::vector<std::string> absent{"libpalpate-absent.so"};
  const auto device = haptics::openForceDimension({.id = "force-dimension"}, absent);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "no-library");
  EXPECT_NE(sentence(device.error()).find("libpalpate-absent.so"), std::string::npos);
  EXPECT_NE(sentence(device.error()).find("Force Dimension SDK"), std::string::npos);
  const auto entries = haptics::surveyForceDimension(absent);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_FALSE(entries[0].present);
  EXPECT_EQ(entries[0].trouble, Trouble::NoLibrary);
  EXPECT_EQ(sentence(entries[0].why), sentence(device.error()));
}

TEST_F(ForceDimension, SaysWhichFunctionTheLibraryLacks) {
  for (const std::string name :
       {"dhdGetSDKVersion", "dhdGetDeviceCount", "dhdErrorGetLast", "dhdStop", "dhdGetSystemType",
        "dhdHasActiveWrist", "dhdEnableExpertMode", "dhdSetWatchdog", "dhdEnableForce",
        "dhdSetGravityCompensation", "dhdGetStatus", "dhdGetPositionAndOrientationFrame",
        "dhdGetButtonMask", "dhdSetForceAndTorqueAndGripperForce", "drdOpenID", "drdClose"}) {
    SCOPED_TRACE(name);
    const std::vector<std::string> lacking{stubs::without(stubs::dhd(), name)};
    const auto device = haptics::openForceDimension({.id = "force-dimension"}, lacking);
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "no-library");
    EXPECT_NE(sentence(device.error()).find(" lacks " + name + ")"), std::string::npos)
        << sentence(device.error());
    EXPECT_EQ(haptics::surveyForceDimension(lacking)[0].trouble, Trouble::NoLibrary);
    std::filesystem::remove(lacking[0]);
  }
}

TEST_F(ForceDimension, WorksWithoutTheRoboticsLibrary) {
  const std::vector<std::string> plain{stubs::without(stubs::dhd(), "drdIsInitialized")};
  StubDhd& other = stubs::control<StubDhd>(plain[0], "stubDhd");
  for (std::size_t n = 0; n < 9; n += 4) other.R_FD[n] = 1.0;
  other.initialised = false;  // nobody asks
  {
    const auto device = haptics::openForceDimension({.id = "force-dimension"}, plain);
    ASSERT_TRUE(device) << sentence(device.error());
    EXPECT_TRUE(reads(**device, DeviceStatus::Ok));
    EXPECT_EQ(other.opened_by_robotics, 0);
  }
  EXPECT_EQ(other.closes, 1);
  std::filesystem::remove(plain[0]);
}

TEST_F(ForceDimension, RefusesVersionsThatItDoesNotKnow) {
  const auto refuses = [this](int major, int minor, int release) {
    stub.major = major, stub.minor = minor, stub.release = release;
    const auto device = tryToOpen();
    return !device && device.error().reason == "no-library" &&
           sentence(device.error())
                   .find(std::to_string(major) + "." + std::to_string(minor) + "." +
                         std::to_string(release)) != std::string::npos;
  };
  EXPECT_TRUE(refuses(2, 99, 9));
  EXPECT_TRUE(refuses(3, 3, 1));
  EXPECT_TRUE(refuses(4, 0, 0));
  EXPECT_FALSE(refuses(3, 3, 2));
  EXPECT_FALSE(refuses(3, 17, 5));
}

TEST_F(ForceDimension, SurveysWithoutOpening) {
  stub.count = 0;
  auto entries = haptics::surveyForceDimension(kStub);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].trouble, Trouble::NotPluggedIn);
  EXPECT_FALSE(entries[0].present);
  stub.count = -1;
  EXPECT_EQ(haptics::surveyForceDimension(kStub)[0].trouble, Trouble::NotPluggedIn);
  stub.count = 2;
  entries = haptics::surveyForceDimension(kStub);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[1].id, "force-dimension:1");
  EXPECT_TRUE(entries[1].present);
  EXPECT_EQ(entries[1].trouble, Trouble::None);
  stub.count = std::numeric_limits<int>::max();
  EXPECT_LE(haptics::surveyForceDimension(kStub).size(), 8u);
  EXPECT_EQ(stub.opened, -1);
}

TEST_F(ForceDimension, OpensTheOneThatIsAskedForAndRefusesOthers) {
  stub.count = 2;
  EXPECT_TRUE(tryToOpen("force-dimension:1"));
  EXPECT_EQ(stub.opened, 1);
  for (const char* id : {"force-dimension:", "force-dimension:x", "force-dimension:-1",
                         "force-dimension:1x", "force-dimension:99999999999", "falcon"}) {
    const auto device = tryToOpen(id);
    ASSERT_FALSE(device) << id;
    EXPECT_EQ(device.error().reason, "unknown-device") << id;
  }
  const auto device = tryToOpen("force-dimension:2");
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "not-plugged-in");
}

TEST_F(ForceDimension, SaysWhyItCannotBeOpened) {
  stub.open_result = -1;
  const std::vector<std::pair<int, std::string>> reasons{
      {20, "in-use"},        {3, "in-use"},  {4, "no-permission"}, {2, "no-permission"},
      {5, "not-plugged-in"}, {1, "refused"}, {-77, "refused"}};
  for (const auto& [error, reason] : reasons) {
    stub.last_error = error;
    const auto device = tryToOpen();
    ASSERT_FALSE(device) << error;
    EXPECT_EQ(device.error().reason, reason) << error;
  }
  stub.open_result = 0;
  EXPECT_TRUE(tryToOpen());  // none of that has left it taken
}

TEST_F(ForceDimension, RefusesAUnitWithoutWatchdogAndAModelThatItDoesNotKnowAndClosesIt) {
  for (auto* result : {&stub.expert_result, &stub.watchdog_result}) {
    *result = -1;
    const auto device = tryToOpen();
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "refused");
    EXPECT_NE(sentence(device.error()).find("watchdog"), std::string::npos);
    EXPECT_EQ(stub.closes, 1);
    *result = 0;
  }
  stub.model = 60;
  const auto device = tryToOpen();
  ASSERT_FALSE(device);
  EXPECT_NE(sentence(device.error()).find("60"), std::string::npos);
  EXPECT_EQ(stub.enables, 0);
  EXPECT_EQ(stub.closes, 1);
}

TEST_F(ForceDimension, IsOpenOnceAtATime) {
  auto device = open();
  const auto second = tryToOpen();
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().reason, "in-use");
  EXPECT_EQ(haptics::surveyForceDimension(kStub)[0].trouble, Trouble::InUse);
  device.reset();
  EXPECT_TRUE(open());
}

TEST_F(ForceDimension, KnowsItsModels) {
  const std::vector<std::pair<int, std::string>> names{
      {63, "delta.3"},   {33, "omega.3"},   {34, "omega.6"},   {36, "omega.6"},  {35, "omega.7"},
      {37, "omega.7"},   {206, "sigma.3"},  {104, "sigma.7"},  {105, "sigma.7"}, {203, "lambda.3"},
      {131, "lambda.6"}, {132, "lambda.6"}, {108, "lambda.7"}, {109, "lambda.7"}};
  std::set<std::string_view> different;
  for (const auto& [model, name] : names) {
    stub.model = model;
    const auto device = tryToOpen();
    ASSERT_TRUE(device) << name;
    const haptics::DeviceRating& rating = (*device)->rating();
    EXPECT_EQ(rating.name.find("Force Dimension " + name), 0u) << rating.name;
    different.insert(rating.name);
    EXPECT_EQ(rating.sensed, name.back() - '0') << name;
    EXPECT_EQ(rating.torque > 0.0, rating.actuated >= 6) << name;
    EXPECT_GT(rating.force, 0.0);
  }
  EXPECT_EQ(different.size(), names.size());
}

TEST_F(ForceDimension, SetsTheWatchdogToFiveMillisecondsAndHasTheWeightBorne) {
  const auto device = open();
  EXPECT_EQ(stub.watchdog * 125, 5000);  // us
  EXPECT_EQ(stub.weight, 1);
  EXPECT_EQ(stub.force, 1);
  EXPECT_EQ(stub.opened_by_robotics, 1);
}

TEST_F(ForceDimension, WorksWhereTheWeightIsNotBorne) {
  stub.weight_result = -1;
  EXPECT_TRUE(open());
}

// the maker's x, y, z point where z, x, y of B do
TEST_F(ForceDimension, TurnsPosesIntoTheBase) {
  const auto device = open();
  const auto shows = [&](const Vec3& p_B, const Mat3& R_BD) {
    return comes([&] {
      device->read(reading);
      return reading.X_BD.translation().isApprox(p_B, 1e-12) &&
             reading.X_BD.linear().isApprox(R_BD, 1e-12);
    });
  };
  const auto turn = [](double angle, int axis) {
    return Mat3{Eigen::AngleAxisd{angle, Vec3::Unit(axis)}};
  };
  constexpr int kMaker[] = {0, 1, 2}, kBase[] = {2, 0, 1};
  for (int n = 0; n < 3; ++n) {
    handle(0.05 * Vec3::Unit(kMaker[n]), turn(0.3 + n, kMaker[n]));
    EXPECT_TRUE(shows(0.05 * Vec3::Unit(kBase[n]), turn(0.3 + n, kBase[n]))) << n;
    handle(-0.05 * Vec3::Unit(kMaker[n]), turn(-0.3, kMaker[n]));
    EXPECT_TRUE(shows(-0.05 * Vec3::Unit(kBase[n]), turn(-0.3, kBase[n]))) << n;
  }
  stub.buttons = 0x80000001;
  EXPECT_TRUE(comes([&] { return device->read(reading), reading.buttons == 0x80000001; }));
  EXPECT_GT(reading.time_ns, 0);
}

TEST_F(ForceDimension, TurnsForceAndTorqueIntoTheMakersAxes) {
  const auto device = open();
  constexpr std::size_t kMaker[] = {1, 2, 0};  // x, y, z of B
  for (int n = 0; n < 6; ++n)
    for (const double sign : {1.0, -1.0}) {
      SCOPED_TRACE(n);
      Wrench wrench;
      std::array<double, 7> expected{};
      if (n < 3) {
        wrench.force[n] = 2.5 * sign;
        expected[kMaker[n]] = 2.5 * sign;
      } else {
        wrench.torque[n - 3] = 0.1 * sign;
        expected[3 + kMaker[n - 3]] = 0.1 * sign;
      }
      EXPECT_TRUE(arrives(*device, wrench, expected));
    }
}

// what goes in as a push along the handle's way out comes back as one: power has its sign
TEST_F(ForceDimension, TakesAndGivesPowerAlike) {
  const auto device = open();
  const Vec3 v_F{0.011, -0.007, 0.005};
  handle(v_F, Mat3::Identity());
  ASSERT_TRUE(comes([&] {
    device->read(reading);
    return std::abs(reading.X_BD.translation().y() - v_F.z()) < 1e-12;
  }));
  const Vec3 p_B = reading.X_BD.translation();
  ASSERT_TRUE(comes([&] {
    device->write(push);
    return stub.wrench()[0] != 0.0;
  }));
  const auto f = stub.wrench();
  EXPECT_NEAR(f[0] * v_F.x() + f[1] * v_F.y() + f[2] * v_F.z(), push.force.dot(p_B), 1e-12);
}

TEST_F(ForceDimension, SendsNoTorqueToAWristWithoutMotors) {
  for (const int model : {104, 34}) {
    stub.model = model;
    stub.active_wrist = model == 34;  // whatever the library says of an omega
    const auto device = open();
    EXPECT_EQ(device->rating().torque, 0.0);
    EXPECT_EQ(device->rating().angular_stiffness, 0.0);
    EXPECT_LE(device->rating().actuated, 4);
    EXPECT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0}));
  }
}

TEST_F(ForceDimension, IgnoresTheOrientationOfAHandleThatCannotTurn) {
  stub.model = 33;
  handle(Vec3{0.0, 0.01, 0.0}, Mat3::Constant(std::numeric_limits<double>::quiet_NaN()));
  const auto device = open();
  EXPECT_TRUE(reading.X_BD.linear().isIdentity());
}

TEST_F(ForceDimension, TakesRecentValuesAndFullMotorsForSuccess) {
  const auto device = open();
  stub.pose_result = 1;  // recent data
  stub.state_result = 1;
  stub.wrench_result = 2;  // motors at their limit
  const long from = stub.rounds;
  int not_ok = 0;
  EXPECT_TRUE(comes([&] {
    not_ok += device->read(reading) == DeviceStatus::Lost;
    device->write(push);
    return stub.rounds > from + 300;
  }));
  EXPECT_EQ(not_ok, 0);
  EXPECT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
}

TEST_F(ForceDimension, IsLostWithForceOffWhenAnyOfItsCallsFailsUnderForceAndOpensAgain) {
  for (auto* result : {&stub.pose_result, &stub.state_result, &stub.wrench_result}) {
    auto device = open();
    ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
    *result = -1;
    const long forces = stub.wrenches_unlike_zero;
    EXPECT_TRUE(reads(*device, DeviceStatus::Lost, push));
    EXPECT_EQ(reading.trouble, Trouble::Lost);
    if (result == &stub.pose_result) {
      EXPECT_LE(stub.wrenches_unlike_zero - forces, 1);  // what was under way
    }
    EXPECT_EQ(device->write(push), DeviceStatus::Lost);
    EXPECT_TRUE(comes([&] { return stub.wrench() == kZero; }));
    *result = 0;
    EXPECT_EQ(device->read(reading), DeviceStatus::Lost);  // it stays so
    device.reset();
    EXPECT_EQ(stub.wrench(), kZero);
    stub.force = 0;
    EXPECT_TRUE(open());
  }
}

TEST_F(ForceDimension, IsLostAtOnceWhenItsLibrarySaysThatItIsUnplugged) {
  for (const bool by_cause : {false, true}) {
    const auto device = open();
    ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
    (by_cause ? stub.cause : stub.connected) = by_cause ? 5 : 0;
    EXPECT_TRUE(reads(*device, DeviceStatus::Lost, push));
    EXPECT_TRUE(comes([&] { return stub.wrench() == kZero; }));
    stub.connected = 1;
    stub.cause = 0;
  }
}

TEST_F(ForceDimension, NeverShowsAPoseThatCannotBe) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Vec3, Mat3>> impossible{
      {{kNan, 0.0, 0.0}, Mat3::Identity()},
      {{0.0, 0.0, std::numeric_limits<double>::infinity()}, Mat3::Identity()},
      {{0.0, 7.0, 0.0}, Mat3::Identity()},
      {Vec3::Zero(), Mat3::Zero()},
      {Vec3::Zero(), Mat3::Constant(kNan)},
      {Vec3::Zero(), -Mat3::Identity()},
      {Vec3::Zero(), 1.1 * Mat3::Identity()}};
  for (const auto& [p, R] : impossible) {
    handle(Vec3{0.01, 0.02, 0.03}, Mat3::Identity());
    stub.force = 0;
    const auto device = open();
    ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
    handle(p, R);
    EXPECT_TRUE(comes([&] {
      const DeviceStatus status = device->read(reading);
      device->write(push);
      EXPECT_TRUE(reading.X_BD.translation().isApprox(Vec3(0.02, 0.03, 0.01), 1e-12));
      EXPECT_TRUE(reading.X_BD.linear().isIdentity(1e-12));
      return status == DeviceStatus::Lost;
    }));
    EXPECT_TRUE(comes([&] { return stub.wrench() == kZero; }));
  }
}

TEST_F(ForceDimension, HasNoForceUntilItIsInitialised) {
  for (const bool by_state : {false, true}) {
    stub.reset = by_state;
    stub.initialised = by_state;
    stub.force = stub.enables = 0;
    const auto device = tryToOpen();
    ASSERT_TRUE(device) << sentence(device.error());
    EXPECT_TRUE(comes(
        [&] { return (*device)->read(reading) == DeviceStatus::NotReady && stub.rounds > 100; }));
    EXPECT_EQ(reading.trouble, Trouble::NeedsCalibration);
    EXPECT_FALSE(anyForce(**device, push));
    EXPECT_EQ(stub.enables, 0);
    stub.initialised = true;
    stub.reset = 0;
    EXPECT_TRUE(reads(**device, DeviceStatus::Ok));
    EXPECT_TRUE(arrives(**device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
    stub.rounds = 0;
  }
}

// 2 speed, 3 watchdog, 4 software: on again from a zero wrench; 1 button, 6 dead man: not by us
TEST_F(ForceDimension, TellsThatForceIsOffAndHasItBackOnlyWhereItMay) {
  for (const int cause : {1, 2, 3, 4, 6}) {
    SCOPED_TRACE(cause);
    stub.force = 0;
    const auto device = open();
    ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
    stub.cause = cause;
    stub.force = 0;
    EXPECT_TRUE(reads(*device, DeviceStatus::NotReady, push));
    EXPECT_EQ(reading.trouble, Trouble::ForceOff);
    EXPECT_FALSE(anyForce(*device, push));  // nor is it had back while a force is asked for
    EXPECT_EQ(stub.force, 0);
    if (cause == 1 || cause == 6) {
      EXPECT_FALSE(anyForce(*device, {}));
      EXPECT_EQ(stub.force, 0);
      stub.force = 1;  // the user switches it on, while a force is asked for
      stub.cause = 0;
      EXPECT_FALSE(anyForce(*device, push));
    }
    EXPECT_TRUE(reads(*device, DeviceStatus::Ok));
    EXPECT_EQ(stub.force, 1);
  }
}

TEST_F(ForceDimension, IsNotReadyWhereItsForceCannotBeSwitchedOn) {
  stub.enable_result = -1;
  const auto device = tryToOpen();
  ASSERT_TRUE(device);
  EXPECT_TRUE(comes([&] {
    (*device)->read(reading);
    return reading.trouble == Trouble::ForceOff;
  }));
  EXPECT_FALSE(anyForce(**device, push));
}

TEST_F(ForceDimension, SendsZeroForWhatIsNotFinite) {
  const auto device = open();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
    Wrench wrench = push;
    wrench.force.y() = bad;
    EXPECT_TRUE(arrives(*device, wrench, kZero));
    wrench = push;
    wrench.torque.z() = bad;
    EXPECT_TRUE(arrives(*device, wrench, kZero));
  }
}

TEST_F(ForceDimension, LetsGoWhenNobodyWritesAnyMore) {
  const auto device = open();
  ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
  EXPECT_TRUE(comes([&] { return stub.wrench() == kZero; }));
}

TEST_F(ForceDimension, LeavesZeroForceAndBrakesWhenItIsClosedUnderForce) {
  auto device = open();
  ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
  device->write(push);
  device.reset();
  EXPECT_EQ(stub.wrench(), kZero);
  EXPECT_EQ(stub.brakes, 1);
  EXPECT_EQ(stub.closes, 1);
}

TEST_F(ForceDimension, AForceThatWaitedInTheLibraryIsNotSent) {
  const auto device = open();
  ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
  stub.pose_ms = 12;
  const long slow = stub.rounds;
  DeviceReading mine;
  const auto rounds = [&](long n) {
    return comes([&] {
      device->read(mine);
      device->write(push);
      return stub.rounds >= slow + n;
    });
  };
  ASSERT_TRUE(rounds(2));  // the one that was under way, perhaps
  const long forces = stub.wrenches_unlike_zero;
  ASSERT_TRUE(rounds(20));
  EXPECT_EQ(stub.wrenches_unlike_zero, forces);
  EXPECT_EQ(stub.wrench(), kZero);
  stub.pose_ms = 0;
}

// else the wrench would wait for the next pose
TEST_F(ForceDimension, SendsTheAnswerToAPoseBeforeItAsksForTheNext) {
  const auto device = open();
  ASSERT_TRUE(device->inStep());
  ASSERT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
  stub.pose_ms = 1;
  int answers = 0;
  for (int tick = 1; tick <= 100; ++tick) {
    const std::int64_t came = device->awaitReading(haptics::monotonicNs() + 1'000'000'000);
    // on a busy machine a pose may take so long that no force is made of it
    if (device->read(reading) != DeviceStatus::Ok || came == 0 || reading.time_ns > came) continue;
    const long poses = stub.poses;
    device->write({.force = {0.01 * tick, 0.0, 0.0}, .torque = Vec3::Zero()});
    // written in time, it is sent while no further pose has been asked for
    if (haptics::monotonicNs() - came > 250'000) continue;
    ASSERT_TRUE(comes([&] { return stub.poses > poses; }));
    const StubDhd::Asked next = stub.asked(poses + 1);
    // on a busy machine the link's thread may be so late that it lets go
    if (next.at_ns - came > 3'000'000) continue;
    EXPECT_EQ(next.wrench[1], 0.01 * tick);
    ++answers;
  }
  stub.pose_ms = 0;
  EXPECT_GT(answers, 0);
}

TEST_F(ForceDimension, StopsFromAnotherThreadWhateverIsWritten) {
  const auto device = open();
  std::atomic<bool> end{false};
  std::thread servo{[&] {
    DeviceReading mine;
    while (!end) {
      device->read(mine);
      device->write(push);
    }
  }};
  EXPECT_TRUE(comes([&] { return stub.wrenches_unlike_zero > 20; }));
  device->stop();
  const long stopped = stub.rounds;
  EXPECT_TRUE(comes([&] { return stub.rounds > stopped + 2; }));
  const long forces = stub.wrenches_unlike_zero;
  EXPECT_TRUE(comes([&] { return stub.rounds > stopped + 200; }));
  EXPECT_EQ(stub.wrenches_unlike_zero, forces);
  EXPECT_EQ(stub.wrench(), kZero);
  end = true;
  servo.join();
  device->resume();
  EXPECT_TRUE(arrives(*device, push, {3.0, 1.0, 2.0, 0.03, 0.01, 0.02, 0.0}));
}

}  // namespace
