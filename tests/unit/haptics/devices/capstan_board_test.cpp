// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/capstan_board.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <random>
#include <thread>

#include "haptics/devices/polhem.h"
#include "haptics/devices/wooden_haptics.h"
#include "tests/support/sentence.h"
#include "tests/unit/haptics/devices/fake_port.h"

namespace {

using fake::Bytes;
using haptics::BoardCommand;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::HidPlace;
using haptics::kPolhemRest;
using haptics::Mat3;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using Counts = haptics::BoardCounts;

constexpr Counts kWork{2000, -6000, 14000, 40, -60, 120};  // in the midst of the workspace

Bytes report(const Counts& counts, bool button = false, bool asks = false,
             std::size_t length = 64) {
  Bytes bytes(length);
  for (std::size_t i = 0; i < 6; ++i) {
    const int value = counts[i] + (button && i == 3 ? 10'000 : 0);
    bytes[2 * i] = static_cast<std::uint8_t>(value & 0xff);
    bytes[2 * i + 1] = static_cast<std::uint8_t>((value >> 8) & 0xff);
  }
  bytes[12] = asks ? 1 : 0;
  return bytes;
}

/// The seven words of a command.
std::array<int, 7> words(std::span<const std::uint8_t> command) {
  std::array<int, 7> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<std::int16_t>(command[1 + 2 * i] | command[2 + 2 * i] << 8);
  return values;
}

bool zero(const Bytes& command) {
  return command.size() == 65 &&
         std::ranges::all_of(command, [](std::uint8_t byte) { return byte == 0; });
}

TEST(BoardReports, SevenWordsOf64Or14Bytes) {
  Bytes bytes(64, 0xee);
  const Bytes head{0x01, 0x00, 0xff, 0xff, 0x34, 0x12, 0x00,
                   0x80, 0x1e, 0x00, 0x00, 0xff, 0x00, 0x00};
  std::ranges::copy(head, bytes.begin());
  const auto decoded = haptics::decodeBoard(bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->counts, (Counts{1, -1, 0x1234, -32768, 30, -256}));
  EXPECT_FALSE(decoded->button);
  EXPECT_FALSE(decoded->asks);
  for (std::size_t length = 0; length < 200; ++length)
    EXPECT_EQ(haptics::decodeBoard(Bytes(length)).has_value(), length == 64 || length == 14)
        << length;
  const auto shorter = haptics::decodeBoard(std::span{bytes}.first(14));
  ASSERT_TRUE(shorter);
  EXPECT_EQ(shorter->counts, decoded->counts);
}

TEST(BoardReports, TheButtonIsTakenOutOfEncoderD) {
  for (const std::int16_t d : {-512, -1, 0, 1, 511}) {
    const auto up = haptics::decodeBoard(report({0, 0, 0, d, 0, 0}));
    const auto down = haptics::decodeBoard(report({0, 0, 0, d, 0, 0}, true, true));
    EXPECT_FALSE(up->button);
    EXPECT_TRUE(down->button);
    EXPECT_TRUE(down->asks);
    EXPECT_EQ(up->counts[3], d);
    EXPECT_EQ(down->counts[3], d);
  }
}

TEST(BoardCommands, AreMilliamperesInLittleEndianWords) {
  const BoardCommand command = haptics::boardCurrents({1.0, -2.0, 0.0005});
  EXPECT_EQ(words(command), (std::array<int, 7>{1000, -2000, 1, 0, 0, 0, 0}));
  EXPECT_EQ(command[0], 0);
  EXPECT_EQ(command[1], 0xe8);
  EXPECT_EQ(command[2], 0x03);
  EXPECT_TRUE(std::all_of(command.begin() + 15, command.end(), [](auto byte) { return !byte; }));
  EXPECT_EQ(words(haptics::boardSets(kPolhemRest)),
            (std::array<int, 7>{0, 30, 0, 1, 8312, -10366, 19764}));
}

TEST(BoardCommands, TheCapKeepsTheDirection) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> exponent{-2.0, 300.0};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Vec3 direction = Vec3{normal(random), normal(random), normal(random)}.normalized();
    const Vec3 asked = direction * std::pow(10.0, exponent(random));
    const auto sent = words(haptics::boardCurrents(asked));
    const Vec3 got{sent[0] * 1e-3, sent[1] * 1e-3, sent[2] * 1e-3};
    ASSERT_LE(got.cwiseAbs().maxCoeff(), 2.0);
    if (asked.cwiseAbs().maxCoeff() > 2.0) {
      EXPECT_EQ(got.cwiseAbs().maxCoeff(), 2.0);
      const Vec3 expected = direction * (2.0 / direction.cwiseAbs().maxCoeff());
      EXPECT_LT((got - expected).cwiseAbs().maxCoeff(), 0.51e-3);
    } else {
      EXPECT_LT((got - asked).cwiseAbs().maxCoeff(), 0.51e-3);
    }
  }
}

TEST(BoardCommands, WhatIsNotFiniteIsZeroForAllMotors) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (int i = 0; i < 3; ++i) {
      Vec3 currents{0.5, 0.5, 0.5};
      currents[i] = bad;
      EXPECT_EQ(haptics::boardCurrents(currents), BoardCommand{});
    }
}

// a clock of the tests', a millisecond later whenever it is looked at
std::int64_t board_now = 0;
std::int64_t boardClock() noexcept { return board_now += 1'000'000; }

/// A device on a transport without a thread. It answers each write with its counts, and sets them
/// as it is told.
struct Linked {
  std::shared_ptr<fake::Hid> hid = std::make_shared<fake::Hid>();
  std::unique_ptr<haptics::Transport> transport;
  DeviceReading reading;
  Counts counts{};
  bool button = false, asks = false, deaf = false;

  explicit Linked(const haptics::CapstanArm& arm = haptics::polhem(),
                  std::size_t length = haptics::kTeensyBoard.report) {
    hid->answer = [this, length](const Bytes& command) {
      const auto told = words(command);
      if (told[3] == 1 && !deaf) {
        for (std::size_t i = 0; i < 6; ++i)
          counts[i] = static_cast<std::int16_t>(told[i < 3 ? 4 + i : i - 3]);
        asks = false;
      }
      hid->reports.push_back(report(counts, button, asks, length));
    };
    transport = haptics::armTransport(arm, std::make_unique<fake::Port>(hid), length, boardClock);
  }
  ~Linked() { hid->answer = nullptr; }
  DeviceStatus round(const Vec3& force = Vec3::Zero()) {
    return transport->exchange({force, Vec3::Zero()}, reading);
  }
  /// Pressed, set and taken to the midst of the workspace.
  void makeReady() {
    asks = true;
    for (int i = 0; i < 3; ++i) round();
    ASSERT_EQ(round(), DeviceStatus::Ok);
    moveTo(kWork);
  }
  void moveTo(const Counts& goal) {
    for (int left = 1; left > 0;) {
      left = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        const int step = std::clamp(goal[i] - counts[i], -500, 500);
        counts[i] = static_cast<std::int16_t>(counts[i] + step);
        left += std::abs(step);
      }
      ASSERT_EQ(round(), DeviceStatus::Ok);
    }
  }
};

constexpr double kForce = 2.0;  // N
const Vec3 kBoardPush{kForce, 0, 0};

TEST(ArmTransport, MakesNoForceBeforeItsZeroIsSet) {
  Linked it;
  it.counts = kWork;  // whatever they are, they are nobody's
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(it.round(kBoardPush), DeviceStatus::NotReady);
    EXPECT_EQ(it.reading.trouble, Trouble::NeedsCalibration);
  }
  for (const Bytes& command : it.hid->written) EXPECT_TRUE(zero(command));
}

TEST(ArmTransport, ItsZeroButtonSetsTheEncoders) {
  Linked it;
  it.round();
  it.asks = true;
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::NotReady);
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_EQ(words(it.hid->written.back())[3], 1);
  EXPECT_EQ(it.reading.trouble, Trouble::None);
  const auto arm = haptics::polhemArm(haptics::polhemAngles(kPolhemRest));
  EXPECT_EQ(it.reading.X_BD.matrix(), arm->X_BD.matrix());
  EXPECT_GT(it.reading.time_ns, 0);
  // and the next round has the force
  it.round(kBoardPush);
  EXPECT_FALSE(zero(it.hid->written.back()));
}

TEST(ArmTransport, TheStylusButtonDoesTooHeldForASecondWithTheArmStill) {
  Linked it;
  const auto rounds = [&](int n) {
    for (int i = 0; i < n; ++i) ASSERT_EQ(it.round(), DeviceStatus::NotReady);
  };
  it.button = true;  // held since before: does not count
  rounds(1500);
  it.button = false;
  rounds(1);
  it.button = true;  // a click, however often
  rounds(900);
  it.button = false;
  rounds(1);
  it.button = true;  // in a hand that moves
  for (int i = 0; i < 30; ++i) {
    it.counts[4] = static_cast<std::int16_t>(it.counts[4] + 21);
    rounds(100);
  }
  for (const Bytes& command : it.hid->written) EXPECT_TRUE(zero(command));
  rounds(900);  // and comes to rest
  EXPECT_EQ(it.round(), DeviceStatus::NotReady);
  EXPECT_EQ(it.round(), DeviceStatus::Ok);
  EXPECT_EQ(it.counts, kPolhemRest);
  EXPECT_EQ(it.reading.buttons, 1u);
}

TEST(ArmTransport, ADeviceThatDoesNotSetItsEncodersStaysUncalibrated) {
  Linked it;
  it.deaf = true;
  it.round();
  it.button = true;
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(it.round(kBoardPush), DeviceStatus::NotReady);
  int set = 0;
  for (const Bytes& command : it.hid->written) {
    if (zero(command)) continue;
    EXPECT_EQ(words(command)[3], 1);
    ++set;
  }
  EXPECT_GT(set, 0);
  EXPECT_LT(set, 30);
}

TEST(ArmTransport, SendsTheCurrentsOfTheForce) {
  Linked it;
  it.makeReady();
  const auto arm = haptics::polhemArm(haptics::polhemAngles(kWork));
  std::mt19937 random{41};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 force{normal(random), normal(random), normal(random)};
    ASSERT_EQ(it.round(force), DeviceStatus::Ok);
    const Vec3 currents = haptics::currentsFor(haptics::polhem(), force, arm->J_B);
    const auto sent = words(it.hid->written.back());
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(sent[i], 1e3 * currents[static_cast<Eigen::Index>(i)], 0.51);
    EXPECT_EQ(sent[3], 0);
  }
  it.round(Vec3::Constant(std::nan("")));
  EXPECT_TRUE(zero(it.hid->written.back()));
  it.round(Vec3{HUGE_VAL, 0, 0});
  EXPECT_TRUE(zero(it.hid->written.back()));
}

TEST(ArmTransport, AfterASilentRoundThereIsNoForceUntilItAnswers) {
  Linked it;
  it.makeReady();
  auto answer = std::exchange(it.hid->answer, nullptr);
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Stale);
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Stale);
  EXPECT_TRUE(zero(it.hid->written.back()));
  it.hid->answer = answer;
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_TRUE(zero(it.hid->written.back()));
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_FALSE(zero(it.hid->written.back()));
}

TEST(ArmTransport, AnswersOfAnotherLengthAreNone) {
  Linked it;
  it.makeReady();
  auto answer = std::exchange(it.hid->answer, nullptr);
  for (const std::size_t length : {1u, 13u, 14u, 63u, 65u, 4096u}) {
    it.hid->reports = {Bytes(length, 0x11)};
    EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Stale) << length;
  }
  // among others that are whole, the newest of these counts
  it.counts = kWork;
  it.counts[0] = static_cast<std::int16_t>(it.counts[0] + 100);
  it.hid->reports = {report(kWork), report(it.counts), Bytes(14)};
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_EQ(it.reading.X_BD.matrix(),
            haptics::polhemArm(haptics::polhemAngles(it.counts))->X_BD.matrix());
}

TEST(ArmTransport, ReadsEightAnswersARoundAtMost) {
  Linked it;
  it.makeReady();
  for (int i = 0; i < 100; ++i) it.hid->reports.push_back(report(kWork));
  it.hid->reads = 0;
  it.round();
  EXPECT_EQ(it.hid->reads, 8);
}

TEST(ArmTransport, AJumpOfItsEncodersOrCountsWithoutAnArmAreItsEnd) {
  const Counts jumped{static_cast<std::int16_t>(kWork[0] + 2'001), kWork[1], kWork[2], 0, 0, 0};
  const Counts restarted{0, 0, 0, 0, 0, 0};
  for (const Counts& counts : {jumped, restarted}) {
    Linked it;
    it.makeReady();
    it.counts = counts;
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Lost);
      EXPECT_EQ(it.reading.trouble, Trouble::Lost);
      if (i > 0) {
        EXPECT_TRUE(zero(it.hid->written.back()));
      }
    }
  }
  // slowly to where there is no arm
  Linked it;
  it.makeReady();
  DeviceStatus status = DeviceStatus::Ok;
  for (int i = 0; i < 100 && status == DeviceStatus::Ok; ++i) {
    it.counts[2] = static_cast<std::int16_t>(it.counts[2] - 300);
    status = it.round(kBoardPush);
  }
  EXPECT_EQ(status, DeviceStatus::Lost);
  it.round(kBoardPush);
  EXPECT_TRUE(zero(it.hid->written.back()));
}

TEST(ArmTransport, UnpluggedItIsLostAndAFailedWriteIsStale) {
  Linked it;
  it.makeReady();
  it.hid->takes = false;  // in the midst of a write
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Stale);
  it.hid->takes = true;
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_TRUE(zero(it.hid->written.back()));
  it.hid->answer = [&](const Bytes&) { it.hid->gone = true; };
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Lost);
}

TEST(ArmTransport, AWoodenArmHasAnotherBoardRestAndMotors) {
  Linked it{haptics::woodenHaptics(), haptics::kMbedBoard.report};
  it.round(kBoardPush);
  it.asks = true;
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::NotReady);
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_EQ(it.counts, haptics::kWoodenRest);
  for (const Bytes& command : it.hid->written) EXPECT_EQ(command.size(), 15u);
  const auto rest = haptics::woodenArm(haptics::kWoodenRest);
  EXPECT_EQ(it.reading.X_BD.matrix(), rest->X_BD.matrix());
  // the forearm level, 245 mm out of the axis: to the right pulls motor a alone
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Ok);
  EXPECT_EQ(words(it.hid->written.back()),
            (std::array<int, 7>{int(std::lround(kForce * 0.245 / 16 / 0.0603 * 1e3))}));
  // a Polhem's handle turns in its gimbal
  it.counts[4] = 300;
  EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Lost);
  it.round(kBoardPush);
  EXPECT_EQ(words(it.hid->written.back()), (std::array<int, 7>{}));
}

TEST(ArmTransport, ClosedItLeavesTheMotorsAtZero) {
  Linked it;
  it.makeReady();
  it.round(kBoardPush);
  EXPECT_FALSE(zero(it.hid->written.back()));
  it.transport.reset();
  EXPECT_TRUE(zero(it.hid->written.back()));
}

TEST(ArmTransport, WritesThatFailForAMomentAreWaitedOut) {
  Linked it;
  it.makeReady();
  it.round(kBoardPush);
  it.hid->refuses = 4;
  const long reads = it.hid->reads;
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(it.round(kBoardPush), DeviceStatus::Stale);
    EXPECT_EQ(it.hid->reads, reads + i);  // that waits as long as a round
  }
  // the last that is written is zero, though not at the first try
  it.transport.reset();
  EXPECT_EQ(it.hid->refuses, 0);
  EXPECT_TRUE(zero(it.hid->written.back()));
  // one that takes nothing any more is let go of
  Linked dead;
  dead.makeReady();
  dead.hid->takes = false;
  dead.hid->reads = 0;
  dead.transport.reset();
  EXPECT_LE(dead.hid->reads, 10);
}

HidPlace place(std::uint16_t product, std::uint16_t page, std::uint16_t usage, std::string path) {
  return {std::move(path), 0x16c0, product, page, usage, 0};
}

TEST(ArmsAmong, TakeTheUsageOfARawReportDevice) {
  const std::array places{place(0x0486, 0xffab, 0x0200, "/dev/null"),
                          place(0x0486, 0xffc9, 0x0004, "/dev/zero"),  // its console
                          place(0x0486, 1, 6, "/dev/zero"),
                          place(0x0483, 0xffab, 0x0200, "/dev/zero"),
                          place(0x0486, 0, 0, "/dev/zero")};
  const auto entries = haptics::armsAmong(haptics::polhem(), places);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].id, "polhem:/dev/null");
  EXPECT_EQ(entries[0].sensed, 6);
  EXPECT_EQ(entries[0].actuated, 3);
  EXPECT_EQ(entries[0].trouble, Trouble::None);
  const std::array two{places[0], place(0x0486, 0xffab, 0x0200, "/dev/nowhere")};
  const auto both = haptics::armsAmong(haptics::polhem(), two);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].id, "polhem:/dev/null");
  EXPECT_EQ(both[1].trouble, Trouble::NotPluggedIn);
}

TEST(ArmsAmong, WhichArmIsBehindABoardTheUserSays) {
  const HidPlace teensy = place(0x0486, 0xffab, 0x0200, "/dev/null");
  const HidPlace mbed{"/dev/zero", 0x1234, 0x0006, 0xffab, 0x0200};
  const HidPlace other{"/dev/zero", 0x1234, 0x0486, 0xffab, 0x0200};
  const std::array all{teensy, mbed, other};
  const auto polhems = haptics::armsAmong(haptics::polhem(), all);
  ASSERT_EQ(polhems.size(), 1u);
  EXPECT_EQ(polhems[0].name, "Polhem");
  EXPECT_NE(sentence(polhems[0].why).find("wrong directions"), std::string::npos);
  const auto wooden = haptics::armsAmong(haptics::woodenHaptics(), all);
  ASSERT_EQ(wooden.size(), 2u);
  EXPECT_EQ(wooden[0].id, "woodenhaptics:/dev/null");
  EXPECT_EQ(wooden[1].id, "woodenhaptics:/dev/zero");
  EXPECT_EQ(wooden[1].sensed, 3);
}

TEST(ArmDriver, IsKnownWhereNoneIsPluggedIn) {
  for (const haptics::CapstanArm* arm : {&haptics::polhem(), &haptics::woodenHaptics()}) {
    const auto entries = haptics::surveyArms(*arm);
    ASSERT_FALSE(entries.empty());
    if (entries[0].present) GTEST_SKIP() << "an arm is plugged in";
    EXPECT_EQ(entries[0].id, arm->driver);
    EXPECT_EQ(entries[0].trouble, Trouble::NotPluggedIn);
    const auto device = haptics::openDevice({std::string{arm->driver}});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "not-plugged-in");
    EXPECT_NE(sentence(device.error()).find(entries[0].name), std::string::npos);
  }
}

TEST(Arm, AnotherProjectOnSuchABoardIsRefused) {
  for (const std::size_t length : {0u, 8u, 63u}) {
    auto hid = std::make_shared<fake::Hid>();
    hid->answer = [hid_pointer = hid.get(), length](const Bytes&) {
      if (length > 0) hid_pointer->reports.push_back(Bytes(length, 0x42));
    };
    const auto device =
        haptics::armAt(haptics::polhem(), std::make_unique<fake::Port>(hid), 64, boardClock);
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "refused");
    for (const Bytes& command : hid->written) EXPECT_TRUE(zero(command));
  }
}

TEST(Arm, FirmwareWithShorterReportsIsRefusedByName) {
  auto hid = std::make_shared<fake::Hid>();
  // it talks without being asked
  hid->answer = [hid_pointer = hid.get()](const Bytes&) {
    for (int i = 0; i < 3; ++i) hid_pointer->reports.push_back(Bytes(8, 1));
  };
  const auto device = haptics::armAt(haptics::woodenHaptics(), std::make_unique<fake::Port>(hid),
                                     haptics::kMbedBoard.report, boardClock);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "refused");
  EXPECT_NE(sentence(device.error()).find("WoodenHaptics has firmware of before"),
            std::string::npos)
      << sentence(device.error());
  for (const Bytes& command : hid->written) EXPECT_EQ(command, Bytes(15));
}

TEST(Arm, OneWhoseWritesTakeSecondsIsNotWaitedForAHundredTimes) {
  auto hid = std::make_shared<fake::Hid>();
  hid->answer = [](const Bytes&) { board_now += 5'000'000'000; };
  const auto device =
      haptics::armAt(haptics::polhem(), std::make_unique<fake::Port>(hid), 64, boardClock);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "refused");
  EXPECT_EQ(hid->written.size(), 1u);
}

/// A device that a transport's thread talks to.
class Board final : public haptics::HidPort {
 public:
  struct State {
    std::mutex lock;
    Counts counts{};
    bool asks = false, pending = false;
    Bytes last;
    long written = 0;
  };
  explicit Board(std::shared_ptr<State> state) : state_{std::move(state)} {}
  std::optional<std::size_t> read(std::span<std::uint8_t> bytes,
                                  std::chrono::milliseconds wait) noexcept override {
    for (int i = 0; i < 1 + wait.count(); ++i) {
      {
        const std::scoped_lock guard{state_->lock};
        if (std::exchange(state_->pending, false)) {
          const Bytes next = report(state_->counts, false, state_->asks);
          std::copy(next.begin(), next.end(), bytes.begin());
          return next.size();
        }
      }
      if (wait.count() > 0) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return 0;
  }
  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    std::this_thread::sleep_for(std::chrono::microseconds{200});
    const std::scoped_lock guard{state_->lock};
    state_->last.assign(bytes.begin(), bytes.end());
    state_->pending = true;
    ++state_->written;
    if (words(bytes)[3] == 1) {
      state_->counts = kPolhemRest;
      state_->asks = false;
    }
    return true;
  }

 private:
  std::shared_ptr<State> state_;
};

TEST(Arm, IsADeviceWithAThreadOfItsOwn) {
  auto state = std::make_shared<Board::State>();
  auto opened = haptics::armAt(haptics::polhem(), std::make_unique<Board>(state), 64);
  ASSERT_TRUE(opened);
  auto device = std::move(*opened);
  EXPECT_EQ(device->rating().actuated, 3);
  DeviceReading reading;
  // as often as it takes, and a test that hangs is ended by its time limit
  const auto until = [&](auto&& there) {
    while (true) {
      device->read(reading);
      device->write({kBoardPush, Vec3::Zero()});
      {
        const std::scoped_lock guard{state->lock};
        if (there()) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
  };
  until([&] { return reading.trouble == Trouble::NeedsCalibration; });
  {
    const std::scoped_lock guard{state->lock};
    state->asks = true;
  }
  until([&] {
    return reading.trouble == Trouble::None && !zero(state->last) && words(state->last)[3] == 0;
  });
  device->stop();
  // one command may have been on its way: all that follow are zero
  long stopped = -1;
  until([&] {
    if (stopped < 0) stopped = state->written;
    const long since = state->written - stopped;
    if (since > 1) {
      EXPECT_TRUE(zero(state->last));
    }
    return since > 100;
  });
  device->resume();
  until([&] { return !zero(state->last); });
  device.reset();
  EXPECT_TRUE(zero(state->last));
}

}  // namespace
