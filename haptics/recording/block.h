// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/recording/columns.h"

namespace haptics {

/// Compressed steps with consecutive sequence numbers. Each column has the values of all steps,
/// little endian: the lowest bytes of all values, then the next bytes, and so on. So bytes that
/// hardly change are adjacent.
struct Block {
  std::uint64_t first = 0;  ///< sequence of the first step
  std::int64_t count = 0;
  std::int64_t from_ns = 0, to_ns = 0;  ///< times of the first and last step
  std::vector<std::uint8_t> steps = {};
  std::int64_t contact_count = 0;
  std::vector<std::uint8_t> contacts = {};
};

inline constexpr std::int64_t kMostStepsInBlock = 1024;

/// At least one and at most kMostStepsInBlock steps, their sequences without a gap.
Block encoded(std::span<const Step> steps);
/// Refuses an invalid block, reason "damaged".
Expected<std::vector<RecordedStep>> decoded(const Block& block);

/// The columns of both parts in order, as JSON: [name, type, unit] each. It is written into every
/// recording, so that a recording can be read without Palpate.
std::string stepLayout();
std::string contactLayout();

}  // namespace haptics
