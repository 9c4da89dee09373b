// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/study/comparison/methods.h"
#include "app/study/report/outcome.h"

namespace study::accuracy {

using haptics::Pose;
using haptics::Vec3;

/// A device that is carried into an analytic solid and held, and where the proxy of a point or a
/// ball must come to rest: the nearest point of the surface `offset` further out, which by the
/// conditions of Karush, Kuhn and Tucker is the only one.
struct AnalyticHold {
  Vec3 start, device;   ///< m, W
  Vec3 base, along;     ///< m, and per metre of offset
  bool corner = false;  ///< two walls bear
  /// m: the ball's radius, or 0 for a point; and the gap that the method keeps.
  Vec3 answer(double offset) const { return base + offset * along; }
};

/// halfspace, sphere, cylinder, wedge, slot: phantoms that have a closed form.
const std::vector<std::string>& analyticSolids();
/// Holds in one of them, for a ball of this radius [m] or a point. Of the half-space's, `radius`
/// is how far the tool's lowest point is below its origin.
std::vector<AnalyticHold> analyticHolds(const std::string& solid, double radius, int count,
                                        unsigned seed);

/// What a method did in some holds, judged by the closed form.
struct HeldErrors {
  std::vector<double> position_um;  ///< to the closed form at the surface itself
  std::vector<double> angle_deg;    ///< between the force and that of the closed form
  std::vector<double> magnitude;    ///< of the force, relative
  std::vector<double> own_force;    ///< N: of every tick, to what its own poses ask for
  std::vector<Pose> settled;
  std::vector<double> tick_us;  ///< of all ticks
  comparison::MeanCounts counts;
};
HeldErrors heldErrors(comparison::Method& method, const std::vector<AnalyticHold>& holds,
                      double radius);

/// How often.
struct HeldEffort {
  int holds = 30;
  int runs = 5;                ///< of every method, one after the other in each
  bool every_fineness = true;  ///< epsilon and sub-steps as well
};

/// Ours in a scene, for an isovalue; a test may plant something else.
using OursMade = std::function<std::unique_ptr<comparison::Method>(
    std::shared_ptr<const haptics::Scene>, double isovalue)>;

/// Point and ball in one of the solids: pose and force of every method against the closed form.
/// What is judged is `ours`, if there is one, in the place of ours by counted work.
Outcome closedForms(const std::string& solid, const HeldEffort& effort, unsigned seed,
                    const OursMade& ours = {});

}  // namespace study::accuracy
