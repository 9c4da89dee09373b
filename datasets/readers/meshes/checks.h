// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "haptics/core/error.h"

namespace datasets {

/// The polygons that a mesh file holds, counted by us, so that what VTK makes of the file can be
/// compared. `bytes` is the whole file, `path` only serves the sentences. Each check refuses a
/// file that ends early ("truncated"), names a vertex it does not have ("bad-index") or does not
/// follow its format ("bad-header").
haptics::Expected<std::int64_t> checkStl(const std::filesystem::path& path, std::string_view bytes);
haptics::Expected<std::int64_t> checkObj(const std::filesystem::path& path, std::string_view bytes);
haptics::Expected<std::int64_t> checkPly(const std::filesystem::path& path, std::string_view bytes);

/// Cuts one line, without its end, off the front of a text.
std::string_view takeLine(std::string_view& text);
/// Cuts one word off the front of a text; empty at the end.
std::string_view takeWord(std::string_view& text);

/// Of an OBJ that was checked: its vertices and the corners of its faces alone. VTK's reader does
/// not take faces that state texture or normal at some corners, and this program needs neither.
std::string placesOfObj(std::string_view bytes);

}  // namespace datasets
