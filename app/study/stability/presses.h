// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/wall.h"
#include "haptics/simulation/closed_loop.h"

namespace study::stability {

/// The loop of a wall, touching a scene instead, as the program ships it: within the device's
/// rating, with its ramp and the guard of passivity. Not `shipped`: within the rating, nothing
/// else.
haptics::ClosedLoop loopOf(const Wall& wall, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue, double stiffness, bool shipped = true);

/// What a closed loop came to, whoever moves the hand.
struct LoopResult {
  double energy = 0.0;  ///< J given to the hand in all: spring let go, what is left was made
  double share = 1.0;   ///< of the stiffness that the guard of passivity left
  int non_finite = 0;   ///< ticks; all of them where the loop was refused
  int inside = 0;       ///< looks that found a shell point inside
  int contact = 0;      ///< ticks
  std::optional<haptics::Error> refused = {};
};
/// Runs a loop, looks at the shell every `look` ticks, and tells `each` every row and the one
/// before, which is null for the first.
LoopResult runLoop(
    haptics::ClosedLoop& loop, const haptics::Hand& hand, std::int64_t ticks, int look,
    const std::function<void(const haptics::TraceRow&, const haptics::TraceRow*)>& each);

/// N/m: what the program allows to the device of this wall with a tool.
double allowedFor(const Wall& wall, const haptics::Scene& scene);

/// A scene to press on: straight down to the first touch at `X_touch`, and from there no deeper
/// than `deepest` [m], for a ball is not to be pressed through.
struct Stage {
  std::shared_ptr<const haptics::Scene> scene;
  haptics::Pose X_touch;
  double deepest = INFINITY;
};

/// "plane": a flat square of points on a half-space; "groove": a rod in a V-groove; "ball": a ball
/// on a ball. Voxels of 1 mm, whose values ramp over six of them to the isovalue 0 and on, under
/// noise: a share of the ramp.
Stage makeStage(const std::string& name, double noise, unsigned seed);

/// What a press came to: down at 60 mm/s at most, gently at both ends, held with about 2 N, or as
/// much as the stage's depth allows, until what that set off has died, and up again.
struct PressResult : LoopResult {
  double amplitude = 0.0;   ///< m, of the handle in the last 0.2 s of the hold, half its range
  double force_step = 0.0;  ///< N, the largest in a tick of that time
  double risen = 0.0;       ///< J by which the proxy's moves raised the spring, drops not counted
  double rise = 0.0;        ///< m, the largest in a tick: its energy over the spring's pull
};

/// `shipped`: as in loopOf; the press then waits for the ramp.
PressResult press(const Wall& wall, const Stage& stage, double stiffness, bool shipped = true);

}  // namespace study::stability
