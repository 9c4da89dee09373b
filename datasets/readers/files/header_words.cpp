// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/header_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace {

template <class Number>
std::optional<Number> wholeWord(std::string_view word) {
  // as other readers take it; of two signs the second is left to be refused
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  Number number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return number;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string modalityFrom(std::string_view stated) {
  static constexpr std::string_view kWords[] = {
      "ANN",      "AR",         "AS",      "ASMT",     "AU",     "BDUS",  "BI",       "BMD",
      "CD",       "CF",         "CFM",     "CP",       "CR",     "CS",    "CT",       "CTPROTOCOL",
      "DD",       "DF",         "DG",      "DM",       "DMS",    "DOC",   "DS",       "DX",
      "EC",       "ECG",        "EEG",     "EMG",      "EOG",    "EPS",   "ES",       "FA",
      "FID",      "FS",         "GM",      "HC",       "HD",     "IO",    "IOL",      "IVOCT",
      "IVUS",     "KER",        "KO",      "LEN",      "LP",     "LS",    "M3D",      "MA",
      "MG",       "MR",         "MS",      "NM",       "OAM",    "OCT",   "OP",       "OPM",
      "OPR",      "OPT",        "OPTBSV",  "OPTENF",   "OPV",    "OSS",   "OT",       "PA",
      "PLAN",     "POS",        "PR",      "PT",       "PX",     "REG",   "RESP",     "RF",
      "RG",       "RTDOSE",     "RTIMAGE", "RTINTENT", "RTPLAN", "RTRAD", "RTRECORD", "RTSEGANN",
      "RTSTRUCT", "RWV",        "SEG",     "SM",       "SMR",    "SR",    "SRF",      "ST",
      "STAIN",    "TEXTUREMAP", "TG",      "US",       "VA",     "VF",    "XA",       "XAPROTOCOL",
      "XC"};
  return std::ranges::find(kWords, stated) != std::end(kWords) ? std::string(stated)
                                                               : std::string();
}

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
  return wholeWord<std::int64_t>(word);
}

std::optional<double> numberOf(std::string_view word) { return wholeWord<double>(word); }

tl::unexpected<haptics::Error> noNumbers(const std::filesystem::path& header, const char* field) {
  return malformed("bad-header", {"header-no-numbers", {quoted(header), field}});
}

tl::unexpected<haptics::Error> wrongField(const std::filesystem::path& header,
                                          const std::string& field) {
  return malformed("bad-header", {"header-field-wrong", {quoted(header), field}});
}

tl::unexpected<haptics::Error> missingField(const std::filesystem::path& header,
                                            const char* field) {
  return malformed("bad-header", {"header-field-missing", {quoted(header), field}});
}

}  // namespace datasets
