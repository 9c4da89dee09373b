// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Maps the device's base B to the world W and back. A change of the mapping does not move the
/// tool:
///
///   p_WD = p_W0 + scale R_WB (p_BD - p_B0),   R_WD = R_WB R_BD R_0
///
/// Each change sets p_B0, p_W0 and R_0 so that X_WD is the same before and after. R_WB turns to the
/// value set at kTurn at most, because the force on the hand turns with it. Servo thread
/// only.
class Mapping {
 public:
  static constexpr double kTurn = 2.0;  ///< rad/s

  /// The first pose of the device becomes X_WD. `period` [s] of a tick.
  Mapping(const Pose& X_WD, double period) : turn_{kTurn * period}, X_WD_{X_WD} {}

  /// The pose of the tool in W, for the handle in B. While clutched, the tool does not move.
  Pose toWorld(const Pose& X_BD) HAPTICS_RT;
  /// The wrench on the hand, its axes turned from W into B.
  Wrench toBase(const Wrench& wrench_W) const HAPTICS_RT;

  /// R_WB: a rotation; `scale`: m in W per m in B, above 0. Other values are ignored.
  void set(const Mat3& R_WB, double scale) HAPTICS_RT;
  void clutch(bool clutched) HAPTICS_RT;
  bool clutched() const HAPTICS_RT { return clutched_; }
  /// Puts the tool at another pose; the hand stays.
  void place(const Pose& X_WD) HAPTICS_RT;
  /// Call it if the next device pose may be anywhere: the tool does not follow that jump.
  void lift() HAPTICS_RT { anchored_ = false; }

 private:
  void anchor(const Pose& X_BD) HAPTICS_RT;

  double turn_;  ///< rad in a tick
  Pose X_WD_;
  Pose X_BD_ = Pose::Identity();         ///< in the last tick
  Mat3 R_WB_ = Mat3::Identity();         ///< now
  Mat3 R_WB_wanted_ = Mat3::Identity();  ///< as it was set
  double scale_ = 1.0;
  Vec3 p_B0_ = Vec3::Zero(), p_W0_ = Vec3::Zero();
  Mat3 R_0_ = Mat3::Identity();
  bool clutched_ = false;
  bool anchored_ = false;
};

}  // namespace haptics
