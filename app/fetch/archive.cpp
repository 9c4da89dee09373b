// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/archive.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <tuple>

namespace app::fetch {

using haptics::Error;

std::string Server::name() const {
  if (isWeb()) return url;
  const bool v6 = host.find(':') != std::string::npos;
  return (v6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

bool Query::isEmpty() const {
  for (const std::string* field :
       {&patient_id, &patient_name, &accession_number, &study_date, &study_description, &modality})
    if (field->find_first_not_of("*? ") != std::string::npos) return false;
  return true;
}

bool isUid(const std::string& text) {
  if (text.empty() || text.size() > 64 || text.front() == '.' || text.back() == '.') return false;
  if (text.find("..") != std::string::npos) return false;
  return std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
}

std::string modalityOf(const std::string& text) {
  static constexpr std::array<std::string_view, 24> kKnown{
      "CR", "CT", "DX", "ES",     "IO",     "KO",       "MG", "MR",  "NM", "OCT", "OP", "PR",
      "PT", "PX", "RF", "RTDOSE", "RTPLAN", "RTSTRUCT", "SC", "SEG", "SR", "US",  "XA", "XC"};
  const auto end = text.find_last_not_of(" \0");
  const std::string word = text.substr(0, end == std::string::npos ? 0 : end + 1);
  return std::ranges::find(kKnown, word) != kKnown.end() ? word : "OT";
}

std::string dateOf(const std::string& text) {
  const bool date =
      text.size() == 8 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  return date ? text : std::string{};
}

void sortSeries(std::vector<FoundSeries>& series) {
  const auto key = [](const FoundSeries& s) {
    return std::tie(s.study_uid, s.number, s.series_uid);
  };
  std::ranges::sort(series, [&](const FoundSeries& a, const FoundSeries& b) {
    if (a.study_date != b.study_date) return a.study_date > b.study_date;
    return key(a) < key(b);
  });
  // clang 14 does not take the subrange of libstdc++'s std::ranges::unique
  const auto repeated =
      std::unique(series.begin(), series.end(), [](const FoundSeries& x, const FoundSeries& y) {
        return x.study_uid == y.study_uid && x.series_uid == y.series_uid;
      });
  series.erase(repeated, series.end());
}

std::string checkOf(const FoundSeries& series) {
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (const char c : series.study_uid + "/" + series.series_uid)
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  char text[9];
  std::snprintf(text, sizeof text, "%08x", hash);
  return text;
}

tl::unexpected<Error> refused(const char* reason, haptics::Message message) {
  return tl::unexpected(Error{Error::Kind::Unsupported, std::move(message), reason});
}

tl::unexpected<Error> failed(const char* reason, haptics::Message message) {
  return tl::unexpected(Error{Error::Kind::NotFound, std::move(message), reason});
}

tl::unexpected<Error> cancelled() {
  return tl::unexpected(Error{Error::Kind::Cancelled, {"fetch-cancelled", {}}, "cancelled"});
}

bool isLoss(const Error& error) {
  return error.reason == "lost" || error.reason == "silent" || error.reason == "port";
}

}  // namespace app::fetch
