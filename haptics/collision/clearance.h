// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// A shell point close enough to the surface to matter, as it was found.
struct NearPoint {
  int place = 0;           ///< in the order of the shell's tree
  double value = 0.0;      ///< F there
  double free = 0.0;       ///< m it may move in any direction: proven
  double lipschitz = 0.0;  ///< per metre, within four voxels; 0 where those are proven empty
};

/// How far each shell point can go before it could possibly meet the surface: proven by the
/// pyramid's bounds, and spent by motion. What is not used up is not looked at, tick after tick,
/// neither points nor whole branches of the shell's tree.
///
/// A search that the budget cuts goes on where it stopped, as long as the tool has not moved.
class Clearance {
 public:
  explicit Clearance(const ShellTree& tree);

  /// Nothing is known any more: the isovalue or the pose changed by other means than motion.
  void forget() HAPTICS_RT;
  /// The tool has moved by at most this along any path.
  void moved(double translation, double rotation) HAPTICS_RT;

  enum class Verdict { Legal, Inside, Cut };
  /// Finds all points with less than `reach` [m] of clearance at this pose, into near(), which may
  /// then hold others too. Inside at the first one at or beyond the ceiling; Cut if the budget ran
  /// out: near() is then not complete.
  Verdict collect(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP, double reach,
                  Budget& budget) HAPTICS_RT;

  /// m that every point of the tool may move in any direction: as proven and not yet used up.
  double room(const ShellTree& tree) const HAPTICS_RT {
    return node_epoch_.front() == epoch_ ? node_until_.front() - travelled(tree.nodes.front().arm)
                                         : -std::numeric_limits<double>::infinity();
  }

  /// Changes whenever the tool has moved: of one number, near() only ever grows.
  std::uint32_t search() const HAPTICS_RT { return search_; }
  std::size_t size() const HAPTICS_RT { return found_; }
  const NearPoint& near(std::size_t i) const HAPTICS_RT { return near_[i]; }
  double farthestArm() const HAPTICS_RT { return arm_; }  ///< m, of the points in near()

  /// Calls f with those of the first `count` points of near() that motion is constrained by: all
  /// of them, or where they are more than kFew, the one with the least clearance in each of
  /// kPatches of the shell.
  static constexpr int kFew = 512, kPatches = 128;
  template <class F>
  void eachNearest(std::size_t count, F&& f) const HAPTICS_RT {
    if (count <= std::size_t{kFew}) {
      for (std::size_t i = 0; i < count; ++i) f(near_[i]);
      return;
    }
    for (int i = 0; i < patches_used_; ++i)
      f(near_[static_cast<std::size_t>(
          nearest_[static_cast<std::size_t>(used_[static_cast<std::size_t>(i)])])]);
  }

  /// Whether near() holds the point at this place of the shell's tree.
  bool holds(std::size_t place) const HAPTICS_RT { return found_in_[place] == search_; }

 private:
  struct Batch;
  void restart() HAPTICS_RT;
  bool look(const Isosurface& solid, const ShellTree& tree, Batch& batch,
            Budget& budget) HAPTICS_RT;
  void note(const NearPoint& point) HAPTICS_RT;
  bool close(const ShellTree& tree, Budget& budget) HAPTICS_RT;
  double travelled(double arm) const HAPTICS_RT { return translated_ + rotated_ * arm; }

  std::vector<double> until_;       ///< clearance plus what had been travelled when it was proven
  std::vector<double> node_until_;  ///< the same of all points of a node
  std::vector<std::uint64_t> node_epoch_;  ///< in which a node's figures were proven
  std::uint64_t epoch_ = 1;                ///< what was proven in an earlier one is void
  double translated_ = 0.0;                ///< m, since forget()
  double rotated_ = 0.0;                   ///< rad

  std::vector<NearPoint> near_;          ///< the first found_ are valid; room for every point
  std::vector<std::uint32_t> found_in_;  ///< the search in which a point was found near
  std::size_t found_ = 0;
  double arm_ = 0.0;
  std::array<int, kPatches> nearest_{};  ///< into near_, -1 for none
  std::array<int, kPatches> used_{};     ///< the patches that hold one
  int patches_used_ = 0;
  int patch_size_ = 1;  ///< points

  // the search in progress
  std::uint32_t search_ = 1;
  double complete_ = -1.0;   ///< m: near() holds all with less clearance than this; -1: none
  double goal_ = -1.0;       ///< m: of the pass that was cut; -1: none was
  int cursor_ = 0;           ///< node at which to go on
  std::vector<int> opened_;  ///< inner nodes whose children were looked at, in order
  std::size_t opened_count_ = 0;
};

/// The tool at a pose, and its points near the surface there.
struct NearTool {
  const Isosurface& solid;
  const ShellTree& tree;
  const Pose& X_WP;
  const Clearance& near;
};

}  // namespace haptics
