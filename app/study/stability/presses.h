// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/wall.h"
#include "haptics/simulation/closed_loop.h"

namespace study {

/// The loop of a wall, touching a scene instead: within the device's rating, nothing else.
haptics::ClosedLoop loopOf(const Wall& wall, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue, double stiffness);

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
};

PressResult press(const Wall& wall, const Stage& stage, double stiffness);

/// The device's rating, and no more than a share of the limit of a sampled spring [N/m].
/// With torque motors the angular spring counts as well: across a long tool it is stiffer than in
/// the mean, while the device's inertia and damping, here, are the same about all axes.
double ceilingOf(const Wall& wall, const Stage& stage, double share);

/// Every device, stage, stiffness, delay and noise through the tick itself; some devices also at 4
/// kHz, with virtual damping and with the passivity controller.
std::vector<Job> pressJobs(Depth depth);

}  // namespace study
