// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::Vec3;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kParallel = 0.1 * kDegree;   // rad, between planes and off the normal
constexpr double kUnitError = 1e-3;           // of a direction's length, and of a right angle
constexpr double kSamePosition = 0.05;        // of the largest step: steps below this are none,
constexpr double kSamePosition_mm = 1e-3;     // at most,
constexpr double kLeastStep_mm = 1e-5;        // and at least
constexpr double kEvenStep = 0.01;            // of the median, or
constexpr double kEvenSmallStep = 0.05;       // of it,
constexpr double kEvenStep_mm = 0.05;         // up to this
constexpr double kEvenPlaces = 2.0;           // of what a step may be off
constexpr double kRoundedStep = 0.4;          // of a step: decimals that are coarser say nothing
constexpr double kRoundedTo_mm = 0.1;         // the coarsest
constexpr double kLikeTheMean = 1.45;         // times: steps beyond it are no matter of rounding
constexpr std::size_t kLeastRun = 3;          // steps of one size, to be meant so
constexpr double kMultipleStep = 0.05;        // of the multiple
constexpr double kEqualPixelSpacing = 1e-4;   // relative
constexpr double kMostTilt = 45.0 * kDegree;  // rad; gantries tilt by 30 degrees at most
constexpr double kMostAside = 8.0;            // of a slice's columns and rows together
constexpr double kMostPlanes = 2.0;           // of a resampled box for each slice that there is
constexpr double kMostPlanesOfTwo = 8.0;      // where a stack has two regular steps

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

haptics::Message spacingOf(const SlicePlane& s) {
  return haptics::Message::numbers(brief(s.column_step_mm).text + " x " +
                                   brief(s.row_step_mm).text);
}

bool hasEqualSpacing(const SlicePlane& a, const SlicePlane& b) {
  return std::abs(a.column_step_mm / b.column_step_mm - 1.0) <= kEqualPixelSpacing &&
         std::abs(a.row_step_mm / b.row_step_mm - 1.0) <= kEqualPixelSpacing;
}

Expected<void> checkPlane(const SlicePlane& s) {
  if (!s.position_mm.allFinite() || !std::isfinite(s.column_step_mm) ||
      !std::isfinite(s.row_step_mm) || s.column_step_mm <= 0.0 || s.row_step_mm <= 0.0)
    return malformed("bad-header", {"dicom-plane-wrong", {}});
  const bool unit = std::abs(s.along_row.norm() - 1.0) < kUnitError &&
                    std::abs(s.along_column.norm() - 1.0) < kUnitError;
  if (!s.along_row.allFinite() || !s.along_column.allFinite() || !unit ||
      std::abs(s.along_row.dot(s.along_column)) > kUnitError)
    return malformed("bad-header", {"dicom-plane-wrong", {}});
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
    widest = std::max(widest, turnBetween(s, first));
  }
  if (widest > kParallel)
    return unsupported("mixed-orientation",
                       {"dicom-orientations-mixed", {brief(widest / kDegree)}});
  for (const SlicePlane& s : slices)
    if (!hasEqualSpacing(s, first))
      return unsupported("mixed-size", {"dicom-spacings-mixed", {spacingOf(first), spacingOf(s)}});
  return {};
}

/// The last place that the positions are written to, mm: 0.01 where all have two decimals at most.
double writtenTo(const std::vector<SlicePlane>& slices) {
  constexpr int kMostDecimals = 6;
  double quantum_mm = 1.0;
  for (int decimals = 0; decimals < kMostDecimals; ++decimals, quantum_mm /= 10.0) {
    const auto isWhole = [&](double x) {
      const double count = x / quantum_mm;
      return std::abs(count - std::round(count)) < 1e-6 * std::max(1.0, std::abs(count) * 1e-3);
    };
    if (std::ranges::all_of(slices, [&](const SlicePlane& s) {
          return isWhole(s.position_mm.x()) && isWhole(s.position_mm.y()) &&
                 isWhole(s.position_mm.z());
        }))
      break;
  }
  return quantum_mm;
}

/// How far off places may be, mm, by the decimals in which they are written; 0 where these are so
/// few, or the steps so small, that they say nothing.
double roundingOf(const std::vector<SlicePlane>& slices, const Vec3& normal, double step_mm) {
  const double written_mm = writtenTo(slices);
  if (written_mm > 1.001 * std::min(kRoundedStep * step_mm, kRoundedTo_mm)) return 0.0;
  return 0.5 * written_mm * normal.cwiseAbs().sum() + 1e-9;
}

/// How ordered slices follow each other.
struct Advance {
  Vec3 normal, along_row, along_column;  ///< unit, at right angles
  Vec3 way_mm = Vec3::Zero();            ///< from the first slice to the last
  double extent_mm = 0.0;                ///< of it, along the normal
  std::vector<double> heights_mm;        ///< of each slice over the first, along the normal
  double rounding_mm = 0.0;              ///< of places, by the decimals in which they are written

  double tilt() const { return angleBetween(way_mm, normal); }
  /// Where a slice's first pixel lies beside that of the first slice, in columns and rows.
  Eigen::Vector2d aside(const SlicePlane& slice, const SlicePlane& first) const {
    const Vec3 offset_mm = slice.position_mm - first.position_mm;
    return {along_row.dot(offset_mm) / first.column_step_mm,
            along_column.dot(offset_mm) / first.row_step_mm};
  }
};

std::vector<double> stepsOf(const std::vector<double>& heights_mm) {
  std::vector<double> steps_mm;
  for (std::size_t k = 1; k < heights_mm.size(); ++k)
    steps_mm.push_back(heights_mm[k] - heights_mm[k - 1]);
  return steps_mm;
}

/// Steps that are none.
std::ptrdiff_t repeatedPlaces(const std::vector<double>& steps_mm) {
  const double none_mm = samePlaceWithin_mm(std::ranges::max(steps_mm));
  return std::ranges::count_if(steps_mm, [&](double step) { return step < none_mm; });
}

/// Of slices in order, at least two; each somewhere else, and all on one line.
Expected<Advance> advanceOf(const std::vector<SlicePlane>& ordered, const Vec3& normal) {
  const SlicePlane& first = ordered.front();
  Advance advance{normal, first.along_row.normalized(), {}, {}, 0.0, {}, 0.0};
  // rounding in the orientation must not leave the axes off their right angles
  advance.along_column = normal.cross(advance.along_row);
  advance.way_mm = ordered.back().position_mm - first.position_mm;
  advance.extent_mm = normal.dot(advance.way_mm);
  for (const SlicePlane& s : ordered)
    advance.heights_mm.push_back(normal.dot(s.position_mm - first.position_mm));
  if (const auto repeated = repeatedPlaces(stepsOf(advance.heights_mm)); repeated > 0)
    return unsupported("duplicate", {"dicom-positions-repeated",
                                     {std::to_string(repeated), std::to_string(ordered.size())}});
  if (advance.tilt() > kMostTilt)
    return unsupported("sheared", {"dicom-tilt-too-large", {brief(advance.tilt() / kDegree)}});
  advance.rounding_mm =
      roundingOf(ordered, normal, advance.extent_mm / static_cast<double>(ordered.size() - 1));
  // within half a pixel's tenth, and what counts as straight
  const double pixel_mm = std::min(first.row_step_mm, first.column_step_mm);
  for (std::size_t k = 0; k < ordered.size(); ++k) {
    const double height_mm = advance.heights_mm[k];
    const Vec3 on_line_mm = height_mm / advance.extent_mm * advance.way_mm;
    const double aside_mm = (ordered[k].position_mm - first.position_mm - on_line_mm).norm();
    if (aside_mm > 0.05 * pixel_mm + std::tan(kParallel) * height_mm + 2.0 * advance.rounding_mm)
      return unsupported("sheared", {"dicom-slice-aside", {brief(aside_mm)}});
  }
  return advance;
}

/// How far a step may be off the usual one, mm.
double evenWithin(double median_mm) {
  return std::max(kEvenStep * median_mm, std::min(kEvenSmallStep * median_mm, kEvenStep_mm));
}

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

/// How far places are off the even line from the first to the last, at most, mm.
double offTheLine(const std::vector<double>& heights_mm) {
  const double step_mm = heights_mm.back() / static_cast<double>(heights_mm.size() - 1);
  double most_mm = 0.0;
  for (std::size_t k = 0; k < heights_mm.size(); ++k)
    most_mm = std::max(most_mm, std::abs(heights_mm[k] - step_mm * static_cast<double>(k)));
  return most_mm;
}

/// The two sizes of steps where one follows the other, in two or three runs of several steps each.
std::optional<std::array<double, 2>> twoRegularSteps(const std::vector<double>& steps_mm,
                                                     double rounding_mm) {
  std::vector<std::size_t> begins;  // of the runs
  const auto isEqual = [&](double a, double b) {
    return std::abs(a - b) <= evenWithin(std::min(a, b)) + 2.0 * rounding_mm;
  };
  for (std::size_t k = 0; k < steps_mm.size(); ++k)
    if (begins.empty() || !isEqual(steps_mm[k], steps_mm[begins.back()])) begins.push_back(k);
  if (begins.size() < 2 || begins.size() > 3) return {};
  begins.push_back(steps_mm.size());
  for (std::size_t n = 1; n < begins.size(); ++n)
    if (begins[n] - begins[n - 1] < kLeastRun) return {};
  if (begins.size() == 4 && !isEqual(steps_mm[begins[0]], steps_mm[begins[2]])) return {};
  return std::array{steps_mm[begins[0]], steps_mm[begins[1]]};
}

/// Why steps are not even, and the step at which they are resampled.
struct Uneven {
  haptics::Error why;
  double step_mm;
  double most_planes;  ///< of the box, for each slice
  bool two_steps = false;
};

/// Nothing where the slices are evenly spaced; or, unexpected, that slices are missing.
Expected<std::optional<Uneven>> checkSteps(const Advance& advance) {
  const std::vector<double> steps_mm = stepsOf(advance.heights_mm);
  const double median_mm = medianOf(steps_mm);
  const double off_mm = offTheLine(advance.heights_mm), rounding_mm = 2.0 * advance.rounding_mm;
  const double even = evenWithin(median_mm) + rounding_mm;
  const auto correctable = [](haptics::Message message) {
    return haptics::Error{haptics::Error::Kind::Correctable, std::move(message), "uneven-spacing"};
  };
  const auto [least, greatest] = std::ranges::minmax(steps_mm);
  const double mean_mm = advance.extent_mm / static_cast<double>(steps_mm.size());
  const bool rounded = greatest < kLikeTheMean * mean_mm && off_mm <= rounding_mm;
  if (rounded) return std::nullopt;
  int odd = 0, missing = 0;
  bool multiples = true;
  for (const double step : steps_mm) {
    if (std::abs(step - median_mm) <= even) continue;
    ++odd;
    const double times = std::round(step / median_mm);
    if (times < 2.0 || std::abs(step - times * median_mm) >
                           kMultipleStep * times * median_mm + times * rounding_mm)
      multiples = false;
    else
      missing += static_cast<int>(times) - 1;
  }
  if (odd == 0 && off_mm <= kEvenPlaces * even) return std::nullopt;
  if (odd == 0)
    return Uneven{correctable({"dicom-drifting", {brief(off_mm), brief(least), brief(greatest)}}),
                  median_mm, kMostPlanes};
  if (const auto two = twoRegularSteps(steps_mm, advance.rounding_mm))
    return Uneven{correctable({"dicom-two-steps", {brief(two->front()), brief(two->back())}}),
                  std::min(two->front(), two->back()), kMostPlanesOfTwo, true};
  const std::string gaps = std::to_string(odd), steps = std::to_string(steps_mm.size());
  if (multiples && missing == 1)
    return unsupported("missing-slices", {"dicom-slice-missing", {gaps, steps, brief(median_mm)}});
  if (multiples)
    return unsupported(
        "missing-slices",
        {"dicom-slices-missing", {std::to_string(missing), gaps, steps, brief(median_mm)}});
  return Uneven{
      correctable({"dicom-uneven", {gaps, steps, brief(median_mm), brief(least), brief(greatest)}}),
      median_mm, kMostPlanes};
}

/// The box that tilted or uneven slices fill once they are resampled: planes at the median step,
/// and columns and rows for all of them. The first slice keeps its pixels.
Expected<Stack> straightened(Stack stack, const std::vector<SlicePlane>& ordered,
                             const Advance& advance, const std::optional<Uneven>& uneven) {
  const SlicePlane& first = ordered.front();
  FileGeometry& box = stack.geometry;
  Crooked crooked{{}, uneven.has_value(), uneven && uneven->two_steps,
                  {}, first.columns,      first.rows};
  const bool tilted = advance.tilt() > kParallel;
  if (tilted) {
    const haptics::Message angle_deg = brief(advance.tilt() / kDegree);
    crooked.why = {haptics::Error::Kind::Correctable,
                   uneven ? haptics::Message{"dicom-tilted-and-uneven", {angle_deg}}
                          : haptics::Message{"dicom-tilted", {angle_deg}},
                   "gantry-tilt"};
  } else {
    crooked.why = uneven->why;
  }
  if (uneven) {
    const double planes = 1.0 + std::round(advance.extent_mm / uneven->step_mm);
    if (!(planes >= 2.0 && planes <= uneven->most_planes * static_cast<double>(ordered.size())))
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

double samePlaceWithin_mm(double largest_step_mm) {
  return std::clamp(kSamePosition * largest_step_mm, kLeastStep_mm, kSamePosition_mm);
}

double turnBetween(const SlicePlane& a, const SlicePlane& b) {
  return std::max(angleBetween(a.along_row, b.along_row),
                  angleBetween(a.along_column, b.along_column));
}

bool isAlike(const SlicePlane& a, const SlicePlane& b) {
  return a.rows == b.rows && a.columns == b.columns && hasEqualSpacing(a, b) &&
         turnBetween(a, b) <= kParallel;
}

std::optional<haptics::Mat3> directionOf(const SlicePlane& slice) {
  if (!checkPlane(slice)) return {};
  haptics::Mat3 direction;
  direction << slice.along_row, slice.along_column, slice.along_row.cross(slice.along_column);
  return direction;
}

Expected<Stack> stackOf(const std::vector<SlicePlane>& slices) {
  if (slices.empty()) return malformed("no-pixels", {"dicom-no-image", {}});
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
  const auto uneven = checkSteps(*advance);
  if (!uneven) return tl::unexpected(uneven.error());
  if (*uneven || advance->tilt() > kParallel)
    return straightened(std::move(stack), ordered, *advance, *uneven);
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
  const double even = evenWithin(median_mm) + 2.0 * roundingOf(slices, normal, median_mm);
  std::size_t first = 0, best = 0, longest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && std::abs(steps_mm[k - 1] - median_mm) > even) first = k;
    if (k + 1 - first <= longest) continue;
    longest = k + 1 - first;
    best = first;
  }
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(best);
  return {begin, begin + static_cast<std::ptrdiff_t>(longest)};
}

}  // namespace datasets
