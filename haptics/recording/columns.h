// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "haptics/servo/step.h"

namespace haptics {

/// A pose as it is written for people: x, y, z [m], then the unit quaternion w, x, y, z.
using PoseNumbers = std::array<double, 7>;
PoseNumbers numbersOf(const Pose& X);

/// A step as it is read from a recording.
struct RecordedStep {
  Step step;             ///< X_WD to the bit; X_WP and the contacts as in the contact layout
  PoseNumbers device{};  ///< numbersOf X_WD
  PoseNumbers proxy{};   ///< numbersOf X_WP when it was recorded
};

enum class ColumnType : std::uint8_t {
  Int64,
  Uint64,
  Float64,
  Uint32,
  Uint16,
  Uint8,
};
const char* nameOf(ColumnType type);  ///< "int64", as in a recording's layout
std::size_t bytesOf(ColumnType type);

/// A step while it is read, with what its columns tell beside the step.
struct PartlyRead {
  RecordedStep row;
  std::array<std::uint64_t, 9> device_bits{};
  std::uint8_t contacts = 0;
};

/// One number of a recorded step. What a recording holds of a step, every export of it, and the
/// list in README.md follow from the table of these.
struct StepColumn {
  const char* name;  ///< in a recording and in CSV
  ColumnType type;
  const char* unit;  ///< "1": has none, being a ratio; "": a count, a code, or the scan's own
  /// Group and name in HDF5, topic and key in MCAP; none: exports write it with others, as a vector
  /// or as time, or leave it out.
  const char* path;
  bool steady;          ///< changes seldom: MCAP tells it when it does
  const char* meaning;  ///< a clause
  /// The value's bits, lowest first.
  std::uint64_t (*bits)(const RecordedStep&);
  /// False: a step cannot have this value.
  bool (*set)(PartlyRead&, std::uint64_t bits);
};

/// In the order in which a recording holds them. To add one, add its row and raise kFormat
/// (schema.h).
std::span<const StepColumn> stepColumns();

/// Calls `f` with the column's value in its own type.
template <class F>
decltype(auto) withValue(const StepColumn& column, const RecordedStep& row, F&& f) {
  const std::uint64_t bits = column.bits(row);
  switch (column.type) {
    case ColumnType::Int64:
      return f(static_cast<std::int64_t>(bits));
    case ColumnType::Uint64:
      return f(bits);
    case ColumnType::Float64:
      return f(std::bit_cast<double>(bits));
    case ColumnType::Uint32:
      return f(static_cast<std::uint32_t>(bits));
    case ColumnType::Uint16:
      return f(static_cast<std::uint16_t>(bits));
    case ColumnType::Uint8:
      break;
  }
  return f(static_cast<std::uint8_t>(bits));
}

}  // namespace haptics
