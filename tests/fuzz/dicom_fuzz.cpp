// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the files of a folder, cut where a separator stands: the verdict on every series,
// and the first file's structures on a small scan.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/labels/label_file.h"
#include "datasets/readers/dicom/codestream.h"
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

/// Compressed frames are for codestream_fuzz.
void checkStructures(const std::filesystem::path& path, const std::string& syntax) {
  if (datasets::codingOf(syntax)) return;
  static const haptics::Volume scan = [] {
    haptics::Grid grid;
    grid.dims = {4, 3, 2};
    grid.spacing = haptics::Vec3::Constant(1e-3);
    auto voxels = haptics::allocateVoxels(24, haptics::ScalarType::UInt8).value();
    return haptics::makeVolume(grid, haptics::ScalarType::UInt8, std::move(voxels)).value();
  }();
  const auto map = datasets::readLabels(path, scan);
  if (!map) {
    fuzz::require(!map.error().message.empty() && !map.error().reason.empty(),
                  "a refusal has a sentence and a reason");
    return;
  }
  std::vector<std::int64_t> counted(map->structures().size());
  for (int n = 0; n < 24; ++n)
    for (const std::uint8_t number : map->structuresOf(map->codes()[n])) ++counted.at(number);
  for (std::size_t n = 0; n < counted.size(); ++n)
    fuzz::require(counted[n] == map->structures()[n].voxels,
                  "a structure has the voxels it states");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const support::ScratchFolder folder;
  const auto paths = filesOf(folder, std::string_view(reinterpret_cast<const char*>(bytes), size));
  if (const auto all = datasets::seriesAmong(paths))
    for (const datasets::DicomSeries& series : *all) check(series);
  const datasets::Beginning beginning(paths.front());
  if (datasets::looksLikeDicom(beginning)) {
    auto header = datasets::readDicomHeader(beginning);
    if (!header.frames.empty() && datasets::holdsStructures(header.frames.front()))
      checkStructures(paths.front(), header.frames.front().syntax);
    else if (const auto some = datasets::seriesOf(paths.front(), std::move(header), {}))
      for (const datasets::DicomSeries& series : *some) check(series);
  }
  for (const auto& path : paths) std::filesystem::remove(path);
  return 0;
}
