// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/falcon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "haptics/devices/falcon_kinematics.h"
#include "haptics/devices/falcon_packets.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Transport;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using haptics::falcon::decoded;
using haptics::falcon::encoded;
using haptics::falcon::FalconPlace;
using haptics::falcon::FalconPort;
using haptics::falcon::linkTo;
using haptics::falcon::Motors;
using haptics::falcon::Packet;
using haptics::falcon::Reply;
using haptics::falcon::Sent;

using Bytes = std::vector<std::uint8_t>;

/// A Falcon of the test's, with a clock of its own, which only waiting moves.
struct FakeFalcon {
  // how it is
  bool firmware_runs = true;
  bool gone = false;
  bool mute = false;               ///< nothing that it says gets through any more
  int sends_left = 1'000'000'000;  ///< then it is unplugged
  std::array<std::int16_t, 3> encoders{};
  std::uint8_t homed = 0b111, buttons = 0;
  // what it answers to a packet; without, itself
  std::function<void(FakeFalcon&)> answer;
  // how it loads
  int deaf_handshakes = 0;     ///< so many are not answered
  bool leading_zero = false;   ///< before the answer
  int wrong_chunk = -1;        ///< its echo has a wrong byte
  int silent_chunk = -1;       ///< it has no echo
  int wrong_tries = 1'000;     ///< so many loads go wrong
  bool takes_firmware = true;  ///< and runs it afterwards
  // what came
  std::int64_t clock = 1;
  std::vector<std::pair<int, int>> requests;
  std::vector<Motors> motors;
  std::vector<char> controls;
  Bytes loaded;
  int handshakes = 0, loads = 0, chunks = 0, busy_left = 0;
  bool closed = false;
  std::deque<Bytes> waiting;

  enum class Stage { Running, Hello, Begin, Loading } stage = Stage::Running;

  void say(const Bytes& bytes) {
    Bytes transfer{0x01, 0x60};
    transfer.insert(transfer.end(), bytes.begin(), bytes.end());
    waiting.push_back(transfer);
  }
  void say(const std::string& text) { say(Bytes{text.begin(), text.end()}); }
  /// A reply as the firmware would make it.
  Packet reply() const {
    Packet packet = encoded({.motors = encoders});
    packet[13] = static_cast<std::uint8_t>('A' + buttons + 16 * homed);
    return packet;
  }
  std::string text() const {
    const Packet packet = reply();
    return {packet.begin(), packet.end()};
  }
  void standAt(const Vec3& p_B) {
    const Vec3 theta1 = haptics::falcon::legsAt(p_B)->theta1;
    for (std::size_t i = 0; i < 3; ++i)
      encoders[i] = static_cast<std::int16_t>(std::lround(
          (theta1[int(i)] * 180.0 / std::numbers::pi - 35.0) / (360.0 / 1280.0 * 14.25 / 110.0)));
  }

  void heard(const Bytes& bytes) {
    const Bytes hello{0x0a, 0x43, 0x0d};
    switch (stage) {
      case Stage::Running: {
        if (!firmware_runs) return;
        ASSERT_EQ(bytes.size(), 16u);
        Packet packet;
        std::copy(bytes.begin(), bytes.end(), packet.begin());
        Packet motors_alone = packet;
        motors_alone[13] = 'A';
        const auto sent = decoded(motors_alone);
        ASSERT_TRUE(sent);
        motors.push_back(sent->encoders);
        controls.push_back(static_cast<char>(packet[13]));
        answer ? answer(*this) : say(text());
        return;
      }
      case Stage::Hello:
        EXPECT_EQ(bytes, hello);
        ++handshakes;
        if (deaf_handshakes-- > 0) return;
        say(leading_zero ? Bytes{0x00, 0x0a, 0x44, 0x2c, 0x0d} : Bytes{0x0a, 0x44, 0x2c, 0x0d});
        return;
      case Stage::Begin:
        EXPECT_EQ(bytes, Bytes{0x41});
        say(Bytes{0x41});
        stage = Stage::Loading;
        loaded.clear();
        chunks = 0;
        ++loads;
        return;
      case Stage::Loading:
        EXPECT_LE(bytes.size(), 62u);
        loaded.insert(loaded.end(), bytes.begin(), bytes.end());
        Bytes echo = bytes;
        if (chunks == wrong_chunk && loads <= wrong_tries) echo.back() ^= 1;
        if (chunks != silent_chunk || loads > wrong_tries) {
          // in two pieces, as it may come
          const auto half = echo.begin() + long(echo.size() / 2);
          say(Bytes{echo.begin(), half});
          say(Bytes{half, echo.end()});
        }
        ++chunks;
        return;
    }
  }
  bool asked(std::uint8_t request, std::uint16_t value) {
    if (gone) return false;
    requests.emplace_back(request, value);
    if (request == 1 && value == 0x0101) stage = Stage::Hello;
    if (request == 3 && value == 0x15) stage = Stage::Begin;
    if (request == 3 && value == 2) {
      if (stage == Stage::Loading) firmware_runs = takes_firmware;
      stage = Stage::Running;
    }
    return true;
  }
};

class FakePort final : public FalconPort {
 public:
  explicit FakePort(FakeFalcon& falcon) : falcon_{falcon} {}
  ~FakePort() override { falcon_.closed = true; }
  bool request(std::uint8_t request, std::uint16_t value) noexcept override {
    return falcon_.asked(request, value);
  }
  Sent send(std::span<const std::uint8_t> bytes) noexcept override {
    if (falcon_.sends_left-- <= 0) falcon_.gone = true;
    if (falcon_.gone) return Sent::Gone;
    if (falcon_.busy_left > 0) return --falcon_.busy_left, Sent::Busy;
    falcon_.heard({bytes.begin(), bytes.end()});
    return Sent::Taken;
  }
  std::optional<std::size_t> receive(std::span<std::uint8_t> transfer,
                                     std::chrono::nanoseconds wait) noexcept override {
    if (falcon_.mute) return std::nullopt;
    if (falcon_.waiting.empty()) {
      if (falcon_.gone) return std::nullopt;
      falcon_.clock += wait.count();
      return 0;
    }
    falcon_.clock += 100'000;
    const Bytes bytes = falcon_.waiting.front();
    falcon_.waiting.pop_front();
    EXPECT_LE(bytes.size(), transfer.size());
    std::copy(bytes.begin(), bytes.end(), transfer.begin());
    return bytes.size();
  }
  std::int64_t now() const noexcept override { return falcon_.clock; }

 private:
  FakeFalcon& falcon_;
};

std::unique_ptr<Transport> linked(FakeFalcon& falcon) {
  auto link = linkTo(std::make_unique<FakePort>(falcon), {});
  EXPECT_TRUE(link) << (link ? "" : sentence(link.error()));
  falcon.motors.clear();
  falcon.controls.clear();
  return link ? std::move(*link) : nullptr;
}

const Wrench kFalconPush{.force = {0.5, -0.3, 1.0}};

bool isZero(const Motors& motors) { return motors == Motors{}; }

std::filesystem::path fileOf(const std::string& name, const Bytes& bytes) {
  static const support::ScratchFolder folder;
  return folder.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Firmware of the test's own: 40 chunks, the last one short, zeros in front.
Bytes someFirmware() {
  Bytes bytes(39 * 62 + 17);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(i < 4 ? 0 : i * 7);
  return bytes;
}

TEST(Falcon, ReadsThePlaceOfTheGripAndPushesIt) {
  FakeFalcon falcon;
  const auto link = linked(falcon);
  const Vec3 p{0.02, -0.01, 0.015};
  falcon.standAt(p);
  falcon.buttons = 0b0101;
  DeviceReading reading;
  ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  EXPECT_LT((reading.X_BD.translation() - p).norm(), 1e-4);
  EXPECT_TRUE(reading.X_BD.linear().isIdentity(0.0));
  EXPECT_EQ(reading.buttons, 0b0101u);
  EXPECT_EQ(reading.trouble, Trouble::None);
  EXPECT_GT(reading.time_ns, 0);
  EXPECT_TRUE(isZero(falcon.motors.back()));  // nothing was known when it was sent
  ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  // the force that these motors make is the one that was asked for
  const auto legs = haptics::falcon::legsAt(reading.X_BD.translation());
  const Motors& motors = falcon.motors.back();
  const Vec3 torques = Vec3{double(motors[0]), double(motors[1]), double(motors[2])} / -10'000.0;
  const Vec3 felt = velocityJacobian(*legs).transpose() * torques;
  EXPECT_LT((felt - kFalconPush.force).norm(), 0.01);
  EXPECT_EQ(falcon.controls.back(), 'A' + 1 + 4);  // homing and blue
}

TEST(Falcon, AGreatForceKeepsItsDirectionWithinTheMotors) {
  FakeFalcon falcon;
  const auto link = linked(falcon);
  falcon.standAt({0.01, 0.02, 0.0});
  DeviceReading reading;
  link->exchange({}, reading);
  const Vec3 force{300.0, -200.0, 500.0};
  ASSERT_EQ(link->exchange({.force = force}, reading), DeviceStatus::Ok);
  const Motors& motors = falcon.motors.back();
  const Vec3 sent{double(motors[0]), double(motors[1]), double(motors[2])};
  EXPECT_LE(sent.cwiseAbs().maxCoeff(), 4096.0);
  EXPECT_GT(sent.cwiseAbs().maxCoeff(), 3000.0);
  const auto legs = haptics::falcon::legsAt(reading.X_BD.translation());
  const Vec3 felt = velocityJacobian(*legs).transpose() * (-sent);
  EXPECT_LT((felt.normalized() - force.normalized()).norm(), 1e-3);
}

TEST(Falcon, WhatIsNotFiniteIsZero) {
  FakeFalcon falcon;
  const auto link = linked(falcon);
  falcon.standAt({0.0, 0.0, 0.0});
  DeviceReading reading;
  link->exchange({}, reading);
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e308}) {
    ASSERT_EQ(link->exchange({.force = {1.0, wrong, wrong}}, reading), DeviceStatus::Ok);
    EXPECT_TRUE(isZero(falcon.motors.back()));
    ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
    EXPECT_FALSE(isZero(falcon.motors.back()));
  }
}

TEST(Falcon, HasNoForceUntilAllLegsAreHomed) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.02});
  falcon.homed = 0;
  const auto link = linked(falcon);
  DeviceReading reading;
  for (const std::uint8_t homed : {0b000, 0b001, 0b011, 0b110, 0b101}) {
    falcon.homed = homed;
    for (int n = 0; n < 3; ++n) {
      ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::NotReady);
      EXPECT_EQ(reading.trouble, Trouble::NotHomed);
      EXPECT_TRUE(isZero(falcon.motors.back()));
      EXPECT_EQ(falcon.controls.back(), 'A' + 1 + 8);  // homing and red
    }
  }
  // the stops are reached, and the encoders start anew somewhere else
  falcon.homed = 0b111;
  falcon.standAt({0.0, 0.01, -0.04});
  ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  EXPECT_EQ(reading.trouble, Trouble::None);
  EXPECT_TRUE(isZero(falcon.motors.back()));
  ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  EXPECT_FALSE(isZero(falcon.motors.back()));
  EXPECT_EQ(falcon.controls.back(), 'A' + 1 + 4);
  // a leg that is no longer homed: the packet under way still pushes, the next does not
  falcon.homed = 0b101;
  EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::NotReady);
  EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::NotReady);
  EXPECT_TRUE(isZero(falcon.motors.back()));
}

/// Exchanges well, then once with the fault, then well again; the packet after a fault is zero.
void expectZeroAfter(const std::function<void(FakeFalcon&)>& fault, DeviceStatus expected) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading, before;
  link->exchange(kFalconPush, reading);
  ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  ASSERT_FALSE(isZero(falcon.motors.back()));
  before = reading;
  falcon.answer = fault;
  const std::int64_t begun = falcon.clock;
  EXPECT_EQ(link->exchange(kFalconPush, reading), expected);
  EXPECT_LE(falcon.clock - begun, 5'000'000);
  if (expected == DeviceStatus::Stale) {
    EXPECT_EQ(reading.X_BD.translation(), before.X_BD.translation());
    EXPECT_EQ(reading.time_ns, before.time_ns);
  }
  falcon.answer = nullptr;
  falcon.gone = false;
  link->exchange(kFalconPush, reading);
  EXPECT_TRUE(isZero(falcon.motors.back()));
  EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  EXPECT_FALSE(isZero(falcon.motors.back()));
}

TEST(Falcon, NoReplyIsStaleAndTheNextPacketZero) {
  expectZeroAfter([](FakeFalcon&) {}, DeviceStatus::Stale);
}

TEST(Falcon, AShortReplyIsStaleAndTheNextPacketZero) {
  expectZeroAfter([](FakeFalcon& falcon) { falcon.say(falcon.text().substr(0, 11)); },
                  DeviceStatus::Stale);
  expectZeroAfter([](FakeFalcon& falcon) { falcon.say("<AAAA>"); }, DeviceStatus::Stale);
}

TEST(Falcon, ACorruptReplyIsStaleAndTheNextPacketZero) {
  expectZeroAfter(
      [](FakeFalcon& falcon) {
        std::string text = falcon.text();
        text[6] = '~';
        falcon.say(text);
      },
      DeviceStatus::Stale);
}

TEST(Falcon, AFloodOfGarbageIsStaleAndTheNextPacketZero) {
  expectZeroAfter(
      [](FakeFalcon& falcon) {
        for (int n = 0; n < 300; ++n) falcon.say(std::string(62, n % 2 ? '<' : '\xff'));
      },
      DeviceStatus::Stale);
}

TEST(Falcon, AnEncoderThatJumpsIsStaleAndTheNextPacketZero) {
  for (std::size_t leg = 0; leg < 3; ++leg)
    expectZeroAfter(
        [leg](FakeFalcon& falcon) {
          auto right = falcon.encoders;
          falcon.encoders[leg] = static_cast<std::int16_t>(right[leg] + 600);  // 22 degrees
          falcon.say(falcon.text());
          falcon.encoders = right;
        },
        DeviceStatus::Stale);
}

TEST(Falcon, AnglesThatNoGripCanHaveAreStaleAndTheNextPacketZero) {
  expectZeroAfter(
      [](FakeFalcon& falcon) {
        const auto right = falcon.encoders;
        falcon.encoders = {20'000, -20'000, 32'767};
        falcon.say(falcon.text());
        falcon.encoders = right;
      },
      DeviceStatus::Stale);
}

TEST(Falcon, AnEncoderThatStaysWhereItJumpedIsNeverTaken) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading;
  ASSERT_EQ(link->exchange({}, reading), DeviceStatus::Ok);
  falcon.encoders[1] = static_cast<std::int16_t>(falcon.encoders[1] + 600);
  for (int n = 0; n < 200; ++n) {
    ASSERT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Stale);
    EXPECT_TRUE(n == 0 || isZero(falcon.motors.back()));
  }
}

TEST(Falcon, AFastHandIsNoJump) {
  FakeFalcon falcon;
  falcon.standAt({-0.04, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading;
  // 2 m/s, and one reply in twenty does not come
  int stale = 0, taken = 0;
  double x = -0.04;
  for (int n = 0; n < 400; ++n) {
    const std::int64_t begun = falcon.clock;
    falcon.answer = n % 20 == 10 ? [](FakeFalcon&) {} : std::function<void(FakeFalcon&)>{};
    falcon.standAt({x, 0.0, 0.0});
    const DeviceStatus status = link->exchange({}, reading);
    stale += status == DeviceStatus::Stale;
    taken += status == DeviceStatus::Ok;
    falcon.clock += 900'000;
    const double passed = 1e-9 * double(falcon.clock - begun);
    x += (n / 20 % 2 == 0 ? 2.0 : -2.0) * passed;
  }
  EXPECT_EQ(stale, 20);
  EXPECT_EQ(taken, 380);
}

TEST(Falcon, ALateReplyIsNotTakenForTheNextOne) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading;
  link->exchange({}, reading);
  const std::string old = falcon.text();
  falcon.answer = [](FakeFalcon&) {};
  EXPECT_EQ(link->exchange({}, reading), DeviceStatus::Stale);
  // it comes just before the next command
  falcon.say(old);
  falcon.answer = nullptr;
  falcon.standAt({0.01, 0.0, 0.0});
  ASSERT_EQ(link->exchange({}, reading), DeviceStatus::Ok);
  EXPECT_NEAR(reading.X_BD.translation().x(), 0.01, 1e-4);
  // it comes just after the next command
  const std::string second = falcon.text();
  falcon.answer = [](FakeFalcon&) {};
  EXPECT_EQ(link->exchange({}, reading), DeviceStatus::Stale);
  falcon.standAt({0.02, 0.0, 0.0});
  falcon.answer = [second](FakeFalcon& self) {
    self.say(second);
    self.say(self.text());
  };
  ASSERT_EQ(link->exchange({}, reading), DeviceStatus::Ok);
  EXPECT_NEAR(reading.X_BD.translation().x(), 0.02, 1e-4);
  // and one that never comes costs one exchange its full wait, no more
  falcon.answer = [](FakeFalcon&) {};
  EXPECT_EQ(link->exchange({}, reading), DeviceStatus::Stale);
  falcon.answer = nullptr;
  EXPECT_EQ(link->exchange({}, reading), DeviceStatus::Ok);
  const std::int64_t begun = falcon.clock;
  EXPECT_EQ(link->exchange({}, reading), DeviceStatus::Ok);
  EXPECT_LT(falcon.clock - begun, 1'000'000);
}

TEST(Falcon, ADoubledReplyDoesNotDelayTheOnesAfterIt) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading;
  falcon.answer = [](FakeFalcon& self) {
    self.say(self.text());
    self.say(self.text());
  };
  link->exchange({}, reading);
  for (int n = 1; n < 10; ++n) {
    falcon.standAt({0.001 * n, 0.0, 0.0});
    ASSERT_EQ(link->exchange({}, reading), DeviceStatus::Ok);
    EXPECT_NEAR(reading.X_BD.translation().x(), 0.001 * n, 1e-4);
  }
}

TEST(Falcon, ARepliesPiecesAreJoined) {
  FakeFalcon falcon;
  falcon.standAt({0.01, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading;
  for (std::size_t cut = 1; cut < 16; ++cut) {
    falcon.answer = [cut](FakeFalcon& self) {
      self.say(self.text().substr(0, cut));
      self.say(self.text().substr(cut));
    };
    EXPECT_EQ(link->exchange({}, reading), DeviceStatus::Ok) << cut;
  }
}

TEST(Falcon, ABusThatDoesNotTakeThePacketIsStaleAndLaterZero) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  const auto link = linked(falcon);
  DeviceReading reading;
  link->exchange(kFalconPush, reading);
  falcon.busy_left = 2;
  EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Stale);
  EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Stale);
  EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Ok);
  EXPECT_TRUE(isZero(falcon.motors.back()));
}

TEST(Falcon, UnpluggedIsLost) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  auto link = linked(falcon);
  DeviceReading reading;
  link->exchange(kFalconPush, reading);
  // while the reply is waited for, and from then on
  falcon.answer = [](FakeFalcon& self) { self.gone = true; };
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Lost);
    EXPECT_EQ(reading.trouble, Trouble::Lost);
  }
  link.reset();
  EXPECT_TRUE(falcon.closed);
}

TEST(Falcon, WhoOnlyHearsAnyMoreIsLostAndToldToLetGo) {
  for (const int busy : {0, 1, 2}) {
    FakeFalcon falcon;
    falcon.standAt({0.0, 0.0, 0.0});
    auto link = linked(falcon);
    DeviceReading reading;
    link->exchange(kFalconPush, reading);
    link->exchange(kFalconPush, reading);
    ASSERT_FALSE(isZero(falcon.motors.back()));
    falcon.mute = true;
    EXPECT_EQ(link->exchange(kFalconPush, reading), DeviceStatus::Lost);
    EXPECT_TRUE(isZero(falcon.motors.back()));
    falcon.motors.clear();
    falcon.busy_left = busy;
    link.reset();
    ASSERT_EQ(falcon.motors.size(), 1u) << busy;
    EXPECT_TRUE(isZero(falcon.motors.back()));
  }
}

TEST(Falcon, DestructionSendsZerosAndWaitsForOneToBeConfirmed) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  auto link = linked(falcon);
  DeviceReading reading;
  link->exchange(kFalconPush, reading);
  link->exchange(kFalconPush, reading);
  ASSERT_FALSE(isZero(falcon.motors.back()));
  const std::size_t sent = falcon.motors.size();
  link.reset();
  EXPECT_EQ(falcon.motors.size(), sent + 1);
  EXPECT_TRUE(isZero(falcon.motors.back()));
  EXPECT_TRUE(falcon.closed);
  // one that does not answer is told three times, and not waited for for ever
  FakeFalcon silent;
  silent.standAt({0.0, 0.0, 0.0});
  auto other = linked(silent);
  other->exchange(kFalconPush, reading);
  silent.answer = [](FakeFalcon&) {};
  silent.motors.clear();
  const std::int64_t begun = silent.clock;
  other.reset();
  EXPECT_EQ(silent.motors, (std::vector<Motors>(3)));
  EXPECT_LE(silent.clock - begun, 100'000'000);
}

TEST(Falcon, AsADeviceItStopsAtOnceAndEndsWithZeros) {
  FakeFalcon falcon;
  falcon.standAt({0.0, 0.0, 0.0});
  std::atomic<int> packets{0}, pushes{0};
  // (a clock that only waiting moves goes on here: every exchange takes some of it)
  falcon.answer = [&](FakeFalcon& self) {
    ++packets;
    pushes += !isZero(self.motors.back());
    self.motors.erase(self.motors.begin(), self.motors.end() - 1);
    self.say(self.text());
  };
  auto link = linkTo(std::make_unique<FakePort>(falcon), {});
  ASSERT_TRUE(link);
  auto device =
      threaded(std::move(*link), *haptics::findRating("falcon"), std::chrono::seconds{20});
  DeviceReading reading;
  const auto waitFor = [&](const auto& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{30};
    while (!holds() && std::chrono::steady_clock::now() < end) {
      device->write(kFalconPush);
      std::this_thread::yield();
    }
    return holds();
  };
  EXPECT_TRUE(waitFor([&] { return device->read(reading) == DeviceStatus::Ok; }));
  EXPECT_TRUE(waitFor([&] { return pushes > 10; }));
  device->stop();
  const int then = packets;
  EXPECT_TRUE(waitFor([&] { return packets > then + 2; }));
  const int pushed = pushes;
  EXPECT_TRUE(waitFor([&] { return packets > then + 200; }));
  EXPECT_EQ(pushes, pushed);
  device->resume();
  EXPECT_TRUE(waitFor([&] { return pushes > pushed; }));
  device.reset();
  EXPECT_TRUE(isZero(falcon.motors.back()));
  EXPECT_TRUE(falcon.closed);
}

TEST(FalconOpening, FirmwareThatRunsIsLeftAlone) {
  FakeFalcon falcon;
  auto link = linkTo(std::make_unique<FakePort>(falcon), "/nowhere/firmware.bin");
  ASSERT_TRUE(link);
  // latency, speed, and both buffers emptied; no line of the chip is touched
  EXPECT_EQ(falcon.requests, (std::vector<std::pair<int, int>>{{9, 1}, {3, 2}, {0, 1}, {0, 2}}));
  EXPECT_EQ(falcon.motors, std::vector<Motors>(1));
  EXPECT_EQ(falcon.loads, 0);
}

TEST(FalconOpening, LoadsFirmwareAsTheBootProgramWantsIt) {
  FakeFalcon falcon;
  falcon.firmware_runs = false;
  auto link = linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware()));
  ASSERT_TRUE(link) << sentence(link.error());
  EXPECT_EQ(falcon.loaded, someFirmware());
  EXPECT_EQ(falcon.chunks, 40);
  const std::vector<std::pair<int, int>> expected{
      {9, 1},      {3, 2},      {0, 1},      {0, 2},               // asked whether it runs
      {0, 1},      {0, 2},      {9, 16},     {3, 0x4138}, {4, 8},  // the boot program, 9600 8N1
      {2, 0},      {1, 0x0200}, {1, 0x0100}, {1, 0x0101},          // its lines
      {1, 0x0100}, {3, 0x15},                                      // 140,000 baud
      {9, 1},      {3, 2},      {0, 1},      {0, 2}};              // and as usual
  EXPECT_EQ(falcon.requests, expected);
}

TEST(FalconOpening, AsksForTheHandshakeAHundredTimes) {
  for (const int deaf : {1, 50, 99}) {
    FakeFalcon falcon;
    falcon.firmware_runs = false;
    falcon.deaf_handshakes = deaf;
    falcon.leading_zero = deaf == 50;
    EXPECT_TRUE(linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware())));
    EXPECT_EQ(falcon.handshakes, deaf + 1);
    EXPECT_EQ(falcon.loaded, someFirmware());
  }
  FakeFalcon falcon;
  falcon.firmware_runs = false;
  falcon.deaf_handshakes = 100'000;
  const auto link = linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware()));
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().reason, "refused");
  EXPECT_EQ(falcon.handshakes, 300);
  EXPECT_LT(falcon.clock, 20'000'000'000);
  EXPECT_TRUE(falcon.closed);
}

TEST(FalconOpening, AWrongEchoOfAnyChunkLoadsAnew) {
  for (int chunk = 0; chunk < 40; ++chunk) {
    FakeFalcon falcon;
    falcon.firmware_runs = false;
    falcon.wrong_chunk = chunk;
    falcon.wrong_tries = 2;
    EXPECT_TRUE(linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware())));
    EXPECT_EQ(falcon.loads, 3);
    EXPECT_EQ(falcon.loaded, someFirmware());

    FakeFalcon never;
    never.firmware_runs = false;
    never.wrong_chunk = chunk;
    const auto link = linkTo(std::make_unique<FakePort>(never), fileOf("firmware", someFirmware()));
    ASSERT_FALSE(link);
    EXPECT_EQ(link.error().reason, "refused");
    EXPECT_NE(sentence(link.error()).find("firmware whole"), std::string::npos);
    EXPECT_EQ(never.loads, 3);
    EXPECT_EQ(never.chunks, chunk + 1);  // nothing after the wrong one
    EXPECT_TRUE(never.motors.empty());
  }
}

TEST(FalconOpening, AMissingEchoLoadsAnew) {
  for (const int chunk : {0, 17, 39}) {
    FakeFalcon falcon;
    falcon.firmware_runs = false;
    falcon.silent_chunk = chunk;
    falcon.wrong_tries = 1;
    EXPECT_TRUE(linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware())));
    EXPECT_EQ(falcon.loads, 2);
    falcon.wrong_tries = 100;
    falcon.firmware_runs = false;
    EXPECT_FALSE(linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware())));
  }
}

TEST(FalconOpening, SaysWhatIsWrongWithTheFirmware) {
  const auto refusedWith = [](const std::filesystem::path& file) {
    FakeFalcon falcon;
    falcon.firmware_runs = false;
    const auto link = linkTo(std::make_unique<FakePort>(falcon), file);
    EXPECT_FALSE(link);
    EXPECT_EQ(falcon.handshakes, 0);  // the device was not started anew for that
    if (link) return std::string{};
    EXPECT_EQ(link.error().reason, "no-firmware");
    return sentence(link.error());
  };
  const auto says = [](const std::string& what, const std::string& part) {
    return what.find(part) != std::string::npos;
  };
  EXPECT_TRUE(says(refusedWith({}), "since it was switched on"));
  EXPECT_TRUE(says(refusedWith("/nowhere/firmware.bin"), "cannot be read"));
  EXPECT_TRUE(says(refusedWith(testing::TempDir()), "cannot be read"));
  EXPECT_TRUE(says(refusedWith("/dev/zero"), "cannot be read"));
  EXPECT_TRUE(says(refusedWith(fileOf("empty", {})), "empty"));
  const Bytes most(haptics::falcon::kMostFirmware);
  EXPECT_TRUE(haptics::falcon::readFirmware(fileOf("most", most)));
  EXPECT_TRUE(says(refusedWith(fileOf("absurd", Bytes(most.size() + 1))), "too large"));
  FakeFalcon falcon;
  falcon.firmware_runs = false;
  falcon.takes_firmware = false;
  const auto link = linkTo(std::make_unique<FakePort>(falcon), fileOf("other", someFirmware()));
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().reason, "no-firmware");
  EXPECT_TRUE(says(sentence(link.error()), "does not run it"));
}

TEST(FalconOpening, UnpluggedMeanwhileIsLost) {
  // while it is asked whether it runs, greeted, and loaded
  for (const int sends : {0, 5, 9, 10, 11, 12, 30, 51}) {
    FakeFalcon falcon;
    falcon.firmware_runs = false;
    falcon.sends_left = sends;
    const auto link =
        linkTo(std::make_unique<FakePort>(falcon), fileOf("firmware", someFirmware()));
    ASSERT_FALSE(link) << sends;
    EXPECT_EQ(link.error().reason, "lost") << sends;
  }
}

TEST(FalconSurvey, SaysWhatIsMissing) {
  using haptics::falcon::entriesOf;
  const auto none = entriesOf({});
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].id, "falcon");
  EXPECT_FALSE(none[0].present);
  EXPECT_EQ(none[0].trouble, Trouble::NotPluggedIn);
  EXPECT_FALSE(none[0].why.empty());
  const std::vector<FalconPlace> one{{"1-2"}};
  ASSERT_EQ(entriesOf(one).size(), 1u);
  EXPECT_EQ(entriesOf(one)[0].id, "falcon:1-2");  // whatever else is plugged in
  EXPECT_TRUE(entriesOf(one)[0].present);
  EXPECT_EQ(entriesOf(one)[0].trouble, Trouble::None);
  EXPECT_TRUE(entriesOf(one)[0].why.empty());
  const std::vector<FalconPlace> several{{"1-2", false, false}, {"3-1.4", true, true}};
  const auto entries = entriesOf(several);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].id, "falcon:1-2");
  EXPECT_EQ(entries[0].trouble, Trouble::NoPermission);
  EXPECT_NE(sentence(entries[0].why).find("70-palpate.rules"), std::string::npos);
  EXPECT_EQ(entries[1].id, "falcon:3-1.4");
  EXPECT_EQ(entries[1].trouble, Trouble::InUse);
  for (const auto& entry : entries) EXPECT_TRUE(entry.present && entry.actuated == 3);
}

TEST(FalconSurvey, WhereNoneIsPluggedInOpeningSaysSo) {
  const auto entries = haptics::surveyFalcon();
  ASSERT_FALSE(entries.empty());
  if (entries[0].present) GTEST_SKIP() << "a Falcon is plugged in";
  for (const std::string id : {"falcon", "falcon:", "falcon:9-9", "falcon::"}) {
    const auto device = haptics::openDevice({.id = id});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "not-plugged-in");
  }
}

}  // namespace
