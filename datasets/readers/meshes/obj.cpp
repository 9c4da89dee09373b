// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <string>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/meshes/polygons.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

/// How many of each list, of "v", "vt" and "vn", and of other statements.
using Counts = std::array<std::int64_t, 4>;

std::size_t listNamedBy(std::string_view word) {
  if (word == "v") return 0;
  if (word == "vt") return 1;
  return word == "vn" ? 2 : 3;
}

/// Calls f with the first word and the rest of each statement, joined over "\" at a line's end,
/// until f returns false.
template <class F>
void eachStatement(std::string_view text, F&& f) {
  std::string joined;
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    if (line.ends_with('\\')) {
      joined.append(line.substr(0, line.size() - 1)).push_back(' ');
      continue;
    }
    joined.append(line);
    std::string_view rest = joined;
    const std::string_view word = takeWord(rest);
    if (!f(word, rest)) return;
    joined.clear();
  }
}

/// The place of a face's corner, "7", "7/2", "7//3" or "7/2/3"; negative ones count back from what
/// has been read so far. None: a part of it names nothing in its list.
std::optional<std::uint32_t> cornerOf(std::string_view corner, const Counts& so_far,
                                      const Counts& totals) {
  std::uint32_t place = 0;
  for (std::size_t part = 0; part < 3; ++part) {
    const auto slash = std::min(corner.find('/'), corner.size());
    const std::string_view text = corner.substr(0, slash);
    if (text.empty() && part == 0) return {};
    if (!text.empty()) {
      const auto index = integerOf(text);
      if (!index || *index == 0 || *index > totals[part] || *index < -so_far[part]) return {};
      if (part == 0)
        place = static_cast<std::uint32_t>(*index > 0 ? *index - 1 : so_far[0] + *index);
    }
    if (slash == corner.size()) return place;
    corner.remove_prefix(slash + 1);
  }
  return {};
}

}  // namespace

Expected<Polygons> readObj(const fs::path& path, std::string_view bytes) {
  Polygons polygons;
  // every list's length first: a face may come before its vertices
  Counts totals{};
  std::optional<haptics::Error> wrong;
  eachStatement(bytes, [&](std::string_view word, std::string_view rest) {
    ++totals[listNamedBy(word)];
    if (word != "v") return true;
    if (const auto place = takePlace(path, rest))
      polygons.places.push_back(*place);
    else
      wrong = place.error();
    return !wrong;
  });
  if (wrong) return tl::unexpected(std::move(*wrong));
  Counts so_far{};
  eachStatement(bytes, [&](std::string_view word, std::string_view rest) {
    ++so_far[listNamedBy(word)];
    if (word != "f") return true;
    const std::size_t begin = polygons.corners.size();
    bool fits = true;
    for (std::string_view text = takeWord(rest); fits && !text.empty() && text.front() != '#';
         text = takeWord(rest)) {
      const auto corner = cornerOf(text, so_far, totals);
      fits = corner.has_value();
      polygons.corners.push_back(corner.value_or(0));
    }
    const std::size_t corners = polygons.corners.size() - begin;
    polygons.ends.push_back(polygons.corners.size());
    if (!fits || corners < 3)
      wrong = malformed("bad-index", {"mesh-face-wrong", {quoted(path)}}).value();
    else if (corners > kMostCorners)
      wrong = tooManyCorners(path).value();
    return !wrong;
  });
  if (wrong) return tl::unexpected(std::move(*wrong));
  return polygons;
}

}  // namespace datasets
