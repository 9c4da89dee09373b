// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/watchdog.h"

#include <pthread.h>
#include <sched.h>

#include <ctime>

#include "haptics/servo/emergency.h"

namespace haptics {
namespace {

constexpr std::int64_t kLookNs = 1'000'000;
constexpr int kWatchdogPriority = 81;  // above the servo thread's, which may hang

}  // namespace

std::int64_t Watchdog::clock() HAPTICS_RT {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

Watchdog::~Watchdog() {
  ending_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

void Watchdog::start() {
  stopAtExit();
  thread_ = std::thread{[this] { run(); }};
}

void Watchdog::run() {
  const sched_param parameters{.sched_priority = kWatchdogPriority};
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  while (!ending_.load(std::memory_order_relaxed)) {
    look(clock());
    const timespec pause{0, kLookNs};
    clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
  }
}

void Watchdog::look(std::int64_t now) HAPTICS_RT {
  const std::int64_t last = last_beat_.load(std::memory_order_acquire);
  const bool silent = last != 0 && now - last > kLongestGap;
  if (!silent && !motorsAreStopped()) return;
  device_.stop();
  // after the stop: who sees the count may let the device go on
  stops_.fetch_add(1, std::memory_order_release);
}

Watchdog::Beat Watchdog::beat(std::int64_t now) HAPTICS_RT {
  const std::int64_t last = last_beat_.exchange(now, std::memory_order_acq_rel);
  const std::uint64_t stops = stops_.load(std::memory_order_acquire);
  Beat beat;
  beat.gap = stops != stops_seen_ || (last != 0 && now - last > kLongestGap);
  if (!beat.gap) return beat;
  stops_seen_ = stops;
  if (!motorsAreStopped()) device_.resume();
  // a stop that came while this thread was waking belongs to the gap before
  const std::int64_t newest =
      gaps_[static_cast<std::size_t>((next_gap_ + kMostGaps - 1) % kMostGaps)];
  if (newest != 0 && now - newest < kLongestGap) return beat;
  // of the last three the oldest makes way
  gaps_[static_cast<std::size_t>(next_gap_)] = now;
  next_gap_ = (next_gap_ + 1) % kMostGaps;
  const std::int64_t oldest = gaps_[static_cast<std::size_t>(next_gap_)];
  beat.stalled = oldest != 0 && now - oldest < kWindow;
  return beat;
}

}  // namespace haptics
