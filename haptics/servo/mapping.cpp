// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/mapping.h"

#include <cmath>

namespace haptics {

void Mapping::anchor(const Pose& X_BD) HAPTICS_RT {
  p_B0_ = X_BD.translation();
  p_W0_ = X_WD_.translation();
  const Mat3 turned = R_WB_ * X_BD.linear();
  R_0_ = Quat{turned.transpose() * X_WD_.linear()}.normalized().toRotationMatrix();
  anchored_ = true;
}

Pose Mapping::toWorld(const Pose& X_BD) HAPTICS_RT {
  if (!X_BD.matrix().allFinite()) return X_BD;  // a doubt that the gate is to see
  if (clutched_) {
    anchored_ = false;
    return X_WD_;
  }
  if (!anchored_) {
    R_WB_ = R_WB_wanted_;
    anchor(X_BD);
  } else if (R_WB_ != R_WB_wanted_) {
    const Eigen::AngleAxisd left{R_WB_wanted_ * R_WB_.transpose()};
    R_WB_ =
        left.angle() <= turn_
            ? R_WB_wanted_
            : Quat{Eigen::AngleAxisd{turn_, left.axis()} * R_WB_}.normalized().toRotationMatrix();
    anchor(X_BD_);
  }
  X_BD_ = X_BD;
  X_WD_.translation() = p_W0_ + scale_ * (R_WB_ * (X_BD.translation() - p_B0_));
  X_WD_.linear() = R_WB_ * X_BD.linear() * R_0_;
  return X_WD_;
}

Wrench Mapping::toBase(const Wrench& wrench_W) const HAPTICS_RT {
  return {R_WB_.transpose() * wrench_W.force, R_WB_.transpose() * wrench_W.torque};
}

void Mapping::set(const Mat3& R_WB, double scale) HAPTICS_RT {
  if (R_WB != R_WB_wanted_ && R_WB.allFinite() && std::abs(R_WB.determinant() - 1.0) < 1e-6 &&
      (R_WB * R_WB.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-6)
    R_WB_wanted_ = R_WB;
  if (scale == scale_ || !(scale > 0.0) || !std::isfinite(scale)) return;
  scale_ = scale;
  if (anchored_) anchor(X_BD_);
}

void Mapping::clutch(bool clutched) HAPTICS_RT { clutched_ = clutched; }

void Mapping::place(const Pose& X_WD) HAPTICS_RT {
  X_WD_ = X_WD;
  anchored_ = false;
}

}  // namespace haptics
