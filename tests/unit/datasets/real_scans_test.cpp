// SPDX-License-Identifier: BSD-3-Clause
// NRRD and meshes that others made. The same faults are looked for in made files, by the tests of
// the readers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "datasets/readers/meshes/tool_mesh.h"
#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/alike.h"
#include "tests/unit/datasets/cancelled.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::differing;
using testing::expectCancelEnds;
using testing::expectCancelLeavesInflating;
using testing::scan;
using testing::voxelAt;
using testing::Workshop;

struct Listed {
  const char* name;
  std::array<std::int64_t, 3> dims;
  Vec3 spacing_mm;
  ScalarType type;
  double least, greatest;
  bool orientation_known;
};

TEST(RealScans, ScansAreWhatTheirListSays) {
  const Listed expected[] = {
      {"stanford_bunny/bunny_512x512x361_airflat.nrrd",
       {512, 512, 361},
       {0.337891, 0.337891, 0.5},
       ScalarType::Int16,
       0,
       4095,
       true},
      {"stanford_bunny/bunny_exact_crop_200x200x80.nrrd",
       {200, 200, 80},
       {0.337891, 0.337891, 0.5},
       ScalarType::UInt16,
       0,
       2537,
       true},
      {"volvis_classics/engine.nhdr", {256, 256, 128}, {1, 1, 1}, ScalarType::UInt8, 0, 255, false},
      {"seg3d_tooth/tooth.nhdr", {103, 94, 161}, {1, 1, 1}, ScalarType::UInt16, 0, 1300, false},
      {"stanford_cthead/cthead_256x256x113_be.nrrd",
       {256, 256, 113},
       {1, 1, 2},
       ScalarType::UInt16,
       0,
       3272,
       true}};
  for (const Listed& said : expected) {
    NEEDS_SCAN(scan(said.name));
    const auto v = readVolume(scan(said.name));
    ASSERT_TRUE(v) << said.name << ": " << sentence(v.error());
    EXPECT_EQ(v->grid.dims, said.dims) << said.name;
    EXPECT_LT((1e3 * v->grid.spacing - said.spacing_mm).norm(), 1e-12) << said.name;
    EXPECT_EQ(v->type, said.type) << said.name;
    EXPECT_EQ(v->least, said.least) << said.name;
    EXPECT_EQ(v->greatest, said.greatest) << said.name;
    EXPECT_EQ(v->orientation_known, said.orientation_known) << said.name;
    EXPECT_EQ(v->unit, "") << said.name;
  }
}

TEST(RealScans, EqualPlacementGivesEqualValuesInTheWorld) {
  const fs::path folder = scan("nrrd_oddities/derived_from_tooth");
  NEEDS_SCAN(folder);
  const auto lps = readVolume(folder / "space_lps.nrrd");
  ASSERT_TRUE(lps) << sentence(lps.error());
  for (const char* name : {"space_ras.nrrd", "space_las_flipped_axes.nrrd"}) {
    const auto other = readVolume(folder / name);
    ASSERT_TRUE(other) << name << ": " << sentence(other.error());
    std::int64_t unequal = 0;
    for (std::int64_t k = 0; k < 40; ++k)
      for (std::int64_t j = 0; j < 40; ++j)
        for (std::int64_t i = 0; i < 45; ++i) {
          const Vec3 at = other->grid.indexOf(lps->grid.worldOf(
              Vec3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))));
          const Vec3 near = at.array().round();
          ASSERT_LT((at - near).norm(), 1e-9) << name;
          unequal +=
              voxelAt(*lps, i, j, k) != voxelAt(*other, std::llround(near.x()),
                                                std::llround(near.y()), std::llround(near.z()))
                  ? 1
                  : 0;
        }
    EXPECT_EQ(unequal, 0) << name;
  }
}

TEST(RealScans, LeftHandedAxesStayAsInTheFile) {
  const fs::path path = scan("nrrd_oddities/derived_from_tooth/left_handed.nrrd");
  NEEDS_SCAN(path);
  const auto v = readVolume(path);
  ASSERT_TRUE(v);
  EXPECT_NEAR(v->grid.direction.determinant(), -1.0, 1e-12);
  EXPECT_LT((v->grid.worldOf({0, 0, 1}) - Vec3(0, 0, -0.002)).norm(), 1e-12);
}

TEST(RealScans, EveryEncodingGivesTheSameVoxels) {
  const fs::path folder = scan("nrrd_oddities/derived_from_tooth");
  NEEDS_SCAN(folder);
  const auto plain = readVolume(folder / "raw_le.nrrd");
  ASSERT_TRUE(plain) << sentence(plain.error());
  for (const char* name : {"raw_be.nrrd", "bzip2.nrrd", "crlf_header.nrrd", "detached_gzip.nhdr",
                           "no_spacing.nrrd", "old_magic_NRRD0001.nrrd", "space_lps.nrrd",
                           "keyvalue_and_minmax.nrrd", "oblique_orthonormal.nrrd"}) {
    const auto v = readVolume(folder / name);
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_EQ(differing(*plain, *v), 0) << name;
  }
  const auto ascii = readVolume(folder / "ascii.nrrd"), hex = readVolume(folder / "hex_be.nrrd");
  ASSERT_TRUE(ascii && hex);
  EXPECT_EQ(differing(*ascii, *hex), 0);
  const auto list = readVolume(folder / "multifile_list.nhdr");
  const auto pattern = readVolume(folder / "multifile_pattern.nhdr");
  ASSERT_TRUE(list && pattern);
  EXPECT_EQ(differing(*list, *pattern), 0);
  // a full-resolution neighbour of the same tooth: every second voxel from (10, 10, 30)
  const auto tooth = readVolume(scan("seg3d_tooth/tooth.nhdr"));
  ASSERT_TRUE(tooth);
  for (std::int64_t k = 0; k < 40; k += 7)
    for (std::int64_t j = 0; j < 40; j += 3)
      for (std::int64_t i = 0; i < 45; ++i)
        ASSERT_EQ(voxelAt(*plain, i, j, k), voxelAt(*tooth, 10 + 2 * i, 10 + 2 * j, 30 + 2 * k));

  const fs::path balls = scan("nrrd_oddities/pynrrd");
  const auto ball = readVolume(balls / "BallBinary30x30x30.nrrd");
  ASSERT_TRUE(ball);
  for (const char* name :
       {"BallBinary30x30x30.nhdr", "BallBinary30x30x30_bz2.nrrd", "BallBinary30x30x30_gz.nrrd",
        "BallBinary30x30x30_byteskip_minus_one.nhdr",
        "BallBinary30x30x30_byteskip_minus_one_nifti.nhdr",
        "BallBinary30x30x30_gz_lineskip.nrrd"}) {
    const auto v = readVolume(balls / name);
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_EQ(differing(*ball, *v), 0) << name;
  }
}

TEST(RealScans, NonFiniteVoxelsBecomeBackgroundAndAreCounted) {
  const fs::path path = scan("nrrd_oddities/derived_from_tooth/float_nan_inf.nrrd");
  NEEDS_SCAN(path);
  const auto v = readVolume(path);
  ASSERT_TRUE(v);
  EXPECT_EQ(v->replaced, 2 * 2 * 40 + 3);
  EXPECT_EQ(voxelAt(*v, 5, 5, 5), v->least);
  EXPECT_EQ(voxelAt(*v, 6, 6, 6), v->least);
}

TEST(RealScans, NrrdIsRefusedByName) {
  const std::map<std::string, std::string> expected = {
      {"derived_from_tooth/2d_slice.nrrd", "not-scalar"},
      {"derived_from_tooth/4d_list_last_axis.nrrd", "which-series"},
      {"derived_from_tooth/4d_vector_first_axis.nrrd", "not-scalar"},
      {"derived_from_tooth/nan_spacing_axis.nrrd", "bad-header"},
      {"derived_from_tooth/sheared_gantry_like.nrrd", "sheared"},
      {"malformed/bad_magic.nrrd", "bad-header"},
      {"malformed/empty.nrrd", "bad-header"},
      {"malformed/header_only.nrrd", "truncated"},
      {"malformed/huge_sizes.nrrd", "truncated"},
      {"malformed/missing_data_file.nhdr", "truncated"},
      {"malformed/missing_sizes.nrrd", "bad-header"},
      {"malformed/short_raw.nrrd", "truncated"},
      {"malformed/truncated_gzip.nrrd", "truncated"},
      {"malformed/unknown_encoding.nrrd", "unsupported-syntax"},
      {"pynrrd/BallBinary30x30x30_byteskip_minus_five.nhdr", "bad-header"},
      {"pynrrd/BallBinary30x30x30_nifti.nhdr", "bad-header"},
      {"pynrrd/test1d_ascii.nrrd", "not-scalar"}};
  for (const auto& [name, reason] : expected) {
    NEEDS_SCAN(scan("nrrd_oddities/" + name));
    const auto v = readVolume(scan("nrrd_oddities/" + name));
    ASSERT_FALSE(v) << name;
    EXPECT_EQ(v.error().reason, reason) << name;
    EXPECT_TRUE(sentence(v.error()).ends_with('.')) << sentence(v.error());
  }
}

TEST(RealScans, CancelEndsTheReadOfAnNrrd) {
  const fs::path path = scan("stanford_bunny/bunny_512x512x361_airflat.nrrd");
  NEEDS_SCAN(path);
  expectCancelEnds(path);
}

TEST(RealScans, CancelWhileAllIsInflatedAtOnceLeavesTheRestOfItBehind) {
  const fs::path path = scan("stanford_bunny/bunny_512x512x361_airflat.nrrd");
  NEEDS_SCAN(path);
  expectCancelLeavesInflating(path);
}

TEST(RealScans, RealTools) {
  struct ListedTool {
    const char* name;
    std::size_t triangles;
    Vec3 box_mm;
  };
  const ListedTool expected[] = {
      {"tools/chai3d_drill.stl", 886, {227, 20.3, 20.0}},
      {"tools/chai3d_endoscope.stl", 8761, {4.7, 0.87, 1.4}},
      {"tools/chai3d_tooth.obj", 8768, {232, 294, 502}},
      {"tools/metaworld_assembly_peg_ring.stl", 1152, {0.13, 0.13, 0.029}}};
  for (const ListedTool& said : expected) {
    NEEDS_SCAN(scan(said.name));
    const auto tool = readToolMesh(scan(said.name), MeshUnit::Millimetre);
    ASSERT_TRUE(tool) << said.name << ": " << sentence(tool.error());
    EXPECT_EQ(tool->mesh.triangles.size(), said.triangles) << said.name;
    Vec3 low = tool->mesh.vertices.front(), high = low;
    for (const Vec3& v : tool->mesh.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    EXPECT_LT((1e3 * (high - low) - said.box_mm).norm(), 0.025 * said.box_mm.norm()) << said.name;
  }
  EXPECT_EQ(
      readToolMesh(scan("tools/chai3d_drill.stl"), MeshUnit::Millimetre)->mesh.vertices.size(),
      445u);
}

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

TEST(RealScans, EveryScanComesBackFromItsNrrdAlike) {
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
      testing::expectAlike(*volume, *back);
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
