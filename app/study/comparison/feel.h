// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/comparison/course.h"

namespace comparison {

/// What a slow slide over the surface feels like beyond the shape itself.
struct FeelSummary {
  std::string method;
  /// rms of the force less its Gaussian mean (deviation half a voxel of way) [N]: what has
  /// wavelengths below about 2.7 voxels
  double fine_noise_N = 0.0;
  double largest_step_N = 0.0;  ///< of the force, from one tick to the next
  double mean_force_N = 0.0;
  /// rms of the heights at which the ball just touches along the same path, less their mean
  /// likewise [mm]; of the surface, not of the method, which feels it times the stiffness
  double surface_fine_mm = 0.0;
  /// Largest change of these heights from one tick to the next, times the stiffness [N]: the step
  /// of a ball that only goes up and down.
  double surface_step_N = 0.0;
  /// Largest step of a proxy that is always at its nearest legal pose [N]: the device goes a
  /// twentieth of a tick's way at a time, the proxy follows each time without a budget, at any
  /// speed, and rests before the next. It falls at once where its pose is no longer the nearest.
  double ideal_step_N = 0.0;
};

/// How the slide goes.
struct SlidePlan {
  double radius = 0.0025;  ///< m: of the ball, 600 points
  double speed = 0.020;    ///< m/s
  double depth = 0.002;    ///< m that the device is below the smoothed path of the surface
  double length = 0.024;   ///< m
};

/// Slides a ball along the surface where a hand would touch it, in the direction in which it is
/// most even, led by all methods in turn. `similar` is the case's scene with its own tool, whose
/// field and choice of normals are taken over. Empty if there is no even stretch, or no legal place
/// to begin, or it is too short.
std::vector<FeelSummary> compareFeel(const Touched& scene, const haptics::Scene& similar,
                                     const FreeBlocks& blocks, const SlidePlan& plan, Limit limit,
                                     unsigned seed = 1);

}  // namespace comparison
