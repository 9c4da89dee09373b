// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/rendezvous.h"

#include <algorithm>
#include <cerrno>
#include <thread>

#include "haptics/core/clock.h"

namespace haptics {
namespace {

constexpr std::int64_t kSpin = 60'000;  // ns: most ticks take less

bool waitUntil(sem_t& semaphore, std::int64_t until_ns) noexcept {
  const timespec until = timeOf(until_ns);
  int result = 0;
  do result = sem_clockwait(&semaphore, CLOCK_MONOTONIC, &until);
  while (result != 0 && errno == EINTR);
  return result == 0;
}

/// Takes away what was for earlier waits.
void drain(sem_t& semaphore) noexcept {
  while (sem_trywait(&semaphore) == 0) {
  }
}

}  // namespace

Rendezvous::Rendezvous() {
  sem_init(&came_, 0, 0);
  sem_init(&answered_, 0, 0);
}

Rendezvous::~Rendezvous() {
  sem_destroy(&came_);
  sem_destroy(&answered_);
}

std::int64_t Rendezvous::awaitReading(std::int64_t until_ns) noexcept {
  drain(came_);
  awaited_.store(++wait_);
  asked_ = true;
  while (waitUntil(came_, until_ns))
    if (came_for_.load() == wait_) return came_at_.load();
  // a reading that comes at the very end is taken, though its thread has yet to say so
  asked_ = awaited_.exchange(0) != wait_;
  return asked_ ? monotonicNs() : 0;
}

void Rendezvous::answer() noexcept {
  if (!asked_) return;
  asked_ = false;
  answered_for_.store(wait_);
  sem_post(&answered_);
}

bool Rendezvous::readingCame(std::int64_t longest_ns) noexcept {
  const std::uint64_t wait = awaited_.exchange(0);
  if (wait == 0) return false;
  const std::int64_t now = monotonicNs();
  drain(answered_);
  came_at_.store(now);
  came_for_.store(wait);
  sem_post(&came_);
  const auto answered = [&] { return answered_for_.load() == wait; };
  const std::int64_t until = now + longest_ns;
  while (!answered() && monotonicNs() < std::min(now + kSpin, until)) std::this_thread::yield();
  while (!answered() && waitUntil(answered_, until)) {
  }
  return true;
}

}  // namespace haptics
