// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace haptics {

/// Units of work in a tick's default budget: about 200 us, a fifth of the period at 1 kHz.
inline constexpr std::int64_t kTickWork = 20'000;

/// The constants of the touch. Lengths that follow from the voxel are in Tolerances.
struct TouchConstants {
  // The search of a tick.

  /// A tick that has spent less than this, some 25 us, tries as often as a millisecond may: the
  /// same number of tries in a second at every rate costs little there.
  static constexpr std::int64_t kLittleWork = kTickWork / 8;
  /// ms. A search is given up after the tries of this many: what helped, helped before.
  static constexpr int kLongestSearch = 3;
  /// rad. A sub-step turns no farther where rows or the field say what is free: they are linear.
  static constexpr double kLargestTurn = 0.3;
  /// Near points, from which on a motion is proven slab by slab.
  static constexpr double kManyPoints = 4096.0;
  /// Units of work that the proof of one sub-step may take, over all of its ticks.
  static constexpr double kProofWork = 32.0 * double(kTickWork);
  /// Voxels that a sub-step goes at most while nodes of the shell are carried: covers hold nearby.
  static constexpr double kCarriedWay = 0.5;
  /// Voxels. The pyramid's finest blocks prove no shorter way than this.
  static constexpr double kLeastStretch = 4.0;
  /// Of its length, which a motion has left after it was blocked and nothing new was learned.
  static constexpr double kShorter = 0.25;
  /// Of the way that an impact left to the last sub-step: a slide along a wavy surface must not
  /// creep.
  static constexpr double kBeyondImpact = 3.0;
  /// Of the last length, where nothing was met.
  static constexpr double kLonger = 2.0;
  /// How often a step that ends inside is halved before it is undone.
  static constexpr int kHalvings = 5;

  // The filter of poses (PoseFilter; MEASURED.md, "Filter acceptance"). In tolerances, unless
  // another unit is named.

  /// Poses that may be no nearer to the device than the nearest before.
  static constexpr int kDetours = 12;
  /// Smallest difference of distances that counts: below it are rounding and the search's own ends.
  static constexpr double kResolution = 0.002;
  /// Play of the device in which its travel does not count. With less than 3, handles wander on
  /// noise of 10 %.
  static constexpr double kPlay = 4.0;
  /// Travel that gives new detours.
  static constexpr double kRenewal = 0.5;
  /// Most released energy that is kept, over the pull.
  static constexpr double kMostSaved = 4.0;
  /// Energy that a detour may add beyond what is saved, over the pull.
  static constexpr double kLent = 0.5;
  /// The same for a place to wait: what bars the way there is released on the rest of it.
  static constexpr double kLentToWait = 1.0;
  /// Of the pull, over the travel across it: as much as normals that are 0.03 rad off the facets
  /// ask for.
  static constexpr double kForgiven = 0.03;

  // The way of a proxy that was held (CatchUp).

  /// N/m. From this stiffness on, the force of a released proxy falls by kRelease; below, faster.
  static constexpr double kStiff = 3000.0;
  /// N/s (MEASURED.md, "Release").
  static constexpr double kRelease = 90.0;
  /// N/s: fastest change of the force in contact by the proxy's own motion (MEASURED.md, "Slow
  /// slides"). A proxy whose place at an edge is no longer the nearest falls to another place,
  /// often over a tenth of a millimetre or more.
  static constexpr double kMostFall = 150.0;
  /// N. A proxy pulled by a larger force approaches at once until this is left: no device renders
  /// more.
  static constexpr double kMostReleased = 50.0;

  // The search for a legal pose after the isovalue moved (recovery).

  /// s of following the gradients.
  static constexpr double kPushTime = 0.006;
  /// s after which the proxy is put outside the grid.
  static constexpr double kLongestRecovery = 0.017;
  /// Pushes a tick.
  static constexpr int kPushes = 4;
};

}  // namespace haptics
