// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "haptics/core/clock.h"
#include "haptics/devices/catalogue.h"
#include "haptics/devices/hid_port.h"

namespace haptics {

// The 3Dconnexion SpaceMouse family over HID: a cap that is pushed and turned, six axes sensed, no
// motors. Ids and report layouts are those that spacenavd and PySpaceMouse know; one layout was
// seen in a capture of a SpaceMouse Compact.
// Not verified on hardware: the signs of the axes, the layout of the wireless models, and that
// every model repeats its reports while the cap is held still.

/// A model that this driver claims.
struct SpaceMouseModel {
  std::uint16_t vendor, product;
  std::string_view name;
};

/// All models. The driver ignores other products of the same vendors (CadMouse, keyboards, number
/// pads).
std::span<const SpaceMouseModel> spaceMouseModels();

/// The state of the cap by its reports.
struct CapState {
  /// Deflection in counts, -350 to 350 by the descriptor: right, towards the user, down; and turns
  /// about these, right-handed.
  std::array<std::int16_t, 3> shift{}, turn{};
  std::uint32_t buttons = 0;  ///< bit n: button n, the maker's numbers less one
};

/// The content of a report.
enum class CapReport : std::uint8_t { Unknown, Shift, Turn, Both, Buttons };

/// Reads one input report, its id first, into what it is about; the rest of `cap` stays. Id 1:
/// three axes, or with 13 bytes all six; id 2: the three turns; id 3: one to four bytes of buttons.
/// Up to three bytes behind the axes are passed over. Unknown, and nothing changed: another id,
/// another length, or an axis beyond 1000 counts, which no cap sends.
CapReport decodeCap(std::span<const std::uint8_t> report, CapState& cap) noexcept;

/// Counts of the cap's three axes along those of the base B: x right, y up, z towards the user.
Vec3 capInBase(const std::array<std::int16_t, 3>& counts) noexcept;

/// Integrates deflections to a pose: the deflection of the cap is the velocity of the pose.
///
/// Shift and turn each have a round dead band of 25 counts, which a released cap stays within and
/// in which turning does not shift. Beyond it the speed grows with the square of what is left, so
/// that it begins at zero with slope zero; at 350 counts, and beyond, it is 0.1 m/s or 1 rad/s in
/// the direction of the deflection.
///
/// A shift or turn that no report has repeated for 200 ms becomes zero until the next report. So
/// the pose does not drift if the cable is pulled or the receiver sleeps while the cap is held. A
/// device repeats its reports every 8 ms while the cap is held. After a gap between two steps, at
/// most 20 ms of motion are made up for.
class RateControl {
 public:
  static constexpr double kDeadBand = 25.0, kFullDeflection = 350.0;  // counts
  static constexpr double kFullSpeed = 0.1;                           // m/s
  static constexpr double kFullTurn = 1.0;                            // rad/s
  static constexpr std::int64_t kSilenceNs = 200'000'000, kLongestStepNs = 20'000'000;

  /// The newest deflections, in counts along and about the axes of B.
  void shift(const Vec3& counts_B, std::int64_t now_ns) noexcept;
  void turn(const Vec3& counts_B, std::int64_t now_ns) noexcept;
  /// No deflection.
  void rest() noexcept;
  /// Integrates up to now; the first call does not move. The pose starts as the identity.
  Pose step(std::int64_t now_ns) noexcept;

 private:
  struct Deflection {
    Vec3 rate = Vec3::Zero();  ///< share of the full speed, 0 to 1, by direction
    std::int64_t at_ns = 0;
  };
  Deflection shift_, turn_;
  Vec3 translation_ = Vec3::Zero();
  Quat rotation_ = Quat::Identity();
  std::int64_t last_ns_ = 0;
  bool started_ = false;
};

/// The device at these ports, which are interfaces of one device; reports of any of them move it.
/// Its light is on until it is closed.
///
/// `read` waits for nothing: it takes what reports are there, sixteen a port at most, and moves the
/// pose to now. Ok until the last port is gone, then Lost, the pose at rest and no button down.
/// `write`, `stop` and `resume` do nothing.
std::unique_ptr<Device> spaceMouseAt(std::vector<std::unique_ptr<HidPort>> ports,
                                     MonotonicClock clock = monotonicNs);

/// The claimed ones among these places, one entry a device, and none if there is none. Only
/// collections of usage page 1, usage 8 (multi-axis controller) count, or of an unknown usage.
/// A universal receiver has several of them, of which all but one are silent: they are one device.
std::vector<DeviceEntry> spaceMiceAmong(std::span<const HidPlace> places);

/// The driver "spacemouse": without a which, the first that can be opened. Where spacenavd answers,
/// its driver "spacenav" comes first in the catalogue and is to be preferred: it has the user's
/// settings. The system lets both be open at once; they do not disturb each other.
std::vector<DeviceEntry> surveySpaceMice();
Expected<std::unique_ptr<Device>> openSpaceMouse(const OpenRequest& request);

}  // namespace haptics
