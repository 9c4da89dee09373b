// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "app/study/reference/choices.h"

namespace reference {

/// M = diag(m 1, I_W): what (3) measures motions by.
struct MassMetric {
  double mass = 1.0;                  ///< kg
  Mat3 inertia_W = Mat3::Identity();  ///< kg m², about the centre, positive definite

  double inner(const Twist& a, const Twist& b) const {
    return mass * a.linear.dot(b.linear) + a.angular.dot(inertia_W * b.angular);
  }
};

/// The metric of a tool in the pose X_WP from its inertia in the tool frame: R I0 R^T.
MassMetric massMetric(const Pose& X_WP, const Mat3& inertia_P);

/// One constraint on a motion (v, w), from a contact at r_W from the centre:
/// n . v + w . (r x n) >= bias. With bias 0 it is the paper's (4); the charitable variant gives
/// it the way back to half of epsilon.
struct Row {
  Vec3 n_W = Vec3::UnitZ();
  Vec3 r_W = Vec3::Zero();  ///< m
  double bias = 0.0;        ///< m
};

/// How far a motion is beyond a row, in m: negative where the row forbids it.
double excess(const Row& row, const Twist& motion);

/// Step 3: the motion nearest to `free` in the metric M that every row allows, which for zero
/// biases is the projection of (3) onto the cone of (4). Zero motion if no motion is allowed.
///
/// The paper names Wilhelmsen's algorithm; the minimiser is unique, so any exact method gives the
/// same answer. Here: with y = L^T x (M = L L^T) and unit rows G, the shortest z = y - y_free with
/// G z >= h follows from the non-negative least squares problem
///   minimise |E u - e|  over u >= 0,  E = (G^T; h^T), e = (0, …, 0, 1):
/// its residual r = E u - e has E^T r >= 0, u . E^T r = 0 and r_last = -|r|², so z = r_1..6 / |r|²
/// is allowed, is a non-negative combination of rows, and those rows are met with equality: the
/// conditions of the minimum. r = 0 means that nothing is allowed. Adds to `pivots` how often a row
/// entered or left the active set.
Twist constrainedMotion(const Twist& free, const std::vector<Row>& rows, const MassMetric& M,
                        std::int64_t* pivots = nullptr);

}  // namespace reference
