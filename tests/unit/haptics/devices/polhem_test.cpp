// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/polhem.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <random>
#include <thread>

#include "tests/unit/haptics/devices/fake_port.h"

namespace {

using fake::Bytes;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::HidPlace;
using haptics::kPolhemRest;
using haptics::Mat3;
using haptics::PolhemAngles;
using haptics::PolhemCommand;
using haptics::Pose;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using Counts = std::array<std::int16_t, 6>;

constexpr Counts kWork{2000, -6000, 14000, 40, -60, 120};  // in the midst of the workspace

Bytes report(const Counts& counts, bool button = false, bool asks = false) {
  Bytes bytes(64);
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

TEST(PolhemReports, SevenWordsOf64Bytes) {
  Bytes bytes(64, 0xee);
  const Bytes head{0x01, 0x00, 0xff, 0xff, 0x34, 0x12, 0x00,
                   0x80, 0x1e, 0x00, 0x00, 0xff, 0x00, 0x00};
  std::ranges::copy(head, bytes.begin());
  const auto decoded = haptics::decodePolhem(bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->counts, (Counts{1, -1, 0x1234, -32768, 30, -256}));
  EXPECT_FALSE(decoded->button);
  EXPECT_FALSE(decoded->asks);
  for (std::size_t length = 0; length < 200; ++length)
    EXPECT_EQ(haptics::decodePolhem(Bytes(length)).has_value(), length == 64) << length;
}

TEST(PolhemReports, TheButtonIsTakenOutOfEncoderD) {
  for (const std::int16_t d : {-512, -1, 0, 1, 511}) {
    const auto up = haptics::decodePolhem(report({0, 0, 0, d, 0, 0}));
    const auto down = haptics::decodePolhem(report({0, 0, 0, d, 0, 0}, true, true));
    EXPECT_FALSE(up->button);
    EXPECT_TRUE(down->button);
    EXPECT_TRUE(down->asks);
    EXPECT_EQ(up->counts[3], d);
    EXPECT_EQ(down->counts[3], d);
  }
}

TEST(PolhemCommands, AreMilliamperesInLittleEndianWords) {
  const PolhemCommand command = haptics::polhemCurrents({1.0, -2.0, 0.0005});
  EXPECT_EQ(words(command), (std::array<int, 7>{1000, -2000, 1, 0, 0, 0, 0}));
  EXPECT_EQ(command[0], 0);
  EXPECT_EQ(command[1], 0xe8);
  EXPECT_EQ(command[2], 0x03);
  EXPECT_TRUE(std::all_of(command.begin() + 15, command.end(), [](auto byte) { return !byte; }));
  EXPECT_EQ(words(haptics::polhemAtRest()), (std::array<int, 7>{0, 30, 0, 1, 8312, -10366, 19764}));
}

TEST(PolhemCommands, TheCapKeepsTheDirection) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> exponent{-2.0, 300.0};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Vec3 direction = Vec3{normal(random), normal(random), normal(random)}.normalized();
    const Vec3 asked = direction * std::pow(10.0, exponent(random));
    const auto sent = words(haptics::polhemCurrents(asked));
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

TEST(PolhemCommands, WhatIsNotFiniteIsZeroForAllMotors) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (int i = 0; i < 3; ++i) {
      Vec3 currents{0.5, 0.5, 0.5};
      currents[i] = bad;
      EXPECT_EQ(haptics::polhemCurrents(currents), PolhemCommand{});
    }
}

/// Angles all over what the arm may do, and more.
PolhemAngles anyAngles(std::mt19937& random) {
  std::uniform_real_distribution<double> turn{-2.2, 2.2}, upper{0.3, 2.4}, crank{1.5, 4.6};
  return {turn(random), upper(random), crank(random), turn(random), turn(random), turn(random)};
}

// The lengths of the header's drawing, once more: the linkage is checked by what its bars are.
TEST(PolhemArm, EveryBarHasItsLength) {
  std::mt19937 random{17};
  int arms = 0;
  const int trials = 20'000;
  for (int trial = 0; trial < trials; ++trial) {
    const PolhemAngles angles = anyAngles(random);
    const auto arm = haptics::polhemArm(angles);
    if (!arm) continue;
    ++arms;
    // back from B into the plane of the arm: r out, z up
    const Vec3 p = arm->X_BD.translation();
    const double forward = p.z() + 0.2045, right = p.x(), z = p.y() + 0.0325;
    const double r = forward * std::cos(angles[0]) + right * std::sin(angles[0]);
    ASSERT_NEAR(-forward * std::sin(angles[0]) + right * std::cos(angles[0]), 0.0, 1e-12);
    const Eigen::Vector2d E{0.017 + 0.165 * std::cos(angles[1]), 0.165 * std::sin(angles[1])};
    const Eigen::Vector2d K{-0.017 + 0.025 * std::cos(angles[2]), 0.025 * std::sin(angles[2])};
    const Eigen::Vector2d G{r, z};
    ASSERT_NEAR((G - E).norm(), 0.1308, 1e-12);
    const Eigen::Vector2d C = E - (G - E) * (0.034 / 0.1308);
    ASSERT_NEAR((C - K).norm(), 0.190, 1e-12);
    const Eigen::Vector2d EK = K - E, EC = C - E;
    ASSERT_LT(EK.x() * EC.y() - EK.y() * EC.x(), 0.0);  // clockwise
  }
  EXPECT_GT(arms, trials / 2);
  EXPECT_LT(arms, trials);
}

TEST(PolhemArm, IsWhereItsMakersSayItRests) {
  // by the law of cosines in three triangles, as a drawing has it, for the rest pose alone
  const PolhemAngles angles = haptics::polhemAngles(kPolhemRest);
  EXPECT_NEAR(angles[0], 2.1023, 1e-3);
  EXPECT_NEAR(angles[1], 2.1782, 1e-3);
  EXPECT_NEAR(angles[2], 4.1621, 1e-3);
  const auto arm = haptics::polhemArm(angles);
  ASSERT_TRUE(arm);
  const double r = 0.0357, up = 0.0695;
  const Vec3 expected{r * std::sin(2.1023), up - 0.0325, r * std::cos(2.1023) - 0.2045};
  EXPECT_LT((arm->X_BD.translation() - expected).norm(), 5e-4);
}

TEST(PolhemArm, ItsJacobianIsItsDerivative) {
  std::mt19937 random{23};
  double worst = 0.0;
  int arms = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const PolhemAngles angles = anyAngles(random);
    const auto arm = haptics::polhemArm(angles);
    // beside a dead point differences of any step are no derivative
    if (!arm || arm->J_B.norm() > 0.5) continue;
    ++arms;
    for (std::size_t i = 0; i < 3; ++i) {
      // Richardson's of two central differences
      const auto difference = [&](double h) -> std::optional<Vec3> {
        PolhemAngles more = angles, less = angles;
        more[i] += h;
        less[i] -= h;
        const auto there = haptics::polhemArm(more), back = haptics::polhemArm(less);
        if (!there || !back) return std::nullopt;
        return (there->X_BD.translation() - back->X_BD.translation()) / (2.0 * h);
      };
      const auto coarse = difference(2e-4), fine = difference(1e-4);
      if (!coarse || !fine) continue;
      const Vec3 slope = (4.0 * *fine - *coarse) / 3.0;
      worst = std::max(worst, (slope - arm->J_B.col(static_cast<Eigen::Index>(i))).norm());
    }
  }
  EXPECT_GT(arms, 8'000);
  EXPECT_LT(worst, 1e-9);
  RecordProperty("worst", std::to_string(worst * 1e12));
}

// Virtual work: what the motors do on their counts is what the force does on the handle.
TEST(PolhemArm, MotorsDoTheWorkOfTheForce) {
  std::mt19937 random{29};
  std::normal_distribution<double> normal;
  const std::array<double, 3> torque_constant{0.0603, 0.0538, 0.0538};
  double worst = 0.0;
  int arms = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    Counts counts{};
    for (std::size_t i = 0; i < 3; ++i)
      counts[i] =
          static_cast<std::int16_t>(kWork[i] + std::uniform_int_distribution{-3000, 3000}(random));
    const PolhemAngles angles = haptics::polhemAngles(counts);
    const auto arm = haptics::polhemArm(angles);
    if (!arm || arm->J_B.norm() > 3.0) continue;
    ++arms;
    const Vec3 force{normal(random), normal(random), normal(random)};
    const Vec3 currents = haptics::polhemCurrentsFor(force, arm->J_B);
    // a motor's turn by one count, as the angle that its body makes of it
    for (std::size_t i = 0; i < 3; ++i) {
      Counts next = counts;
      ++next[i];
      const double dq = haptics::polhemAngles(next)[i] - angles[i];
      const double motor_work = currents[static_cast<Eigen::Index>(i)] * torque_constant[i] *
                                (2.0 * std::numbers::pi / 4096.0);
      const double handle_work = force.dot(arm->J_B.col(static_cast<Eigen::Index>(i)) * dq);
      worst = std::max(worst, std::abs(motor_work - handle_work));
    }
  }
  EXPECT_GT(arms, 10'000);
  EXPECT_LT(worst, 1e-12);  // J, of some 1e-4
}

TEST(PolhemArm, TurnsRightLiftsAndReachesOut) {
  const PolhemAngles angles = haptics::polhemAngles(kWork);
  const auto arm = haptics::polhemArm(angles);
  ASSERT_TRUE(arm);
  PolhemAngles level = angles;
  level[0] = 0.0;
  const Mat3 J = haptics::polhemArm(level)->J_B;
  EXPECT_GT(J(0, 0), 0.1);           // a: to the right
  EXPECT_NEAR(J(1, 0), 0.0, 1e-12);  // and neither up
  EXPECT_NEAR(J(2, 0), 0.0, 1e-12);  // nor out
  EXPECT_NEAR(J(0, 1), 0.0, 1e-12);  // b and c: in the plane
  EXPECT_NEAR(J(0, 2), 0.0, 1e-12);
}

TEST(PolhemArm, ReachesItsWorkspace) {
  // by Newton's method from the midst of it to points in a ball of two thirds of its radius
  std::mt19937 random{31};
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  int reached = 0;
  const int points = 500;
  for (int point = 0; point < points; ++point) {
    const Vec3 direction = Vec3{normal(random), normal(random), normal(random)}.normalized();
    const Vec3 target = direction * (0.10 * std::cbrt(unit(random)));
    PolhemAngles angles = haptics::polhemAngles(kWork);
    for (int i = 0; i < 100; ++i) {
      const auto arm = haptics::polhemArm(angles);
      if (!arm) break;
      const Vec3 away = target - arm->X_BD.translation();
      if (away.norm() < 1e-9) {
        ++reached;
        break;
      }
      const Vec3 step = arm->J_B.partialPivLu().solve(away) * 0.5;
      for (std::size_t k = 0; k < 3; ++k) angles[k] += step[static_cast<Eigen::Index>(k)];
    }
  }
  EXPECT_GT(reached, points * 9 / 10);
  RecordProperty("reached", reached);
}

TEST(PolhemArm, TheGimbalTurnsTheHandle) {
  PolhemAngles angles = haptics::polhemAngles(kWork);
  angles[0] = angles[3] = angles[4] = angles[5] = 0.0;
  const Mat3 straight = haptics::polhemArm(angles)->X_BD.linear();
  // the stylus, D's z, lies along the forearm, in the plane of the arm
  EXPECT_NEAR(straight(0, 2), 0.0, 1e-12);
  EXPECT_NEAR((straight * straight.transpose() - Mat3::Identity()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(straight.determinant(), 1.0, 1e-12);
  for (const std::size_t axis : {3u, 4u, 5u}) {
    PolhemAngles turned = angles;
    turned[axis] = 0.3;
    const Mat3 R_DD = straight.transpose() * haptics::polhemArm(turned)->X_BD.linear();
    const Eigen::AngleAxisd turn{R_DD};
    EXPECT_NEAR(turn.angle(), 0.3, 1e-9);
    const Vec3 about = axis == 4 ? Vec3::UnitX() : Vec3::UnitZ();
    EXPECT_NEAR((turn.axis() - about).norm(), 0.0, 1e-9) << axis;
    EXPECT_EQ(haptics::polhemArm(turned)->X_BD.translation(),
              haptics::polhemArm(angles)->X_BD.translation());
  }
}

TEST(PolhemArm, AnyCountsAreAnArmOrNone) {
  std::mt19937 random{37};
  int none = 0;
  for (int trial = 0; trial < 100'000; ++trial) {
    Counts counts{};
    for (std::int16_t& count : counts) count = static_cast<std::int16_t>(random());
    const auto arm = haptics::polhemArm(haptics::polhemAngles(counts));
    none += !arm;
    if (!arm) continue;
    ASSERT_TRUE(arm->X_BD.matrix().allFinite());
    ASSERT_TRUE(arm->J_B.allFinite());
    ASSERT_LT(arm->J_B.norm(), 50.0);
  }
  EXPECT_GT(none, 0);
  EXPECT_FALSE(haptics::polhemArm({std::nan(""), 1.5, 3.0, 0, 0, 0})
                   .value_or(haptics::PolhemArm{Pose::Identity(), Mat3::Constant(std::nan(""))})
                   .J_B.allFinite());
}

/// A device on a transport without a thread. It answers each write with its counts, and sets them
/// as it is told.
struct Linked {
  std::shared_ptr<fake::Hid> hid = std::make_shared<fake::Hid>();
  std::unique_ptr<haptics::Transport> transport;
  DeviceReading reading;
  Counts counts{};
  bool button = false, asks = false, deaf = false;

  Linked() {
    hid->answer = [this](const Bytes& command) {
      if (words(command)[3] == 1 && !deaf) {
        counts = kPolhemRest;
        asks = false;
      }
      hid->reports.push_back(report(counts, button, asks));
    };
    transport = haptics::polhemTransport(std::make_unique<fake::Port>(hid));
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
const Vec3 kPush{kForce, 0, 0};

TEST(PolhemTransport, MakesNoForceBeforeItsZeroIsSet) {
  Linked it;
  it.counts = kWork;  // whatever they are, they are nobody's
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(it.round(kPush), DeviceStatus::NotReady);
    EXPECT_EQ(it.reading.trouble, Trouble::NeedsCalibration);
  }
  for (const Bytes& command : it.hid->written) EXPECT_TRUE(zero(command));
}

TEST(PolhemTransport, ItsZeroButtonSetsTheEncoders) {
  Linked it;
  it.round();
  it.asks = true;
  EXPECT_EQ(it.round(kPush), DeviceStatus::NotReady);
  EXPECT_EQ(it.round(kPush), DeviceStatus::Ok);
  EXPECT_EQ(words(it.hid->written.back())[3], 1);
  EXPECT_EQ(it.reading.trouble, Trouble::None);
  const auto arm = haptics::polhemArm(haptics::polhemAngles(kPolhemRest));
  EXPECT_EQ(it.reading.X_BD.matrix(), arm->X_BD.matrix());
  EXPECT_GT(it.reading.time_ns, 0);
  // and the next round has the force
  it.round(kPush);
  EXPECT_FALSE(zero(it.hid->written.back()));
}

TEST(PolhemTransport, TheStylusButtonDoesToo) {
  Linked it;
  it.button = true;  // held since before: does not count
  for (int i = 0; i < 10; ++i) it.round();
  for (const Bytes& command : it.hid->written) EXPECT_TRUE(zero(command));
  it.button = false;
  it.round();
  it.button = true;
  EXPECT_EQ(it.round(), DeviceStatus::NotReady);
  EXPECT_EQ(it.round(), DeviceStatus::Ok);
  EXPECT_EQ(it.reading.buttons, 1u);
  EXPECT_EQ(it.hid->written.size(), 13u);
}

TEST(PolhemTransport, ADeviceThatDoesNotSetItsEncodersStaysUncalibrated) {
  Linked it;
  it.deaf = true;
  it.round();
  it.button = true;
  for (int i = 0; i < 200; ++i) ASSERT_EQ(it.round(kPush), DeviceStatus::NotReady);
  int set = 0;
  for (const Bytes& command : it.hid->written) {
    if (zero(command)) continue;
    EXPECT_EQ(words(command)[3], 1);
    ++set;
  }
  EXPECT_GT(set, 0);
  EXPECT_LT(set, 30);
}

TEST(PolhemTransport, SendsTheCurrentsOfTheForce) {
  Linked it;
  it.makeReady();
  const auto arm = haptics::polhemArm(haptics::polhemAngles(kWork));
  std::mt19937 random{41};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 force{normal(random), normal(random), normal(random)};
    ASSERT_EQ(it.round(force), DeviceStatus::Ok);
    const Vec3 currents = haptics::polhemCurrentsFor(force, arm->J_B);
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

TEST(PolhemTransport, AfterASilentRoundThereIsNoForceUntilItAnswers) {
  Linked it;
  it.makeReady();
  auto answer = std::exchange(it.hid->answer, nullptr);
  EXPECT_EQ(it.round(kPush), DeviceStatus::Stale);
  EXPECT_EQ(it.round(kPush), DeviceStatus::Stale);
  EXPECT_TRUE(zero(it.hid->written.back()));
  it.hid->answer = answer;
  EXPECT_EQ(it.round(kPush), DeviceStatus::Ok);
  EXPECT_TRUE(zero(it.hid->written.back()));
  EXPECT_EQ(it.round(kPush), DeviceStatus::Ok);
  EXPECT_FALSE(zero(it.hid->written.back()));
}

TEST(PolhemTransport, AnswersOfAnotherLengthAreNone) {
  Linked it;
  it.makeReady();
  auto answer = std::exchange(it.hid->answer, nullptr);
  for (const std::size_t length : {1u, 13u, 14u, 63u, 65u, 4096u}) {
    it.hid->reports = {Bytes(length, 0x11)};
    EXPECT_EQ(it.round(kPush), DeviceStatus::Stale) << length;
  }
  // among others that are whole, the newest of these counts
  it.counts = kWork;
  it.counts[0] = static_cast<std::int16_t>(it.counts[0] + 100);
  it.hid->reports = {report(kWork), report(it.counts), Bytes(14)};
  EXPECT_EQ(it.round(kPush), DeviceStatus::Ok);
  EXPECT_EQ(it.reading.X_BD.matrix(),
            haptics::polhemArm(haptics::polhemAngles(it.counts))->X_BD.matrix());
}

TEST(PolhemTransport, ReadsEightAnswersARoundAtMost) {
  Linked it;
  it.makeReady();
  for (int i = 0; i < 100; ++i) it.hid->reports.push_back(report(kWork));
  it.hid->reads = 0;
  it.round();
  EXPECT_EQ(it.hid->reads, 8);
}

TEST(PolhemTransport, AJumpOfItsEncodersOrCountsWithoutAnArmAreItsEnd) {
  const Counts jumped{static_cast<std::int16_t>(kWork[0] + 2'001), kWork[1], kWork[2], 0, 0, 0};
  const Counts restarted{0, 0, 0, 0, 0, 0};
  for (const Counts& counts : {jumped, restarted}) {
    Linked it;
    it.makeReady();
    it.counts = counts;
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(it.round(kPush), DeviceStatus::Lost);
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
    status = it.round(kPush);
  }
  EXPECT_EQ(status, DeviceStatus::Lost);
  it.round(kPush);
  EXPECT_TRUE(zero(it.hid->written.back()));
}

TEST(PolhemTransport, UnpluggedItIsLostAndAFailedWriteIsStale) {
  Linked it;
  it.makeReady();
  it.hid->takes = false;  // in the midst of a write
  EXPECT_EQ(it.round(kPush), DeviceStatus::Stale);
  it.hid->takes = true;
  EXPECT_EQ(it.round(kPush), DeviceStatus::Ok);
  EXPECT_TRUE(zero(it.hid->written.back()));
  it.hid->answer = [&](const Bytes&) { it.hid->gone = true; };
  EXPECT_EQ(it.round(kPush), DeviceStatus::Lost);
}

TEST(PolhemTransport, ClosedItLeavesTheMotorsAtZero) {
  Linked it;
  it.makeReady();
  it.round(kPush);
  EXPECT_FALSE(zero(it.hid->written.back()));
  it.transport.reset();
  EXPECT_TRUE(zero(it.hid->written.back()));
}

HidPlace place(std::uint16_t product, std::uint16_t page, std::uint16_t usage, std::string path) {
  return {std::move(path), 0x16c0, product, page, usage, 0};
}

TEST(PolhemsAmong, TakeTheUsageOfARawReportDevice) {
  const std::array places{place(0x0486, 0xffab, 0x0200, "/dev/null"),
                          place(0x0486, 0xffc9, 0x0004, "/dev/zero"),  // its console
                          place(0x0486, 1, 6, "/dev/zero"),
                          place(0x0483, 0xffab, 0x0200, "/dev/zero"),
                          place(0x0486, 0, 0, "/dev/zero")};
  const auto entries = haptics::polhemsAmong(places);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].id, "polhem");
  EXPECT_EQ(entries[0].sensed, 6);
  EXPECT_EQ(entries[0].actuated, 3);
  EXPECT_EQ(entries[0].trouble, Trouble::None);
  const std::array two{places[0], place(0x0486, 0xffab, 0x0200, "/dev/nowhere")};
  const auto both = haptics::polhemsAmong(two);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].id, "polhem:/dev/null");
  EXPECT_EQ(both[1].trouble, Trouble::NotPluggedIn);
}

TEST(PolhemDriver, IsKnownWhereNoneIsPluggedIn) {
  const auto entries = haptics::surveyPolhem();
  ASSERT_FALSE(entries.empty());
  if (entries[0].present) GTEST_SKIP() << "a Polhem is plugged in";
  EXPECT_EQ(entries[0].trouble, Trouble::NotPluggedIn);
  const auto device = haptics::openDevice({"polhem"});
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "not-plugged-in");
}

TEST(Polhem, AnotherProjectOnSuchABoardIsRefused) {
  for (const std::size_t length : {0u, 8u, 63u}) {
    auto hid = std::make_shared<fake::Hid>();
    hid->answer = [hid_pointer = hid.get(), length](const Bytes&) {
      if (length > 0) hid_pointer->reports.push_back(Bytes(length, 0x42));
    };
    const auto device = haptics::polhemAt(std::make_unique<fake::Port>(hid));
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().reason, "refused");
    for (const Bytes& command : hid->written) EXPECT_TRUE(zero(command));
  }
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

TEST(Polhem, IsADeviceWithAThreadOfItsOwn) {
  auto state = std::make_shared<Board::State>();
  auto opened = haptics::polhemAt(std::make_unique<Board>(state));
  ASSERT_TRUE(opened);
  auto device = std::move(*opened);
  EXPECT_EQ(device->rating().actuated, 3);
  DeviceReading reading;
  // as often as it takes, and a test that hangs is ended by its time limit
  const auto until = [&](auto&& there) {
    while (true) {
      device->read(reading);
      device->write({kPush, Vec3::Zero()});
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
