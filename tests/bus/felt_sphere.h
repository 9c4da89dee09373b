// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/devices/device.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/servo_loop.h"
#include "tests/support/made.h"

namespace bus {

/// Whether it comes true within ten seconds: nothing here depends on how fast a guest is.
template <class Condition>
bool comesTrue(Condition condition) {
  for (int n = 0; n < 2000; ++n) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
  return false;
}

/// The whole servo loop on a real device, watched and guarded and not armed: a ball of 3 mm on a
/// sphere of 20 mm about the middle of the device's workspace, at 1000 N/m.
///
/// The tool starts at kAbove. A device that is held there too has its base where W is.
class FeltSphere {
 public:
  static constexpr double kTouch = 0.023;  ///< m from the middle: where the ball touches
  static inline const haptics::Vec3 kAbove{0.0, 0.0, 0.030};

  /// `p_BD`: where the device is held in its base [m] meanwhile. Waits until it gives poses and is
  /// there, and throws std::runtime_error where it is not within twenty seconds.
  explicit FeltSphere(std::unique_ptr<haptics::Device> device, const haptics::Vec3& p_BD = kAbove) {
    datasets::Phantom sphere = datasets::makePhantom("sphere").value();
    scene_ = haptics::makeScene(made::shared(std::move(sphere.volume)),
                                made::tool(datasets::ballPoints(100, 3e-3)))
                 .value();
    settings_.isovalue = sphere.isovalue;
    haptics::Pose X_WD = poseNear(*device, p_BD);
    X_WD.translation() += kAbove - p_BD;
    loop_ = std::make_unique<haptics::ServoLoop>(std::move(device), settings_, X_WD);
    loop_->scenes.offer(std::make_unique<haptics::Engagement>(scene_, X_WD));
    loop_->start();
  }

  void arm() { loop_->armed = true; }
  bool isArmed() const { return loop_->armed; }
  haptics::Snapshot snapshot() {
    loop_->snapshots.take(snapshot_);
    return snapshot_;
  }
  bool runs(std::uint64_t ticks) {
    const std::uint64_t until = snapshot().tick + ticks;
    return comesTrue([&] { return snapshot().tick >= until; });
  }
  /// All steps of the force since it was made, oldest first.
  const std::vector<haptics::ForceTransition>& transitions() {
    for (haptics::ForceTransition next; loop_->transitions.try_dequeue(next);)
      transitions_.push_back(next);
    return transitions_;
  }
  /// How often the force has come into this state for this reason.
  int times(haptics::ForceState state, haptics::ForceReason reason) {
    int times = 0;
    for (const haptics::ForceTransition& step : transitions())
      times += step.to == state && step.reason == reason ? 1 : 0;
    return times;
  }

 private:
  static haptics::Pose poseNear(haptics::Device& device, const haptics::Vec3& p_BD) {
    haptics::DeviceReading reading;
    for (int n = 0; n < 20'000; ++n) {
      const haptics::DeviceStatus status = device.read(reading);
      device.write({});
      if (status == haptics::DeviceStatus::Ok && (reading.X_BD.translation() - p_BD).norm() < 1e-4)
        return reading.X_BD;
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    throw std::runtime_error{"The device gives no pose where it is held."};
  }

  std::shared_ptr<const haptics::Scene> scene_;
  haptics::Settings settings_;
  haptics::Snapshot snapshot_;
  std::vector<haptics::ForceTransition> transitions_;
  std::unique_ptr<haptics::ServoLoop> loop_;
};

}  // namespace bus
