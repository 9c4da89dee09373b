// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace haptics {

// Frames: W world (patient LPS), V voxel index, P proxy, D device handle, B device base.
// X_AB maps coordinates in B to coordinates in A. p_PC_W is the vector from P's origin to
// C, written in W. SI units throughout: m, rad, s, kg, N, N·m. Millimetres exist only in
// datasets/readers, app/ and ui/.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;
using Pose = Eigen::Isometry3d;

/// Force and torque about the handle origin, in W.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 torque = Vec3::Zero();  ///< N·m
};

/// A velocity, or a motion over a unit of time: the origin along `linear`, and a rotation by
/// `angular` about it. Not a screw: [Chan 2011], (2).
struct Twist {
  Vec3 linear = Vec3::Zero();   ///< m, or m/s
  Vec3 angular = Vec3::Zero();  ///< rad, or rad/s
};

/// The pose with this translation and rotation.
inline Pose poseOf(const Vec3& translation, const Quat& rotation) {
  Pose X = Pose::Identity();
  X.linear() = rotation.normalized().toRotationMatrix();
  X.translation() = translation;
  return X;
}

/// The unit quaternion of a pose's rotation, with w >= 0.
inline Quat rotationOf(const Pose& X) {
  Quat q{X.linear()};
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return q;
}

}  // namespace haptics
