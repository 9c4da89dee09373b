// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/collision/motion.h"
#include "haptics/core/budget.h"
#include "haptics/core/cursor.h"

namespace haptics {

/// The end of the free way of a motion.
struct Impact {
  double time = 1.0;  ///< fraction of the motion that is proven free
  bool met = false;   ///< a point met the surface at `time`
  Contact contact;    ///< the contact, relative to the start of the motion
};

/// Step 4: continuous collision detection of all near points along a motion, in slabs of time short
/// enough that every path keeps within the sagitta of its chord. Each slab is processed sixteen
/// points at a time. Points that their surroundings prove free are skipped. Cells whose Bernstein
/// hull stays below the surface are skipped too. Only the remaining cells are searched for a root.
/// So the earliest impact is found first, and later slabs are not examined.
///
/// A sweep that the budget cuts continues in the next call of advance().
class Sweep {
 public:
  static constexpr double kSlab = 2.0;  ///< longest path in a slab, voxels

  explicit Sweep(std::size_t points) : clear_until_(points, 0.0) {}

  /// Call it before a motion from X_WP. `near` must hold all points with less clearance than the
  /// length of the motion, but for those of nodes that are carried along it.
  void begin(const ScalarField& field, const Clearance& near, const Pose& X_WP, const Twist& motion,
             const Tolerances& lengths) HAPTICS_RT;
  /// Continues the sweep. Returns false if the budget ran out before the impact was known.
  bool advance(const Isosurface& solid, const ShellTree& tree, const Clearance& near,
               const Tolerances& lengths, Budget& budget) HAPTICS_RT;
  double time() const HAPTICS_RT { return time_; }  ///< time of the earliest impact so far; 1: none
  /// Sets an impact at `time`, earlier than the known one, that was found by other means.
  void meet(double time, std::size_t place) HAPTICS_RT {
    time_ = time;
    met_ = static_cast<int>(place);
  }
  /// The impact, once advance() has returned true. The contact has the exact normal of the cell
  /// *behind* the crossing. The budget counts the work and does not limit it.
  Impact impact(const Isosurface& solid, const ShellTree& tree, const Tolerances& lengths,
                Budget& budget) const HAPTICS_RT;

 private:
  /// A slice of the motion's time, and the tool at its two ends.
  struct Slab {
    double begin, end;
    lanes::Affine at_begin, at_end;  // tool frame to index coordinates
  };
  /// Near points that are processed together.
  struct Group {
    int count = 0;
    int points[lanes::kLanes];  // into near()
  };
  void look(const Isosurface& solid, const ShellTree& tree, const Clearance& near, const Slab& slab,
            const Group& group, const Tolerances& lengths, Budget& budget) HAPTICS_RT;

  Pose X_ = Pose::Identity();
  Twist motion_;
  double speed_ = 0.0, turn_ = 0.0;  ///< norms of the motion
  double duration_ = 1.0;            ///< duration of a slab
  double slab_ = 0.0;                ///< time at which the present slab begins
  Cursor cursor_;                    ///< in this slab, through the near points
  double time_ = 1.0;                ///< of the earliest impact so far
  int met_ = -1;                     ///< place of the point that met the surface
  std::vector<double> clear_until_;  ///< time until which a near point is proven free
};

}  // namespace haptics
