// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>

#include "haptics/devices/device.h"

namespace haptics {

/// A link to a device that is slower than the servo thread can wait for. It lives on a thread of
/// its own, which alone calls it, opening and closing aside.
class Transport {
 public:
  /// The longest that an exchange may wait.
  static constexpr std::chrono::milliseconds kLongestWait{5};

  virtual ~Transport() = default;  ///< leaves the motors off
  /// One round: sends the wrench, waits kLongestWait at most for what comes back. Stale: nothing
  /// came, and the reading stands. What is not finite is never sent. A device without motors
  /// ignores the wrench.
  virtual DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept = 0;
};

/// The transport as a device: its thread exchanges as fast as the transport lets it, always with
/// the newest wrench. Reading and writing take no time, so `read` gives what came last, Stale once
/// that is older than `fresh`; three exchanges in a row that failed make it Lost. A wrench that no
/// write has confirmed for 5 ms is not sent any more: zero is. stop() is obeyed by the next
/// exchange, within kLongestWait.
///
/// `fresh`: how old a reading may be; 0: as old as it likes (a device that reports changes only).
std::unique_ptr<Device> threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
                                 std::chrono::milliseconds fresh);

}  // namespace haptics
