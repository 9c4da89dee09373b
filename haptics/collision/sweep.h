// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/collision/motion.h"
#include "haptics/core/budget.h"

namespace haptics {

/// How far the tool gets.
struct Impact {
  double time = 1.0;  ///< fraction of the motion that is certainly free
  bool met = false;   ///< a point met the surface then
  Contact contact;    ///< which, seen from the start of the motion
};

/// Step 4: continuous collision detection of all near points along a motion, in slabs of time
/// short enough that every path keeps within the sagitta of its chord. In each slab, sixteen
/// points at a time: what their surroundings prove free is skipped, cells whose Bernstein hull
/// stays below the surface are passed, and only what is left is looked at for a root. So the
/// earliest point is met first, and later slabs are never looked at.
///
/// One that the budget cuts goes on where it stopped.
class Sweep {
 public:
  static constexpr double kSlab = 2.0;  ///< voxels of path in a slab at most

  explicit Sweep(std::size_t points) : clear_until_(points, 0.0) {}

  /// Before a motion from X_WP; `near` holds all points with less clearance than its length.
  void begin(const ScalarField& field, const Clearance& near, const Pose& X_WP, const Twist& motion,
             const Tolerances& lengths) HAPTICS_RT;
  /// Goes on; false if the budget ran out before the impact was known.
  bool advance(const Isosurface& solid, const ShellTree& tree, const Clearance& near,
               const Tolerances& lengths, Budget& budget) HAPTICS_RT;
  double time() const HAPTICS_RT { return time_; }  ///< of the earliest impact so far; 1: none
  /// Takes an impact at `time`, before the one known, that was found by other means.
  void meet(double time, std::size_t place) HAPTICS_RT {
    time_ = time;
    met_ = static_cast<int>(place);
  }
  /// Once advance() is through. The contact has the exact normal of the cell *behind* the
  /// crossing. The budget counts the look and is not asked.
  Impact impact(const Isosurface& solid, const ShellTree& tree, const Tolerances& lengths,
                Budget& budget) const HAPTICS_RT;

 private:
  /// A slice of the motion's time, and the tool at its two ends.
  struct Slab {
    double begin, end;
    lanes::Affine at_begin, at_end;  // tool frame to index coordinates
  };
  /// Near points that are looked at together.
  struct Group {
    int count = 0;
    int points[lanes::kLanes];  // into near()
  };
  void look(const Isosurface& solid, const ShellTree& tree, const Clearance& near, const Slab& slab,
            const Group& group, const Tolerances& lengths, Budget& budget) HAPTICS_RT;

  Pose X_ = Pose::Identity();
  Twist motion_;
  double speed_ = 0.0, turn_ = 0.0;  ///< norms of the motion
  double duration_ = 1.0;            ///< of a slab
  double slab_ = 0.0;                ///< time at which the slab in hand begins
  std::size_t cursor_ = 0;           ///< near point at which to go on in it
  double time_ = 1.0;                ///< of the earliest impact so far
  int met_ = -1;                     ///< the place of the point that met it
  std::vector<double> clear_until_;  ///< time until which a near point is proven free
};

}  // namespace haptics
