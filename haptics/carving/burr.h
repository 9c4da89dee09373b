// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/carving/wall.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

namespace haptics {

/// A ball that cuts on its way from one place to another, and the isovalue at which the wall stands
/// that it leaves.
struct BurrCut {
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  ///< m, W: of the ball's centre
  double radius = 0.0;                              ///< m, above 0
  double isovalue = 0.0;

  bool operator==(const BurrCut&) const = default;
};

/// What a cut took away.
struct Removed {
  /// m3 within the isosurface. A voxel counts in part by its value, so that a wall counts where it
  /// lies and not where voxels are.
  double volume = 0.0;
  std::int64_t voxels = 0;  ///< that were lowered

  void add(const Removed& more) HAPTICS_RT {
    volume += more.volume;
    voxels += more.voxels;
  }
};

/// Carries out a cut: no voxel stays above the profile of the wall at its distance to the burr
/// (README.md, "The burr"). An absolute value and no decrement, so neither order nor repetition of
/// cuts matters. It goes row by row, and may be left between two of them.
class BurrCarving {
 public:
  BurrCarving() = default;
  /// `volume`: its grid, type, background and greatest value count, its voxels do not. The cut must
  /// be finite.
  BurrCarving(const Volume& volume, const BurrCut& cut) HAPTICS_RT;

  /// The voxels that the cut may lower, clipped to those that exist; empty if it lies beside them.
  const VoxelBox& box() const HAPTICS_RT { return box_; }
  /// An upper bound of the difference between two neighbours along an axis, both of which the cut
  /// lowers [value].
  double steepest() const HAPTICS_RT { return steepest_; }

  bool isDone() const HAPTICS_RT { return next_ >= rows_; }
  /// The voxels of the next row that it lowers, from the first to the last; empty: none.
  /// `voxels` have the grid and the type of the volume.
  VoxelBox changes(const void* voxels) const HAPTICS_RT;
  /// Lowers these voxels of the next row, and goes on to the one behind it. Returns what they lost.
  Removed lower(void* voxels, const VoxelBox& changed) HAPTICS_RT;

 private:
  std::array<std::int64_t, 2> nextRow() const HAPTICS_RT;  ///< j and k
  /// Voxels between the ball and a voxel, of which the centre lies here [m, along the grid's axes].
  double distanceAt(const Vec3& p) const HAPTICS_RT;

  std::array<std::int64_t, 3> dims_{};
  ScalarType type_ = ScalarType::Int16;
  VoxelBox box_;
  Vec3 spacing_ = Vec3::Ones();
  Vec3 a_ = Vec3::Zero(), way_ = Vec3::Zero();  ///< m, along the grid's axes from its voxel (0,0,0)
  double way_square_ = 0.0;
  double radius_ = 0.0, reach_ = 0.0;  ///< m
  double isovalue_ = 0.0, background_ = 0.0;
  WallProfile profile_{0.0, 1.0, 0.5};
  double per_value_ = 0.0;  ///< parts of a voxel, by a voxel's value beside the wall
  double part_at_wall_ = 0.5;
  double steepest_ = 0.0;
  std::int64_t rows_ = 0, next_ = 0;
};

}  // namespace haptics
