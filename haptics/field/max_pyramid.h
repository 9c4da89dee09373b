// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/core/parallel.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"
#include "haptics/field/field_kind.h"
#include "haptics/field/lanes.h"

namespace haptics {

/// Bounds of a volume's field near a place: its greatest value and its Lipschitz constant. They
/// hold for every isovalue, so moving the isovalue rebuilds nothing.
///
/// Blocks of 4^3 cells (then 8^3, … 64^3) hold the greatest voxel of themselves and their 26
/// neighbours, so that a block below the isovalue proves a ball of one block side empty. The finest
/// level also holds a Lipschitz constant over the same neighbourhood. Cells run from -1 to dims - 1
/// on each axis: in the outermost ring F falls to the background. A spline's value is a mean of the
/// voxels about its cell, and its slope a mean of their differences, so its blocks include one more
/// voxel on every side.
///
/// The blocks lie over the whole grid. Beyond the volume's crop there is only background.
class MaxPyramid {
 public:
  /// On so many threads, whose number changes nothing of the result. If `cancel` becomes true
  /// meanwhile, the result is incomplete and must not be used.
  explicit MaxPyramid(const Volume& volume, FieldKind kind = FieldKind::Trilinear,
                      const std::atomic<bool>* cancel = nullptr, int threads = coreCount());

  /// Equal to a new pyramid of `volume`, from one of the same kind over the volume that it was
  /// before: with the same grid, type and background, and the same voxels outside the boxes
  /// `changed`. Its crop may be another. Renews only what they reach.
  MaxPyramid(const MaxPyramid& before, const Volume& volume, std::span<const VoxelBox> changed,
             FieldKind kind, const std::atomic<bool>* cancel = nullptr);

  // Where voxels are lowered while the field is in use (scene/carved_scene.h). Then the greatest
  // values stay bounds; the Lipschitz constants do not.

  /// The finest blocks whose bounds depend on a voxel of this box.
  VoxelBox blocksAround(const VoxelBox& voxels, FieldKind kind) const HAPTICS_RT;
  /// Raises the Lipschitz constant of a finest block for voxels that are lowered next: two
  /// neighbours then differ by no more than before, or than `steepest`. `raised`: by which it was
  /// raised since it was last exact, 0 if it is; it must be kept for each block. Returns whether it
  /// raised it.
  bool raise(std::int64_t block, double steepest, float& raised) HAPTICS_RT;
  /// Finds the bounds of a finest block anew. Returns false, and changes nothing, where it meets
  /// the faces of the volume.
  bool renew(const Volume& volume, FieldKind kind, std::int64_t block) HAPTICS_RT;

  /// A bound over a ball around a place.
  struct Bound {
    double radius;     ///< m: radius of the ball
    double lipschitz;  ///< per metre, over that ball; 0 where the ball is proven below s
  };
  /// At index coordinates u: a radius within which F < s if lipschitz is 0; else the radius
  /// within which |F(a) - F(b)| <= lipschitz |a - b|.
  Bound bound(const Vec3& u, double s) const HAPTICS_RT;

  /// Lipschitz constant of F in W [per metre] within finestRadius() of index coordinates u.
  double lipschitz(const Vec3& u) const HAPTICS_RT;
  double finestRadius() const HAPTICS_RT { return kCells * smallest_spacing_; }  ///< m

  /// The finest level as the lanes read it.
  const lanes::BlockBound* finest() const HAPTICS_RT { return finest_.data(); }
  const std::array<std::int64_t, 3>& finestCounts() const HAPTICS_RT { return levels_[0].blocks; }

  std::size_t bytes() const;
  bool operator==(const MaxPyramid&) const = default;

 private:
  static constexpr int kCells = 4;  ///< cells along a side of the finest block
  static constexpr int kLevels = 5;

  struct Level {
    std::array<std::int64_t, 3> blocks{};
    /// Dilated by one block; the values of the finest level are in finest_.
    std::vector<float> greatest;
    std::vector<float> own;  ///< not dilated: what the next level is made of; the finest has none
    bool operator==(const Level&) const = default;
    std::int64_t at(const std::array<std::int64_t, 3>& b) const {
      return (b[2] * blocks[1] + b[1]) * blocks[0] + b[0];
    }
  };
  std::array<std::int64_t, 3> blockOf(const Vec3& u, int level) const HAPTICS_RT;

  std::array<Level, kLevels> levels_;
  std::vector<lanes::BlockBound> finest_;  ///< both dilated
  VoxelBox box_;                           ///< the voxels that exist
  double smallest_spacing_;                ///< m
  Vec3 per_spacing_;                       ///< 1/m
};

}  // namespace haptics
