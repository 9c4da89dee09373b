// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/servo_tick.h"

#include "haptics/recording/step.h"

namespace haptics {

ServoResult servoTick(const ServoInput& input, const Scene* scene, Proxy* proxy, Safety& safety,
                      double period, Budget& budget) HAPTICS_RT {
  const auto has = [&](std::uint8_t flag) { return (input.flags & flag) != 0; };
  if (has(StepFlags::kAdopted)) safety.restart();
  if (has(StepFlags::kSettingMoved)) safety.settingMoved();
  if (has(StepFlags::kArmed))
    safety.arm();
  else
    safety.forceOff();
  ServoResult result;
  if (scene != nullptr && !has(StepFlags::kLost))
    result.tick =
        tick(*scene, input.settings.isovalue,
             {input.settings.stiffness, input.settings.angular_stiffness, input.settings.friction},
             input.X_WD, *proxy, budget);
  if (has(StepFlags::kLost)) safety.forceOff();
  result.sent_W = safety.pass(result.tick.wrench_W, result.tick.outside, period);
  return result;
}

}  // namespace haptics
