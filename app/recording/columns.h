// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "haptics/servo/step.h"

namespace app {

/// A pose as numbers: x, y, z [m], then the unit quaternion w, x, y, z.
using PoseNumbers = std::array<double, 7>;
PoseNumbers numbersOf(const haptics::Pose& X);

/// A step read from a recording.
struct RecordedStep {
  haptics::Step step;    ///< X_WD exact to the bit; the results with the precision of their columns
  PoseNumbers device{};  ///< numbersOf X_WD
  PoseNumbers proxy{};   ///< numbersOf X_WP as recorded
  /// checkOf the proxy and the wrench as they were, if they are recorded rounded.
  std::optional<std::uint32_t> check = {};
};

/// A number of 23 bits, three bytes in a recording, that tells results apart: if any bit of them
/// differs, it differs, but for one case in eight million.
std::uint32_t checkOf(const PoseNumbers& proxy, const haptics::Wrench& sent_W);

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

/// A step that is being read, with the columns that are not part of Step.
struct PartlyRead {
  RecordedStep row;
  std::array<std::uint64_t, 9> device_bits{};
  std::uint8_t contacts = 0;
};

/// One number of a recorded step. The recording, every export and the list in README.md follow from
/// the table of these columns.
struct StepColumn {
  const char* name;  ///< in a recording and in CSV
  ColumnType type;
  const char* unit;  ///< "1": a ratio; "": a count, a code, or the scan's own unit
  /// Group and name in HDF5, topic and key in MCAP. Null: exports write the column as part of a
  /// vector or as time, or leave it out.
  const char* path;
  bool steady;          ///< changes seldom; MCAP writes it only when it changes
  const char* meaning;  ///< a clause
  /// The value's bits, lowest first.
  std::uint64_t (*bits)(const RecordedStep&);
  /// Sets the value. Returns false if a step cannot have it.
  bool (*set)(PartlyRead&, std::uint64_t bits);
  /// Of a result, a float64, which Layout::Rounded rounds: roundings in a unit. 0: always exact.
  double per_unit = 0.0;
};

/// The columns, in the order of a recording. To add a column, add its row and add a format
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

}  // namespace app
