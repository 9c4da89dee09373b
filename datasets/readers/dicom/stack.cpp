// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::Vec3;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kParallel = 0.1 * kDegree;   // rad, between planes and off the normal
constexpr double kUnitError = 1e-3;           // of a direction's length, and of a right angle
constexpr double kSamePosition_mm = 1e-3;     // steps below this are none
constexpr double kEvenStep = 0.01;            // of the median
constexpr double kEvenStep_mm = 0.05;         //
constexpr double kMultipleStep = 0.05;        // of the multiple
constexpr double kEqualPixelSpacing = 1e-4;   // relative
constexpr double kMostTilt = 45.0 * kDegree;  // rad; gantries tilt by 30 degrees at most
constexpr double kMostAside = 8.0;            // of a slice's columns and rows together
constexpr double kMostPlanes = 2.0;           // of a resampled box for each slice that there is

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Expected<void> checkPlane(const SlicePlane& s) {
  if (!s.position_mm.allFinite() || !std::isfinite(s.column_step_mm) ||
      !std::isfinite(s.row_step_mm) || s.column_step_mm <= 0.0 || s.row_step_mm <= 0.0)
    return malformed("bad-header", {"dicom-position-or-spacing", {}});
  const bool unit = std::abs(s.along_row.norm() - 1.0) < kUnitError &&
                    std::abs(s.along_column.norm() - 1.0) < kUnitError;
  if (!s.along_row.allFinite() || !s.along_column.allFinite() || !unit ||
      std::abs(s.along_row.dot(s.along_column)) > kUnitError)
    return malformed("bad-header", {"dicom-orientation", {}});
  return {};
}

Expected<void> checkAlike(const std::vector<SlicePlane>& slices) {
  const SlicePlane& first = slices.front();
  double widest = 0.0;
  for (const SlicePlane& s : slices) {
    if (s.columns != first.columns || s.rows != first.rows)
      return unsupported("mixed-size", {"dicom-sizes-mixed",
                                        {std::to_string(first.columns), std::to_string(first.rows),
                                         std::to_string(s.columns), std::to_string(s.rows)}});
    widest = std::max({widest, angleBetween(s.along_row, first.along_row),
                       angleBetween(s.along_column, first.along_column)});
  }
  if (widest > kParallel)
    return unsupported("mixed-orientation",
                       {"dicom-orientations-mixed", {brief(widest / kDegree)}});
  for (const SlicePlane& s : slices)
    if (std::abs(s.column_step_mm / first.column_step_mm - 1.0) > kEqualPixelSpacing ||
        std::abs(s.row_step_mm / first.row_step_mm - 1.0) > kEqualPixelSpacing)
      return unsupported("mixed-size", {"dicom-spacings-mixed",
                                        {brief(first.column_step_mm), brief(s.column_step_mm)}});
  return {};
}

/// How ordered slices follow each other.
struct Advance {
  Vec3 normal, along_row, along_column;  ///< unit, at right angles
  Vec3 way_mm = Vec3::Zero();            ///< from the first slice to the last
  double extent_mm = 0.0;                ///< of it, along the normal
  std::vector<double> heights_mm;        ///< of each slice over the first, along the normal

  double tilt() const { return angleBetween(way_mm, normal); }
  /// Where a slice's first pixel lies beside that of the first slice, in columns and rows.
  Eigen::Vector2d aside(const SlicePlane& slice, const SlicePlane& first) const {
    const Vec3 offset_mm = slice.position_mm - first.position_mm;
    return {along_row.dot(offset_mm) / first.column_step_mm,
            along_column.dot(offset_mm) / first.row_step_mm};
  }
};

/// Of slices in order, at least two; each somewhere else, and all on one line.
Expected<Advance> advanceOf(const std::vector<SlicePlane>& ordered, const Vec3& normal) {
  const SlicePlane& first = ordered.front();
  Advance advance{normal, first.along_row.normalized(), {}, {}, 0.0, {}};
  // rounding in the orientation must not leave the axes off their right angles
  advance.along_column = normal.cross(advance.along_row);
  advance.way_mm = ordered.back().position_mm - first.position_mm;
  advance.extent_mm = normal.dot(advance.way_mm);
  int repeated = 0;
  for (const SlicePlane& s : ordered) {
    const double height_mm = normal.dot(s.position_mm - first.position_mm);
    if (!advance.heights_mm.empty())
      repeated += height_mm - advance.heights_mm.back() < kSamePosition_mm ? 1 : 0;
    advance.heights_mm.push_back(height_mm);
  }
  if (repeated > 0)
    return unsupported("duplicate", {"dicom-positions-repeated",
                                     {std::to_string(repeated), std::to_string(ordered.size())}});
  if (advance.tilt() > kMostTilt)
    return unsupported("sheared", {"dicom-tilt-too-large", {brief(advance.tilt() / kDegree)}});
  // within half a pixel's tenth, and what counts as straight
  const double pixel_mm = std::min(first.row_step_mm, first.column_step_mm);
  for (std::size_t k = 0; k < ordered.size(); ++k) {
    const double height_mm = advance.heights_mm[k];
    const Vec3 on_line_mm = height_mm / advance.extent_mm * advance.way_mm;
    const double aside_mm = (ordered[k].position_mm - first.position_mm - on_line_mm).norm();
    if (aside_mm > 0.05 * pixel_mm + std::tan(kParallel) * height_mm)
      return unsupported("sheared", {"dicom-slice-aside", {brief(aside_mm)}});
  }
  return advance;
}

/// How far a step may be off the usual one, mm.
double evenWithin(double median_mm) { return std::max(kEvenStep * median_mm, kEvenStep_mm); }

double medianOf(std::vector<double> numbers) {
  std::ranges::sort(numbers);
  return numbers[numbers.size() / 2];
}

Vec3 normalOf(const SlicePlane& slice) {
  return slice.along_row.cross(slice.along_column).normalized();
}

/// Indices along the normal.
std::vector<std::size_t> orderAlong(const Vec3& normal, const std::vector<SlicePlane>& slices) {
  std::vector<std::size_t> order(slices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return normal.dot(slices[i].position_mm); });
  return order;
}

/// Nothing where the steps are even; why they are not; or, unexpected, that slices are missing.
Expected<std::optional<haptics::Error>> checkSteps(const std::vector<double>& steps_mm,
                                                   double median_mm) {
  const auto [least, greatest] = std::ranges::minmax(steps_mm);
  const double even = evenWithin(median_mm);
  int odd = 0, missing = 0;
  bool multiples = true;
  for (const double step : steps_mm) {
    if (std::abs(step - median_mm) <= even) continue;
    ++odd;
    const double times = std::round(step / median_mm);
    if (times < 2.0 || std::abs(step - times * median_mm) > kMultipleStep * times * median_mm)
      multiples = false;
    else
      missing += static_cast<int>(times) - 1;
  }
  if (odd == 0) return std::nullopt;
  const std::string gaps = std::to_string(odd), steps = std::to_string(steps_mm.size());
  if (multiples && missing == 1)
    return unsupported("missing-slices", {"dicom-slice-missing", {gaps, steps, brief(median_mm)}});
  if (multiples)
    return unsupported(
        "missing-slices",
        {"dicom-slices-missing", {std::to_string(missing), gaps, steps, brief(median_mm)}});
  return haptics::Error{
      haptics::Error::Kind::Correctable,
      {"dicom-uneven", {gaps, steps, brief(median_mm), brief(least), brief(greatest)}},
      "uneven-spacing"};
}

/// The box that tilted or uneven slices fill once they are resampled: planes at the median step,
/// and columns and rows for all of them. The first slice keeps its pixels.
Expected<Stack> straightened(Stack stack, const std::vector<SlicePlane>& ordered,
                             const Advance& advance, const std::optional<haptics::Error>& uneven,
                             double median_mm) {
  const SlicePlane& first = ordered.front();
  FileGeometry& box = stack.geometry;
  Crooked crooked{{}, {}, first.columns, first.rows};
  const bool tilted = advance.tilt() > kParallel;
  if (tilted) {
    const haptics::Message angle_deg = brief(advance.tilt() / kDegree);
    crooked.why = {haptics::Error::Kind::Correctable,
                   uneven ? haptics::Message{"dicom-tilted-and-uneven", {angle_deg}}
                          : haptics::Message{"dicom-tilted", {angle_deg}},
                   "gantry-tilt"};
  } else {
    crooked.why = *uneven;
  }
  if (uneven) {
    const double planes = 1.0 + std::round(advance.extent_mm / median_mm);
    if (!(planes >= 2.0 && planes <= kMostPlanes * static_cast<double>(ordered.size())))
      return unsupported("uneven-spacing", {"dicom-too-few-for-gaps", {crooked.why.message}});
    box.dims[2] = std::lround(planes);
  }
  const double step_mm = advance.extent_mm / static_cast<double>(box.dims[2] - 1);
  Vec3 least = Vec3::Zero(), greatest = least;
  for (std::size_t k = 0; k < ordered.size(); ++k) {
    Vec3 place{0.0, 0.0, uneven ? advance.heights_mm[k] / step_mm : static_cast<double>(k)};
    if (tilted) place.head<2>() = advance.aside(ordered[k], first);
    least = least.cwiseMin(place);
    greatest = greatest.cwiseMax(place);
    crooked.places.push_back(place);
  }
  // whole pixels to the box's corner
  const Vec3 corner = least.array().floor();
  const Vec3 more = greatest.array().ceil() - corner.array();
  // a header may state anything, and a small file must not ask for all memory
  if (!(more.head<2>().maxCoeff() <= kMostAside * static_cast<double>(first.columns + first.rows)))
    return unsupported(
        "sheared", {"dicom-slices-aside", {crooked.why.message, brief(more.head<2>().maxCoeff())}});
  for (Vec3& place : crooked.places) place -= corner;
  for (const int axis : {0, 1}) box.dims[static_cast<std::size_t>(axis)] += std::lround(more[axis]);
  box.steps_mm.col(2) = advance.normal * step_mm;
  box.origin_mm += box.steps_mm * corner;
  crooked.why.message = {"dicom-can-be-resampled", {crooked.why.message}};
  stack.crooked = std::move(crooked);
  return stack;
}

}  // namespace

std::optional<haptics::Mat3> directionOf(const SlicePlane& slice) {
  if (!checkPlane(slice)) return {};
  haptics::Mat3 direction;
  direction << slice.along_row, slice.along_column, slice.along_row.cross(slice.along_column);
  return direction;
}

Expected<Stack> stackOf(const std::vector<SlicePlane>& slices) {
  if (slices.empty()) return malformed("no-pixels", {"dicom-no-slice", {}});
  for (const SlicePlane& s : slices)
    if (const auto sound = checkPlane(s); !sound) return tl::unexpected(sound.error());
  if (const auto alike = checkAlike(slices); !alike) return tl::unexpected(alike.error());

  // order along the normal
  const SlicePlane& any = slices.front();
  const Vec3 normal = normalOf(any);
  Stack stack;
  stack.order = orderAlong(normal, slices);
  std::vector<SlicePlane> ordered;
  for (const std::size_t i : stack.order) ordered.push_back(slices[i]);

  const SlicePlane& first = ordered.front();
  FileGeometry& box = stack.geometry;
  box.dims = {any.columns, any.rows, static_cast<std::int64_t>(slices.size())};
  const Vec3 along_row = first.along_row.normalized();
  box.steps_mm.col(0) = along_row * any.column_step_mm;
  box.steps_mm.col(1) = normal.cross(along_row) * any.row_step_mm;
  box.steps_mm.col(2) = normal * (any.thickness_mm > 0.0 ? any.thickness_mm : 1.0);
  box.origin_mm = first.position_mm;
  if (slices.size() == 1) return stack;

  const auto advance = advanceOf(ordered, normal);
  if (!advance) return tl::unexpected(advance.error());
  std::vector<double> steps_mm;
  for (std::size_t k = 1; k < ordered.size(); ++k)
    steps_mm.push_back(advance->heights_mm[k] - advance->heights_mm[k - 1]);
  const double median_mm = medianOf(steps_mm);
  const auto uneven = checkSteps(steps_mm, median_mm);
  if (!uneven) return tl::unexpected(uneven.error());
  if (*uneven || advance->tilt() > kParallel)
    return straightened(std::move(stack), ordered, *advance, *uneven, median_mm);
  box.steps_mm.col(2) = normal * (advance->extent_mm / static_cast<double>(slices.size() - 1));
  return stack;
}

std::vector<std::size_t> longestRun(const std::vector<SlicePlane>& slices) {
  if (slices.size() < 2) return {};
  const Vec3 normal = normalOf(slices.front());
  const std::vector<std::size_t> order = orderAlong(normal, slices);
  std::vector<double> steps_mm;
  for (std::size_t k = 1; k < order.size(); ++k)
    steps_mm.push_back(normal.dot(slices[order[k]].position_mm - slices[order[k - 1]].position_mm));
  const double median_mm = medianOf(steps_mm);
  std::size_t first = 0, best = 0, longest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && std::abs(steps_mm[k - 1] - median_mm) > evenWithin(median_mm)) first = k;
    if (k + 1 - first <= longest) continue;
    longest = k + 1 - first;
    best = first;
  }
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(best);
  return {begin, begin + static_cast<std::ptrdiff_t>(longest)};
}

}  // namespace datasets
