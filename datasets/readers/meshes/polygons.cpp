// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/meshes/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

std::string_view takeLine(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view takeWord(std::string_view& text) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  const auto end = std::min(text.find_first_of(kBlank), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

Expected<Polygons::Place> takePlace(const fs::path& path, std::string_view& text) {
  std::array<double, 3> numbers{};
  for (double& number : numbers) {
    const auto word = numberOf(takeWord(text));
    if (!word) return malformed("truncated", {"mesh-vertex-wrong", {quoted(path)}});
    number = *word;
  }
  return placeOf(path, numbers);
}

Expected<Polygons::Place> placeOf(const fs::path& path, const std::array<double, 3>& numbers) {
  Polygons::Place place{};
  for (std::size_t c = 0; c < place.size(); ++c) {
    // beyond float32, and NaN
    if (!(std::abs(numbers[c]) <= double{std::numeric_limits<float>::max()}))
      return malformed("non-finite", {"mesh-vertex-wrong", {quoted(path)}});
    place[c] = static_cast<float>(numbers[c]);
  }
  return place;
}

tl::unexpected<haptics::Error> tooManyCorners(const fs::path& path) {
  return unsupported("too-large",
                     {"mesh-polygon-large", {quoted(path), std::to_string(kMostCorners)}});
}

}  // namespace datasets
