// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd_text.h"

#include <cctype>
#include <charconv>
#include <fstream>

#include "datasets/readers/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::int64_t kLongestHeader = 1 << 20;  // bytes, a list of data files included

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

}  // namespace

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const auto end = std::min(text.find_first_of(" \t"), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

std::optional<std::int64_t> integerOf(std::string_view word) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return number;
}

tl::unexpected<haptics::Error> badHeader(const fs::path& path, const std::string& why) {
  return malformed("bad-header",
                   "The header of " + quoted(path) + " " + why + "; export it again.");
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
    return badHeader(path, "does not begin with NRRD0001 to NRRD0005");
  text.lines = std::string(magic) + "\n";
  bool listing = false, closed = false;
  while (nextLine(line)) {
    if (static_cast<std::int64_t>(in.tellg()) > kLongestHeader)
      return badHeader(path, "is longer than 1 MB");
    const std::string_view content = trimmed(line);
    if (listing) {
      if (!content.empty()) text.listed_files.emplace_back(content);
      if (text.listed_files.size() > kMostDataFiles) return badHeader(path, "lists too many files");
      continue;
    }
    if (content.empty()) {
      closed = true;
      break;
    }
    const auto colon = content.find(':');
    const std::string field = lowered(trimmed(content.substr(0, std::min(colon, content.size()))));
    const bool names_data = field == "data file" || field == "datafile";
    if (!names_data) text.lines.append(content).append("\n");
    if (content.front() == '#' || colon == content.npos) continue;
    if (colon + 1 < content.size() && content[colon + 1] == '=') continue;  // key and value
    const std::string_view value = trimmed(content.substr(colon + 1));
    if (!text.fields.emplace(field, value).second) return badHeader(path, "states a field twice");
    listing = names_data && value.starts_with("LIST");
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
