// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/open_haptics.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

#include "tests/support/sentence.h"
#include "tests/unit/haptics/devices/stub_hd.h"
#include "tests/unit/haptics/devices/stub_library.h"

namespace {

using haptics::Device;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Mat3;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using stubs::comes;

const std::vector<std::string> kStubOfTouch{stubs::hd()};
constexpr std::array<double, 6> kNoTorque{};

class OpenHaptics : public testing::Test {
 protected:
  void SetUp() override {
    for (auto* none : {&stub.open_error, &stub.enable_error, &stub.schedule_error,
                       &stub.start_error, &stub.frame_error, &stub.second_error})
      *none = 0;
    stub.unit = 7;
    stub.errors_left = -1;
    stub.endless_errors = stub.frozen = false;
    stub.model = "Touch";
    stub.inputs = 6, stub.outputs = 3, stub.style = 4;
    stub.stiffness = 0.5, stub.force = 3.4, stub.continuous_force = 0.9, stub.torque = 0.0;
    stub.calibration = 0x5000;
    stub.buttons = 0;
    stub.calls = stub.frames = stub.unlike_zero = 0;
    stub.calibrations = stub.calibration_style = 0;
    stub.not_finite = stub.set_outside_frame = stub.torque_to_unit_without = false;
    stub.force_on = stub.clamped = false;
    stub.errors.clear();
    stub.words.clear();
    stub.next = stub.sent = {};
    handle(Vec3{10.0, 20.0, 30.0}, Mat3::Identity());
  }
  void TearDown() override {
    EXPECT_FALSE(stub.not_finite);
    EXPECT_FALSE(stub.set_outside_frame);
    EXPECT_FALSE(stub.torque_to_unit_without);
    EXPECT_FALSE(stub.force_on);  // all are closed
    EXPECT_FALSE(stub.running);
  }

  /// In the library's way: millimetres, column after column.
  void handle(const Vec3& p_mm, const Mat3& R) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        stub.transform[static_cast<std::size_t>(4 * column + row)] = R(row, column);
      stub.transform[static_cast<std::size_t>(12 + row)] = p_mm[row];
    }
    stub.transform[15] = 1.0;
  }

  static auto tryToOpen(const std::string& id = "openhaptics") {
    return haptics::openOpenHaptics({.id = id}, kStubOfTouch);
  }
  std::unique_ptr<Device> open() {
    auto device = tryToOpen();
    EXPECT_TRUE(device) << sentence(device.error());
    if (!device) return nullptr;
    EXPECT_TRUE(reads(**device, DeviceStatus::Ok));
    return std::move(*device);
  }
  bool reads(Device& device, DeviceStatus status, const Wrench& wrench_B = {}) {
    return comes([&] {
      const DeviceStatus now = device.read(reading);
      device.write(wrench_B);
      return now == status;
    });
  }
  bool arrives(Device& device, const Wrench& wrench_B, const std::array<double, 6>& expected) {
    return comes([&] {
      device.write(wrench_B);
      const std::array<double, 6> sent = stub.wrench();
      for (std::size_t n = 0; n < 6; ++n)
        if (std::abs(sent[n] - expected[n]) > 1e-9) return false;
      return true;
    });
  }
  /// Many frames while the wrench is written: whether any was unlike zero.
  bool anyForce(Device& device, const Wrench& wrench_B, long frames = 150) {
    const long before = stub.unlike_zero, first = stub.frames;
    EXPECT_TRUE(comes([&] {
      device.write(wrench_B);
      return stub.frames > first + frames;
    }));
    return stub.unlike_zero != before;
  }

  StubHd& stub = stubs::control<StubHd>(stubs::hd(), "stubHd");
  DeviceReading reading;
  const Wrench push{.force = {1.0, 2.0, 3.0}, .torque = {0.01, 0.02, 0.03}};
  const std::array<double, 6> pushed{1.0, 2.0, 3.0, 0.0, 0.0, 0.0};
};

TEST_F(OpenHaptics, SaysWhatIsMissingWhereTheLibraryIsNot) {
  const std::vector<std::string> absent{"libpalpate-absent.so"};
  const auto device = haptics::openOpenHaptics({.id = "openhaptics"}, absent);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "no-library");
  EXPECT_NE(sentence(device.error()).find("libpalpate-absent.so"), std::string::npos);
  EXPECT_NE(sentence(device.error()).find("maker's site"), std::string::npos);
  const auto entries = haptics::surveyOpenHaptics(absent);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].trouble, Trouble::NoLibrary);
  EXPECT_EQ(sentence(entries[0].why), sentence(device.error()));
}

TEST_F(OpenHaptics, SaysWhichFunctionTheLibraryLacks) {
  for (const std::string name :
       {"hdInitDevice", "hdDisableDevice", "hdMakeCurrentDevice", "hdBeginFrame", "hdEndFrame",
        "hdGetError", "hdEnable", "hdDisable", "hdGetDoublev", "hdGetIntegerv", "hdGetString",
        "hdSetDoublev", "hdCheckCalibration", "hdUpdateCalibration", "hdScheduleAsynchronous",
        "hdUnschedule", "hdStartScheduler", "hdStopScheduler"}) {
    SCOPED_TRACE(name);
    const std::vector<std::string> lacking{stubs::without(stubs::hd(), name)};
    const auto device = haptics::openOpenHaptics({.id = "openhaptics"}, lacking);
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "no-library");
    EXPECT_NE(sentence(device.error()).find(" lacks " + name + ")"), std::string::npos)
        << sentence(device.error());
    EXPECT_EQ(haptics::surveyOpenHaptics(lacking)[0].trouble, Trouble::NoLibrary);
    std::filesystem::remove(lacking[0]);
  }
}

TEST_F(OpenHaptics, SurveysWithoutOpening) {
  const auto entries = haptics::surveyOpenHaptics(kStubOfTouch);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].id, "openhaptics");
  EXPECT_FALSE(entries[0].present);
  EXPECT_EQ(entries[0].trouble, Trouble::None);
  EXPECT_NE(sentence(entries[0].why).find("opening tells"), std::string::npos);
  EXPECT_TRUE(stub.story().empty());
}

TEST_F(OpenHaptics, SaysWhyItCannotBeOpened) {
  const std::vector<std::pair<unsigned, std::string>> reasons{
      {0x300, "not-plugged-in"}, {0x301, "in-use"},  {0x302, "not-plugged-in"},
      {0x303, "not-plugged-in"}, {0x600, "refused"}, {0x100, "refused"}};
  for (const unsigned unit : {0xFFFFFFFFu, 7u})
    for (const auto& [error, reason] : reasons) {
      stub.words.clear();
      stub.unit = unit;
      stub.open_error = error;
      const auto device = tryToOpen();
      ASSERT_FALSE(device) << error;
      EXPECT_EQ(device.error().reason, reason) << error;
      EXPECT_EQ(stub.story().back(), unit == 7 ? "close" : "open");
    }
  stub.open_error = 0;
  stub.unit = 0xFFFFFFFF;
  EXPECT_FALSE(tryToOpen());  // none, and no word why
  stub.unit = 7;
  EXPECT_TRUE(tryToOpen());  // none of that has left it taken
}

TEST_F(OpenHaptics, ClosesAUnitThatCannotBeStarted) {
  for (auto* error : {&stub.enable_error, &stub.schedule_error, &stub.start_error}) {
    *error = 0x501;
    stub.words.clear();
    const auto device = tryToOpen();
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "refused");
    EXPECT_NE(sentence(device.error()).find("0x0501"), std::string::npos);
    EXPECT_EQ(stub.story().back(), "close");
    EXPECT_FALSE(stub.force_on);
    EXPECT_EQ(stub.wrench(), kNoTorque);
    *error = 0;
    stub.errors.clear();
  }
}

TEST_F(OpenHaptics, EndsThoughTheErrorsDoNot) {
  stub.endless_errors = true;
  EXPECT_FALSE(tryToOpen());
  stub.endless_errors = false;
  const auto device = open();
  stub.endless_errors = true;
  EXPECT_TRUE(reads(*device, DeviceStatus::Lost));
}

TEST_F(OpenHaptics, OpensByNameAndOnceAtATime) {
  {
    const auto device = tryToOpen("openhaptics:Left Device");
    ASSERT_TRUE(device);
    EXPECT_EQ(stub.nameOpened(), "Left Device");
    const auto second = tryToOpen();
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().reason, "in-use");
    EXPECT_EQ(haptics::surveyOpenHaptics(kStubOfTouch)[0].trouble, Trouble::InUse);
  }
  EXPECT_TRUE(open());
  EXPECT_EQ(stub.nameOpened(), "(default)");
}

TEST_F(OpenHaptics, KnowsItsModels) {
  stub.stiffness = stub.force = stub.continuous_force = 0.0;  // it tells nothing: the table's
  const std::vector<std::pair<const char*, std::string>> models{
      {"Touch", "touch"},
      {"Touch X", "desktop"},
      {"PHANTOM Desktop", "desktop"},
      {"Omni", "omni"},
      {"PHANTOM Premium 3.0 6DOF", "premium-3.0"},
      {"Premium 1.5 High Force", "premium-1.5"},
      {"something new", "touch"},
      {nullptr, "touch"}};
  for (const auto& [words, id] : models) {
    stub.model = words;
    const auto device = tryToOpen();
    ASSERT_TRUE(device);
    const haptics::DeviceRating& row = *haptics::findRating(id);
    EXPECT_EQ((*device)->rating().id, id);
    EXPECT_EQ((*device)->rating().stiffness, row.stiffness);
    EXPECT_EQ((*device)->rating().force, row.force);
    EXPECT_EQ((*device)->rating().continuous_force, row.continuous_force);
    EXPECT_EQ((*device)->rating().torque, 0.0);
    EXPECT_EQ((*device)->rating().actuated, 3);
  }
}

TEST_F(OpenHaptics, TakesLimitsFromTheUnitWhereTheyCanBe) {
  const auto limits = [this](double stiffness, double force, double continuous) {
    stub.stiffness = stiffness, stub.force = force, stub.continuous_force = continuous;
    const auto device = tryToOpen();
    EXPECT_TRUE(device);
    const haptics::DeviceRating& rating = (*device)->rating();
    return Vec3{rating.stiffness, rating.force, rating.continuous_force};
  };
  const haptics::DeviceRating& row = *haptics::findRating("touch");
  const Vec3 table{row.stiffness, row.force, row.continuous_force};
  EXPECT_TRUE(limits(0.5, 3.4, 0.9).isApprox(Vec3(500.0, 3.4, 0.9)));
  EXPECT_TRUE(limits(0.2, 2.0, 0.5).isApprox(Vec3(200.0, 2.0, 0.5)));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, 1e9, 1e-9, kNan, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(limits(bad, bad, bad), table) << bad;
  EXPECT_TRUE(limits(0.4, 1.2, 2.0).isApprox(Vec3(400.0, 1.2, 1.2)));  // never more than at once
}

TEST_F(OpenHaptics, ShowsPosesInMetres) {
  const auto device = open();
  const auto shows = [&](const Vec3& p, const Mat3& R) {
    return comes([&] {
      device->read(reading);
      return reading.X_BD.translation().isApprox(p, 1e-12) && reading.X_BD.linear().isApprox(R);
    });
  };
  for (int n = 0; n < 3; ++n)
    for (const double sign : {1.0, -1.0}) {
      const Mat3 R{Eigen::AngleAxisd{0.4 * sign, Vec3::Unit(n)}};
      handle(50.0 * sign * Vec3::Unit(n), R);
      EXPECT_TRUE(shows(0.05 * sign * Vec3::Unit(n), R)) << n;
    }
  stub.buttons = 3;
  EXPECT_TRUE(comes([&] { return device->read(reading), reading.buttons == 3; }));
  EXPECT_GT(reading.time_ns, 0);
}

TEST_F(OpenHaptics, SendsForceInNewtonAndTorqueInItsThousandths) {
  stub.model = "PHANTOM Premium 1.5 6DOF";
  stub.outputs = 6;
  stub.torque = 188.0;
  const auto device = open();
  EXPECT_EQ(device->rating().actuated, 6);
  EXPECT_GT(device->rating().torque, 0.0);
  for (std::size_t n = 0; n < 6; ++n)
    for (const double sign : {1.0, -1.0}) {
      SCOPED_TRACE(n);
      Wrench wrench;
      std::array<double, 6> expected{};
      (n < 3 ? wrench.force : wrench.torque)[static_cast<int>(n % 3)] = 0.1 * sign;
      expected[n] = (n < 3 ? 0.1 : 100.0) * sign;
      EXPECT_TRUE(arrives(*device, wrench, expected));
    }
}

// a unit that gives its torque in N·m would turn a thousand times too strongly
TEST_F(OpenHaptics, SendsNoTorqueWhereItsUnitIsInDoubt) {
  stub.model = "PHANTOM Premium 1.5 6DOF";
  for (const auto& [outputs, torque] :
       {std::pair{6, 0.188}, std::pair{6, 0.0}, std::pair{6, 1e6}, std::pair{3, 188.0}}) {
    stub.outputs = outputs;
    stub.torque = torque;
    const auto device = open();
    EXPECT_EQ(device->rating().torque, 0.0);
    EXPECT_EQ(device->rating().actuated, 3);
    EXPECT_TRUE(arrives(*device, push, pushed));
  }
}

TEST_F(OpenHaptics, IsDrivenByTheLibrarysThreadFromStartToEnd) {
  auto device = open();
  EXPECT_TRUE(stub.force_on);
  EXPECT_TRUE(stub.clamped);
  ASSERT_TRUE(arrives(*device, push, pushed));
  device->write(push);
  device.reset();
  EXPECT_EQ(stub.wrench(), kNoTorque);
  EXPECT_EQ(stub.story(), (std::vector<std::string>{"open", "schedule", "start", "stop",
                                                    "unschedule", "disable", "close"}));
  const long calls = stub.calls;
  std::this_thread::sleep_for(std::chrono::milliseconds{20});
  EXPECT_EQ(stub.calls, calls);
}

TEST_F(OpenHaptics, IsStaleThenLostWhenTheLibraryCallsNoMoreAndOpensAgain) {
  auto device = open();
  ASSERT_TRUE(arrives(*device, push, pushed));
  stub.frozen = true;
  EXPECT_TRUE(reads(*device, DeviceStatus::Stale, push));
  EXPECT_TRUE(reads(*device, DeviceStatus::Lost, push));
  EXPECT_EQ(reading.trouble, Trouble::Lost);
  EXPECT_EQ(device->write(push), DeviceStatus::Lost);
  // it wakes up: still no force, and still lost
  stub.frozen = false;
  EXPECT_TRUE(comes([&] { return stub.wrench() == kNoTorque; }));
  EXPECT_FALSE(anyForce(*device, push));
  EXPECT_EQ(device->read(reading), DeviceStatus::Lost);
  device.reset();
  EXPECT_TRUE(open());
}

TEST_F(OpenHaptics, IsLostWhenTheLibraryNeverCalls) {
  stub.frozen = true;
  const auto device = tryToOpen();
  ASSERT_TRUE(device);
  EXPECT_TRUE(reads(**device, DeviceStatus::Lost));
}

TEST_F(OpenHaptics, SendsZeroItselfWhenClosedWhileTheLibraryDoesNotCall) {
  auto device = open();
  ASSERT_TRUE(arrives(*device, push, pushed));
  stub.frozen = true;
  std::this_thread::sleep_for(std::chrono::milliseconds{5});
  device.reset();
  EXPECT_EQ(stub.wrench(), kNoTorque);
  EXPECT_EQ(stub.story().back(), "close");
  stub.frozen = false;
  EXPECT_TRUE(open());
}

TEST_F(OpenHaptics, IsLostAtOnceByAFaultUnderForceAndOpensAgain) {
  for (const unsigned error : {0x300u, 0x302u, 0x303u, 0x304u, 0x3FFu}) {
    SCOPED_TRACE(error);
    auto device = open();
    ASSERT_TRUE(arrives(*device, push, pushed));
    stub.errors_left = 1;       // once is enough
    stub.second_error = 0x201;  // which is not what it is about
    stub.frame_error = error;
    EXPECT_TRUE(reads(*device, DeviceStatus::Lost, push));
    EXPECT_EQ(reading.trouble, Trouble::Lost);
    EXPECT_TRUE(comes([&] { return stub.wrench() == kNoTorque; }));
    EXPECT_FALSE(anyForce(*device, push));
    stub.frame_error = stub.second_error = 0;
    stub.errors_left = -1;
    device.reset();
    EXPECT_TRUE(open());
  }
}

TEST_F(OpenHaptics, IsLostByTheThirdErrorOfAnyOtherKindInARow) {
  for (const unsigned error : {0x201u, 0x202u, 0x203u, 0x204u, 0x103u, 0x402u, 0x501u, 0xDEADu}) {
    SCOPED_TRACE(error);
    const auto device = open();
    ASSERT_TRUE(arrives(*device, push, pushed));
    const long forces = stub.unlike_zero, frames = stub.frames;
    stub.frame_error = error;
    EXPECT_TRUE(reads(*device, DeviceStatus::Lost, push));
    EXPECT_GE(stub.frames - frames, 2);
    // a frame that was under way when the first error came, and that which brought it
    EXPECT_LE(stub.unlike_zero - forces, stub.frames - frames);
    EXPECT_TRUE(comes([&] { return stub.wrench() == kNoTorque; }));
    stub.frame_error = 0;
  }
}

TEST_F(OpenHaptics, PausesAfterOneErrorUntilZeroIsAskedForLongEnough) {
  const auto device = open();
  ASSERT_TRUE(arrives(*device, push, pushed));
  stub.errors_left = 1;
  stub.frame_error = 0x203;
  EXPECT_TRUE(reads(*device, DeviceStatus::NotReady, push));
  EXPECT_EQ(reading.trouble, Trouble::ForceOff);
  EXPECT_FALSE(anyForce(*device, push, 1500));  // a second and more, for force is asked for
  EXPECT_EQ(device->read(reading), DeviceStatus::NotReady);
  EXPECT_TRUE(reads(*device, DeviceStatus::Ok));
  EXPECT_TRUE(arrives(*device, push, pushed));
}

TEST_F(OpenHaptics, LetsWarmMotorsCoolDown) {
  const auto device = open();
  ASSERT_TRUE(arrives(*device, push, pushed));
  stub.frame_error = 0x200;
  EXPECT_TRUE(reads(*device, DeviceStatus::NotReady, push));
  EXPECT_EQ(reading.trouble, Trouble::MotorsHot);
  EXPECT_TRUE(comes([&] { return stub.wrench() == kNoTorque; }));
  EXPECT_FALSE(anyForce(*device, push));
  EXPECT_EQ(device->read(reading), DeviceStatus::NotReady);  // warm is not lost
  stub.frame_error = 0;
  const long cool = stub.frames;
  EXPECT_TRUE(reads(*device, DeviceStatus::Ok));
  EXPECT_GE(stub.frames - cool, 100);
  EXPECT_TRUE(arrives(*device, push, pushed));
}

TEST_F(OpenHaptics, NeverShowsAPoseThatCannotBe) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Vec3, Mat3>> impossible{
      {{kNan, 0.0, 0.0}, Mat3::Identity()},
      {{0.0, std::numeric_limits<double>::infinity(), 0.0}, Mat3::Identity()},
      {{0.0, 7000.0, 0.0}, Mat3::Identity()},
      {Vec3::Zero(), Mat3::Zero()},
      {Vec3::Zero(), Mat3::Constant(kNan)},
      {Vec3::Zero(), -Mat3::Identity()}};
  for (const auto& [p, R] : impossible) {
    handle(Vec3{10.0, 20.0, 30.0}, Mat3::Identity());
    const auto device = open();
    ASSERT_TRUE(arrives(*device, push, pushed));
    handle(p, R);
    EXPECT_TRUE(comes([&] {
      const DeviceStatus status = device->read(reading);
      device->write(push);
      EXPECT_TRUE(reading.X_BD.translation().isApprox(Vec3(0.01, 0.02, 0.03), 1e-12));
      return status == DeviceStatus::Lost;
    }));
    EXPECT_TRUE(comes([&] { return stub.wrench() == kNoTorque; }));
  }
}

TEST_F(OpenHaptics, HasNoForceUntilItIsCalibrated) {
  for (const unsigned calibration : {0x5001u, 0x5002u, 0u}) {
    SCOPED_TRACE(calibration);
    stub.calibrations = 0;
    stub.calibration = calibration;
    const auto device = tryToOpen();
    ASSERT_TRUE(device);
    EXPECT_FALSE(anyForce(**device, push));
    EXPECT_EQ((*device)->read(reading), DeviceStatus::NotReady);
    EXPECT_EQ(reading.trouble, Trouble::NeedsCalibration);
    EXPECT_EQ(stub.calibrations > 0, calibration == 0x5001u);
    if (calibration == 0x5001u) {
      EXPECT_EQ(stub.calibration_style, 4);
    }
    stub.calibration = 0x5000;
    EXPECT_TRUE(reads(**device, DeviceStatus::Ok));
    EXPECT_TRUE(arrives(**device, push, pushed));
  }
}

// encoders are reset where the arm stands: only by its user, who has put it there
TEST_F(OpenHaptics, DoesNotResetEncodersByItself) {
  stub.style = 1;
  stub.calibration = 0x5001;
  const auto device = tryToOpen();
  ASSERT_TRUE(device);
  EXPECT_FALSE(anyForce(**device, push));
  EXPECT_EQ(stub.calibrations, 0);
}

TEST_F(OpenHaptics, SendsZeroForWhatIsNotFiniteAndForWhatNobodyConfirms) {
  const auto device = open();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    ASSERT_TRUE(arrives(*device, push, pushed));
    Wrench wrench = push;
    wrench.force.x() = bad;
    EXPECT_TRUE(arrives(*device, wrench, kNoTorque));
    ASSERT_TRUE(arrives(*device, push, pushed));
    wrench = push;
    wrench.torque.x() = bad;
    EXPECT_TRUE(arrives(*device, wrench, kNoTorque));
  }
  ASSERT_TRUE(arrives(*device, push, pushed));
  EXPECT_TRUE(comes([&] { return stub.wrench() == kNoTorque; }));
}

TEST_F(OpenHaptics, StopsFromAnotherThreadWhateverIsWritten) {
  const auto device = open();
  std::atomic<bool> end{false};
  std::thread servo{[&] {
    DeviceReading mine;
    while (!end) {
      device->read(mine);
      device->write(push);
    }
  }};
  EXPECT_TRUE(comes([&] { return stub.unlike_zero > 20; }));
  device->stop();
  const long stopped = stub.frames;
  EXPECT_TRUE(comes([&] { return stub.frames > stopped + 2; }));
  const long forces = stub.unlike_zero;
  EXPECT_TRUE(comes([&] { return stub.frames > stopped + 100; }));
  EXPECT_EQ(stub.unlike_zero, forces);
  EXPECT_EQ(stub.wrench(), kNoTorque);
  end = true;
  servo.join();
  device->resume();
  EXPECT_TRUE(arrives(*device, push, pushed));
}

}  // namespace
