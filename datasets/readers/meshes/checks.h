// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "haptics/core/error.h"

namespace datasets {

/// Counts a file's polygons, to compare with VTK's count. `bytes` is the whole file, `path` is used
/// in messages only. Each check refuses a file that ends early ("truncated"), refers to a vertex
/// that does not exist ("bad-index") or does not follow its format ("bad-header").
haptics::Expected<std::int64_t> checkStl(const std::filesystem::path& path, std::string_view bytes);
haptics::Expected<std::int64_t> checkObj(const std::filesystem::path& path, std::string_view bytes);
haptics::Expected<std::int64_t> checkPly(const std::filesystem::path& path, std::string_view bytes);

/// Cuts one line, without its end, off the front of a text.
std::string_view takeLine(std::string_view& text);
/// Cuts one word off the front of a text; empty at the end.
std::string_view takeWord(std::string_view& text);

/// The vertices and the corners of the faces of a checked OBJ, without anything else. VTK's reader
/// does not accept faces that state texture or normal at some corners, and this program needs
/// neither.
std::string placesOfObj(std::string_view bytes);

}  // namespace datasets
