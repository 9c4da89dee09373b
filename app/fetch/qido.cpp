// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/qido.h"

#include <nlohmann/json.hpp>

#include "haptics/process/input_file.h"

namespace app::fetch {

using haptics::Expected;
using nlohmann::json;

namespace {

constexpr int kDeepest = 32;                // sequences in sequences
constexpr std::size_t kLongestText = 1024;  // bytes of a value that is kept

tl::unexpected<haptics::Error> noList() {
  return refused("answer", {"fetch-web-answer-senseless", {}});
}

/// The array of an answer; an empty answer is an empty array.
Expected<json> parsed(std::string_view text) {
  if (text.size() > kMostJson) return refused("too-many", {"fetch-answer-too-large", {}});
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return json::array();
  if (haptics::isNestedDeeper(text, kDeepest)) return noList();
  json all = json::parse(text, nullptr, false);
  if (!all.is_array()) return noList();
  return all;
}

/// The first value of an attribute, as text.
std::string valueOf(const json& entry, const char* tag) {
  const auto attribute = entry.find(tag);
  if (attribute == entry.end() || !attribute->is_object()) return {};
  const auto values = attribute->find("Value");
  if (values == attribute->end() || !values->is_array() || values->empty()) return {};
  const json* value = &values->front();
  if (value->is_object()) {  // a name
    const auto name = value->find("Alphabetic");
    if (name == value->end()) return {};
    value = &*name;
  }
  if (value->is_number_integer()) return value->dump();
  if (!value->is_string()) return {};
  const auto& text = value->get_ref<const std::string&>();
  return text.size() > kLongestText ? std::string{} : text;
}

std::optional<std::int64_t> numberOf(const json& entry, const char* tag) {
  const std::string text = valueOf(entry, tag);
  if (text.empty() || text.size() > 12 || text.find_first_not_of("0123456789") != text.npos)
    return {};
  return std::stoll(text);
}

}  // namespace

Expected<Findings> findingsFrom(std::string_view text, Level level) {
  const auto all = parsed(text);
  if (!all) return tl::unexpected(all.error());
  Findings findings;
  for (const json& entry : *all) {
    if (!entry.is_object()) return noList();
    FoundSeries found;
    found.study_uid = valueOf(entry, "0020000D");
    found.series_uid = valueOf(entry, "0020000E");
    // an answer about the series of a study need not repeat the study
    const bool named =
        level == Level::Study
            ? isUid(found.study_uid)
            : isUid(found.series_uid) && (found.study_uid.empty() || isUid(found.study_uid));
    if (!named) {
      ++findings.refused;
      continue;
    }
    found.modality = modalityOf(valueOf(entry, "00080060"));
    found.study_date = dateOf(valueOf(entry, "00080020"));
    found.number = numberOf(entry, "00200011");
    found.images = numberOf(entry, "00201209");
    found.patient_name = valueOf(entry, "00100010");
    found.patient_id = valueOf(entry, "00100020");
    found.study_description = valueOf(entry, "00081030");
    found.series_description = valueOf(entry, "0008103E");
    findings.series.push_back(std::move(found));
  }
  return findings;
}

Expected<std::vector<std::string>> imagesFrom(std::string_view text) {
  const auto all = parsed(text);
  if (!all) return tl::unexpected(all.error());
  std::vector<std::string> images;
  for (const json& entry : *all) {
    if (!entry.is_object()) return noList();
    if (std::string uid = valueOf(entry, "00080018"); isUid(uid)) images.push_back(std::move(uid));
  }
  return images;
}

}  // namespace app::fetch
