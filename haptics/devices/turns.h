// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <semaphore.h>

#include <atomic>
#include <cstdint>

namespace haptics {

/// Lets a tick begin when a reading comes, and lets the device's thread wait for the wrench that
/// answers it. So the force is late by the time of the tick, and not by a round of that thread.
/// Either thread goes on without the other: each wait has an end.
class Turns {
 public:
  Turns();
  ~Turns();
  Turns(const Turns&) = delete;
  Turns& operator=(const Turns&) = delete;

  // Servo thread.
  /// Waits for a reading that comes after this call, until `until_ns` (monotonic). True: it came,
  /// and the device's thread waits for answer().
  bool awaitReading(std::int64_t until_ns) noexcept;
  /// The wrench is written. Does not wait.
  void answer() noexcept;

  // The device's thread.
  /// A reading has come. If the servo thread waits for one, wakes it, waits for its answer, at most
  /// `longest_ns`, and returns true.
  bool readingCame(std::int64_t longest_ns) noexcept;

 private:
  std::atomic<bool> awaited_{false};  ///< the servo thread waits for a reading
  bool asked_ = false;                ///< the servo thread's: the device's thread waits
  sem_t came_, answered_;
};

}  // namespace haptics
