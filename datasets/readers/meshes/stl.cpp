// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <string>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/meshes/polygons.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::size_t kHead = 84, kFacet = 50;  // bytes of a binary file

void endPolygon(Polygons& polygons) {
  polygons.corners.push_back(static_cast<std::uint32_t>(polygons.places.size() - 3));
  polygons.corners.push_back(static_cast<std::uint32_t>(polygons.places.size() - 2));
  polygons.corners.push_back(static_cast<std::uint32_t>(polygons.places.size() - 1));
  polygons.ends.push_back(polygons.corners.size());
}

Expected<Polygons> readBinary(const fs::path& path, std::string_view facets) {
  Polygons polygons;
  for (; facets.size() >= kFacet; facets.remove_prefix(kFacet)) {
    std::array<float, 12> numbers{};  // a normal, which nobody needs, and three corners
    std::memcpy(numbers.data(), facets.data(), sizeof numbers);
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const auto place =
          placeOf(path, {numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]});
      if (!place) return tl::unexpected(place.error());
      polygons.places.push_back(*place);
    }
    endPolygon(polygons);
  }
  return polygons;
}

Expected<Polygons> readAscii(const fs::path& path, std::string_view text) {
  Polygons polygons;
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
      if (inside) return malformed("bad-header", {"mesh-unreadable", {quoted(path)}});
      inside = true;
      vertices = 0;
    } else if (word == "vertex") {
      const auto place = takePlace(path, line);
      if (!place) return tl::unexpected(place.error());
      if (!takeWord(line).empty())
        return malformed("truncated", {"mesh-vertex-wrong", {quoted(path)}});
      ++vertices;
      polygons.places.push_back(*place);
    } else if (word == "endfacet") {
      if (!inside || vertices != 3)
        return malformed("bad-header", {"mesh-unreadable", {quoted(path)}});
      inside = false;
      endPolygon(polygons);
    }
  }
  if (inside || !closed) return malformed("truncated", {"file-damaged", {quoted(path)}});
  return polygons;
}

}  // namespace

Expected<Polygons> readStl(const fs::path& path, std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHead) std::memcpy(&count, bytes.data() + kHead - 4, 4);
  const std::size_t stated = kHead + kFacet * std::size_t{count};
  if (bytes.size() == stated) return readBinary(path, bytes.substr(kHead));
  std::string_view start = bytes;
  if (lowered(takeWord(start)) == "solid" && bytes.find('\0') == bytes.npos)
    return readAscii(path, bytes);
  return malformed("truncated", {"file-damaged", {quoted(path)}});
}

}  // namespace datasets
