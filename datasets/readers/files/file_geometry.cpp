// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/file_geometry.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Mat3;
using haptics::Vec3;

namespace {

constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kLeastStep_mm = 1e-6;
constexpr double kMostStep_mm = 1e3;  // no voxel of a scan is as large as a step
constexpr double kFarthest_mm = 1e5;  // beyond, positions have no room for their micrometres
constexpr double kSquareEnough_deg = 0.10005;  // off a right angle: 0.1 in single precision
constexpr double kRounding = 1e-12;            // cosine below which axes are left as they are

/// The signs that turn a file's world into LPS.
Vec3 signsOf(FileSpace space) {
  switch (space) {
    case FileSpace::RightAnteriorSuperior:
      return {-1.0, -1.0, 1.0};
    case FileSpace::LeftAnteriorSuperior:
      return {1.0, -1.0, 1.0};
    case FileSpace::LeftPosteriorSuperior:
    case FileSpace::Unknown:
      break;
  }
  return Vec3::Ones();
}

/// The greatest cosine between two of the axes.
double cosineBetween(const Mat3& axes) {
  const Mat3 gram = axes.transpose() * axes;
  return std::max({std::abs(gram(0, 1)), std::abs(gram(0, 2)), std::abs(gram(1, 2))});
}

double offRightAngle_deg(double cosine) {
  return std::asin(std::min(cosine, 1.0)) * 180.0 / std::numbers::pi;
}

}  // namespace

double shear_deg(const Mat3& steps) {
  return offRightAngle_deg(cosineBetween(steps.colwise().normalized()));
}

bool isSquareEnough(const Mat3& steps) { return shear_deg(steps) <= kSquareEnough_deg; }

haptics::Expected<haptics::Grid> gridOf(const FileGeometry& file) {
  if (std::ranges::any_of(file.dims, [](std::int64_t n) { return n < 1; }))
    return malformed("bad-header", {"geometry-axis-empty", {}});
  if (!file.steps_mm.allFinite() || !file.origin_mm.allFinite())
    return malformed("bad-header", {"geometry-not-finite", {}});
  const Vec3 spacing_mm = file.steps_mm.colwise().norm().transpose();
  if (spacing_mm.minCoeff() < kLeastStep_mm || spacing_mm.maxCoeff() > kMostStep_mm)
    return malformed("bad-header",
                     {"geometry-spacing",
                      {brief(spacing_mm.x()), brief(spacing_mm.y()), brief(spacing_mm.z())}});
  if (file.origin_mm.cwiseAbs().maxCoeff() > kFarthest_mm)
    return malformed("bad-header",
                     {"geometry-too-far", {brief(1e-3 * file.origin_mm.cwiseAbs().maxCoeff())}});

  Mat3 direction = signsOf(file.space).asDiagonal() * file.steps_mm;
  for (int axis = 0; axis < 3; ++axis) direction.col(axis) /= spacing_mm[axis];

  // axes at right angles, up to rounding
  const double cosine = cosineBetween(direction);
  if (const double off_deg = offRightAngle_deg(cosine); off_deg > kSquareEnough_deg)
    return unsupported("sheared", {"geometry-sheared", {brief(off_deg)}});
  if (cosine > kRounding) {
    const Eigen::JacobiSVD<Mat3> svd(direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
    direction = svd.matrixU() * svd.matrixV().transpose();
  }

  haptics::Grid grid;
  grid.dims = file.dims;
  grid.spacing = spacing_mm * kMetresPerMillimetre;
  grid.origin = signsOf(file.space).cwiseProduct(file.origin_mm) * kMetresPerMillimetre;
  grid.direction = direction;
  return grid;
}

}  // namespace datasets
