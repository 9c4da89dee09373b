// SPDX-License-Identifier: BSD-3-Clause
// Every scan beside the checkout that can be loaded, written as NRRD and read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using testing::Workshop;

constexpr double kExact_mm = 1e-9;

/// The folders that hold files themselves.
std::set<fs::path> foldersOfFiles(const fs::path& root) {
  std::set<fs::path> folders;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file()) folders.insert(entry.path().parent_path());
  return folders;
}

/// What can be loaded of a folder: of its series, and where some images are copies of others (in
/// other encodings) of each of its files.
std::vector<SeriesVerdict> loadableIn(const fs::path& folder) {
  std::vector<SeriesVerdict> loadable;
  const auto keep = [&](const fs::path& path) {
    const auto found = survey(path);
    bool copies = false;
    if (!found) return copies;
    for (const SeriesVerdict& verdict : found->series) {
      if (verdict.verdict != Verdict::Refused) loadable.push_back(verdict);
      copies = copies || std::ranges::count(verdict.reasons, "duplicate") > 0;
    }
    return copies;
  };
  if (!keep(folder)) return loadable;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.is_regular_file()) keep(file.path());
  return loadable;
}

void expectAlike(const haptics::Volume& a, const haptics::Volume& b) {
  ASSERT_EQ(a.grid.dims, b.grid.dims);
  EXPECT_LT(1e3 * (a.grid.spacing - b.grid.spacing).cwiseAbs().maxCoeff(), kExact_mm);
  EXPECT_LT(1e3 * (a.grid.origin - b.grid.origin).cwiseAbs().maxCoeff(), kExact_mm);
  // as far as the last voxel
  const haptics::Vec3 end(double(a.grid.dims[0] - 1), double(a.grid.dims[1] - 1),
                          double(a.grid.dims[2] - 1));
  EXPECT_LT(1e3 * (a.grid.worldOf(end) - b.grid.worldOf(end)).cwiseAbs().maxCoeff(), kExact_mm);
  EXPECT_LT((a.grid.direction - b.grid.direction).cwiseAbs().maxCoeff(), 1e-12);
  ASSERT_EQ(a.type, b.type);
  EXPECT_EQ(a.least, b.least);
  EXPECT_EQ(a.greatest, b.greatest);
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.modality, b.modality);
  EXPECT_EQ(a.orientation_known, b.orientation_known);
  const auto bytes = static_cast<std::size_t>(a.grid.voxelCount()) * haptics::sizeOf(a.type);
  EXPECT_EQ(std::memcmp(a.voxels.get(), b.voxels.get(), bytes), 0) << "voxels differ";
}

TEST(RoundTrip, EveryScanComesBackFromItsNrrdAlike) {
  const fs::path scans(places::scan());
  NEEDS_SCAN(scans);
  Workshop workshop;
  const fs::path out = workshop.folder() / "out.nrrd";
  std::set<haptics::ScalarType> types;
  int volumes = 0, sideless = 0, turned = 0;
  for (const fs::path& folder : foldersOfFiles(scans))
    for (const SeriesVerdict& chosen : loadableIn(folder)) {
      SCOPED_TRACE(folder.filename().string() + ", series " + std::to_string(chosen.index));
      const auto volume = readVolume(chosen, {.geometry = Geometry::Corrected});
      if (!volume) {  // a verdict is drawn from headers, and here the voxels end early
        EXPECT_EQ(volume.error().reason, "truncated");
        continue;
      }
      ASSERT_TRUE(writeNrrd(*volume, out));
      const auto back = readVolume(out);
      ASSERT_TRUE(back) << sentence(back.error());
      expectAlike(*volume, *back);
      types.insert(volume->type);
      ++volumes;
      sideless += !volume->orientation_known;
      turned += !volume->grid.direction.isIdentity(1e-9);
    }
  std::printf("%d volumes, %d without sides, %d turned, %zu types\n", volumes, sideless, turned,
              types.size());
  // the scans at hand are of all these kinds
  EXPECT_GT(volumes, 60);
  EXPECT_GT(sideless, 5);
  EXPECT_GT(turned, 10);
  EXPECT_GE(types.size(), 4U);
}

}  // namespace
}  // namespace datasets
