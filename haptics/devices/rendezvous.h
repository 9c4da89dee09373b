// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <semaphore.h>

#include <atomic>
#include <cstdint>

namespace haptics {

/// Lets a tick begin when a reading comes, and lets the device's thread wait for the wrench that
/// answers it. So the force is late by the time of the tick, and not by a round of that thread.
/// Either thread goes on without the other: each wait has an end.
class Rendezvous {
 public:
  Rendezvous();
  ~Rendezvous();
  Rendezvous(const Rendezvous&) = delete;
  Rendezvous& operator=(const Rendezvous&) = delete;

  // Servo thread.
  /// Waits for a reading that comes after this call, until `until_ns` (monotonic). Returns when it
  /// came [ns], and the device's thread waits for answer(); 0: none came.
  std::int64_t awaitReading(std::int64_t until_ns) noexcept;
  /// The wrench is written. Does not wait.
  void answer() noexcept;

  // The device's thread.
  /// A reading has come. If the servo thread waits for one, wakes it, waits for its answer, at most
  /// `longest_ns`, and returns true. It spins for as long as most ticks take, since to be woken may
  /// take longer than the tick.
  bool readingCame(std::int64_t longest_ns) noexcept;

 private:
  // a wait has a number, so that what comes too late for it is not taken for the answer to a later
  // one; 0: none
  std::uint64_t wait_ = 0;                      ///< the servo thread's last
  bool asked_ = false;                          ///< the servo thread owes an answer
  std::atomic<std::uint64_t> awaited_{0};       ///< the servo thread waits
  std::atomic<std::uint64_t> came_for_{0};      ///< the wait that a reading ended
  std::atomic<std::int64_t> came_at_{0};        ///< when it came [ns]
  std::atomic<std::uint64_t> answered_for_{0};  ///< the wait whose reading was answered
  sem_t came_, answered_;
};

}  // namespace haptics
