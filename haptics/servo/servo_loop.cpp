// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/servo_loop.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "haptics/core/clock.h"
#include "haptics/servo/servo_tick.h"

namespace haptics {
namespace {

constexpr int kServoPriority = 80;

}  // namespace

ServoLoop::ServoLoop(std::unique_ptr<Device> device, const Settings& initial, bool arm,
                     ServoRate rate)
    : armed{arm},
      device_{std::move(device)},
      rate_{rate},
      in_force_{initial},
      safety_{limitsOf(device_->rating())} {
  touchPages(forces);
  touchPages(transitions);
  touchPages(cuts);
}

ServoLoop::ServoLoop(std::unique_ptr<Device> device, const Settings& initial, const Pose& X_WD,
                     double heat, ServoRate rate)
    : ServoLoop{std::move(device), initial, false, rate} {
  guard_ = std::make_unique<Guard>(*device_, X_WD, rate_);
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
    due += rate_.period_ns();
    // a period in which no tick can begin any more is missed, not made up for
    const std::int64_t behind = monotonicNs() - due;
    if (behind > rate_.period_ns()) {
      const std::int64_t missed = behind / rate_.period_ns();
      snapshot_.missed_ticks += static_cast<std::uint64_t>(missed);
      due += missed * rate_.period_ns();
    }
    due = awaitTick(due);
  }
  device_->write({});
}

std::int64_t ServoLoop::awaitTick(std::int64_t due) {
  std::int64_t came = 0;
  if (device_->inStep() && !lost_) {
    // of readings that come more often than ticks, up to 4 kHz, the one nearest to the time
    constexpr std::int64_t kAbout = 125'000;
    sleepUntil(due - kAbout);
    came = device_->awaitReading(due + std::min(kAbout, rate_.period_ns() / 4));
  } else {
    sleepUntil(due);
  }
  if (monotonicNs() - due > rate_.late_ns()) ++snapshot_.late_ticks;
  return came != 0 ? came : due;
}

void ServoLoop::readDevice(Period& period, std::int64_t now) HAPTICS_RT {
  if (period.has(StepFlags::kAdopted)) device_->fit(gyrationOf(period.engaged->scene->tool.shell));
  if (period.has(StepFlags::kAdopted) && period.engaged->X_WH)
    device_->place(period.engaged->proxy.X_WP, *period.engaged->X_WH);
  const DeviceStatus read = lost_ ? DeviceStatus::Lost : device_->read(reading_);
  period.raise(StepFlags::kLost, read == DeviceStatus::Lost);
  period.raise(StepFlags::kNotReady, read == DeviceStatus::NotReady);
  period.raise(StepFlags::kStale, read == DeviceStatus::Stale);
  if (!guard_) {
    X_WD_ = reading_.X_BD;
    return;
  }
  if (handling.take(guard_->handling)) guard_->handled_ns = now;
  if (period.has(StepFlags::kAdopted) && period.engaged != nullptr)
    guard_->mapping.place(X_WD_ = period.engaged->proxy.X_WP);
  constexpr std::int64_t kSilent = 1'500'000;  // ns; at 1 kHz the third reading
  if (read != DeviceStatus::Stale)
    guard_->silent_ns = 0;
  else if (guard_->silent_ns == 0)
    guard_->silent_ns = now;
  period.raise(StepFlags::kSilent, guard_->silent_ns != 0 && now - guard_->silent_ns >= kSilent);
  // poses that mean nothing are neither followed nor judged
  if (read == DeviceStatus::Lost || read == DeviceStatus::NotReady) {
    guard_->mapping.lift();
    guard_->motion = {};
    guard_->lead.forget();
    return;
  }
  const std::int64_t measured = reading_.time_ns != 0 ? reading_.time_ns : now;
  const ForceReason judged = guard_->motion.judge(reading_.X_BD, measured);
  period.raise(StepFlags::kTooFast, judged == ForceReason::TooFast);
  period.raise(StepFlags::kJumped, judged == ForceReason::Jump);
  const auto down = [&](int button) {
    return button >= 0 && button < 32 && ((reading_.buttons >> button) & 1U) != 0;
  };
  const Handling& held = guard_->handling;
  const bool clutched = held.clutch || down(held.clutch_button);
  period.raise(StepFlags::kClutched, clutched);
  constexpr std::int64_t kKeyCounts = 250'000'000;  // ns
  const bool key = held.held && now - guard_->handled_ns < kKeyCounts;
  period.raise(StepFlags::kLetGo, held.hold_to_run && !key && !down(held.hold_button));
  guard_->mapping.set(held.R_WB, in_force_.position_scale);
  guard_->mapping.clutch(clutched);
  if (judged == ForceReason::Jump) guard_->lead.forget();
  X_WD_ = guard_->mapping.toWorld(guard_->lead.ahead(reading_.X_BD, measured));
}

void ServoLoop::judgeCut(Period& period, std::int64_t now) HAPTICS_RT {
  const int button = guard_ ? guard_->handling.cut_button : -1;
  const std::int64_t until = cut_until.load(std::memory_order_relaxed);
  const bool pressed = button >= 0 && button < 32 && ((reading_.buttons >> button) & 1U) != 0;
  const bool down = now < until || pressed;
  constexpr auto kUnsure = static_cast<std::uint16_t>(
      StepFlags::kAdopted | StepFlags::kLost | StepFlags::kSilent | StepFlags::kNotReady |
      StepFlags::kGap | StepFlags::kTooFast | StepFlags::kJumped | StepFlags::kStalled |
      StepFlags::kClutched | StepFlags::kLetGo);
  // nobody cuts what he does not feel
  const bool felt = safety_.state() == ForceState::On || safety_.state() == ForceState::Ramping;
  if (period.has(kUnsure) || !period.has(StepFlags::kArmed) || !felt ||
      cut_rests.load(std::memory_order_relaxed))
    may_cut_ = false;
  else if (until == 0 && !pressed)
    may_cut_ = true;
  // what is recorded has every cut
  const bool able = period.engaged != nullptr && period.engaged->cutting != nullptr &&
                    cuts.size_approx() < kMostCuts / 2 &&
                    (period.ring == nullptr || period.ring->hasRoom());
  period.raise(StepFlags::kCut, down && may_cut_ && able);
}

void ServoLoop::step(double time, std::int64_t now) HAPTICS_RT {
  const std::int64_t begun = Budget::threadTime();
  Period period = takeWishes(now);
  readDevice(period, now);
  judgeCut(period, now);
  period.read_at = period.ring != nullptr ? monotonicNs() : 0;
  Budget budget = Budget::timed(rate_.budget_ns());
  const ServoResult result = feel(period, budget);
  push(result.sent_W, period);
  noteTransitions(time);
  measureNearness(period);
  period.cpu_ns = Budget::threadTime() - begun;
  publish(period, result, time);
  if (period.ring != nullptr) record(period, budget);
  boundary.store(snapshot_.tick, std::memory_order_release);
}

ServoLoop::Period ServoLoop::takeWishes(std::int64_t now) HAPTICS_RT {
  const Watchdog::Beat beat = guard_ && !lost_ ? guard_->watchdog.beat(now) : Watchdog::Beat{};
  const Settings before = in_force_;
  settings.take(in_force_);
  Period period;
  const bool adopted = scenes.adopt();
  scenes.takeCutting();
  const bool stiffened = in_force_.stiffness != before.stiffness ||
                         in_force_.angular_stiffness != before.angular_stiffness;
  const bool moved = stiffened || in_force_.isovalue != before.isovalue ||
                     in_force_.friction != before.friction ||
                     in_force_.position_scale != before.position_scale;
  const bool arm = armed.load(std::memory_order_relaxed);
  period.engaged = scenes.current();
  // from here on the recorder's own: what it is not told any more it will not miss
  period.ring = recording.load(std::memory_order_acquire);
  if (period.ring != nullptr && (adopted || period.ring->startIsDue()))
    startRecording(*period.ring, period.engaged);
  period.watch = watch.load(std::memory_order_acquire);
  if (period.watch != watched_) {
    const bool felt = period.watch != nullptr && period.watch->isFelt();
    period.raise(StepFlags::kWatchMoved, felt || felt_);
    watched_ = period.watch;
    felt_ = felt;
  }
  period.raise(StepFlags::kAdopted, adopted);
  period.raise(StepFlags::kSettingMoved, moved);
  period.raise(StepFlags::kStiffnessMoved, stiffened);
  period.raise(StepFlags::kArmed, arm);
  period.raise(StepFlags::kGap, beat.gap);
  period.raise(StepFlags::kStalled, beat.stalled && arm);
  return period;
}

ServoResult ServoLoop::feel(Period& period, Budget& budget) HAPTICS_RT {
  if (period.has(StepFlags::kLost)) period.engaged = nullptr;
  Engagement* const engaged = period.engaged;
  return servoTick({.X_WD = X_WD_,
                    .settings = in_force_,
                    .flags = period.flags,
                    .watch = period.watch,
                    .felt = engaged != nullptr ? &engaged->felt : nullptr,
                    .cutting = engaged != nullptr ? engaged->cutting.get() : nullptr},
                   engaged != nullptr ? engaged->scene.get() : nullptr,
                   engaged != nullptr ? &engaged->proxy : nullptr, safety_, rate_.period(), budget);
}

void ServoLoop::push(const Wrench& sent_W, const Period& period) HAPTICS_RT {
  const Wrench sent_B = guard_ ? guard_->mapping.toBase(sent_W) : sent_W;
  if (device_->write(sent_B) == DeviceStatus::Lost || period.has(StepFlags::kLost)) {
    lost_ = true;
    device_->stop();
  }
  // what is at fault, or was homed and is no more, stays off until the user arms it
  if (lost_ || safety_.state() == ForceState::Fault || period.has(StepFlags::kNotReady))
    armed.store(false, std::memory_order_relaxed);
}

void ServoLoop::noteTransitions(double time) HAPTICS_RT {
  for (ForceTransition transition : safety_.transitions()) {
    transition.time = time;
    transitions.try_enqueue(transition);
  }
}

void ServoLoop::publish(const Period& period, const ServoResult& result, double time) HAPTICS_RT {
  const Engagement* const engaged = period.engaged;
  const Cutting* const cutting = engaged != nullptr ? engaged->cutting.get() : nullptr;
  stats_.add(time, double(period.cpu_ns) * 1e-9);
  ++snapshot_.tick;
  snapshot_.time = time;
  snapshot_.X_WD = X_WD_;
  snapshot_.X_WP = engaged != nullptr ? engaged->proxy.X_WP : X_WD_;
  snapshot_.scene = engaged != nullptr ? engaged->scene->id : 0;
  snapshot_.felt_W = result.sent_W;
  snapshot_.coupling_W = result.tick.wrench_W;
  snapshot_.isovalue = in_force_.isovalue;
  snapshot_.contacts = result.tick.contacts;
  if (engaged != nullptr) notePlaces(engaged->proxy);
  snapshot_.force_state = safety_.state();
  snapshot_.reason = safety_.reason();
  snapshot_.buttons = reading_.buttons;
  snapshot_.trouble = reading_.trouble;
  snapshot_.clutched = period.has(StepFlags::kClutched);
  snapshot_.can_cut = cutting != nullptr;
  snapshot_.cuts = period.has(StepFlags::kCut);
  snapshot_.burr_force = snapshot_.cuts ? cutting->force() : 0.0;
  if (cutting != nullptr && cutting->begun()) cuts.try_enqueue(*cutting->begun());
  snapshot_.stiffness_share = safety_.stiffnessShare();
  snapshot_.servo_rate = stats_.rate();
  snapshot_.tick_p99 = stats_.p99();
  snapshots.publish(snapshot_);
  // a full queue drops the newest: the plot is not worth waiting for
  forces.try_enqueue({time, static_cast<float>(result.sent_W.force.norm()),
                      static_cast<float>(result.sent_W.torque.norm())});
}

void ServoLoop::measureNearness(const Period& period) HAPTICS_RT {
  if (period.watch != nullptr && period.engaged != nullptr)
    measure(*period.watch, *period.engaged->scene, period.engaged->proxy.X_WP, snapshot_.near);
  else
    snapshot_.near.clear();
}

void ServoLoop::notePlaces(const Proxy& proxy) HAPTICS_RT {
  static_assert(Bearing::capacity() <= std::tuple_size_v<decltype(Snapshot::places)>);
  const Vec3 p_WP = proxy.X_WP.translation();
  for (std::size_t i = 0; i < proxy.bearing.size(); ++i) {
    const BearingContact& contact = proxy.bearing[i];
    ContactPlace& place = snapshot_.places[i];
    for (Eigen::Index a = 0; a < 3; ++a)
      place.p_W[static_cast<std::size_t>(a)] = static_cast<float>(p_WP[a] + contact.r_W[a]);
    place.push = static_cast<float>(contact.push);
  }
}

void ServoLoop::startRecording(StepRing& ring, Engagement* touched) HAPTICS_RT {
  ProxyStart start;
  start.limits = safety_.limits();
  start.safety = safety_.memory();
  start.rate = rate_;
  if (touched != nullptr) {
    touched->proxy.forget();
    touched->felt.forget();
    if (touched->cutting) touched->cutting->forget();
    start.scene = static_cast<std::uint32_t>(touched->scene->id);
    start.X_WP = touched->proxy.X_WP;
    start.turn = touched->proxy.turn;
  }
  ring.start(start);
}

void ServoLoop::record(const Period& period, const Budget& budget) HAPTICS_RT {
  step_.time_ns = period.read_at - period.ring->begun();
  step_.flags = period.flags;
  step_.cut_at = budget.cutAt();
  step_.cpu_ns = period.cpu_ns;
  step_.X_WD = snapshot_.X_WD;
  step_.X_WP = snapshot_.X_WP;
  step_.sent_W = snapshot_.felt_W;
  step_.settings = in_force_;
  step_.scene = static_cast<std::uint32_t>(snapshot_.scene);
  step_.late_ticks = static_cast<std::uint32_t>(snapshot_.late_ticks);
  step_.missed_ticks = static_cast<std::uint32_t>(snapshot_.missed_ticks);
  step_.force_state = snapshot_.force_state;
  step_.contacts.clear();
  if (period.engaged != nullptr) step_.contacts = period.engaged->proxy.bearing;
  step_.near = snapshot_.near;
  step_.cut.reset();
  if (period.engaged != nullptr && period.engaged->cutting)
    step_.cut = period.engaged->cutting->begun();
  period.ring->push(step_);
}

}  // namespace haptics
