// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/devices/catalogue.h"
#include "haptics/devices/threaded.h"

namespace haptics {

// The Haply Inverse3, and a VerseGrip for its rotation, through the service that its maker installs
// (haply-inverse-service): a WebSocket on this machine, JSON in it. Written after the maker's
// public documentation of service 3.5 (docs.haply.co: WebSocket protocol, simulation channel,
// basis); no hardware has been seen.
//
// On connection the service tells what it has: the inventory. After that it sends one state for
// each message it gets. An exchange is one set_cursor_force [N] and the state that answers it, so
// our rate is the loop's rate. A force is not persistent: a service that gets no more messages goes
// idle, also when the program is killed.
//
// The service's axes are x right, y forward, z up (its basis "XYZ"); those of B are (x, z, -y). A
// device that is set to another basis is refused. The origin is the maker's, in the device's base:
// the cursor is at home some 15 cm above it and before it.
//
// The service is spoken to at 127.0.0.1 alone: no name is looked up, no proxy or redirection
// followed, no TLS. The library and the parser allocate, on the transport's thread, not the servo
// thread's. The library has the process ignore SIGPIPE, and its own messages are turned off.
//
// Unverified on hardware: the signs of the axes and of the grip's rotation; how soon the service
// goes idle; that `calibrated`, `ready`, `started` and `power_supply` in the status are all true in
// use (one that is false makes the device NotReady; one that is missing counts as true); whether
// the service adds forces of its own, such as gravity compensation, on top; buttons of the grips.

/// Where the service listens, and how long an answer may take.
struct Inverse3Address {
  std::uint16_t port = 10001;                                  ///< of this machine
  std::chrono::milliseconds answer = Transport::kLongestWait;  ///< tests wait longer
};

/// One Inverse3 in a message.
struct Inverse3State {
  std::string id;                   ///< letters, digits, '-' and '_', 32 at most
  Vec3 p_BD = Vec3::Zero();         ///< m, the cursor
  bool tells_status = false;        ///< the message has a status; otherwise the last one stands
  Trouble trouble = Trouble::None;  ///< by its status
  Message why = {};                 ///< a sentence for the user, with `trouble`
  bool axes_are_ours = true;        ///< its basis is "XYZ", or not told
};

/// The content of a message of the service: an inventory or a state.
struct Inverse3Message {
  std::vector<Inverse3State> devices;
  std::optional<Mat3> R_BD;   ///< of the first grip that tells its orientation
  std::uint32_t buttons = 0;  ///< of that grip: a, b, c, or its one
};

/// The largest message that is read [bytes].
inline constexpr std::size_t kInverse3LongestMessage = 65'536;

/// Reads a message from any bytes. Nothing if it is not a message of the known protocol. Numbers
/// that are not finite, or positions further than 10 m away, are left out.
std::optional<Inverse3Message> readInverse3(std::string_view text);

/// The command for a force [N, in B]; what is not finite is zero. `id` as in Inverse3State.
std::string inverse3Command(std::string_view id, const Vec3& force_B);

/// Connects for 300 ms at most, reads the inventory, and sends nothing, so other programs are not
/// disturbed.
std::vector<DeviceEntry> surveyInverse3(const Inverse3Address& address);
std::vector<DeviceEntry> surveyInverse3();

/// The Inverse3 "inverse3:ID", or for "inverse3" the first that the service has. Without a grip the
/// rotation is the identity, and when a grip goes silent its last rotation is held.
///
/// An answer that is late, or that is not understood, is a failed exchange: three in a row, and the
/// device is Lost; likewise one without the device. A connection that closes is Lost at once.
Expected<std::unique_ptr<Device>> openInverse3(const OpenRequest& request,
                                               const Inverse3Address& address);
Expected<std::unique_ptr<Device>> openInverse3(const OpenRequest& request);

}  // namespace haptics
