// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "app/study/made/made.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/devices/device.h"
#include "haptics/scene.h"
#include "haptics/servo/servo_loop.h"

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

/// The whole servo loop on a device: a ball of 3 mm on a sphere of 20 mm about the middle of the
/// device's workspace, at 1000 N/m.
class FeltSphere {
 public:
  static constexpr double kTouch = 0.023;  ///< m from the middle: where the ball touches

  explicit FeltSphere(std::unique_ptr<haptics::Device> device) {
    datasets::Phantom sphere = datasets::makePhantom("sphere").value();
    scene_ = haptics::makeScene(made::shared(std::move(sphere.volume)),
                                made::tool(made::ballPoints(100, 3e-3)))
                 .value();
    settings_.isovalue = sphere.isovalue;
    loop_ = std::make_unique<haptics::ServoLoop>(std::move(device), settings_);
    loop_->scenes.offer(std::make_unique<haptics::Engagement>(scene_, made::at(0, 0, 0.030)));
    loop_->start();
  }

  haptics::Snapshot snapshot() {
    loop_->snapshots.take(snapshot_);
    return snapshot_;
  }
  bool isArmed() const { return loop_->armed; }
  bool runs(std::uint64_t ticks) {
    const std::uint64_t until = snapshot().tick + ticks;
    return comesTrue([&] { return snapshot().tick >= until; });
  }

 private:
  std::shared_ptr<const haptics::Scene> scene_;
  haptics::Settings settings_;
  haptics::Snapshot snapshot_;
  std::unique_ptr<haptics::ServoLoop> loop_;
};

}  // namespace bus
