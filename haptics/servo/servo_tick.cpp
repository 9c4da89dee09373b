// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/servo_tick.h"

#include "haptics/servo/rate.h"
#include "haptics/servo/step.h"

namespace haptics {

static_assert(int(CatchUp::kRecent) == kServoRates.back().hz / 1000 - 1,
              "a step in contact may take the way of a whole millisecond, at the highest rate too");

ForceLimits limitsOf(const DeviceRating& rating) {
  constexpr double kRampTime = 1.0, kSlewTime = 0.02, kRiseTime = 0.002;
  ForceLimits limits{.force = rating.force,
                     .torque = rating.torque,
                     .ramp_time = kRampTime,
                     .slew_time = kSlewTime,
                     .rise_time = kRiseTime,
                     .guard_passivity = true};
  if (rating.continuous_force > 0.0) limits.continuous_force = rating.continuous_force;
  return limits;
}

ServoResult servoTick(const ServoInput& input, const Scene* scene, Proxy* proxy, Safety& safety,
                      double period, Budget& budget) HAPTICS_RT {
  const auto has = [&](std::uint16_t flag) { return (input.flags & flag) != 0; };
  const bool ready = scene != nullptr && !has(StepFlags::kLost | StepFlags::kNotReady);
  safety.begin({.armed = has(StepFlags::kArmed),
                .ready = ready,
                .unready = has(StepFlags::kNotReady) ? ForceReason::NotHomed
                           : scene == nullptr        ? ForceReason::Scene
                                                     : ForceReason::NoReading,
                .withheld = has(StepFlags::kGap)        ? ForceReason::Gap
                            : has(StepFlags::kSilent)   ? ForceReason::Stale
                            : has(StepFlags::kTooFast)  ? ForceReason::TooFast
                            : has(StepFlags::kClutched) ? ForceReason::Clutched
                            : has(StepFlags::kLetGo)    ? ForceReason::NotHeld
                                                        : ForceReason::None,
                .fault = has(StepFlags::kLost)      ? ForceReason::Lost
                         : has(StepFlags::kJumped)  ? ForceReason::Jump
                         : has(StepFlags::kStalled) ? ForceReason::Stalled
                                                    : ForceReason::None,
                .adopted = has(StepFlags::kAdopted)});
  if (has(StepFlags::kWatchMoved)) {
    safety.settingMoved(false);
    if (input.felt != nullptr) input.felt->forget();
  }
  if (has(StepFlags::kSettingMoved)) safety.settingMoved(has(StepFlags::kStiffnessMoved));
  safety.moved(input.X_WD, input.settings.position_scale, period);
  const double share = safety.stiffnessShare();
  ServoResult result;
  if (ready)
    result.tick = tick(*scene, input.settings.isovalue,
                       {share * input.settings.stiffness, share * input.settings.angular_stiffness,
                        input.settings.friction},
                       input.X_WD, *proxy, budget, period);
  if (ready && input.watch != nullptr)
    result.tick.wrench_W =
        input.felt->shaped(*input.watch, *scene, *proxy, input.X_WD,
                           share * input.settings.stiffness, result.tick.wrench_W, period);
  if (ready && input.cutting != nullptr) {
    const Wrench drag = input.cutting->go(has(StepFlags::kCut), *proxy, input.X_WD,
                                          input.settings.isovalue, period, budget);
    result.tick.wrench_W.force += drag.force;
    result.tick.wrench_W.torque += drag.torque;
  } else if (input.cutting != nullptr) {
    input.cutting->skip();
  }
  const Wrench wanted = input.hook == nullptr
                            ? result.tick.wrench_W
                            : input.hook->shaped(result.tick.wrench_W, input.X_WD, period);
  result.sent_W = safety.pass(wanted, result.tick.outside, period);
  if (input.hook != nullptr) input.hook->sent(result.sent_W);
  return result;
}

}  // namespace haptics
