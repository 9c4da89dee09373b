// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/input.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>

namespace app::fetch {

using haptics::Expected;
using nlohmann::json;

namespace {

constexpr std::size_t kMostBytes = 65536;
constexpr std::size_t kLongestField = 64;      // characters, as the standard has it for most
constexpr std::size_t kLongestSecret = 16384;  // a token may be long

tl::unexpected<haptics::Error> wrong(const char* field) {
  return refused("usage", {"fetch-input-field", {field}});
}

bool isPlain(const std::string& text) {
  // a backslash separates values, and whoever asks for one thing gets two
  return std::ranges::none_of(text,
                              [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; });
}

bool isDateRange(const std::string& text) {
  const auto dash = text.find('-');
  const auto end = [](const std::string& part) { return part.empty() || !dateOf(part).empty(); };
  if (dash == std::string::npos) return end(text);
  return text.size() > 1 && end(text.substr(0, dash)) && end(text.substr(dash + 1));
}

/// The texts of an object, each under its name; nothing if one is unknown or no text.
using Fields = std::initializer_list<std::pair<const char*, std::string*>>;
const char* take(const json& object, Fields fields, std::size_t longest) {
  static thread_local std::string unknown;
  for (const auto& [name, value] : object.items()) {
    const auto field = std::ranges::find_if(fields, [&](const auto& f) { return name == f.first; });
    unknown = name.substr(0, kLongestField);
    if (field == fields.end() || !value.is_string()) return unknown.c_str();
    *field->second = value.get<std::string>();
    if (field->second->size() > longest) return unknown.c_str();
  }
  return nullptr;
}

}  // namespace

Expected<Input> inputFrom(const std::string& text) {
  const json all = json::parse(text, nullptr, false);
  if (!all.is_object()) return refused("usage", {"fetch-input-senseless", {}});
  Input input;
  for (const auto& [name, value] : all.items()) {
    if (name == "query" && value.is_object()) {
      Query& q = input.query;
      if (const char* field = take(value,
                                   {{"patient_id", &q.patient_id},
                                    {"patient_name", &q.patient_name},
                                    {"accession_number", &q.accession_number},
                                    {"study_date", &q.study_date},
                                    {"study_description", &q.study_description},
                                    {"modality", &q.modality}},
                                   kLongestField))
        return wrong(field);
    } else if (name == "login" && value.is_object()) {
      if (const char* field =
              take(value,
                   {{"user", &input.user}, {"password", &input.password}, {"token", &input.token}},
                   kLongestSecret))
        return wrong(field);
    } else if (name == "key_passphrase" && value.is_string()) {
      input.key_passphrase = value.get<std::string>();
    } else if (name == "index" && value.is_number_unsigned() &&
               value.get<std::size_t>() < kMostSeries) {
      input.index = value.get<std::size_t>();
    } else if (name == "check" && value.is_string()) {
      input.check = value.get<std::string>();
    } else {
      return wrong(name.substr(0, kLongestField).c_str());
    }
  }
  const Query& q = input.query;
  for (const std::string* field :
       {&q.patient_id, &q.patient_name, &q.accession_number, &q.study_description, &q.modality})
    if (!isPlain(*field)) return wrong("query");
  if (!isDateRange(q.study_date)) return wrong("study_date");
  for (const std::string* field : {&input.user, &input.password, &input.token})
    if (std::ranges::any_of(*field, [](unsigned char c) { return c < 0x20; }))
      return wrong("login");
  if (input.user.find(':') != std::string::npos) return wrong("user");
  return input;
}

Expected<Input> readInput(int descriptor) {
  std::string text;
  while (text.size() < kMostBytes) {
    char bytes[4096];
    const ssize_t size = read(descriptor, bytes, sizeof bytes);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) break;
    text.append(bytes, static_cast<std::size_t>(size));
    // the other end may keep it open
    const auto last = text.find_last_not_of(" \t\r\n");
    if (last != std::string::npos && text[last] == '}' && json::accept(text)) break;
  }
  return inputFrom(text);
}

}  // namespace app::fetch
