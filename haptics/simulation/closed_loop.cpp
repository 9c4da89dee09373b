// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/closed_loop.h"

#include "haptics/coupling/passivity.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/servo/pose_predictor.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/servo/step.h"

namespace haptics {
namespace {

static_assert(ServoRate{}.budget_work() == kTickWork);  // what the studies at 1 kHz count

/// Virtual damping, and the passivity controller behind it.
class Damping final : public WrenchHook {
 public:
  Damping(const ClosedLoop& loop, const Pose& X_start)
      : loop_{loop},
        X_WD_{X_start},
        controller_{loop.passivity_damping, loop.grip.gyration, loop.linkage.torque} {}

  Wrench shaped(const Wrench& wanted, const Pose& X_WD, double period) HAPTICS_RT override {
    const Twist motion = motionBetween(X_WD_, X_WD);
    X_WD_ = X_WD;
    Wrench wrench = wanted;
    if (loop_.damping > 0.0)
      wrench = damped(wrench, motion, period, loop_.damping, loop_.grip.gyration);
    if (loop_.passivity_damping > 0.0) wrench = controller_.pass(wrench, motion, period);
    return wrench;
  }
  void sent(const Wrench& sent_W) HAPTICS_RT override { controller_.sent(sent_W); }

 private:
  const ClosedLoop& loop_;
  Pose X_WD_;
  PassivityController controller_;
};

}  // namespace

Expected<void> ClosedLoop::run(const Hand& hand, std::int64_t ticks,
                               const std::function<bool(const TraceRow&)>& each) {
  // what a run changes is its own, so that the next is the same
  Grip device = grip;
  Linkage link = linkage;
  device.X_WD = link.handleAt(hand.at(0.0));
  const std::int64_t period_ns = rate.period_ns();
  PosePredictor ahead{lead, linkage.encoder};
  Pose X_WD = ahead.ahead(link.read(device.X_WD), 0);
  std::optional<Cutting> cutting;
  if (cut) {
    auto carved = CarvedScene::of(*scene);
    if (!carved) return tl::unexpected(carved.error());
    cutting.emplace(std::move(*carved), *cut);
  }
  const std::shared_ptr<const Scene> touched = cutting ? cutting->scene() : scene;
  const std::optional<Pose> start = legalPoseNear(*touched, settings.isovalue, X_WD);
  if (!start) return tl::unexpected(Error{Error::Kind::Unsupported, {"session-no-room", {}}});
  if (on_start) on_start(*start);
  Proxy proxy{*touched, *start};
  Safety safety{limits};
  Damping hook{*this, X_WD};
  const bool hooked = damping > 0.0 || passivity_damping > 0.0;
  const double period = rate.period();
  PassivityObserver observer;  // at the handle, of what really acts there
  Wrench held;
  Nearnesses near;
  Felt felt;
  for (std::int64_t n = 0; n < ticks; ++n) {
    const double time = double(n) * period;
    const Pose X_WH_before = device.X_WD;
    // the hand moves the device against the force that was sent last, which is held between ticks
    if (hand_is_device)
      device.X_WD = hand.at(time);
    else if (n > 0)
      device.advance(link.handleAt(hand.at(time)), held, period);
    observer.add(held, motionBetween(X_WH_before, device.X_WD));
    X_WD = ahead.ahead(link.read(device.X_WD), n * period_ns);

    Budget budget = Budget::counted(budget_work > 0 ? budget_work : rate.budget_work());
    const std::int64_t begun = Budget::threadTime();
    std::uint16_t flags = StepFlags::kArmed;
    if (cutting) flags |= StepFlags::kCut;
    const ServoResult result = servoTick({X_WD, settings, flags, hooked ? &hook : nullptr,
                                          watch.get(), &felt, cutting ? &*cutting : nullptr},
                                         touched.get(), &proxy, safety, period, budget);
    if (watch) measure(*watch, *touched, proxy.X_WP, near);
    const std::int64_t ended = Budget::threadTime();
    held = link.carry(result.sent_W, device.X_WD);
    if (!each({time, X_WD, proxy.X_WP, result.sent_W, result.tick.wrench_W, result.tick.contacts,
               ended - begun, device.X_WD, observer.energy(), budget.cutAt(), budget.spent(),
               proxy.bearing, safety.state(), safety.stiffnessShare(), near,
               cutting ? &*cutting : nullptr}))
      break;
  }
  return {};
}

}  // namespace haptics
