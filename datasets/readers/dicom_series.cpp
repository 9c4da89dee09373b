// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom_series.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "datasets/readers/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::Vec3;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kParallel = 0.1 * kDegree;  // rad, between planes and off the normal
constexpr double kUnitError = 1e-3;          // of a direction's length, and of a right angle
constexpr double kSamePosition_mm = 1e-3;    // steps below this are none
constexpr double kEvenStep = 0.01;           // of the median
constexpr double kEvenStep_mm = 0.05;        //
constexpr double kMultipleStep = 0.05;       // of the multiple
constexpr double kEqualPixelSpacing = 1e-4;  // relative

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Expected<void> checkPlane(const SlicePlane& s) {
  if (!s.position_mm.allFinite() || !std::isfinite(s.column_step_mm) ||
      !std::isfinite(s.row_step_mm) || s.column_step_mm <= 0.0 || s.row_step_mm <= 0.0)
    return malformed("bad-header",
                     "A slice of the series has a position or pixel spacing that is no positive "
                     "number; export the series again.");
  const bool unit = std::abs(s.along_row.norm() - 1.0) < kUnitError &&
                    std::abs(s.along_column.norm() - 1.0) < kUnitError;
  if (!s.along_row.allFinite() || !s.along_column.allFinite() || !unit ||
      std::abs(s.along_row.dot(s.along_column)) > kUnitError)
    return malformed("bad-header",
                     "A slice of the series has an orientation that is not two perpendicular "
                     "directions; export the series again.");
  return {};
}

Expected<void> checkAlike(const std::vector<SlicePlane>& slices) {
  const SlicePlane& first = slices.front();
  double widest = 0.0;
  for (const SlicePlane& s : slices) {
    if (s.columns != first.columns || s.rows != first.rows)
      return unsupported("mixed-size",
                         "The series mixes slices of " + std::to_string(first.columns) + " x " +
                             std::to_string(first.rows) + " and " + std::to_string(s.columns) +
                             " x " + std::to_string(s.rows) +
                             " pixels; put them into folders of their own.");
    widest = std::max({widest, angleBetween(s.along_row, first.along_row),
                       angleBetween(s.along_column, first.along_column)});
  }
  if (widest > kParallel)
    return unsupported("mixed-orientation",
                       "The series mixes slices that are turned against each other by up to " +
                           brief(widest / kDegree) +
                           " degrees; put each orientation into a folder of its own.");
  for (const SlicePlane& s : slices)
    if (std::abs(s.column_step_mm / first.column_step_mm - 1.0) > kEqualPixelSpacing ||
        std::abs(s.row_step_mm / first.row_step_mm - 1.0) > kEqualPixelSpacing)
      return unsupported("mixed-size", "The series mixes pixel spacings of " +
                                           brief(first.column_step_mm) + " and " +
                                           brief(s.column_step_mm) +
                                           " mm; put them into folders of their own.");
  return {};
}

Expected<void> checkSteps(std::vector<double> steps_mm) {
  std::vector<double> sorted = steps_mm;
  std::ranges::sort(sorted);
  const double median = sorted[sorted.size() / 2];
  const double even = std::max(kEvenStep * median, kEvenStep_mm);
  int odd = 0, missing = 0;
  bool multiples = true;
  for (const double step : steps_mm) {
    if (std::abs(step - median) <= even) continue;
    ++odd;
    const double times = std::round(step / median);
    if (times < 2.0 || std::abs(step - times * median) > kMultipleStep * times * median)
      multiples = false;
    else
      missing += static_cast<int>(times) - 1;
  }
  if (odd == 0) return {};
  const std::string gaps =
      std::to_string(odd) + " of " + std::to_string(steps_mm.size()) + " steps";
  if (multiples)
    return unsupported("missing-slices",
                       std::to_string(missing) + (missing == 1 ? " slice is" : " slices are") +
                           " missing from the series (" + gaps + " are a multiple of " +
                           brief(median) + " mm); fetch the series again.");
  return unsupported("uneven-spacing", "The slices are unevenly spaced: " + gaps + " differ from " +
                                           brief(median) + " mm, from " + brief(sorted.front()) +
                                           " to " + brief(sorted.back()) +
                                           " mm; ask for a reconstruction with even spacing.");
}

}  // namespace

Expected<Stack> stackOf(const std::vector<SlicePlane>& slices) {
  if (slices.empty()) return malformed("no-pixels", "The series holds no slice.");
  for (const SlicePlane& s : slices)
    if (const auto sound = checkPlane(s); !sound) return tl::unexpected(sound.error());
  if (const auto alike = checkAlike(slices); !alike) return tl::unexpected(alike.error());

  // order along the normal
  const SlicePlane& any = slices.front();
  const Vec3 normal = any.along_row.cross(any.along_column).normalized();
  Stack stack;
  stack.order.resize(slices.size());
  std::iota(stack.order.begin(), stack.order.end(), std::size_t{0});
  const auto height = [&](std::size_t i) { return normal.dot(slices[i].position_mm); };
  std::ranges::stable_sort(stack.order, {}, height);

  const SlicePlane& first = slices[stack.order.front()];
  double step_mm = any.thickness_mm > 0.0 ? any.thickness_mm : 1.0;
  if (slices.size() > 1) {
    // a repeated position, whether or not the slices lie beside each other
    std::vector<double> steps_mm;
    int repeated = 0;
    for (std::size_t k = 1; k < slices.size(); ++k) {
      steps_mm.push_back(height(stack.order[k]) - height(stack.order[k - 1]));
      repeated += steps_mm.back() < kSamePosition_mm ? 1 : 0;
    }
    if (repeated > 0)
      return unsupported("duplicate", std::to_string(repeated) + " of " +
                                          std::to_string(slices.size()) +
                                          " slices lie at the position of another one; keep one "
                                          "image of each position in the folder.");
    const SlicePlane& last = slices[stack.order.back()];
    const double tilt = angleBetween(last.position_mm - first.position_mm, normal);
    if (tilt > kParallel)
      return unsupported("gantry-tilt", "The slices are tilted by " + brief(tilt / kDegree) +
                                            " degrees against the direction in which they advance; "
                                            "ask for a reconstruction without gantry tilt.");
    if (const auto even = checkSteps(steps_mm); !even) return tl::unexpected(even.error());
    step_mm = (height(stack.order.back()) - height(stack.order.front())) /
              static_cast<double>(slices.size() - 1);

    // every slice over the first, within half a pixel's tenth
    for (const SlicePlane& s : slices) {
      const Vec3 offset_mm = s.position_mm - first.position_mm;
      const double aside_mm = (offset_mm - normal * normal.dot(offset_mm)).norm();
      if (aside_mm > 0.05 * std::min(s.row_step_mm, s.column_step_mm) +
                         std::tan(kParallel) * std::abs(normal.dot(offset_mm)))
        return unsupported("sheared", "A slice of the series lies " + brief(aside_mm) +
                                          " mm beside the others; ask for a reconstruction as one "
                                          "straight stack.");
    }
  }

  stack.geometry.dims = {any.columns, any.rows, static_cast<std::int64_t>(slices.size())};
  // rounding in the orientation must not leave the axes off their right angles
  const Vec3 along_row = any.along_row.normalized();
  const Vec3 along_column = normal.cross(along_row);
  stack.geometry.steps_mm.col(0) = along_row * any.column_step_mm;
  stack.geometry.steps_mm.col(1) = along_column * any.row_step_mm;
  stack.geometry.steps_mm.col(2) = normal * step_mm;
  stack.geometry.origin_mm = first.position_mm;
  return stack;
}

}  // namespace datasets
