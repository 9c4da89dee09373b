// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/segments.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/nrrd/text.h"

namespace datasets {

using haptics::Expected;

namespace {

/// How many bytes the character at `at` has in UTF-8; 0 if it is none, or a control character.
std::size_t lengthOfCharacter(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(text[n]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t n = 1; n < length; ++n)
    if ((byte(at + n) & 0xc0) != 0x80) return 0;
  const unsigned char second = byte(at + 1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool beyond = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  const bool control = first == 0xc2 && second < 0xa0;
  // marks that turn the direction of what follows
  const bool turns =
      first == 0xe2 &&
      ((second == 0x80 && byte(at + 2) >= 0xaa) || (second == 0x81 && byte(at + 2) >= 0xa6)) &&
      byte(at + 2) <= (second == 0x80 ? 0xae : 0xa9);
  return overlong || beyond || control || turns ? 0 : length;
}

/// A value of an NRRD's keys, in which a backslash and a line's end are written with a backslash.
std::string unescaped(std::string_view value) {
  std::string text;
  for (std::size_t n = 0; n < value.size(); ++n) {
    if (value[n] == '\\' && n + 1 < value.size()) ++n;
    text.push_back(value[n]);
  }
  return text;
}

std::optional<std::array<double, 3>> colourFrom(const std::string& text) {
  const auto words = wordsOf(text);
  if (words.size() != 3) return {};
  std::array<double, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto channel = numberOf(words[c]);
    if (!channel || !(*channel >= 0.0 && *channel <= 1.0)) return {};
    colour[c] = *channel;
  }
  return colour;
}

}  // namespace

std::string shownName(std::string_view stated) {
  std::string name;
  for (std::size_t at = 0; at < stated.size();) {
    const std::size_t length = lengthOfCharacter(stated, at);
    if (name.size() + std::max<std::size_t>(length, 1) > Structure::kLongestName) break;
    // a blank for each run of what cannot be shown
    if (length > 0)
      name += stated.substr(at, length);
    else if (!name.empty() && name.back() != ' ')
      name += ' ';
    at += std::max<std::size_t>(length, 1);
  }
  return std::string(trimmed(name));
}

Expected<std::vector<Segment>> segmentsOf(const std::filesystem::path& path) {
  std::vector<Segment> segments;
  const Beginning beginning{path};
  if (!beginning.is_open || !looksLikeNrrd(beginning)) return segments;
  const auto text = readNrrdText(path);
  if (!text) return tl::unexpected(text.error());
  std::set<std::pair<std::int64_t, std::int64_t>> seen;
  for (std::size_t n = 0;; ++n) {
    const std::string prefix = "Segment" + std::to_string(n) + "_";
    const auto find = [&](const char* key) -> std::optional<std::string> {
      const auto found = text->keys.find(prefix + key);
      if (found == text->keys.end()) return {};
      return unescaped(found->second);
    };
    const auto name = find("Name");
    if (!name && !find("ID")) return segments;
    if (n == kMostStructures)
      return unsupported("labels-too-many", {"labels-too-many", {quoted(path)}});
    Segment segment;
    segment.structure.name = shownName(name.value_or(""));
    if (const auto colour = find("Color"))
      if (const auto read = colourFrom(*colour)) {
        segment.structure.colour = *read;
        segment.coloured = true;
      }
    segment.layer = std::int64_t(n);
    for (const auto& [key, number] :
         {std::pair{"LabelValue", &segment.label}, {"Layer", &segment.layer}}) {
      const auto stated = find(key);
      // a single layer goes without saying
      if (!stated && key == std::string_view{"Layer"} && find("LabelValue")) *number = 0;
      if (!stated) continue;
      const auto read = integerOf(trimmed(*stated));
      if (!read || *read < 0 || (*read == 0 && number == &segment.label))
        return wrongField(path, prefix + key);
      *number = *read;
    }
    if (!seen.insert({segment.layer, segment.label}).second)
      return wrongField(path, prefix + "LabelValue");
    segments.push_back(std::move(segment));
  }
}

}  // namespace datasets
