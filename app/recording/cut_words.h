// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "haptics/core/error.h"
#include "haptics/proxy/cutting.h"

namespace app {

/// The kind of the event that stores how a burr cuts, at the beginning of a recording.
inline constexpr const char* kCutLawEvent = "cut_law";
/// The kind of the event that says what cuts have left: the digest of the voxels that differ from
/// the volume before the first of them, in hexadecimal.
inline constexpr const char* kCarvedEvent = "carved";

/// The law as an event of a recording stores it: JSON, SI.
std::string wordsOf(const haptics::CutLaw& law);
/// Refuses words that say nothing sound, reason "damaged".
haptics::Expected<haptics::CutLaw> lawFrom(const std::string& words);

/// A digest of the voxels of `after` that differ from those of `before`, and of their places; 0 if
/// none does. Both have the same grid and type.
std::uint64_t digestOfCuts(const haptics::Volume& before, const haptics::Volume& after);
std::string wordOf(std::uint64_t digest);

}  // namespace app
