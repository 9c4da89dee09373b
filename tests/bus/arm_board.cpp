// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bus/arm_board.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bus {
namespace {

using haptics::Vec3;

// a report of 14 bytes either way, without an id, as the board's own library describes it
const Bytes kReports{0x06, 0xAB, 0xFF, 0x0A, 0x00, 0x02, 0xA1, 0x01, 0x75, 0x08,
                     0x15, 0x00, 0x26, 0xFF, 0x00, 0x95, 0x0E, 0x09, 0x01, 0x81,
                     0x02, 0x95, 0x0E, 0x09, 0x02, 0x91, 0x02, 0xC0};

constexpr double kUpper = 0.205, kFore = 0.245, kOut = 0.22;  // m; the shoulder is at B's height
constexpr double kStep = 0.2e-3;                              // m, of the hand
constexpr double kTorque = 0.0603;                            // N·m/A
constexpr std::array<double, 3> kGear{16.0, 12.0, 12.0};      // turns of a motor, of a body
const Vec3 kRest{0.0, kUpper, kFore - kOut};

/// Angles of the bodies with the handle there: a to the right, b from upright, c from hanging.
std::array<double, 3> anglesAt(const Vec3& p_B) {
  const double towards = p_B.z() + kOut;
  const double level = std::hypot(p_B.x(), towards), far = std::hypot(level, p_B.y());
  const auto opposite = [](double a, double b, double side) {
    return std::acos((a * a + b * b - side * side) / (2.0 * a * b));
  };
  const double b = std::atan2(level, p_B.y()) - opposite(kUpper, far, kFore);
  return {std::atan2(p_B.x(), towards), b, opposite(kUpper, kFore, far) - b};
}

/// Counts of the motors' encoders, 2000 a turn.
std::array<double, 3> countsAt(const Vec3& p_B) {
  std::array<double, 3> counts = anglesAt(p_B);
  for (std::size_t i = 0; i < 3; ++i) counts[i] *= kGear[i] * 2000.0 / (2.0 * std::numbers::pi);
  return counts;
}

}  // namespace

ArmBoardEmulator::ArmBoardEmulator()
    : hand_{kRest},
      goal_{kRest},
      zero_{700, -300, 40},  // switched on wherever the arm was
      port_{"Emulated arm", 0x1234, 0x0006, kReports,
            [this](std::span<const std::uint8_t> report) { hear(report); }} {}

void ArmBoardEmulator::askForZero() {
  const std::scoped_lock lock{mutex_};
  asks_ = true;
}

void ArmBoardEmulator::lead(const Vec3& p_B) {
  const std::scoped_lock lock{mutex_};
  goal_ = p_B;
}

bool ArmBoardEmulator::isThere() const {
  const std::scoped_lock lock{mutex_};
  return hand_ == goal_;
}

long ArmBoardEmulator::commands() const {
  const std::scoped_lock lock{mutex_};
  return commands_;
}

long ArmBoardEmulator::forced() const {
  const std::scoped_lock lock{mutex_};
  return forced_;
}

Vec3 ArmBoardEmulator::force_B() const {
  const std::scoped_lock lock{mutex_};
  constexpr double kApart = 1e-5;  // m
  Vec3 force;
  for (int axis = 0; axis < 3; ++axis) {
    const auto there = anglesAt(hand_ + kApart * Vec3::Unit(axis));
    const auto back = anglesAt(hand_ - kApart * Vec3::Unit(axis));
    double work = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      work += 1e-3 * last_[i] * kTorque * kGear[i] * (there[i] - back[i]);
    force[axis] = work / (2.0 * kApart);
  }
  return force;
}

void ArmBoardEmulator::hear(std::span<const std::uint8_t> report) {
  Bytes answer(14);
  {
    const std::scoped_lock lock{mutex_};
    if (report.size() != 15 || report[0] != 0) return;  // hidraw's zero for a report without an id
    for (std::size_t i = 0; i < last_.size(); ++i)
      last_[i] = std::int16_t(report[1 + 2 * i] | report[2 + 2 * i] << 8);
    ++commands_;
    const auto counts = countsAt(hand_);
    if (last_[3] == 1) {
      for (std::size_t i = 0; i < 3; ++i) zero_[i] = last_[4 + i] - int(std::lround(counts[i]));
      asks_ = false;
      last_ = {};
    }
    forced_ += last_[0] != 0 || last_[1] != 0 || last_[2] != 0 ? 1 : 0;
    const Vec3 way = goal_ - hand_;
    hand_ = way.norm() <= kStep ? goal_ : Vec3{hand_ + kStep * way.normalized()};
    for (std::size_t i = 0; i < 3; ++i) {
      const int count = zero_[i] + int(std::lround(counts[i]));
      answer[2 * i] = std::uint8_t(count);
      answer[2 * i + 1] = std::uint8_t(count >> 8);
    }
    answer[12] = asks_ ? 1 : 0;
  }
  port_.report(answer);
}

}  // namespace bus
