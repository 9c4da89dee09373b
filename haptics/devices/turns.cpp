// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/turns.h"

#include <cerrno>

#include "haptics/core/clock.h"

namespace haptics {
namespace {

bool waitUntil(sem_t& semaphore, std::int64_t until_ns) noexcept {
  const timespec until = timeOf(until_ns);
  int result = 0;
  do result = sem_clockwait(&semaphore, CLOCK_MONOTONIC, &until);
  while (result != 0 && errno == EINTR);
  return result == 0;
}

/// Takes away what a wait that had ended before left behind.
void drain(sem_t& semaphore) noexcept {
  while (sem_trywait(&semaphore) == 0) {
  }
}

}  // namespace

Turns::Turns() {
  sem_init(&came_, 0, 0);
  sem_init(&answered_, 0, 0);
}

Turns::~Turns() {
  sem_destroy(&came_);
  sem_destroy(&answered_);
}

bool Turns::awaitReading(std::int64_t until_ns) noexcept {
  drain(came_);
  awaited_.store(true);
  // a reading that comes at the very end is taken, though its thread has yet to say so
  asked_ = waitUntil(came_, until_ns) || !awaited_.exchange(false);
  return asked_;
}

void Turns::answer() noexcept {
  if (!asked_) return;
  asked_ = false;
  sem_post(&answered_);
}

bool Turns::readingCame(std::int64_t longest_ns) noexcept {
  if (!awaited_.exchange(false)) return false;
  drain(answered_);
  sem_post(&came_);
  waitUntil(answered_, monotonicNs() + longest_ns);
  return true;
}

}  // namespace haptics
