// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The distance between two poses of a tool: M = diag(m 1, R I0 R^T) with m = 1 and I0 the shell's
/// mean inertia [m²]. Whitened coordinates y = (v, L^T R^T w), I0 = L L^T, are all in metres, and
/// y·y is twice the energy.
class MassMetric {
 public:
  explicit MassMetric(const Mat3& inertia_P) HAPTICS_RT;

  Vector6 whitened(const Twist& V, const Mat3& R_WP) const HAPTICS_RT {
    Vector6 y;
    y.head<3>() = V.linear;
    y.tail<3>() = L_.transpose() * (R_WP.transpose() * V.angular);
    return y;
  }
  Twist twist(const Vector6& y, const Mat3& R_WP) const HAPTICS_RT {
    return {y.head<3>(), R_WP * (L_inverse_.transpose() * y.tail<3>())};
  }
  /// The row of a contact: a·y = n·(v + w x r).
  Vector6 row(const Vec3& n_W, const Vec3& r_W, const Mat3& R_WP) const HAPTICS_RT {
    Vector6 a;
    a.head<3>() = n_W;
    a.tail<3>() = L_inverse_ * (R_WP.transpose() * r_W.cross(n_W));
    return a;
  }
  const Mat3& inertia() const HAPTICS_RT { return I_P_; }
  /// L^-1, of which row() makes use.
  const Mat3& shape() const HAPTICS_RT { return L_inverse_; }

 private:
  Mat3 I_P_, L_, L_inverse_;
};

}  // namespace haptics
