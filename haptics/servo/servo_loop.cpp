// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/servo_loop.h"

#include <pthread.h>
#include <sched.h>

#include <cmath>
#include <ctime>

#include "haptics/core/clock.h"
#include "haptics/servo/servo_tick.h"

namespace haptics {
namespace {

constexpr std::int64_t kPeriodNs = 1'000'000;
constexpr std::int64_t kLateNs = 100'000;
constexpr int kServoPriority = 80;

}  // namespace

ServoLoop::ServoLoop(std::unique_ptr<Device> device, const Settings& initial, bool arm)
    : armed{arm},
      device_{std::move(device)},
      in_force_{initial},
      safety_{limitsOf(device_->rating())} {}

ServoLoop::ServoLoop(std::unique_ptr<Device> device, const Settings& initial, const Pose& X_WD,
                     double heat)
    : ServoLoop{std::move(device), initial, false} {
  guard_ = std::make_unique<Guard>(*device_, X_WD);
  X_WD_ = X_WD;
  Safety::Memory warm;
  warm.heat = heat;
  safety_ = Safety{safety_.limits(), warm};
}

void ServoLoop::end() {
  ending_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

ServoLoop::~ServoLoop() {
  end();
  device_->stop();
  guard_.reset();
}

void ServoLoop::start() {
  if (guard_) guard_->watchdog.start();
  thread_ = std::thread{[this] { run(); }};
}

void ServoLoop::run() {
  const sched_param parameters{.sched_priority = kServoPriority};
  snapshot_.policy = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0
                         ? SchedulingPolicy::RealTime
                         : SchedulingPolicy::Ordinary;
  const std::int64_t begun = monotonicNs();
  std::int64_t due = begun;
  while (!ending_.load(std::memory_order_relaxed)) {
    step(double(due - begun) * 1e-9, Watchdog::clock());
    due += kPeriodNs;
    // a period in which no tick can begin any more is missed, not made up for
    const std::int64_t behind = monotonicNs() - due;
    if (behind > kPeriodNs) {
      const std::int64_t missed = behind / kPeriodNs;
      snapshot_.missed_ticks += static_cast<std::uint64_t>(missed);
      due += missed * kPeriodNs;
    }
    const timespec wake{due / 1'000'000'000, due % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {
    }
    if (monotonicNs() - due > kLateNs) ++snapshot_.late_ticks;
  }
  device_->write({});
}

std::uint16_t ServoLoop::readDevice(Engagement* adopted, std::int64_t now) HAPTICS_RT {
  unsigned flags = 0;
  const DeviceStatus read = lost_ ? DeviceStatus::Lost : device_->read(reading_);
  if (read == DeviceStatus::Lost) flags |= StepFlags::kLost;
  if (read == DeviceStatus::NotReady) flags |= StepFlags::kNotReady;
  if (read == DeviceStatus::Stale) flags |= StepFlags::kStale;
  if (!guard_) {
    X_WD_ = reading_.X_BD;
    return static_cast<std::uint16_t>(flags);
  }
  if (handling.take(guard_->handling)) guard_->handled_ns = now;
  if (adopted != nullptr) guard_->mapping.place(X_WD_ = adopted->proxy.X_WP);
  constexpr int kSilent = 3;
  guard_->silent = read == DeviceStatus::Stale ? guard_->silent + 1 : 0;
  if (guard_->silent >= kSilent) flags |= StepFlags::kSilent;
  // poses that mean nothing are neither followed nor judged
  if (read == DeviceStatus::Lost || read == DeviceStatus::NotReady) {
    guard_->mapping.lift();
    guard_->motion = {};
    return static_cast<std::uint16_t>(flags);
  }
  const std::int64_t measured = reading_.time_ns != 0 ? reading_.time_ns : now;
  switch (guard_->motion.judge(reading_.X_BD, measured)) {
    case ForceReason::TooFast:
      flags |= StepFlags::kTooFast;
      break;
    case ForceReason::Jump:
      flags |= StepFlags::kJumped;
      break;
    default:
      break;
  }
  const auto down = [&](int button) {
    return button >= 0 && button < 32 && ((reading_.buttons >> button) & 1U) != 0;
  };
  const Handling& held = guard_->handling;
  const bool clutched = held.clutch || down(held.clutch_button);
  if (clutched) flags |= StepFlags::kClutched;
  constexpr std::int64_t kKeyCounts = 250'000'000;  // ns
  const bool key = held.held && now - guard_->handled_ns < kKeyCounts;
  if (held.hold_to_run && !key && !down(held.hold_button)) flags |= StepFlags::kLetGo;
  guard_->mapping.set(held.R_WB, in_force_.position_scale);
  guard_->mapping.clutch(clutched);
  X_WD_ = guard_->mapping.toWorld(reading_.X_BD);
  return static_cast<std::uint16_t>(flags);
}

void ServoLoop::step(double time, std::int64_t now) HAPTICS_RT {
  const std::int64_t begun = Budget::threadTime();
  const Watchdog::Beat beat = guard_ && !lost_ ? guard_->watchdog.beat(now) : Watchdog::Beat{};
  const Settings before = in_force_;
  settings.take(in_force_);
  const bool adopted = scenes.adopt();
  const bool stiffened = in_force_.stiffness != before.stiffness ||
                         in_force_.angular_stiffness != before.angular_stiffness;
  const bool moved = stiffened || in_force_.isovalue != before.isovalue ||
                     in_force_.friction != before.friction ||
                     in_force_.position_scale != before.position_scale;
  const bool arm = armed.load(std::memory_order_relaxed);
  Engagement* const touched = scenes.current();
  // from here on the recorder's own: what it is not told any more it will not miss
  StepRing* const ring = recording.load(std::memory_order_acquire);
  if (ring != nullptr && (adopted || ring->startIsDue())) startRecording(*ring, touched);

  std::uint16_t flags = readDevice(adopted ? touched : nullptr, now);
  const std::int64_t read_at = ring != nullptr ? monotonicNs() : 0;
  flags = static_cast<std::uint16_t>(
      flags | (adopted ? StepFlags::kAdopted : 0) | (moved ? StepFlags::kSettingMoved : 0) |
      (stiffened ? StepFlags::kStiffnessMoved : 0) | (arm ? StepFlags::kArmed : 0) |
      (beat.gap ? StepFlags::kGap : 0) | (beat.stalled && arm ? StepFlags::kStalled : 0));
  Budget budget = Budget::timed(kTickBudget);
  const bool touching = touched != nullptr && (flags & StepFlags::kLost) == 0;
  const ServoResult result =
      servoTick({X_WD_, in_force_, flags}, touching ? touched->scene.get() : nullptr,
                touching ? &touched->proxy : nullptr, safety_, kPeriod, budget);
  const Wrench sent_B = guard_ ? guard_->mapping.toBase(result.sent_W) : result.sent_W;
  if (device_->write(sent_B) == DeviceStatus::Lost || (flags & StepFlags::kLost) != 0) {
    lost_ = true;
    device_->stop();
  }
  // what is at fault, or was homed and is no more, stays off until the user arms it
  if (lost_ || safety_.state() == ForceState::Fault || (flags & StepFlags::kNotReady) != 0)
    armed.store(false, std::memory_order_relaxed);
  for (ForceTransition transition : safety_.transitions()) {
    transition.time = time;
    transitions.try_enqueue(transition);
  }

  const std::int64_t cpu_ns = Budget::threadTime() - begun;
  stats_.add(time, double(cpu_ns) * 1e-9);
  ++snapshot_.tick;
  snapshot_.time = time;
  snapshot_.X_WD = X_WD_;
  snapshot_.X_WP = touching ? touched->proxy.X_WP : X_WD_;
  snapshot_.scene = touching ? touched->scene->id : 0;
  snapshot_.felt_W = result.sent_W;
  snapshot_.coupling_W = result.tick.wrench_W;
  snapshot_.isovalue = in_force_.isovalue;
  snapshot_.contacts = result.tick.contacts;
  snapshot_.force_state = safety_.state();
  snapshot_.reason = safety_.reason();
  snapshot_.buttons = reading_.buttons;
  snapshot_.trouble = reading_.trouble;
  snapshot_.clutched = (flags & StepFlags::kClutched) != 0;
  snapshot_.stiffness_share = safety_.stiffnessShare();
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
