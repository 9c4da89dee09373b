// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
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

/// N/m: what the program allows to the device of this wall with a tool, and what it begins with.
double allowedFor(const Wall& wall, const haptics::Scene& scene);
double defaultFor(const Wall& wall, const haptics::Scene& scene);

/// A scene to press on: from `X_from` straight down to the first touch at `X_touch`, and from there
/// no deeper than `deepest` [m], for a ball is not to be pressed through.
struct Stage {
  std::string name;
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
  haptics::Pose X_from, X_touch;
  double deepest = INFINITY;
};

/// "plane": a flat square of points on a half-space; "groove": a rod in a V-groove; "ball": a ball
/// on a ball. Voxels of 1 mm, whose values ramp over six of them, under noise: a share of the ramp.
Stage makeStage(const std::string& name, double noise, unsigned seed);
inline const std::vector<std::string> kStages{"plane", "groove", "ball"};

/// What a press came to: down at 60 mm/s at most, gently at both ends, held with about 2 N, or as
/// much as the stage's depth allows, until what that set off has died, and up again.
struct PressResult {
  double amplitude = 0.0;   ///< m, of the handle in the last 0.2 s of the hold, half its range
  double force_step = 0.0;  ///< N, the largest in a tick of that time
  double energy = 0.0;      ///< J given to the hand in all: spring let go, what is left was made
  double risen = 0.0;       ///< J by which the proxy's moves raised the spring, drops not counted
  double rise = 0.0;        ///< m, the largest in a tick: its energy over the spring's pull
  int non_finite = 0;       ///< ticks
  int inside = 0;           ///< looks, every 50 ticks, that found a shell point inside
  int contact = 0;          ///< ticks
  double share = 1.0;       ///< of the stiffness that the guard of passivity left
};

/// `shipped`: as in loopOf; the press then waits for the ramp.
PressResult press(const Wall& wall, const Stage& stage, double stiffness, bool shipped = true);

/// Every device, stage, stiffness, delay and noise through the tick itself, at 1 and 4 kHz. A case
/// is the program as shipped, up to what is allowed; rows of a table are what is stiffer, and for
/// some devices what the guard, virtual damping and the passivity controller each do.
std::vector<Job> pressJobs(Depth depth);

}  // namespace study::stability
