// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the JSON of a server's list: by the first byte of studies, series or images.
#include <cstdint>
#include <string_view>

#include "app/fetch/qido.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace app::fetch;
  if (size < 1) return 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  const auto refused = [](const haptics::Error& error) {
    fuzz::require(!error.message.empty() && !error.reason.empty(),
                  "a refusal has a sentence and a reason");
  };
  if (bytes[0] % 3 == 2) {
    const auto images = imagesFrom(text);
    if (!images) return refused(images.error()), 0;
    for (const std::string& uid : *images) fuzz::require(isUid(uid), "an image has an identifier");
    return 0;
  }
  const bool studies = bytes[0] % 3 == 0;
  auto found = findingsFrom(text, studies ? Level::Study : Level::Series);
  if (!found) return refused(found.error()), 0;
  for (const FoundSeries& series : found->series) {
    fuzz::require(isUid(studies ? series.study_uid : series.series_uid), "it has an identifier");
    fuzz::require(series.study_uid.find_first_not_of("0123456789.") == std::string::npos,
                  "an identifier that becomes a part of a URL is one");
    fuzz::require(modalityOf(series.modality) == series.modality, "the modality is a known word");
    fuzz::require(series.study_date.empty() || series.study_date.size() == 8, "a date is one");
    fuzz::require(!series.images || *series.images >= 0, "a number of images is none or more");
  }
  sortSeries(found->series);
  const auto once = found->series;
  sortSeries(found->series);
  fuzz::require(once == found->series, "the order is settled");
  return 0;
}
