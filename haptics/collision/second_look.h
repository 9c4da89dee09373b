// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/sweep.h"
#include "haptics/core/budget.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Does what collision detection leaves out, beside it. Studies and tests attach one to a Proxy;
/// the program attaches none. What it finds counts, so a motion differs where something was left
/// out that was needed, and is the same to the bit where nothing was. The budget counts its work
/// and never cuts it.
class SecondLook {
 public:
  virtual ~SecondLook() = default;
  /// `near` is said to hold all points with less than `reach` [m] of clearance, and none to be
  /// inside. False if one is inside.
  virtual bool collected(const NearTool& tool, double reach, Budget& budget) HAPTICS_RT = 0;
  /// `surface` is said to hold the rows of all points within the band. Adds those it lacks.
  virtual void gathered(const NearTool& tool, const Tolerances& lengths, SurfaceRows& surface,
                        Budget& budget) HAPTICS_RT = 0;
  /// The way from the tool's pose along `motion` is said to be free until the sweep's impact.
  /// Tells the sweep of an earlier one.
  virtual void swept(const NearTool& tool, const Twist& motion, const Tolerances& lengths,
                     Sweep& sweep, Budget& budget) HAPTICS_RT = 0;
};

}  // namespace haptics
