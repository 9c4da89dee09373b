// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "haptics/core/budget.h"
#include "haptics/core/cursor.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/cell_covers.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// A shell point near the surface, with the values found there.
struct NearPoint {
  int place = 0;       ///< index in the order of the shell's tree
  double value = 0.0;  ///< F at the point
  double free = 0.0;   ///< m that it may move in any direction, proven
  /// Lipschitz bound of F per metre, within four voxels; 0 if they are proven empty.
  double lipschitz = 0.0;
};

/// The distance that each shell point can move before it could meet the surface. The pyramid's
/// bounds prove it, and motion uses it up. Points and whole branches of the shell's tree with
/// clearance left are skipped, in every tick.
///
/// A dense tool may have so many points on a surface that even one look at each is too much. Then
/// a node of the tree is *carried*: its box lies beyond the covers of all cells that it reaches
/// (CellCovers), so all of its points are free. Only one point of a carried node is looked at, the
/// one that is nearest to the surface.
///
/// A search that the budget cuts continues in the next call, if the tool has not moved.
class Clearance {
 public:
  /// `band` [m]: points nearer than this get rows. At 0 no node is carried.
  explicit Clearance(const ShellTree& tree, double band = 0.0);

  /// Discards all clearance. Call it when the isovalue changed, or the pose changed without
  /// moved().
  void forget() HAPTICS_RT;
  /// Uses up clearance: the tool moved by at most `translation` [m] and `rotation` [rad], along any
  /// path.
  void moved(double translation, double rotation) HAPTICS_RT;

  /// The field was lowered somewhere. Proofs hold on; points near the surface are sought anew.
  void lowered() HAPTICS_RT {
    covers_.forget();
    restart();
  }

  enum class Verdict { Legal, Inside, Cut };
  /// Finds all points with less than `reach` [m] of clearance at this pose and puts them into
  /// near(), which may hold other points too. Of the nodes that it carries, one point is in near().
  /// Returns Inside at the first point with F at or above the ceiling. Returns Cut if the budget
  /// ran out; near() is then incomplete.
  Verdict collect(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP, double reach,
                  Budget& budget) HAPTICS_RT;
  /// Call it before carry() for another motion.
  void aim() HAPTICS_RT { aimed_ = 0; }
  /// After collect(): carries the carried nodes along the motion from X_WP, too. Of the nodes for
  /// which that is not proven, the points with less than that reach are put into near().
  Verdict carry(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP,
                const Twist& motion, Budget& budget) HAPTICS_RT;

  /// m that every point of the tool may move in any direction: proven, less the part used up.
  double room(const ShellTree& tree) const HAPTICS_RT {
    return node_epoch_.front() == epoch_ ? node_until_.front() - travelled(tree.nodes.front().arm)
                                         : -std::numeric_limits<double>::infinity();
  }

  /// Number of the search. It changes whenever the tool has moved; within one number, near() only
  /// grows.
  std::uint32_t search() const HAPTICS_RT { return search_; }
  std::size_t size() const HAPTICS_RT { return found_; }
  const NearPoint& near(std::size_t i) const HAPTICS_RT { return near_[i]; }
  bool carriesAny() const HAPTICS_RT { return carried_count_ > 0; }
  double farthestArm() const HAPTICS_RT { return arm_; }  ///< m, of the points in near()

  /// Those of the first `count` points of near() that constrain the motion, by number. These are
  /// all of them, or, if they are more than kFew, the point with the least clearance in each of
  /// kPatches patches of the shell.
  static constexpr int kFew = 512, kPatches = 128;
  std::size_t nearestCount(std::size_t count) const HAPTICS_RT {
    return count <= std::size_t{kFew} ? count : static_cast<std::size_t>(patches_used_);
  }
  const NearPoint& nearest(std::size_t count, std::size_t i) const HAPTICS_RT {
    if (count <= std::size_t{kFew}) return near_[i];
    return near_[static_cast<std::size_t>(nearest_[static_cast<std::size_t>(used_[i])])];
  }

  /// Whether near() holds the point at this place of the shell's tree.
  bool holds(std::size_t place) const HAPTICS_RT { return found_in_[place] == search_; }
  /// Whether the point at this place belongs to a node that is carried.
  bool carries(const ShellTree& tree, std::size_t place) const HAPTICS_RT;

 private:
  struct Batch;
  struct Ride;
  bool carried(const Isosurface& solid, const ShellTree& tree, int n, const Ride& ride,
               int& nearest, Budget& budget) HAPTICS_RT;
  Verdict walk(const Isosurface& solid, const ShellTree& tree, const Ride& ride,
               Budget& budget) HAPTICS_RT;
  void restart() HAPTICS_RT;
  bool look(const Isosurface& solid, const ShellTree& tree, Batch& batch,
            Budget& budget) HAPTICS_RT;
  void note(const NearPoint& point) HAPTICS_RT;
  bool close(const ShellTree& tree, Budget& budget) HAPTICS_RT;
  double travelled(double arm) const HAPTICS_RT { return translated_ + rotated_ * arm; }

  std::vector<double> until_;              ///< clearance plus the way travelled when it was proven
  std::vector<double> node_until_;         ///< the same for all points of a node
  std::vector<std::uint64_t> node_epoch_;  ///< epoch in which a node's clearance was proven
  std::uint64_t epoch_ = 1;                ///< clearance proven in an earlier epoch is void
  double translated_ = 0.0;                ///< m, since forget()
  double rotated_ = 0.0;                   ///< rad

  std::vector<NearPoint> near_;          ///< the first found_ are valid; room for every point
  std::vector<std::uint32_t> found_in_;  ///< the search in which a point was found near
  std::size_t found_ = 0;
  double arm_ = 0.0;
  std::array<int, kPatches> nearest_{};  ///< into near_, -1 for none
  std::array<int, kPatches> used_{};     ///< the patches that contain a point
  int patches_used_ = 0;
  int patch_size_ = 1;  ///< points

  // the search in progress
  std::uint32_t search_ = 1;
  double complete_ = -1.0;   ///< m: near() holds all with less clearance than this; -1: none
  double goal_ = -1.0;       ///< m: reach of the pass that was cut; -1: none
  Cursor cursor_;            ///< through the nodes
  std::size_t end_ = 0;      ///< node at which this pass ends
  int open_ = -1;            ///< node that is not carried in this pass
  std::vector<int> opened_;  ///< inner nodes whose children were looked at, in order
  std::size_t opened_count_ = 0;

  CellCovers covers_;
  int crowd_ = 0;                          ///< points looked at or carried in this search
  bool crowded_ = false;                   ///< they were many in the search before
  std::vector<std::uint32_t> carried_in_;  ///< the search in which a node is carried
  std::vector<int> carried_;  ///< nodes carried in this search, and some that no longer are
  std::size_t carried_count_ = 0;
  std::size_t aimed_ = 0;  ///< number of them that were carried along the motion, or opened
  double band_;            ///< m
};

/// The tool at a pose, and its points near the surface there.
struct NearTool {
  const Isosurface& solid;
  const ShellTree& tree;
  const Pose& X_WP;
  const Clearance& near;
};

}  // namespace haptics
