// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>

#include "haptics/devices/device.h"

namespace haptics {

/// A link to a device that is too slow for the servo thread. Apart from opening and closing, only
/// one thread of its own calls it.
class Transport {
 public:
  /// The longest that an exchange may wait.
  static constexpr std::chrono::milliseconds kLongestWait{5};

  virtual ~Transport() = default;  ///< leaves the motors off
  /// One round: sends the wrench and waits at most kLongestWait for the answer. Stale: an expected
  /// answer did not come, and the reading is kept. A device that reports only changes is Ok without
  /// an answer. A number that is not finite is never sent. A device without motors ignores the
  /// wrench.
  virtual DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept = 0;
};

/// The transport as a device: its thread exchanges as fast as the transport lets it, but not more
/// than once in 250 us, always with the newest wrench. Reading and writing take no time, so `read`
/// gives what came last, Stale once that is older than `fresh`; three exchanges in a row that
/// failed make it Lost, as does an exchange that hangs, noticed by a read when nothing has come
/// for two seconds. The Relay decides what may be sent: an exchange that begins later than 5 ms
/// after the last write sends zero, and so does every one while the device is NotReady or Lost.
///
/// `in_step`: for a transport whose exchange sends first, then waits for the time of its round, and
/// reads at the end. A servo thread that waits for a reading is woken when it comes, and the next
/// exchange begins once the wrench that answers it is written, or 250 us later. So this wrench is
/// late by the time of the tick; without it, by a round of the thread.
///
/// stop(): every exchange that begins after it sends zero. The one that had begun, or was about to,
/// may still carry a force; so zero is sent within kLongestWait and 250 us, and within two
/// exchanges. What was written before resume() is never sent after it.
///
/// The last exchange before the transport is destroyed, on its thread, sends zero. Where an
/// exchange hangs, the destructor waits two seconds and leaves thread and transport behind; they
/// end, with a zero, when the exchange does. What a hung exchange had sent cannot
/// be taken back here. So a transport that can hang needs a device that ends its force by itself.
///
/// `fresh`: the greatest age of a reading; 0: no limit (for a device that reports only changes).
std::unique_ptr<Device> threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
                                 std::chrono::milliseconds fresh, bool in_step = false);

}  // namespace haptics
