// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/closed_loop.h"

namespace haptics {

Expected<void> ClosedLoop::run(const Hand& hand, std::int64_t ticks,
                               const std::function<bool(const TraceRow&)>& each) {
  grip.X_WD = hand.at(0.0);
  const std::optional<Pose> start = legalPoseNear(*scene, isovalue, grip.X_WD);
  if (!start)
    return tl::unexpected(Error{Error::Kind::Unsupported,
                                "The tool starts inside the solid and there is no room for it "
                                "within 50 mm; start the hand outside or raise the isovalue."});
  Proxy proxy{*scene, *start};
  Safety safety{limits};
  safety.arm();
  Wrench sent;
  for (std::int64_t n = 0; n < ticks; ++n) {
    const double time = double(n) * period;
    // the hand moves the device against the force that was sent last, which is held between ticks
    if (hand_is_device)
      grip.X_WD = hand.at(time);
    else if (n > 0)
      grip.advance(hand.at(time), sent, period);

    Budget budget = Budget::counted(kTickWork);
    const std::int64_t begun = Budget::threadTime();
    const TickResult result = tick(*scene, isovalue, coupling, grip.X_WD, proxy, budget);
    sent = safety.pass(result.wrench_W, result.outside, period);
    const std::int64_t ended = Budget::threadTime();
    if (!each({time, grip.X_WD, proxy.X_WP, sent, result.wrench_W, result.contacts, ended - begun}))
      break;
  }
  return {};
}

}  // namespace haptics
