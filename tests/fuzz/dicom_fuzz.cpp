// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the files of a folder, cut where a separator stands: the verdict on every series.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/readers/dicom/folder.h"
#include "datasets/readers/files/file_geometry.h"
#include "tests/fuzz/require.h"
#include "tests/support/scratch_folder.h"

namespace {

constexpr std::string_view kSeparator = "\n=file=\n";
constexpr std::size_t kMostFiles = 12;

std::vector<std::filesystem::path> filesOf(const support::ScratchFolder& folder,
                                           std::string_view bytes) {
  std::vector<std::filesystem::path> paths;
  for (std::size_t n = 0; n < kMostFiles; ++n) {
    const auto end = bytes.find(kSeparator);
    paths.push_back(folder.write(std::to_string(n), bytes.substr(0, end)));
    if (end == bytes.npos) break;
    bytes.remove_prefix(end + kSeparator.size());
  }
  return paths;
}

void check(const datasets::DicomSeries& series) {
  fuzz::require(!series.files.empty(), "a series has files");
  const datasets::SeriesVerdict verdict = datasets::verdictOf(series);
  fuzz::require(!verdict.message.empty(), "a verdict has a sentence");
  if (!series.stack) {
    fuzz::require(verdict.verdict == datasets::Verdict::Refused && !verdict.reasons.empty() &&
                      !verdict.reasons.front().empty(),
                  "a refusal has a reason");
    return;
  }
  const datasets::Stack& stack = *series.stack;
  fuzz::require(stack.order.size() == series.files.size(), "every slice has its place");
  fuzz::require(datasets::gridOf(stack.geometry).has_value(), "what can be loaded has a grid");
  // dims of the box beyond its slices' are bounded by them; two regular steps make the most
  fuzz::require(stack.geometry.dims[2] <= 8 * static_cast<std::int64_t>(series.files.size()),
                "few planes are made up");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const support::ScratchFolder folder;
  const auto paths = filesOf(folder, std::string_view(reinterpret_cast<const char*>(bytes), size));
  if (const auto all = datasets::seriesAmong(paths))
    for (const datasets::DicomSeries& series : *all) check(series);
  const datasets::Beginning beginning(paths.front());
  if (datasets::looksLikeDicom(beginning))
    if (const auto some =
            datasets::seriesOf(paths.front(), datasets::readDicomHeader(beginning), {}))
      for (const datasets::DicomSeries& series : *some) check(series);
  for (const auto& path : paths) std::filesystem::remove(path);
  return 0;
}
