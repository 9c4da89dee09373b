// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/devices/space_mouse.h"

namespace haptics {

// A SpaceMouse through the service spacenavd, which many systems run: its UNIX socket, without its
// library. The service has the device and the user's settings for it, so where it answers this
// driver comes before the one over HID.
// By what is public of spacenavd and libspnav; not verified on hardware: the signs of the axes.

/// One event of the service: a type and seven values, 32 bytes in the machine's byte order.
using SpacenavEvent = std::array<std::int32_t, 8>;

/// Puts events together from what a stream socket gives, in pieces of any size.
class SpacenavStream {
 public:
  /// Takes bytes from the front of `bytes` until an event is whole; nothing: all were taken and it
  /// is not.
  std::optional<SpacenavEvent> take(std::span<const std::uint8_t>& bytes) noexcept;

 private:
  std::array<std::uint8_t, sizeof(SpacenavEvent)> part_{};
  std::size_t have_ = 0;
};

/// Result of an event.
enum class SpacenavStep : std::uint8_t {
  Taken,
  PassedOver,  ///< of the service's, and not about the cap; or a button beyond 31
  Refused      ///< of no known type: this is not the service, or the stream is out of step
};

/// Puts an event into the pose's control and the buttons. The service's axes are right, up and away
/// from the user, and turns about these as its library's own examples have it; its counts are
/// those of HID times the user's sensitivity.
SpacenavStep applySpacenav(const SpacenavEvent& event, std::int64_t now_ns, RateControl& control,
                           std::uint32_t& buttons) noexcept;

/// Where the service listens: $SPNAV_SOCKET, else /var/run/spnav.sock.
std::string spacenavPlace();

/// The device through a service at this place. Refused as Trouble::NoService or NoPermission.
///
/// `read` waits for nothing and takes at most 128 events; else as spaceMouseAt. Lost when the
/// service ends or sends an unknown event. The service controls the light.
///
/// RateControl's silence applies: the kernel passes on only axes that change, so a cap held
/// without the least tremor, as at its stop, halts after 200 ms unless spacenavd is told to repeat
/// (`repeat-interval = 50` in /etc/spnavrc; not verified).
Expected<std::unique_ptr<Device>> spacenavAt(const std::string& place,
                                             MonotonicClock clock = monotonicNs);

/// The driver "spacenav".
std::vector<DeviceEntry> surveySpacenav();
Expected<std::unique_ptr<Device>> openSpacenav(const OpenRequest& request);

}  // namespace haptics
