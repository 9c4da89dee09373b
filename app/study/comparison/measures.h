// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/measurement/quantile.h"
#include "app/study/comparison/methods.h"
#include "haptics/core/volume.h"
#include "haptics/tool/point_shell.h"

namespace comparison {

/// The distance of two poses of a tool in its mass metric [m], by the reference's own arithmetic.
double massDistance(const Pose& X_WP, const Pose& X_WD, const haptics::PointShell& shell);
/// A bound on how far any point of the shell moved between two poses [m].
double wayBetween(const Pose& X_from, const Pose& X_to, const haptics::PointShell& shell);

/// A share of the way from one pose to another: along a line, and about one axis.
inline Pose between(const Pose& X_a, const Pose& X_b, double share) {
  return haptics::poseOf(X_a.translation() + share * (X_b.translation() - X_a.translation()),
                         haptics::Quat{X_a.linear()}.slerp(share, haptics::Quat{X_b.linear()}));
}

using measurement::quantile;
double mean(std::span<const double> values);  ///< 0 for none
double median(std::vector<double> values);    ///< 0 for none

/// Where a volume can hold nothing at or above an isovalue, by the greatest voxel of blocks of
/// 8^3, and where it does: so that checks on millions of points stay quick. Of no use to haptics,
/// which has bounds of its own.
class FreeBlocks {
 public:
  FreeBlocks(const haptics::Volume& volume, double isovalue);
  /// True if F < isovalue everywhere within `reach` metres of p, at most one block's side.
  bool free(const Vec3& p_W, double reach) const;
  double reach() const { return reach_; }  ///< m: the most that may be asked for

 private:
  const haptics::Volume& volume_;
  std::array<std::int64_t, 3> blocks_{};
  std::vector<bool> occupied_;  ///< the block or a neighbour of it
  double reach_;
};

/// The judge of poses: depth of the deepest point, and points that go through walls. Refers to
/// what it is made from.
class Judge {
 public:
  Judge(const Touched& scene, const haptics::PointShell& shell, const FreeBlocks& blocks);

  /// m, in double: 0 where every point has F < s, else the most (F - s) / |grad F| of the cells.
  double depth(const Pose& X_WP) const;
  /// Whether every point has F < s, in double.
  bool legal(const Pose& X_WP) const;
  /// The least motion in the mass metric after which, to first order, every point that is inside
  /// is out again by `margin` [m]; zero where none is.
  haptics::Twist wayOut(const Pose& X_WP, double margin) const;
  /// How many points pass through material between an outside start and an outside end, when the
  /// tool goes straight from one pose to the other. Each path is sampled at a 25th of a voxel.
  /// A method that takes several sub-steps in a tick is seen only at its ends: with
  /// `may_go_round` a point is not counted if free space joins its ends within twice its way and
  /// two voxels, or if it grazes the surface by less than a hundredth of a voxel.
  int passages(const Pose& X_from, const Pose& X_to, bool may_go_round) const;

 private:
  bool inside(const Vec3& p_W) const;
  bool wayRound(const Vec3& from_W, const Vec3& to_W, double step) const;
  const Touched& scene_;
  const haptics::PointShell& shell_;
  const FreeBlocks& blocks_;
  double voxel_;  ///< m: the smallest side
};

}  // namespace comparison
