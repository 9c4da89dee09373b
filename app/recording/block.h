// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/recording/columns.h"
#include "haptics/core/error.h"

namespace app {

/// How the numbers of a block are stored. README.md has the reasons and the sizes.
enum class Layout : std::uint8_t {
  Exact,  ///< every number of a step to the bit, as planes of bytes
  /// What went into a tick to the bit. What came out is rounded, with RecordedStep::check of its
  /// bits. All as differences. For rates above 1 kHz.
  Rounded,
};

/// Compressed steps with consecutive sequence numbers, column by column (number_columns.h).
struct Block {
  std::uint64_t first = 0;  ///< sequence of the first step
  std::int64_t count = 0;
  std::int64_t from_ns = 0, to_ns = 0;  ///< times of the first and last step
  std::vector<std::uint8_t> steps = {};
  std::int64_t contact_count = 0;
  std::vector<std::uint8_t> contacts = {};
  std::vector<std::uint8_t> structures = {};  ///< that all of its steps watch, from 0
  std::vector<std::uint8_t> nearness = {};    ///< of each of them tip, then nearest
  std::int64_t cut_count = 0;                 ///< steps in which a cut began
  std::vector<std::uint8_t> cuts = {};        ///< which of the block's steps, and their numbers
};

inline constexpr std::int64_t kMostStepsInBlock = 1024;

/// Whether two steps may lie in one block, the second behind the first: no step is missing between
/// them, and they watch the same structures.
bool isNext(const haptics::Step& step, const haptics::Step& next);

/// At least one and at most kMostStepsInBlock steps, each of them isNext to the one before.
Block encoded(std::span<const haptics::Step> steps, Layout layout);
/// Refuses an invalid block, reason "damaged".
haptics::Expected<std::vector<RecordedStep>> decoded(const Block& block, Layout layout);

/// The columns of both parts in order, as JSON: [name, type, unit] each, and if it is rounded, how
/// many roundings are one unit. It is written into every recording, so that a recording can be read
/// without Palpate.
std::string stepLayout(Layout layout);
std::string contactLayout(Layout layout);
/// Of cuts: [name, type, unit]. They are exact in either layout.
std::string cutLayout();

}  // namespace app
