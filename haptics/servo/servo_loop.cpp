// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/servo_loop.h"

#include <pthread.h>
#include <sched.h>

#include <cmath>
#include <ctime>

#include "haptics/servo/tick.h"

namespace haptics {
namespace {

constexpr std::int64_t kPeriodNs = 1'000'000;
constexpr std::int64_t kLateNs = 100'000;
constexpr double kRampTime = 1.0;   // s
constexpr double kSlewTime = 0.02;  // s from zero to the rated force
constexpr int kPriority = 80;

std::int64_t monotonic() HAPTICS_RT {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

ServoLoop::ServoLoop(std::unique_ptr<Device> device, const Settings& initial, bool arm)
    : armed{arm},
      device_{std::move(device)},
      in_force_{initial},
      safety_{{device_->limits().force, device_->limits().torque, kRampTime, kSlewTime}} {}

ServoLoop::~ServoLoop() {
  ending_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
  device_->stop();
}

void ServoLoop::start() {
  thread_ = std::thread{[this] { run(); }};
}

void ServoLoop::run() {
  const sched_param parameters{.sched_priority = kPriority};
  snapshot_.policy = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0
                         ? SchedulingPolicy::RealTime
                         : SchedulingPolicy::Ordinary;
  const std::int64_t begun = monotonic();
  std::int64_t due = begun;
  while (!ending_.load(std::memory_order_relaxed)) {
    step(double(due - begun) * 1e-9);
    due += kPeriodNs;
    // a period in which no tick can begin any more is missed, not made up for
    const std::int64_t behind = monotonic() - due;
    if (behind > kPeriodNs) {
      const std::int64_t missed = behind / kPeriodNs;
      snapshot_.missed_ticks += static_cast<std::uint64_t>(missed);
      due += missed * kPeriodNs;
    }
    const timespec wake{due / 1'000'000'000, due % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {
    }
    if (monotonic() - due > kLateNs) ++snapshot_.late_ticks;
  }
  device_->write({});
}

void ServoLoop::step(double time) HAPTICS_RT {
  const std::int64_t begun = Budget::threadTime();
  const Settings before = in_force_;
  settings.take(in_force_);
  if (scenes.adopt()) safety_.restart();
  if (in_force_.isovalue != before.isovalue || in_force_.stiffness != before.stiffness ||
      in_force_.angular_stiffness != before.angular_stiffness ||
      in_force_.friction != before.friction)
    safety_.settingMoved();
  if (armed.load(std::memory_order_relaxed))
    safety_.arm();
  else
    safety_.forceOff();

  const DeviceStatus read = device_->read(reading_);
  TickResult result;
  snapshot_.X_WD = snapshot_.X_WP = reading_.X_BD;
  snapshot_.scene = 0;
  if (Engagement* touched = scenes.current(); touched != nullptr && read != DeviceStatus::Lost) {
    Budget budget = Budget::timed(kTickBudget);
    result = tick(*touched->scene, in_force_.isovalue,
                  {in_force_.stiffness, in_force_.angular_stiffness, in_force_.friction},
                  reading_.X_BD, touched->proxy, budget);
    snapshot_.X_WP = touched->proxy.X_WP;
    snapshot_.scene = touched->scene->id;
  }
  if (read == DeviceStatus::Lost) safety_.forceOff();
  const Wrench sent = safety_.pass(result.wrench_W, result.outside, kPeriod);
  if (device_->write(sent) == DeviceStatus::Lost || read == DeviceStatus::Lost) {
    armed.store(false, std::memory_order_relaxed);
    device_->stop();
  }

  const double cpu = double(Budget::threadTime() - begun) * 1e-9;
  stats_.add(time, cpu);
  ++snapshot_.tick;
  snapshot_.time = time;
  snapshot_.felt_W = sent;
  snapshot_.coupling_W = result.wrench_W;
  snapshot_.isovalue = in_force_.isovalue;
  snapshot_.contacts = result.contacts;
  snapshot_.force_state = safety_.state();
  snapshot_.servo_rate = stats_.rate();
  snapshot_.tick_p99 = stats_.p99();
  snapshots.publish(snapshot_);
  // a full queue drops the newest: the plot is not worth waiting for
  forces.try_enqueue(
      {time, static_cast<float>(sent.force.norm()), static_cast<float>(sent.torque.norm())});
}

}  // namespace haptics
