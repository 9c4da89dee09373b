// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "app/measurement/load.h"
#include "haptics/core/error.h"
#include "haptics/scene/scene.h"

namespace measurement {

/// What to measure: the scene that is being touched, and how.
struct CapacityRequest {
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
  haptics::VirtualCoupling coupling = {};
  Allowance allowance = {};
  double touching = 1.0;  ///< s that each of the hands touches
  double seconds = 8.0;   ///< by the clock on the wall: no further tool is begun after it
  int most_points = 300'000;
};

/// What this machine carries, measured. Times are CPU time of one thread: what other programs and
/// the live loop take beside it does not count as the tick's, though it may slow it a little.
struct Capacity {
  Load present;             ///< the tool as it is
  std::vector<Load> tried;  ///< its mesh with other numbers of points, fewest first
  int most = 0;  ///< the most points that were carried, as were all fewer that were tried; or 0
  std::optional<int> too_many;  ///< the fewest that were tried and not carried
  int dense = 0;  ///< points so many that each has no more of the mesh's area than a voxel's side
  int suggested = 0;    ///< the lesser of dense and most
  double budget = 0.0;  ///< s of a tick
  double voxel = 0.0;   ///< m, its smallest side
  double area = 0.0;    ///< m², of the mesh; 0 where there is none, and then nothing was tried

  /// m: between that many points spread evenly over the mesh.
  double spacing(int points) const;
};

/// Which number of points to try next, given those tried, fewest first; none if enough is known.
/// By decades from a thousand until one is too many, then between the most carried and the fewest
/// not, until a third more is too many; `dense` as soon as more than it was tried.
std::optional<int> nextToTry(std::span<const Load> tried, int dense, int most_points);

/// The same paths for another tool of the same mesh: each vertex goes where it went. (The poses
/// differ, as the origin is the centroid of the points, which are others.)
std::vector<Path> pathsFor(const haptics::Tool& other, const haptics::Tool& tool,
                           std::vector<Path> paths);

/// Sets most, too_many and suggested from what was tried.
void conclude(Capacity& capacity);

/// Measures on the calling thread, which should be neither the servo's nor the GUI's. The hands
/// slide, tap, hook and wedge; every tool is led along the paths that were aimed with the present
/// one. Refused where a hand finds nothing to touch; of kind Cancelled once `stop` asks for it.
/// `advanced` is told how far it is, 0 to 1.
haptics::Expected<Capacity> measureCapacity(const CapacityRequest& request, std::stop_token stop,
                                            const std::function<void(double fraction)>& advanced);

}  // namespace measurement
