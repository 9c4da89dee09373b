// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bus/falcon_emulator.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace bus {
namespace {

using haptics::Mat3;
using haptics::Vec3;

// the legs (m): upper arm, forearm, and what lies between their joints
constexpr double kFalconUpper = 0.060, kFalconFore = 0.1025, kC = 0.01443, kD = 0.01125,
                 kE = 0.01125, kF = -0.025, kR = 0.0400, kS = -0.02309;
constexpr double kRadian = std::numbers::pi / 180.0;
constexpr std::array<double, 3> kAzimuths{105.0 * kRadian, -15.0 * kRadian, -135.0 * kRadian};
constexpr double kDegreePerCount = 0.0364347, kDegreeAtZero = 35.0;
constexpr double kMotorPerTorque = -10'000.0;

// the angles [rad] of the upper arms where the grip is at p_F
Vec3 falconAnglesAt(const Vec3& p_F) {
  Vec3 angles;
  for (int leg = 0; leg < 3; ++leg) {
    const double co = std::cos(kAzimuths[std::size_t(leg)]);
    const double si = std::sin(kAzimuths[std::size_t(leg)]);
    const double u = p_F.x() * co + p_F.y() * si - kR;
    const double v = -p_F.x() * si + p_F.y() * co - kS;
    const double w = p_F.z();
    // the forearm's parallelogram as one rod of this length in the leg's plane
    const double rod = kFalconFore * std::sqrt(1.0 - std::pow((v + kF) / kFalconFore, 2)) + kD + kE;
    // |(u + c, w) - upper (cos, sin)| is the rod: A cos + B sin = C
    const double a = 2.0 * kFalconUpper * (u + kC), b = 2.0 * kFalconUpper * w;
    const double c = kFalconUpper * kFalconUpper + (u + kC) * (u + kC) + w * w - rod * rod;
    angles[leg] = std::atan2(b, a) - std::acos(c / std::hypot(a, b));
  }
  return angles;
}

std::array<int, 3> falconCountsAt(const Vec3& p_F) {
  const Vec3 angles = falconAnglesAt(p_F);
  std::array<int, 3> counts{};
  for (int leg = 0; leg < 3; ++leg)
    counts[std::size_t(leg)] =
        int(std::lround((angles[leg] / kRadian - kDegreeAtZero) / kDegreePerCount));
  return counts;
}

// four letters a number, the least significant first
void append(Bytes& packet, int value) {
  for (int n = 0; n < 4; ++n) packet.push_back(std::uint8_t('A' + (value >> (4 * n) & 15)));
}
int numberIn(std::span<const std::uint8_t> letters) {
  int value = 0;
  for (std::size_t n = 0; n < 4; ++n) value |= (letters[n] - 'A') << (4 * n);
  return std::int16_t(value);
}

}  // namespace

void FalconEmulator::hold(const Vec3& p_F) {
  const std::scoped_lock lock{mutex_};
  from_F_ = gripNow();
  to_F_ = p_F;
  left_at_ = Clock::now();
}

Vec3 FalconEmulator::gripNow() const {
  const Vec3 way = to_F_ - from_F_;
  const double gone = kHandSpeed * std::chrono::duration<double>{Clock::now() - left_at_}.count();
  return gone < way.norm() ? Vec3{from_F_ + gone * way.normalized()} : to_F_;
}

void FalconEmulator::press(int buttons) {
  const std::scoped_lock lock{mutex_};
  buttons_ = buttons;
}

bool FalconEmulator::home() {
  const std::scoped_lock lock{mutex_};
  if ((seen_.control & 1) == 0) return false;
  homed_ = true;
  lost_ = {};
  return true;
}

FalconEmulator::Seen FalconEmulator::jump(int counts) {
  const std::scoped_lock lock{mutex_};
  for (int& lost : lost_) lost += counts;
  return seen_;
}

void FalconEmulator::leave(const Bytes& stale) {
  const std::scoped_lock lock{mutex_};
  to_host_.insert(to_host_.end(), stale.begin(), stale.end());
}

FalconEmulator::Seen FalconEmulator::fail(const Faults& faults) {
  const std::scoped_lock lock{mutex_};
  faults_ = faults;
  return seen_;
}

FalconEmulator::Seen FalconEmulator::seen() const {
  const std::scoped_lock lock{mutex_};
  return seen_;
}

Vec3 FalconEmulator::force_F() const {
  const std::scoped_lock lock{mutex_};
  return forceOf(seen_.motors, gripNow());
}

Vec3 FalconEmulator::forceOf(const std::array<int, 3>& motors, const Vec3& p_F) {
  // virtual work: force times way is torque times turn
  constexpr double kStep = 1e-6;  // m
  Mat3 turn_per_way;
  for (int axis = 0; axis < 3; ++axis)
    turn_per_way.col(axis) = (falconAnglesAt(p_F + kStep * Vec3::Unit(axis)) -
                              falconAnglesAt(p_F - kStep * Vec3::Unit(axis))) /
                             (2.0 * kStep);
  const Vec3 torques =
      Vec3{double(motors[0]), double(motors[1]), double(motors[2])} / kMotorPerTorque;
  return turn_per_way.transpose() * torques;
}

Bytes FalconEmulator::deviceDescriptor() const {
  return {18, 1, 0x00, 0x02, 0, 0, 0, 64, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x04, 1, 2, 0, 1};
}

Bytes FalconEmulator::configuration() const {
  return {9, 2, 32,   0, 1,  1,    0,    0x80, 45,  // one interface
          9, 4, 0,    0, 2,  0xFF, 0xFF, 0xFF, 2,   // the maker's own class
          7, 5, 0x81, 2, 64, 0,    0,               // bulk in
          7, 5, 0x02, 2, 64, 0,    0};              // bulk out
}

std::vector<std::string> FalconEmulator::strings() const { return {"Palpate", "Emulated Falcon"}; }

std::optional<Bytes> FalconEmulator::control(const Setup& setup,
                                             std::span<const std::uint8_t> /*out*/) {
  constexpr std::uint8_t kReset = 0, kModem = 1, kFlow = 2, kBaud = 3, kLetters = 4, kStatus = 5,
                         kSetLatency = 9, kLatency = 10;
  const std::scoped_lock lock{mutex_};
  if (setup.type == 0xC0 && setup.request == kStatus) return Bytes{0x01, 0x60};
  if (setup.type == 0xC0 && setup.request == kLatency) return Bytes{std::uint8_t(latency_.count())};
  if (setup.type != 0x40) return std::nullopt;
  switch (setup.request) {
    case kReset:
      dropAll();
      return Bytes{};
    case kModem:
      if ((setup.value & 0x0100) != 0) data_terminal_ready_ = (setup.value & 1) != 0;
      return Bytes{};
    case kFlow:
    case kLetters:
      return Bytes{};
    case kBaud:
      line_ = setup.value == 0x4138 ? Line::Boot
              : setup.value == 0x15 ? Line::Loader
              : setup.value == 2    ? Line::Normal
                                    : Line::Other;
      if (line_ == Line::Boot) loading_ = false;
      if (line_ == Line::Normal && loading_ && !seen_.firmware.empty()) loaded_ = true;
      return Bytes{};
    case kSetLatency:
      latency_ = std::chrono::milliseconds{setup.value};
      return Bytes{};
    default:
      return std::nullopt;
  }
}

void FalconEmulator::dropAll() {
  to_host_.clear();
  late_.clear();
  command_.clear();
}

void FalconEmulator::received(int /*endpoint*/, std::span<const std::uint8_t> bytes) {
  const std::scoped_lock lock{mutex_};
  for (const std::uint8_t byte : bytes) take(byte);
}

void FalconEmulator::take(std::uint8_t byte) {
  switch (line_) {
    case Line::Boot:
      command_.push_back(byte);
      if (byte != 0x0D) return;
      if (data_terminal_ready_ && command_ == Bytes{0x0A, 0x43, 0x0D})
        to_host_.insert(to_host_.end(), {0x0A, 0x44, 0x2C, 0x0D});
      command_.clear();
      return;
    case Line::Loader:
      if (!loading_) {
        if (byte != 0x41) return;
        loading_ = true;
        seen_.firmware.clear();
        to_host_.push_back(0x41);
        return;
      }
      seen_.firmware.push_back(byte);
      to_host_.push_back(faults_.wrong_echo && seen_.firmware.size() == 100 ? byte ^ 0x10 : byte);
      return;
    case Line::Normal: {
      if (!loaded_) return;
      command_.push_back(byte);
      const std::size_t n = command_.size();
      const bool fits = n == 1 ? byte == '<' : n == 16 ? byte == '>' : byte >= 'A' && byte <= 'P';
      if (!fits) {
        seen_.malformed += n;
        command_.clear();
      } else if (n == 16) {
        obey();
        command_.clear();
      }
      return;
    }
    case Line::Other:
      return;
  }
}

void FalconEmulator::obey() {
  ++seen_.commands;
  for (std::size_t n = 0; n < 3; ++n) {
    seen_.motors[n] = numberIn(std::span{command_}.subspan(1 + 4 * n, 4));
    seen_.largest = std::max(seen_.largest, std::abs(seen_.motors[n]));
  }
  seen_.control = command_[13] - 'A';
  if (seen_.motors != std::array<int, 3>{}) {
    ++seen_.forced;
    if (!homed_) ++seen_.forced_early;
  }
  if (faults_.mute) return;
  late_.push_back({Clock::now() + faults_.delay, reply()});
}

Bytes FalconEmulator::reply() {
  const std::array<int, 3> counts = falconCountsAt(gripNow());
  Bytes packet{'<'};
  for (std::size_t n = 0; n < 3; ++n) append(packet, counts[n] + lost_[n]);
  packet.push_back(std::uint8_t('A' + ((homed_ ? 0x70 : 0) | buttons_)));
  packet.push_back('A');
  packet.push_back('>');
  if (faults_.garble > 0) {
    --faults_.garble;
    packet[5] = 'z';
  }
  return packet;
}

std::optional<Bytes> FalconEmulator::toSend(int /*endpoint*/, std::size_t room) {
  const std::scoped_lock lock{mutex_};
  const Clock::time_point now = Clock::now();
  while (!late_.empty() && late_.front().due <= now) {
    to_host_.insert(to_host_.end(), late_.front().bytes.begin(), late_.front().bytes.end());
    late_.pop_front();
  }
  // the chip sends what it has, and its two status bytes alone when its time is up
  if (room < 2 || (to_host_.empty() && now - sent_at_ < latency_)) return std::nullopt;
  sent_at_ = now;
  Bytes transfer;
  // packets of 64, each with the status first, up to one that is not full
  while (room - transfer.size() >= 2) {
    transfer.insert(transfer.end(), {0x01, 0x60});
    const std::size_t n = std::min({to_host_.size(), faults_.most_bytes, room - transfer.size()});
    transfer.insert(transfer.end(), to_host_.begin(), to_host_.begin() + std::ptrdiff_t(n));
    to_host_.erase(to_host_.begin(), to_host_.begin() + std::ptrdiff_t(n));
    if (n < 62) break;
  }
  return transfer;
}

}  // namespace bus
