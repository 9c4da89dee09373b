// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as what a SpaceMouse, spacenavd or a Polhem sends: the first byte says which, and the
// rest is cut into reports by a byte of length before each.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>

#include "haptics/devices/polhem.h"
#include "haptics/devices/space_mouse.h"
#include "haptics/devices/spacenav_socket.h"
#include "tests/fuzz/require.h"

namespace {

using haptics::DeviceStatus;
using haptics::Pose;
using haptics::Vec3;
using Bytes = std::span<const std::uint8_t>;
constexpr std::int64_t kStepNs = 8'000'000;

/// The next report: its length's byte, and as many bytes as there are.
Bytes nextReport(Bytes& bytes) {
  const std::size_t length = std::min<std::size_t>(bytes[0], bytes.size() - 1);
  const Bytes report = bytes.subspan(1, length);
  bytes = bytes.subspan(1 + length);
  return report;
}

/// A step of 8 ms is no longer than the full speed has it, and ends at a pose.
void requireMotion(const Pose& before, const Pose& after) {
  fuzz::require(after.matrix().allFinite(), "a pose is somewhere");
  const double moved = (after.translation() - before.translation()).norm();
  fuzz::require(moved <= 0.1 * 8e-3 + 1e-9, "no faster than the full speed");
  const haptics::Mat3 RtR = after.linear().transpose() * after.linear();
  fuzz::require((RtR - haptics::Mat3::Identity()).norm() < 1e-9, "a rotation");
}

void readCap(Bytes bytes) {
  haptics::CapState cap;
  haptics::RateControl control;
  std::int64_t now = 0;
  Pose before = control.step(now);
  while (!bytes.empty()) {
    haptics::decodeCap(nextReport(bytes), cap);
    for (std::size_t i = 0; i < 3; ++i)
      fuzz::require(std::abs(cap.shift[i]) <= 1000 && std::abs(cap.turn[i]) <= 1000,
                    "axes within a cap's reach");
    control.shift(haptics::capInBase(cap.shift), now);
    control.turn(haptics::capInBase(cap.turn), now);
    const Pose after = control.step(now += kStepNs);
    requireMotion(before, after);
    before = after;
  }
}

void readSpacenav(Bytes bytes) {
  haptics::SpacenavStream stream;
  haptics::RateControl control;
  std::uint32_t buttons = 0;
  std::int64_t now = 0;
  Pose before = control.step(now);
  while (!bytes.empty()) {
    Bytes piece = nextReport(bytes);
    while (const auto event = stream.take(piece))
      if (haptics::applySpacenav(*event, now, control, buttons) == haptics::SpacenavStep::Refused)
        return;
    fuzz::require(piece.empty(), "what is taken is taken");
    const Pose after = control.step(now += kStepNs);
    requireMotion(before, after);
    before = after;
  }
}

/// What came of the device's bytes, and what was sent to it.
struct Line {
  Bytes left;
  haptics::BoardCommand last{};
};

class Port final : public haptics::HidPort {
 public:
  explicit Port(Line& line) : line_{line} {}
  std::optional<std::size_t> read(std::span<std::uint8_t> bytes,
                                  std::chrono::milliseconds wait) noexcept override {
    if (line_.left.empty()) return std::nullopt;
    if (wait.count() == 0) return 0;
    const Bytes report = nextReport(line_.left);
    std::copy_n(report.begin(), std::min(report.size(), bytes.size()), bytes.begin());
    return std::min(report.size(), bytes.size());
  }
  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    fuzz::require(bytes.size() == line_.last.size(), "a command of 65 bytes");
    std::copy(bytes.begin(), bytes.end(), line_.last.begin());
    return true;
  }

 private:
  Line& line_;
};

void readPolhem(Bytes bytes) {
  Line line{bytes};
  {
    const auto transport = haptics::armTransport(haptics::polhem(), std::make_unique<Port>(line),
                                                 haptics::kTeensyBoard.report);
    haptics::DeviceReading reading;
    DeviceStatus last = DeviceStatus::NotReady;
    while (last != DeviceStatus::Lost) {
      const DeviceStatus status = transport->exchange({Vec3{1, -5, 1e9}, Vec3::Zero()}, reading);
      const auto word = [&](std::size_t i) {
        return static_cast<std::int16_t>(line.last[1 + 2 * i] | line.last[2 + 2 * i] << 8);
      };
      if (word(3) == 0) {
        for (std::size_t i = 0; i < 3; ++i) {
          fuzz::require(std::abs(word(i)) <= 2000, "currents within the cap");
          fuzz::require(last == DeviceStatus::Ok || word(i) == 0, "no force without a pose");
        }
      }
      if (status == DeviceStatus::Ok)
        fuzz::require(reading.X_BD.matrix().allFinite(), "a pose is somewhere");
      last = status;
    }
  }
  fuzz::require(line.last == haptics::BoardCommand{}, "zero is the last word");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const Bytes rest{bytes + 1, size - 1};
  switch (bytes[0] % 3) {
    case 0:
      readCap(rest);
      break;
    case 1:
      readSpacenav(rest);
      break;
    default:
      readPolhem(rest);
      break;
  }
  return 0;
}
