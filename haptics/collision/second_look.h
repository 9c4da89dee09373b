// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/sweep.h"
#include "haptics/core/budget.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Does the checks that collision detection leaves out. Studies and tests attach one to a Proxy;
/// the program attaches none. Its results are used: the motion differs if a needed check was left
/// out, and is otherwise the same to the bit. The budget counts its work and never cuts it.
class SecondLook {
 public:
  virtual ~SecondLook() = default;
  /// Called when `tool.near` should hold all points with less than `reach` [m] of clearance, and no
  /// point should be inside. Returns false if a point is inside.
  virtual bool collected(const NearTool& tool, double reach, Budget& budget) HAPTICS_RT = 0;
  /// Called when `surface` should hold the rows of all points within the band. Adds missing rows.
  virtual void gathered(const NearTool& tool, const Tolerances& lengths, SurfaceRows& surface,
                        Budget& budget) HAPTICS_RT = 0;
  /// Called when the way from the tool's pose along `motion` should be free until the sweep's
  /// impact. Passes an earlier impact to the sweep.
  virtual void swept(const NearTool& tool, const Twist& motion, const Tolerances& lengths,
                     Sweep& sweep, Budget& budget) HAPTICS_RT = 0;
};

}  // namespace haptics
