// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"

namespace datasets {

/// The polygons of a mesh file, in the file's unit and axes. The tool is made of these numbers: no
/// other parser sees the file.
struct Polygons {
  using Place = std::array<float, 3>;  ///< finite

  std::vector<Place> places;
  std::vector<std::uint32_t> corners;  ///< places of the first polygon, then of the second, …
  std::vector<std::size_t> ends;       ///< where each polygon ends in `corners`; three or more each
};

inline constexpr std::size_t kMostCorners = 1000;  ///< of a polygon: cutting it up takes n² steps

// Each reads the bytes of a whole file; `path` is used in messages only. Refusals: a file that ends
// early ("truncated") or goes on behind its rows ("too-long"), does not follow its format
// ("bad-header"), has a coordinate that is no finite float32 ("non-finite"), or a polygon with
// fewer than three corners or one that does not exist ("bad-index"), or more than kMostCorners
// ("too-large").
haptics::Expected<Polygons> readStl(const std::filesystem::path& path, std::string_view bytes);
haptics::Expected<Polygons> readObj(const std::filesystem::path& path, std::string_view bytes);
haptics::Expected<Polygons> readPly(const std::filesystem::path& path, std::string_view bytes);

/// Cuts one line, without its end, off the front of a text.
std::string_view takeLine(std::string_view& text);
/// Cuts one word off the front of a text; empty at the end.
std::string_view takeWord(std::string_view& text);
/// Cuts three words off the front of a text, and takes them for a place. Refused as above.
haptics::Expected<Polygons::Place> takePlace(const std::filesystem::path& path,
                                             std::string_view& text);
/// Of three numbers. Refused as above.
haptics::Expected<Polygons::Place> placeOf(const std::filesystem::path& path,
                                           const std::array<double, 3>& numbers);

/// The refusal of a polygon with too many corners.
tl::unexpected<haptics::Error> tooManyCorners(const std::filesystem::path& path);

}  // namespace datasets
