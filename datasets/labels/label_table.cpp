// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/label_table.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/labels/label_map.h"
#include "datasets/labels/segments.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/meshes/polygons.h"

namespace datasets {

using haptics::Expected;

namespace {

/// The words of a line, a text in quotes as one; none where a quote is not closed.
std::vector<std::string_view> quotedWordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    if (line.front() != '"') {
      words.push_back(takeWord(line));
      continue;
    }
    const auto end = line.find('"', 1);
    if (end == line.npos) return {};
    words.push_back(line.substr(1, end - 1));
    line.remove_prefix(end + 1);
  }
  return words;
}

/// Three numbers from 0 to 255.
std::optional<std::array<double, 3>> colourAt(const std::vector<std::string_view>& words,
                                              std::size_t first) {
  std::array<double, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto channel = numberOf(words[first + c]);
    if (!channel || !(*channel >= 0.0 && *channel <= 255.0)) return {};
    colour[c] = *channel / 255.0;
  }
  return colour;
}

bool areNumbers(const std::vector<std::string_view>& words, std::size_t first, std::size_t count) {
  for (std::size_t n = first; n < first + count; ++n)
    if (!numberOf(words[n])) return false;
  return true;
}

/// Of ITK-SNAP: number, three of the colour, opacity, two switches, name. Of the others: number,
/// name, three of the colour, opacity.
std::optional<std::pair<std::int64_t, NamedLabel>> namedBy(std::string_view line) {
  const auto words = quotedWordsOf(line);
  if (words.size() < 6) return {};
  const auto number = integerOf(words[0]);
  if (!number || *number < 0) return {};
  const bool name_is_last = words.size() == 8 && areNumbers(words, 1, 6);
  if (!name_is_last && !areNumbers(words, words.size() - 4, 4)) return {};
  const auto colour = colourAt(words, name_is_last ? 1 : words.size() - 4);
  if (!colour) return {};
  std::string name;
  if (name_is_last)
    name = words.back();
  else
    for (std::size_t n = 1; n < words.size() - 4; ++n) {
      if (n > 1) name += ' ';
      name += words[n];
    }
  return std::pair{*number, NamedLabel{shownName(name), *colour}};
}

}  // namespace

Expected<std::map<std::int64_t, NamedLabel>> readLabelTable(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return notFound(path);
  if (std::filesystem::file_size(path, error) > std::uintmax_t{kLongestHeader})
    return unsupported("too-large", {"labels-table-too-large", {quoted(path)}});
  std::ifstream in(path, std::ios::binary);
  if (!in) return notFound(path);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::string_view text = bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::map<std::int64_t, NamedLabel> table;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(takeLine(text));
    if (line.empty() || line.starts_with('#')) continue;
    auto named = namedBy(line);
    if (!named)
      return malformed("bad-header", {"labels-table-line", {quoted(path), std::to_string(number)}});
    if (!table.insert(std::move(*named)).second)
      return malformed("bad-header",
                       {"labels-table-twice", {quoted(path), std::to_string(number)}});
  }
  if (table.empty()) return malformed("bad-header", {"labels-table-empty", {quoted(path)}});
  return table;
}

}  // namespace datasets
