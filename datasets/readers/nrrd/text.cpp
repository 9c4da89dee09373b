// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/text.h"

#include <fstream>

#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::size_t kLongestField = 400;  // characters; numbers need some hundred

bool isOneOf(std::string_view name, std::string_view one, std::string_view other) {
  return name == one || name == other;
}

}  // namespace

bool isList(std::string_view data_file) {
  const auto words = wordsOf(data_file);
  return !words.empty() && words.front() == "LIST";
}

Expected<NrrdText> readNrrdText(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return notFound(path);
  const auto nextLine = [&](std::string& line) {
    line.clear();
    for (int c = in.get(); c != std::ifstream::traits_type::eof(); c = in.get()) {
      if (c == '\n') return true;
      line.push_back(static_cast<char>(c));
      if (static_cast<std::int64_t>(line.size()) > kLongestHeader) return false;
    }
    return !line.empty();
  };

  NrrdText text;
  std::string line;
  nextLine(line);
  const std::string_view magic = trimmed(line);
  if (!magic.starts_with("NRRD000") || magic.size() != 8 || magic[7] < '1' || magic[7] > '5')
    return malformed("bad-header", {"nrrd-no-magic", {quoted(path)}});
  text.lines = std::string(magic) + "\n";
  bool listing = false, closed = false;
  while (nextLine(line)) {
    if (static_cast<std::int64_t>(in.tellg()) > kLongestHeader)
      return malformed("bad-header", {"header-unreadable", {quoted(path)}});
    const std::string_view content = trimmed(line);
    if (listing) {
      if (!content.empty()) text.listed_files.emplace_back(content);
      if (text.listed_files.size() > kMostDataFiles)
        return malformed("bad-header", {"header-unreadable", {quoted(path)}});
      continue;
    }
    if (content.empty()) {
      closed = true;
      break;
    }
    const auto colon = content.find(':');
    const std::string field = lowered(trimmed(content.substr(0, std::min(colon, content.size()))));
    const bool names_data = isOneOf(field, "data file", "datafile");
    const bool skips =
        isOneOf(field, "line skip", "lineskip") || isOneOf(field, "byte skip", "byteskip");
    if (!names_data) (skips ? text.skips : text.lines).append(content).append("\n");
    if (content.front() == '#') continue;
    const bool named = colon != content.npos;
    if (named && content.substr(colon + 1).starts_with('=')) {
      text.keys.emplace(content.substr(0, colon), content.substr(colon + 2));
      continue;
    }
    // teem writes what it cannot parse into a message of fixed size, with words around it
    if (content.size() > kLongestField && field != "content")
      return malformed("bad-header", {"header-unreadable", {quoted(path)}});
    if (!named) continue;
    const std::string_view value = trimmed(content.substr(colon + 1));
    if (!text.fields.emplace(field, value).second)
      return malformed("bad-header", {"header-unreadable", {quoted(path)}});
    listing = names_data && isList(value);
  }
  if (!closed) in.clear();
  text.bytes = closed ? static_cast<std::int64_t>(in.tellg()) : 0;
  return text;
}

const std::string* NrrdText::find(const char* name, const char* other) const {
  auto it = fields.find(name);
  if (it == fields.end() && other != nullptr) it = fields.find(other);
  return it == fields.end() ? nullptr : &it->second;
}

}  // namespace datasets
