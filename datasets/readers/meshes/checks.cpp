// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/meshes/checks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <vector>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::string_view kBlank = " \t\r\n\v\f";

enum class Corner { Finite, NonFinite, NoNumbers };

Corner cornerOf(std::string_view& words) {
  Corner corner = Corner::Finite;
  for (int c = 0; c < 3; ++c) {
    const auto number = numberOf(takeWord(words));
    if (!number) return Corner::NoNumbers;
    if (!std::isfinite(*number)) corner = Corner::NonFinite;
  }
  return corner;
}

tl::unexpected<haptics::Error> badCorner(const fs::path& path, Corner corner) {
  if (corner == Corner::NonFinite)
    return malformed("non-finite", {"mesh-vertex-not-finite", {quoted(path)}});
  return malformed("truncated", {"mesh-vertex-incomplete", {quoted(path)}});
}

Expected<std::int64_t> checkAsciiStl(const fs::path& path, std::string_view text) {
  std::int64_t facets = 0;
  int vertices = 0;
  bool inside = false, closed = false;
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    const std::string word = lowered(takeWord(line));
    if (word == "solid") {
      closed = false;
    } else if (word == "endsolid") {
      closed = !inside;
    } else if (word == "facet") {
      if (inside) return malformed("bad-header", {"stl-facet-in-facet", {quoted(path)}});
      inside = true;
      vertices = 0;
    } else if (word == "vertex") {
      ++vertices;
      if (const Corner corner = cornerOf(line); corner != Corner::Finite)
        return badCorner(path, corner);
    } else if (word == "endfacet") {
      if (!inside || vertices != 3)
        return malformed("bad-header",
                         {"stl-facet-vertices", {quoted(path), std::to_string(vertices)}});
      inside = false;
      ++facets;
    }
  }
  if (inside || !closed) return malformed("truncated", {"stl-cut-off", {quoted(path)}});
  return facets;
}

/// One corner of an OBJ face, "7", "7/2", "7//3" or "7/2/3", against what has been counted.
bool cornerFits(std::string_view corner, const std::vector<std::int64_t>& so_far,
                const std::vector<std::int64_t>& totals) {
  for (std::size_t part = 0; part < 3; ++part) {
    const auto slash = std::min(corner.find('/'), corner.size());
    const std::string_view text = corner.substr(0, slash);
    if (text.empty() && part == 0) return false;
    if (!text.empty()) {
      const auto index = integerOf(text);
      if (!index || *index == 0 || *index > totals[part] || *index < -so_far[part]) return false;
    }
    if (slash == corner.size()) return true;
    corner.remove_prefix(slash + 1);
  }
  return false;
}

/// Calls f with the first word and the rest of each statement, joined over "\" at a line's end.
template <class F>
bool eachStatement(std::string_view text, F&& f) {
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
    if (!f(word, rest)) return false;
    joined.clear();
  }
  return true;
}

std::size_t listNamedBy(std::string_view word) {
  if (word == "v") return 0;
  if (word == "vt") return 1;
  return word == "vn" ? 2 : 3;
}

}  // namespace

std::string_view takeLine(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view takeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  const auto end = std::min(text.find_first_of(kBlank), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

Expected<std::int64_t> checkStl(const fs::path& path, std::string_view bytes) {
  constexpr std::size_t kHead = 84, kFacet = 50;
  std::uint32_t count = 0;
  if (bytes.size() >= kHead) std::memcpy(&count, bytes.data() + kHead - 4, 4);
  if (bytes.size() >= kHead && bytes.size() == kHead + kFacet * std::size_t{count}) return count;
  std::string_view start = bytes;
  if (lowered(takeWord(start)) == "solid" && bytes.find('\0') == bytes.npos)
    return checkAsciiStl(path, bytes);
  if (bytes.size() < kHead) return malformed("truncated", {"stl-header-cut-off", {quoted(path)}});
  const std::size_t stated = kHead + kFacet * std::size_t{count};
  if (bytes.size() > stated)
    return malformed("truncated", {"stl-goes-on",
                                   {quoted(path), std::to_string(bytes.size() - stated),
                                    std::to_string(count)}});
  return malformed("truncated", {"stl-too-few-triangles",
                                 {quoted(path), std::to_string(count),
                                  std::to_string((bytes.size() - kHead) / kFacet)}});
}

std::string placesOfObj(std::string_view bytes) {
  std::string text;
  std::int64_t so_far = 0;
  eachStatement(bytes, [&](std::string_view word, std::string_view rest) {
    if (word == "v") {
      ++so_far;
      text += "v";
      for (int c = 0; c < 3; ++c) text.append(" ").append(takeWord(rest));
      text += '\n';
    } else if (word == "f") {
      text += "f";
      for (std::string_view corner = takeWord(rest); !corner.empty() && corner.front() != '#';
           corner = takeWord(rest)) {
        const std::int64_t index = integerOf(corner.substr(0, corner.find('/'))).value_or(0);
        text.append(" ").append(std::to_string(index < 0 ? so_far + 1 + index : index));
      }
      text += '\n';
    }
    return true;
  });
  return text;
}

Expected<std::int64_t> checkObj(const fs::path& path, std::string_view bytes) {
  // every list's length first: a face may come before its vertices
  std::vector<std::int64_t> totals(4, 0);
  Corner worst = Corner::Finite;
  eachStatement(bytes, [&](std::string_view word, std::string_view rest) {
    ++totals[listNamedBy(word)];
    if (word == "v") worst = cornerOf(rest);
    return worst == Corner::Finite;
  });
  if (worst != Corner::Finite) return badCorner(path, worst);
  std::vector<std::int64_t> so_far(4, 0);
  std::int64_t faces = 0;
  const bool fits = eachStatement(bytes, [&](std::string_view word, std::string_view rest) {
    ++so_far[listNamedBy(word)];
    if (word != "f") return true;
    ++faces;
    int corners = 0;
    for (std::string_view corner = takeWord(rest); !corner.empty() && corner.front() != '#';
         corner = takeWord(rest), ++corners)
      if (!cornerFits(corner, so_far, totals)) return false;
    return corners >= 3;
  });
  if (!fits)
    return malformed("bad-index", {"obj-face-index", {std::to_string(faces), quoted(path)}});
  return faces;
}

}  // namespace datasets
