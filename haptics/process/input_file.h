// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>

#include "haptics/core/error.h"

namespace haptics {

/// Opens a file that is read from front to back, if it is a regular one of at most so many bytes:
/// whoever waited for a pipe would wait for ever, and a device or a sparse file need not end. Links
/// are followed. Errors: "unreadable" (no such file, no permission), "no-file", "too-large".
Expected<std::ifstream> openInput(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// The same, whole.
Expected<std::string> readInput(const std::filesystem::path& path, std::uintmax_t most_bytes);

enum class LineRead { Whole, TooLong, End };

/// Takes the next line, without its end ("\n" or "\r\n"). One of more than `most_bytes` is cut
/// there, so that a file without line ends takes no memory.
LineRead takeLine(std::istream& in, std::string& line, std::size_t most_bytes);

/// Whether arrays and objects of a JSON text lie in each other more than `levels` deep. The text
/// need not be JSON. Who copies or prints such a value calls itself as often.
bool isNestedDeeper(std::string_view json, int levels);

inline constexpr int kDeepestJson = 32;  ///< levels; nothing that Palpate reads has a third of it

}  // namespace haptics
