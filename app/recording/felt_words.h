// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "haptics/core/error.h"
#include "haptics/scene/watch.h"

namespace app {

/// The kind of the event that stores how structures are felt: at the beginning of a recording with
/// the value 1, and each time it changes.
inline constexpr const char* kFeltEvent = "structures";

/// The structures that are felt otherwise than the scan has them, as an event of a recording stores
/// them: JSON, numbers from 1, SI. Empty: none is.
std::string wordsOf(const haptics::Watch& watch);

/// A watch of the same structures that feels as the words say. Refuses words that say nothing sound
/// ("damaged") and structures that the watch lacks ("no-structures").
haptics::Expected<haptics::Watch> feltAsSaid(const std::string& words, const haptics::Watch& watch);

/// The error ("no-structures") of a recording in which a structure was felt that is not known.
haptics::Error structureMissing(std::uint8_t structure);

}  // namespace app
