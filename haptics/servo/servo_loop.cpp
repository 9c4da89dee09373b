// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/servo_loop.h"

#include <pthread.h>
#include <sched.h>

#include <cmath>
#include <ctime>

#include "haptics/servo/servo_tick.h"

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
      safety_{{device_->rating().force, device_->rating().torque, kRampTime, kSlewTime}} {}

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
  const bool adopted = scenes.adopt();
  const bool moved = in_force_.isovalue != before.isovalue ||
                     in_force_.stiffness != before.stiffness ||
                     in_force_.angular_stiffness != before.angular_stiffness ||
                     in_force_.friction != before.friction;
  const bool arm = armed.load(std::memory_order_relaxed);
  Engagement* const touched = scenes.current();
  // from here on the recorder's own: what it is not told any more it will not miss
  StepRing* const ring = recording.load(std::memory_order_acquire);
  if (ring != nullptr && (adopted || ring->startIsDue())) startRecording(*ring, touched);

  const DeviceStatus read = device_->read(reading_);
  const std::int64_t read_at = ring != nullptr ? monotonic() : 0;
  const auto flags = static_cast<std::uint8_t>(
      (adopted ? StepFlags::kAdopted : 0) | (moved ? StepFlags::kSettingMoved : 0) |
      (arm ? StepFlags::kArmed : 0) | (read == DeviceStatus::Lost ? StepFlags::kLost : 0) |
      (read == DeviceStatus::Stale ? StepFlags::kStale : 0));
  Budget budget = Budget::timed(kTickBudget);
  const bool touching = touched != nullptr && read != DeviceStatus::Lost;
  const ServoResult result =
      servoTick({reading_.X_BD, in_force_, flags}, touching ? touched->scene.get() : nullptr,
                touching ? &touched->proxy : nullptr, safety_, kPeriod, budget);
  if (device_->write(result.sent_W) == DeviceStatus::Lost || read == DeviceStatus::Lost) {
    armed.store(false, std::memory_order_relaxed);
    device_->stop();
  }

  const std::int64_t cpu_ns = Budget::threadTime() - begun;
  stats_.add(time, double(cpu_ns) * 1e-9);
  ++snapshot_.tick;
  snapshot_.time = time;
  snapshot_.X_WD = reading_.X_BD;
  snapshot_.X_WP = touching ? touched->proxy.X_WP : reading_.X_BD;
  snapshot_.scene = touching ? touched->scene->id : 0;
  snapshot_.felt_W = result.sent_W;
  snapshot_.coupling_W = result.tick.wrench_W;
  snapshot_.isovalue = in_force_.isovalue;
  snapshot_.contacts = result.tick.contacts;
  snapshot_.force_state = safety_.state();
  snapshot_.servo_rate = stats_.rate();
  snapshot_.tick_p99 = stats_.p99();
  snapshots.publish(snapshot_);
  // a full queue drops the newest: the plot is not worth waiting for
  forces.try_enqueue({time, static_cast<float>(result.sent_W.force.norm()),
                      static_cast<float>(result.sent_W.torque.norm())});
  if (ring != nullptr) {
    step_.time_ns = read_at - ring->begun();
    step_.flags = flags;
    step_.cut_at = budget.cutAt();
    step_.cpu_ns = cpu_ns;
    record(*ring, touching ? &touched->proxy : nullptr);
  }
  boundary.store(snapshot_.tick, std::memory_order_release);
}

void ServoLoop::startRecording(StepRing& ring, Engagement* touched) HAPTICS_RT {
  ProxyStart start;
  start.limits = safety_.limits();
  start.safety = safety_.memory();
  if (touched != nullptr) {
    touched->proxy.forget();
    start.scene = static_cast<std::uint32_t>(touched->scene->id);
    start.X_WP = touched->proxy.X_WP;
    start.turn = touched->proxy.turn;
  }
  ring.start(start);
}

void ServoLoop::record(StepRing& ring, const Proxy* proxy) HAPTICS_RT {
  step_.X_WD = snapshot_.X_WD;
  step_.X_WP = snapshot_.X_WP;
  step_.sent_W = snapshot_.felt_W;
  step_.settings = in_force_;
  step_.scene = static_cast<std::uint32_t>(snapshot_.scene);
  step_.late_ticks = static_cast<std::uint32_t>(snapshot_.late_ticks);
  step_.missed_ticks = static_cast<std::uint32_t>(snapshot_.missed_ticks);
  step_.force_state = snapshot_.force_state;
  step_.contacts.clear();
  if (proxy != nullptr) step_.contacts = proxy->bearing;
  ring.push(step_);
}

}  // namespace haptics
