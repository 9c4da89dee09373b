// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "haptics/devices/catalogue.h"
#include "tests/bus/child.h"
#include "tests/bus/falcon_emulator.h"
#include "tests/bus/felt_sphere.h"
#include "tests/support/passing_device.h"
#include "tests/support/sentence.h"

namespace {

using bus::As;
using bus::Bytes;
using bus::Child;
using bus::comesTrue;
using bus::FalconEmulator;
using bus::FeltSphere;
using bus::lineOf;
using haptics::Device;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::ForceReason;
using haptics::ForceState;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;

using Motors = std::array<int, 3>;

constexpr Motors kNone{};
/// The middle of the workspace, which the driver takes for the base's origin, in the Falcon's
/// frame.
const Vec3 kMiddle{0, 0, 0.125};
const Vec3 kFalconPressed{0, 0, FeltSphere::kTouch - 3e-3};

/// A Falcon with a plug, which may be pulled.
struct PluggedFalcon {
  explicit PluggedFalcon(bool loaded = true) : falcon{loaded} {
    hold(FeltSphere::kAbove);
    plug();
  }
  void plug() { port.emplace(0, falcon); }
  void unplug() { port.reset(); }
  void hold(const Vec3& p_BD) { falcon.hold(p_BD + kMiddle); }
  Motors motors() const { return falcon.seen().motors; }
  /// Until the device has heard so many commands more.
  bool hears(std::uint64_t commands) const {
    const std::uint64_t until = falcon.seen().commands + commands;
    return comesTrue([&] { return falcon.seen().commands >= until; });
  }

  FalconEmulator falcon;
  std::optional<bus::UsbPort> port;
};

/// Counts by which the encoders let the grip seem 4 mm deeper in the sphere.
constexpr int kSlipInwards = -110;

struct Heard {
  DeviceStatus status = DeviceStatus::Stale;
  DeviceReading reading;
};

/// Reads, and writes as a servo loop does, until the reading is as wanted.
template <class Condition>
bool readsUntil(Device& device, Heard& heard, Condition condition, const Wrench& wrench = {}) {
  for (int n = 0; n < 20'000; ++n) {
    heard.status = device.read(heard.reading);
    device.write(wrench);
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return false;
}

/// Opened, and homed by its user.
std::unique_ptr<Device> opened(PluggedFalcon& plugged) {
  auto device = haptics::openDevice({"falcon"});
  if (!device) {
    ADD_FAILURE() << sentence(device.error());
    return nullptr;
  }
  Heard heard;
  EXPECT_TRUE(readsUntil(**device, heard, [&] {
    plugged.falcon.home();
    return heard.status == DeviceStatus::Ok;
  }));
  return std::move(*device);
}

bool isPressed(FeltSphere& sphere) {
  return (sphere.snapshot().X_WD.translation() - kFalconPressed).norm() < 1e-4;
}

/// Pressed into the sphere, the hand at rest, and not armed.
bool pressedUnarmed(PluggedFalcon& plugged, FeltSphere& sphere) {
  plugged.hold(kFalconPressed);
  return comesTrue([&] { return isPressed(sphere); });
}

/// Whether the force comes up from zero to most of what the sphere gives, in no fewer commands than
/// a ramp of a second takes.
bool rampsFromZero(PluggedFalcon& plugged, std::uint64_t since) {
  constexpr std::uint64_t kFewest = 400;
  const bool came = comesTrue([&] { return plugged.falcon.force_F().z() > 2.5; });
  return came && plugged.falcon.seen().commands >= since + kFewest;
}

/// Renders the sphere on this device, armed and pressed into it: full force.
std::unique_ptr<FeltSphere> pressed(PluggedFalcon& plugged, std::unique_ptr<Device> device) {
  if (device == nullptr) return nullptr;
  auto sphere = std::make_unique<FeltSphere>(std::move(device));
  sphere->arm();
  plugged.hold(kFalconPressed);
  EXPECT_TRUE(comesTrue([&] {
    return plugged.falcon.force_F().z() > 2.0 && isPressed(*sphere) &&
           sphere->snapshot().force_state == ForceState::On;
  }));
  return sphere;
}
std::unique_ptr<FeltSphere> pressed(PluggedFalcon& plugged) {
  return pressed(plugged, opened(plugged));
}

/// A device whose next read, on demand, takes `kHang`: longer than the watchdog waits. Says what
/// the emulator had seen before and after.
class Hanging final : public support::PassingDevice {
 public:
  static constexpr std::chrono::milliseconds kHang{30};

  /// The test's side of it, which outlives the device.
  struct Hangs {
    std::atomic<bool> wanted{false};
    std::atomic<int> over{0};   ///< hangs that have ended; the two below are of the last one
    std::atomic<int> stops{0};  ///< calls of stop()
    FalconEmulator::Seen before, after;
  };

  Hanging(std::unique_ptr<Device> device, const FalconEmulator& falcon, Hangs& hangs)
      : PassingDevice{std::move(device)}, falcon_{falcon}, hangs_{hangs} {}
  DeviceStatus read(DeviceReading& reading) noexcept override {
    if (hangs_.wanted.exchange(false)) {
      hangs_.before = falcon_.seen();
      std::this_thread::sleep_for(kHang);
      hangs_.after = falcon_.seen();
      ++hangs_.over;
    }
    return PassingDevice::read(reading);
  }
  void stop() noexcept override {
    ++hangs_.stops;
    PassingDevice::stop();
  }

 private:
  const FalconEmulator& falcon_;
  Hangs& hangs_;
};

/// Until the force is at fault; it then stays zero and off for as long as nobody arms it.
void expectLatchedFault(PluggedFalcon& plugged, FeltSphere& sphere,
                        std::initializer_list<ForceReason> reasons) {
  ASSERT_TRUE(comesTrue([&] { return sphere.snapshot().force_state == ForceState::Fault; }));
  ASSERT_TRUE(sphere.runs(20));
  const std::uint64_t forced = plugged.falcon.seen().forced;
  ASSERT_TRUE(sphere.runs(300));
  const haptics::Snapshot last = sphere.snapshot();
  EXPECT_EQ(last.force_state, ForceState::Fault);
  EXPECT_NE(std::find(reasons.begin(), reasons.end(), last.reason), reasons.end())
      << int(last.reason);
  EXPECT_FALSE(sphere.isArmed());
  EXPECT_EQ(last.felt_W.force.norm(), 0.0);
  EXPECT_EQ(plugged.falcon.seen().forced, forced);
  EXPECT_EQ(sphere.transitions().back().to, ForceState::Fault);
}

/// The same, of a device that stays lost until it is opened again: arming it changes nothing.
void expectLost(PluggedFalcon& plugged, FeltSphere& sphere,
                std::initializer_list<ForceReason> reasons = {ForceReason::Lost}) {
  expectLatchedFault(plugged, sphere, reasons);
  EXPECT_EQ(sphere.snapshot().trouble, Trouble::Lost);
  sphere.arm();
  expectLatchedFault(plugged, sphere, reasons);
}

std::filesystem::path fakeFirmware(Bytes& bytes) {
  for (int n = 0; n < 1500; ++n) bytes.push_back(std::uint8_t(n * 7 + n / 256));
  const std::filesystem::path path = "/tmp/fake-firmware.bin";
  std::ofstream{path, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                              std::streamsize(bytes.size()));
  return path;
}

TEST(Falcon, IsNotThereUntilItIsPluggedIn) {
  EXPECT_NE(lineOf(Child{As::Root, {"survey"}}.said(), "falcon").find("not-plugged-in"),
            std::string::npos);
  const auto refused = haptics::openDevice({"falcon"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "not-plugged-in");
  const PluggedFalcon plugged;
  EXPECT_NE(lineOf(Child{As::Root, {"survey"}}.said(), "falcon").find(" none "), std::string::npos);
}

TEST(Falcon, AUserWithoutTheRuleIsToldOfItAndWithItOpensTheDevice) {
  const PluggedFalcon plugged;
  const std::string line = lineOf(Child{As::User, {"survey"}}.said(), "falcon");
  EXPECT_NE(line.find("no-permission"), std::string::npos) << line;
  EXPECT_NE(line.find("70-palpate.rules"), std::string::npos) << line;
  const std::string refused = Child{As::User, {"open", "falcon"}}.said();
  EXPECT_TRUE(refused.starts_with("no-permission ")) << refused;
  EXPECT_NE(refused.find("70-palpate.rules"), std::string::npos) << refused;
  EXPECT_EQ(plugged.falcon.seen().commands, 0u);

  // what the rule does
  ASSERT_EQ(chmod(plugged.port->node().c_str(), 0666), 0);
  const std::string granted = lineOf(Child{As::User, {"survey"}}.said(), "falcon");
  EXPECT_NE(granted.find(" none "), std::string::npos) << granted;
  EXPECT_EQ(Child(As::User, {"open", "falcon"}).said(), "opened\n");
}

TEST(Falcon, TakesItsFirmwareByteByByteAndKeepsItForTheNextProgram) {
  PluggedFalcon plugged{false};
  const auto without = haptics::openDevice({"falcon"});
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().reason, "no-firmware") << sentence(without.error());

  Bytes bytes;
  const std::filesystem::path path = fakeFirmware(bytes);
  {
    const auto with = haptics::openDevice({"falcon", path});
    ASSERT_TRUE(with) << sentence(with.error());
    EXPECT_EQ(plugged.falcon.seen().firmware, bytes);
  }
  EXPECT_TRUE(haptics::openDevice({"falcon"}));
  EXPECT_EQ(plugged.falcon.seen().malformed, 0u);
}

TEST(Falcon, AWrongEchoOfItsFirmwareIsRefusedWithoutACommand) {
  PluggedFalcon plugged{false};
  plugged.falcon.fail({.wrong_echo = true});
  Bytes bytes;
  const auto refused = haptics::openDevice({"falcon", fakeFirmware(bytes)});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "refused") << sentence(refused.error());
  EXPECT_EQ(plugged.falcon.seen().commands, 0u);
}

TEST(Falcon, GetsNoForceBeforeItIsHomedWhateverIsWritten) {
  PluggedFalcon plugged;
  auto device = haptics::openDevice({"falcon"});
  ASSERT_TRUE(device) << sentence(device.error());
  Heard heard;
  EXPECT_TRUE(readsUntil(**device, heard,
                         [&] {
                           return heard.status == DeviceStatus::NotReady &&
                                  heard.reading.trouble == Trouble::NotHomed;
                         },
                         {.force = Vec3{0, 0, 3}}));
  const std::uint64_t until = plugged.falcon.seen().commands + 300;
  EXPECT_TRUE(readsUntil(**device, heard, [&] { return plugged.falcon.seen().commands >= until; },
                         {.force = Vec3{0, 0, 3}}));
  EXPECT_EQ(plugged.falcon.seen().forced, 0u);
  EXPECT_NE(heard.status, DeviceStatus::Ok);
  EXPECT_TRUE(plugged.falcon.home());
  EXPECT_TRUE(readsUntil(**device, heard, [&] { return heard.status == DeviceStatus::Ok; }));
  EXPECT_EQ(heard.reading.trouble, Trouble::None);
}

// position in and force out, at places and in directions all over the workspace
TEST(Falcon, ItsMotorsPushAsWrittenAndItsEncodersSayWhereItIs) {
  PluggedFalcon plugged;
  const auto device = opened(plugged);
  ASSERT_NE(device, nullptr);
  Heard heard;
  for (const Vec3& p_BD :
       {Vec3{0, 0, 0}, Vec3{0.02, 0.01, 0.01}, Vec3{-0.03, 0.02, -0.02}, Vec3{0.01, -0.03, 0.03}}) {
    plugged.hold(p_BD);
    ASSERT_TRUE(readsUntil(*device, heard, [&] {
      return heard.status == DeviceStatus::Ok &&
             (heard.reading.X_BD.translation() - p_BD).norm() < 1e-4;  // m: two counts
    })) << p_BD.transpose();
    for (const Vec3& force_B : {Vec3{2, 0, 0}, Vec3{0, -2, 0}, Vec3{0, 0, 2}, Vec3{1, 2, -1}}) {
      int same = 0, none = 0, other = 0;
      // what was under way may still arrive; a write that came late ends in zero
      for (int n = 0; n < 2000 && same < 40 && other < 10; ++n) {
        const std::uint64_t before = plugged.falcon.seen().commands;
        device->read(heard.reading);
        device->write({.force = force_B});
        for (int k = 0; k < 1000 && plugged.falcon.seen().commands == before; ++k)
          std::this_thread::sleep_for(std::chrono::microseconds{100});
        if (n < 20) continue;
        const Vec3 force_F = plugged.falcon.force_F();
        if (force_F.norm() == 0.0)
          ++none;
        else if ((force_F - force_B).norm() < 0.02)  // N: a count of a motor, and of an encoder
          ++same;
        else
          ++other;
      }
      EXPECT_EQ(same, 40) << p_BD.transpose() << " / " << force_B.transpose() << ": " << none
                          << " none, " << other << " other";
      EXPECT_EQ(other, 0) << p_BD.transpose() << " / " << force_B.transpose() << ", last "
                          << plugged.falcon.force_F().transpose();
    }
  }
  EXPECT_LE(plugged.falcon.seen().largest, 4096);
  EXPECT_EQ(plugged.falcon.seen().malformed, 0u);
  plugged.falcon.press(0b0101);
  EXPECT_TRUE(readsUntil(*device, heard, [&] { return heard.reading.buttons == 0b0101; }));
}

TEST(Falcon, GivesNoForceBeforeItIsArmedAndThenRampsFromZero) {
  PluggedFalcon plugged;
  auto device = opened(plugged);
  ASSERT_NE(device, nullptr);
  FeltSphere sphere{std::move(device)};
  ASSERT_TRUE(pressedUnarmed(plugged, sphere));
  ASSERT_TRUE(plugged.hears(300));
  const haptics::Snapshot withheld = sphere.snapshot();
  EXPECT_EQ(withheld.force_state, ForceState::Ready);
  EXPECT_GT(withheld.coupling_W.force.z(), 2.0);
  EXPECT_EQ(withheld.felt_W.force.norm(), 0.0);
  EXPECT_EQ(plugged.falcon.seen().forced, 0u);

  const std::uint64_t since = plugged.falcon.seen().commands;
  sphere.arm();
  EXPECT_TRUE(rampsFromZero(plugged, since))
      << plugged.falcon.seen().commands - since << " commands";
}

TEST(Falcon, TheServoLoopRendersASphereAndEndsAtZeroForce) {
  PluggedFalcon plugged;
  auto sphere = pressed(plugged);
  ASSERT_NE(sphere, nullptr);
  // a thousand ticks, along the surface and back
  Vec3 p_BD = kFalconPressed;
  for (int n = 0; n < 40; ++n) {
    const double angle = 0.5 * std::sin(0.3 * n);
    p_BD = kFalconPressed.z() * Vec3{std::sin(angle), 0.0, std::cos(angle)};
    plugged.hold(p_BD);
    ASSERT_TRUE(sphere->runs(25));
  }
  EXPECT_GE(plugged.falcon.seen().commands, 1000u);
  // the guards let a sound device alone: the force came up once, and stayed
  std::vector<ForceState> states;
  for (const haptics::ForceTransition& step : sphere->transitions()) states.push_back(step.to);
  EXPECT_EQ(states, (std::vector{ForceState::Ready, ForceState::Armed, ForceState::Ramping,
                                 ForceState::On}));
  const haptics::Snapshot end = sphere->snapshot();
  std::cout << "of " << end.tick << " ticks " << end.late_ticks << " were late, "
            << end.missed_ticks << " missed\n";
  ASSERT_TRUE(
      comesTrue([&] { return (sphere->snapshot().X_WD.translation() - p_BD).norm() < 1e-4; }));
  // at rest the motors are those of the force that the loop says it sent, outwards
  Vec3 felt, pushed;
  const bool equal = comesTrue([&] {
    felt = sphere->snapshot().felt_W.force;
    pushed = plugged.falcon.force_F();
    return felt.norm() > 2.0 && (felt - pushed).norm() < 0.05;
  });
  EXPECT_TRUE(equal) << felt.transpose() << " / " << pushed.transpose();
  EXPECT_GT(felt.normalized().dot(p_BD.normalized()), 0.99);

  sphere.reset();
  EXPECT_EQ(plugged.motors(), kNone);
  EXPECT_EQ(plugged.falcon.seen().forced_early, 0u);
  EXPECT_EQ(plugged.falcon.seen().malformed, 0u);
}

TEST(Falcon, RepliesInPiecesStaleLateOrGarbledNeitherLoseItNorKickTheHand) {
  PluggedFalcon plugged;
  const Bytes stale{'P', 'P', 'A', 'B', '>', '<', 'A', 'A', 'A', 'A', 'P', 'P'};
  plugged.falcon.leave(stale);
  auto sphere = pressed(plugged);
  ASSERT_NE(sphere, nullptr);
  ASSERT_TRUE(comesTrue([&] { return plugged.falcon.force_F().z() > 2.9; }));
  const int largest = plugged.falcon.seen().largest;
  const auto staysPressed = [&](const char* what) {
    EXPECT_TRUE(plugged.hears(200)) << what;
    EXPECT_TRUE(sphere->isArmed()) << what;
    EXPECT_TRUE(comesTrue([&] { return plugged.falcon.force_F().z() > 2.0; })) << what;
    EXPECT_LT((sphere->snapshot().X_WD.translation() - kFalconPressed).norm(), 1e-4) << what;
    EXPECT_LT(plugged.falcon.seen().largest, 1.1 * largest) << what;
  };
  plugged.falcon.fail({.most_bytes = 5});
  staysPressed("in pieces");
  plugged.falcon.fail({.garble = 1});
  staysPressed("garbled");
  plugged.falcon.fail({.delay = std::chrono::milliseconds{3}});
  staysPressed("late");
  plugged.falcon.leave(stale);
  staysPressed("stale");
}

// one command that was under way may carry a force, none after it
TEST(Falcon, ASilentOneIsLostAtZeroForce) {
  PluggedFalcon plugged;
  auto sphere = pressed(plugged);
  ASSERT_NE(sphere, nullptr);
  const std::uint64_t forced = plugged.falcon.fail({.mute = true}).forced;
  expectLost(plugged, *sphere);
  EXPECT_EQ(plugged.motors(), kNone);
  EXPECT_LE(plugged.falcon.seen().forced, forced + 1);
  // that it answers again is not enough
  plugged.falcon.fail({});
  expectLost(plugged, *sphere);
}

TEST(Falcon, EncodersThatLoseTheirPlaceEndTheForce) {
  PluggedFalcon plugged;
  auto sphere = pressed(plugged);
  ASSERT_NE(sphere, nullptr);
  const std::uint64_t forced = plugged.falcon.jump(400).forced;
  expectLost(plugged, *sphere, {ForceReason::Lost, ForceReason::Jump});
  EXPECT_EQ(plugged.motors(), kNone);
  EXPECT_LE(plugged.falcon.seen().forced, forced + 1);
  // the pose has not gone along
  EXPECT_TRUE(isPressed(*sphere));
}

// 4 mm in a millisecond: no hand under force, and not enough to know that an encoder is wrong
TEST(Falcon, EncodersThatSlipALittleTakeTheForceAwayUntilItRampsAnew) {
  PluggedFalcon plugged;
  auto sphere = pressed(plugged);
  ASSERT_NE(sphere, nullptr);
  const int largest = plugged.falcon.seen().largest;
  plugged.falcon.jump(kSlipInwards);
  ASSERT_TRUE(
      comesTrue([&] { return sphere->times(ForceState::Armed, ForceReason::TooFast) == 1; }));
  plugged.falcon.jump(-kSlipInwards);
  const std::uint64_t since = plugged.falcon.seen().commands;
  EXPECT_TRUE(comesTrue([&] { return plugged.motors() == kNone; }));
  EXPECT_TRUE(rampsFromZero(plugged, since))
      << plugged.falcon.seen().commands - since << " commands";
  EXPECT_LT(plugged.falcon.seen().largest, 1.1 * largest);
  EXPECT_TRUE(sphere->isArmed());
}

TEST(Falcon, PulledOutUnderForceItIsLostAndReplugGivesForceOnlyOnceArmed) {
  PluggedFalcon plugged;
  auto sphere = pressed(plugged);
  ASSERT_NE(sphere, nullptr);
  plugged.unplug();
  expectLost(plugged, *sphere);
  // it has a power supply of its own: as far as is known what was sent last still stands there, and
  // no one can take it back through a cable that is out
  EXPECT_NE(plugged.motors(), kNone);

  // plugged in again it is not the one that the loop had
  plugged.hold(FeltSphere::kAbove);
  plugged.plug();
  expectLost(plugged, *sphere);
  sphere.reset();
  plugged.unplug();
  const auto refused = haptics::openDevice({"falcon"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "not-plugged-in");
  EXPECT_FALSE(sentence(refused.error()).empty());

  plugged.plug();
  const std::uint64_t forced = plugged.falcon.seen().forced;
  auto device = opened(plugged);
  ASSERT_NE(device, nullptr);
  FeltSphere again{std::move(device)};
  EXPECT_EQ(plugged.motors(), kNone);
  ASSERT_TRUE(pressedUnarmed(plugged, again));
  ASSERT_TRUE(plugged.hears(300));
  EXPECT_EQ(again.snapshot().force_state, ForceState::Ready);
  EXPECT_EQ(plugged.falcon.seen().forced, forced);
  const std::uint64_t since = plugged.falcon.seen().commands;
  again.arm();
  EXPECT_TRUE(rampsFromZero(plugged, since))
      << plugged.falcon.seen().commands - since << " commands";
}

TEST(Falcon, AServoThreadThatHangsIsAnsweredWithZeroAndThriceWithAFault) {
  PluggedFalcon plugged;
  auto device = opened(plugged);
  ASSERT_NE(device, nullptr);
  Hanging::Hangs hangs;
  auto sphere =
      pressed(plugged, std::make_unique<Hanging>(std::move(device), plugged.falcon, hangs));
  ASSERT_NE(sphere, nullptr);
  EXPECT_EQ(hangs.stops, 0);
  for (int n = 1; n <= 3; ++n) {
    hangs.stops = 0;
    hangs.wanted = true;
    ASSERT_TRUE(comesTrue([&] { return hangs.over == n; }));
    EXPECT_EQ(hangs.after.motors, kNone);
    EXPECT_GT(hangs.stops, 0);
    const std::uint64_t commands = hangs.after.commands - hangs.before.commands;
    const std::uint64_t forced = hangs.after.forced - hangs.before.forced;
    std::cout << "while it hung: " << commands << " commands, " << forced << " with force\n";
    EXPECT_GE(commands, forced + 5);
    if (n == 3) break;
    // by itself, and from zero
    EXPECT_TRUE(rampsFromZero(plugged, hangs.after.commands));
    EXPECT_TRUE(sphere->isArmed());
    EXPECT_EQ(sphere->times(ForceState::Armed, ForceReason::Gap), n);
  }
  expectLatchedFault(plugged, *sphere, {ForceReason::Stalled});
  EXPECT_EQ(sphere->snapshot().trouble, Trouble::None);
  EXPECT_EQ(plugged.motors(), kNone);
  // the device is sound: whoever arms it has force again
  const std::uint64_t since = plugged.falcon.seen().commands;
  sphere->arm();
  EXPECT_TRUE(rampsFromZero(plugged, since));
}

TEST(Falcon, StoppedFromAnotherThreadNothingWrittenCountsUntilItIsResumed) {
  PluggedFalcon plugged;
  const auto device = opened(plugged);
  ASSERT_NE(device, nullptr);
  const Wrench push{.force = Vec3{0, 0, 2}};
  Heard heard;
  ASSERT_TRUE(readsUntil(
      *device, heard, [&] { return plugged.motors() != kNone; }, push));
  std::thread{[&] { device->stop(); }}.join();
  ASSERT_TRUE(readsUntil(
      *device, heard, [&] { return plugged.motors() == kNone; }, push));
  const std::uint64_t forced = plugged.falcon.seen().forced;
  const std::uint64_t until = plugged.falcon.seen().commands + 100;
  ASSERT_TRUE(readsUntil(
      *device, heard, [&] { return plugged.falcon.seen().commands >= until; }, push));
  EXPECT_EQ(plugged.falcon.seen().forced, forced);
  device->resume();
  EXPECT_TRUE(readsUntil(
      *device, heard, [&] { return plugged.motors() != kNone; }, push));
}

// a fact, not a wish: no watchdog of the device is known, and nobody is left to send a zero
TEST(Falcon, AKilledProgramLeavesItsLastForceStandingUntilTheNextOneOpensTheDevice) {
  PluggedFalcon plugged;
  {
    Child child{As::Root, {"feel", "falcon"}};
    ASSERT_TRUE(comesTrue([&] { return plugged.falcon.home(); }));
    ASSERT_EQ(child.line(), "armed");
    plugged.hold(kFalconPressed);
    ASSERT_TRUE(comesTrue([&] { return plugged.falcon.force_F().z() > 2.0; }));
    child.kill();
  }
  const std::uint64_t commands = plugged.falcon.seen().commands;
  std::this_thread::sleep_for(std::chrono::milliseconds{200});
  EXPECT_EQ(plugged.falcon.seen().commands, commands);
  std::cout << "after SIGKILL the last force is " << plugged.falcon.force_F().transpose()
            << " N, in motor values " << plugged.motors()[0] << " " << plugged.motors()[1] << " "
            << plugged.motors()[2] << "\n";
  EXPECT_GT(plugged.falcon.force_F().z(), 2.0);
  EXPECT_TRUE(haptics::openDevice({"falcon"}));
  EXPECT_EQ(plugged.motors(), kNone);
}

}  // namespace
