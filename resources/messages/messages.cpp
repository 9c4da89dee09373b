// SPDX-License-Identifier: BSD-3-Clause
#include "resources/messages/messages.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "resources/messages/app.h"
#include "resources/messages/drivers.h"
#include "resources/messages/exports.h"
#include "resources/messages/fetch.h"
#include "resources/messages/readers.h"
#include "resources/messages/recordings.h"
#include "resources/messages/scenes.h"

namespace resources {
namespace {

std::vector<Row> together() {
  std::vector<Row> all;
  for (const std::span<const Row> table : std::initializer_list<std::span<const Row>>{
           kReaders, kDrivers, kRecordings, kScenes, kExports, kApp, kFetch})
    all.insert(all.end(), table.begin(), table.end());
  return all;
}

bool isDigit(char c) { return c >= '1' && c <= '9'; }

/// Where the next place of an argument begins, or the end.
std::size_t placeIn(std::string_view text) {
  for (std::size_t at = text.find('%'); at != text.npos; at = text.find('%', at + 1))
    if (at + 1 < text.size() && (isDigit(text[at + 1]) || text[at + 1] == '(')) return at;
  return text.size();
}

std::string worded(const Row& row, const Wording& wording) {
  return wording.row ? wording.row(row.english) : std::string{row.english};
}

std::string marked(std::string_view numbers, std::string_view decimal_mark) {
  std::string text;
  for (const char c : numbers)
    if (c == '.')
      text += decimal_mark;
    else
      text += c;
  return text;
}

/// In one pass: a "%1" in an argument, which may be the name of a file, stays as it is.
std::string filled(std::string_view row, const std::vector<haptics::Message>& arguments,
                   const Wording& wording) {
  std::string words;
  for (std::size_t at = 0; at < row.size();) {
    const std::string_view rest = row.substr(at);
    const bool plain = rest.size() > 1 && rest[0] == '%' && isDigit(rest[1]);
    const bool unstopped =
        rest.size() > 3 && rest.starts_with("%(") && isDigit(rest[2]) && rest[3] == ')';
    const std::size_t which =
        plain || unstopped ? static_cast<std::size_t>(rest[plain ? 1 : 2] - '1') : arguments.size();
    if (which >= arguments.size()) {
      words += rest[0];
      ++at;
      continue;
    }
    words += sentence(arguments[which], wording);
    if (unstopped && words.ends_with('.')) words.pop_back();
    at += plain ? 2 : 4;
  }
  return words;
}

}  // namespace

std::span<const Row> rows() {
  static const std::vector<Row> all = together();
  return all;
}

std::string sentence(const haptics::Message& message, const Wording& wording) {
  if (message.id.empty())
    return message.of_numbers ? marked(message.text, wording.decimal_mark) : message.text;
  const std::span<const Row> all = rows();
  const auto row = std::ranges::find(all, message.id, &Row::id);
  if (row != all.end()) return filled(worded(*row, wording), message.arguments, wording);
  std::string words = message.id;
  for (std::size_t i = 0; i < message.arguments.size(); ++i)
    words += (i == 0 ? ": " : ", ") + sentence(message.arguments[i], wording);
  return words;
}

const Row* rowIn(std::string_view words, const Wording& wording) {
  constexpr std::size_t kTooLittle = 12;  // "%1: %2" stands in nearly every sentence
  const Row* best = nullptr;
  std::size_t most = kTooLittle;
  for (const Row& row : rows()) {
    // the parts between the arguments, in their order
    std::size_t at = 0, matched = 0;
    bool all = true;
    const std::string text = worded(row, wording);
    for (std::string_view rest = text; all && !rest.empty();) {
      const std::size_t end = placeIn(rest);
      const std::string_view part = rest.substr(0, end);
      const std::size_t found = words.find(part, at);
      all = found != std::string_view::npos;
      at = found + part.size();
      matched += part.size();
      rest.remove_prefix(end);
      if (!rest.empty()) rest.remove_prefix(rest.starts_with("%(") ? 4 : 2);
    }
    if (all && matched > most) {
      most = matched;
      best = &row;
    }
  }
  return best;
}

std::string sentence(const haptics::Error& error, const Wording& wording) {
  return sentence(error.message, wording);
}

}  // namespace resources
