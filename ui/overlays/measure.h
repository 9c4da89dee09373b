// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ui {

enum class MeasureKind { Distance, Angle, Point, Note };

/// One measure, mark or note of a scan.
struct Measure {
  MeasureKind kind = MeasureKind::Point;
  std::string text = {};  ///< UTF-8: the words of a note, the name of anything else
  /// Millimetres of W, as many as placesOf(kind). An angle is at the second place.
  std::vector<Eigen::Vector3d> places_mm = {};

  bool operator==(const Measure&) const = default;
};

inline constexpr std::array kMeasureKinds{MeasureKind::Distance, MeasureKind::Angle,
                                          MeasureKind::Point, MeasureKind::Note};
inline constexpr int kLongestMeasureText = 1000;  ///< characters

/// How many places a measure has.
constexpr std::size_t placesOf(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::Distance:
      return 2;
    case MeasureKind::Angle:
      return 3;
    case MeasureKind::Point:
    case MeasureKind::Note:
      break;
  }
  return 1;
}

}  // namespace ui
