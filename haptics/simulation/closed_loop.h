// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "haptics/core/geometry.h"
#include "haptics/coupling/safety.h"
#include "haptics/proxy/cutting.h"
#include "haptics/proxy/proxy.h"
#include "haptics/scene/scene.h"
#include "haptics/scene/watch.h"
#include "haptics/servo/rate.h"
#include "haptics/settings.h"
#include "haptics/simulation/device_model.h"
#include "haptics/simulation/grip.h"
#include "haptics/simulation/hand.h"

namespace haptics {

/// One row of a trace: the state after a tick, with the device pose that it read and the force
/// that it sent.
struct TraceRow {
  double time = 0.0;  ///< s
  Pose X_WD, X_WP;
  Wrench sent_W;
  Wrench coupling_W;  ///< wrench before the limits; not part of the trace
  int contacts = 0;
  std::int64_t cpu_ns = 0;  ///< thread CPU time of the tick; not part of the trace
  Pose X_WH;                ///< true pose of the handle; not part of the trace
  double energy = 0.0;      ///< J given to the hand since the start; not part of the trace
  std::int64_t cut_at = 0;  ///< Budget::cutAt; not part of the trace
  std::int64_t work = 0;    ///< Budget::spent; not part of the trace
  Bearing bearing = {};     ///< contacts that bear force; not part of the trace
  ForceState force_state = ForceState::Off;  ///< not part of the trace
  double stiffness_share = 1.0;              ///< Safety::stiffnessShare; not part of the trace
  Nearnesses near = {};                      ///< to the watched structures
  const Cutting* cutting = nullptr;          ///< after the tick; null: nothing is cut
};

/// Hand, grip and servoTick in one loop, armed, without threads or clocks. Two runs give the same
/// rows.
struct ClosedLoop {
  std::shared_ptr<const Scene> scene;
  Settings settings;
  ForceLimits limits;
  Grip grip;
  /// True for a recorded device path: its poses are read as the device's, without a grip.
  bool hand_is_device = false;
  ServoRate rate = {};
  Linkage linkage = {};
  double lead = 0.0;             ///< s, of the pose that the tick takes (servo/pose_predictor.h)
  std::int64_t budget_work = 0;  ///< units of work that a tick may take; 0: what the rate gives
  double damping = 0.0;          ///< N·s/m, virtual damping while the wrench is not zero
  /// Damping that a passivity controller may use, N·s/m; 0: no controller.
  double passivity_damping = 0.0;
  std::shared_ptr<const Watch> watch = {};  ///< structures to which distances are measured
  /// The tool cuts from the first tick to the last, in a view of the scene's volume; none: it does
  /// not. Another run begins at the uncut volume again.
  std::optional<CutLaw> cut = {};
  /// Called once, before the first tick, with the pose at which the proxy begins; may be empty.
  std::function<void(const Pose&)> on_start = {};

  /// Runs `ticks` ticks and calls `each` with each row, until it returns false. Refuses a start
  /// without a legal pose nearby, and a volume that cannot be cut.
  Expected<void> run(const Hand& hand, std::int64_t ticks,
                     const std::function<bool(const TraceRow&)>& each);
};

}  // namespace haptics
