// SPDX-License-Identifier: BSD-3-Clause
// Parts of an NRRD, its several volumes, and its own pages in place of a copy.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "datasets/readers/files/stored_volumes.h"
#include "datasets/readers/nrrd/voxels.h"
#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/core/voxel_memory.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/packed.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::asBytes;
using testing::deflated;
using testing::differing;
using testing::swapped;
using testing::voxelAt;
using testing::Workshop;

constexpr std::array<std::int64_t, 3> kPartDims{11, 7, 5};

int valueAt(std::int64_t i, std::int64_t j, std::int64_t k, std::int64_t volume = 0) {
  return static_cast<int>(i + 11 * (j + 7 * (k + 5 * volume)) - 300);
}

template <class T>
std::string voxels(std::int64_t volume = 0) {
  std::string bytes;
  for (std::int64_t k = 0; k < kPartDims[2]; ++k)
    for (std::int64_t j = 0; j < kPartDims[1]; ++j)
      for (std::int64_t i = 0; i < kPartDims[0]; ++i)
        bytes += asBytes(static_cast<T>(valueAt(i, j, k, volume)));
  return bytes;
}

std::string headerInParts(const std::string& rest, const std::string& type = "short") {
  return "NRRD0005\ntype: " + type +
         "\ndimension: 3\nsizes: 11 7 5\nspace: left-posterior-superior\n"
         "space directions: (0,2,0) (0,0,3) (4,0,0)\nspace origin: (10,20,30)\n" +
         rest;
}

void expectPart(const haptics::Volume& v, const Part& part, const std::string& what) {
  const std::array<std::int64_t, 3> first =
      part.box ? part.box->first : std::array<std::int64_t, 3>{};
  for (std::int64_t k = 0; k < v.grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < v.grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < v.grid.dims[0]; ++i)
        ASSERT_EQ(voxelAt(v, i, j, k), valueAt(first[0] + i * part.step, first[1] + j * part.step,
                                               first[2] + k * part.step))
            << what;
  const Vec3 origin = 1e-3 * Vec3(10.0 + 4.0 * double(first[2]), 20.0 + 2.0 * double(first[0]),
                                  30.0 + 3.0 * double(first[1]));
  EXPECT_LT((v.grid.origin - origin).norm(), 1e-12) << what;
  EXPECT_LT((v.grid.spacing - 1e-3 * part.step * Vec3(2, 3, 4)).norm(), 1e-12) << what;
}

TEST(NrrdParts, AreTakenOfEveryEncoding) {
  Workshop workshop;
  const std::string raw = voxels<std::int16_t>();
  const std::string little = "endian: little\n", big = "endian: big\n";
  std::string ascii, hex;
  for (std::size_t at = 0; at < raw.size(); ++at) {
    const char* digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(raw[at]);
    hex += {digits[byte >> 4], digits[byte & 15]};
  }
  for (std::int64_t n = 0; n < 11 * 7 * 5; ++n) ascii += std::to_string(n - 300) + "\n";
  workshop.write("v.raw", "two\nlines\nabc" + raw);
  workshop.write("v.raw.gz", "a line\n" + deflated("abc" + raw));
  for (int k = 0; k < 5; ++k)
    workshop.write("s" + std::to_string(k) + ".raw", raw.substr(std::size_t(k) * 154, 154));
  const std::vector<std::pair<std::string, std::string>> files{
      {"raw.nrrd", headerInParts(little + "encoding: raw\n\n") + raw},
      {"be.nrrd", headerInParts(big + "encoding: raw\n\n") + swapped(raw, 2)},
      {"gz.nrrd", headerInParts(little + "encoding: gzip\n\n") + deflated(raw)},
      {"gzbe.nrrd", headerInParts(big + "encoding: gzip\n\n") + deflated(swapped(raw, 2))},
      {"gztwo.nrrd", headerInParts(little + "encoding: gzip\n\n") + deflated(raw.substr(0, 300)) +
                         deflated(raw.substr(300))},
      {"gzlast.nrrd",
       headerInParts(little + "encoding: gzip\nbyte skip: -1\n\n") + deflated("odd" + raw)},
      {"double.nrrd", headerInParts(little + "encoding: raw\n\n", "double") + voxels<double>()},
      {"float.nrrd",
       headerInParts(little + "encoding: gz\n\n", "float") + deflated(voxels<float>())},
      {"ascii.nrrd", headerInParts("encoding: ascii\n\n") + ascii},
      {"hex.nrrd", headerInParts(little + "encoding: hex\n\n") + hex},
      {"skips.nhdr",
       headerInParts(little + "encoding: raw\nline skip: 2\nbyte skip: 3\ndata file: v.raw\n")},
      {"last.nhdr", headerInParts(little + "encoding: raw\nbyte skip: -1\ndata file: v.raw\n")},
      {"gzskips.nhdr",
       headerInParts(little + "encoding: gzip\nline skip: 1\nbyte skip: 3\ndata file: v.raw.gz\n")},
      {"many.nhdr", headerInParts(little + "encoding: raw\ndata file: s%d.raw 0 4 1 2\n")}};
  const std::vector<Part> parts{{.step = 2},
                                {.step = 3},
                                {.box = Part::Box{{2, 1, 0}, {9, 6, 4}}},
                                {.step = 2, .box = Part::Box{{3, 0, 1}, {11, 7, 5}}},
                                {.box = Part::Box{{10, 6, 4}, {11, 7, 5}}},
                                {}};
  for (const auto& [name, bytes] : files) {
    const fs::path path = workshop.write(name, bytes);
    for (const Part& part : parts) {
      const auto v = readVolume(path, {.part = part});
      ASSERT_TRUE(v) << name << ": " << sentence(v.error());
      EXPECT_EQ(v->type, name == "double.nrrd" || name == "float.nrrd" ? ScalarType::Float32
                                                                       : ScalarType::Int16);
      expectPart(*v, part, name);
    }
    EXPECT_EQ(readVolume(path, {.part = {.box = Part::Box{{0, 0, 0}, {12, 7, 5}}}}).error().reason,
              "no-voxels");
  }
}

TEST(NrrdParts, AndAllOfADamagedFileAreRefused) {
  Workshop workshop;
  const std::string packed = deflated(voxels<std::int16_t>());
  const auto reason = [&](const std::string& bytes) {
    const fs::path path =
        workshop.write("v.nrrd", headerInParts("endian: little\nencoding: gzip\n\n") + bytes);
    const auto part = readVolume(path, {.part = {.step = 2}}), all = readVolume(path);
    EXPECT_EQ(part.has_value(), all.has_value());
    if (!part && !all) {
      EXPECT_EQ(part.error().reason, all.error().reason);
    }
    return part ? "" : part.error().reason;
  };
  EXPECT_EQ(reason(packed), "");
  EXPECT_EQ(reason(packed.substr(0, packed.size() / 2)), "truncated");
  std::string damaged = packed;
  for (std::size_t i = 100; i < 140; ++i) damaged[i] = static_cast<char>(~damaged[i]);
  EXPECT_EQ(reason(damaged), "truncated");
  EXPECT_EQ(reason(deflated("short")), "truncated");
}

std::string four(const std::string& sizes, const std::string& directions, const std::string& kinds,
                 const std::string& encoding = "raw") {
  return "NRRD0005\ntype: short\ndimension: 4\nsizes: " + sizes +
         "\nspace: left-posterior-superior\nspace directions: " + directions +
         "\nspace origin: (10,20,30)\n" + (kinds.empty() ? "" : "kinds: " + kinds + "\n") +
         "endian: little\nencoding: " + encoding + "\n\n";
}

TEST(NrrdVolumes, OfAFourthAxisAreOffered) {
  Workshop workshop;
  std::string last, first;
  for (int volume = 0; volume < 3; ++volume) last += voxels<std::int16_t>(volume);
  for (std::size_t at = 0; at < last.size() / 3; at += 2)
    for (std::size_t volume = 0; volume < 3; ++volume)
      first += last.substr(volume * last.size() / 3 + at, 2);
  const std::string vectors = "(0,2,0) (0,0,3) (4,0,0)";
  const std::string in_front = "none " + vectors, behind = vectors + " none";
  const std::vector<std::pair<std::string, std::string>> files{
      {"last", four("11 7 5 3", behind, "domain domain domain list") + last},
      {"time", four("11 7 5 3", behind, "space space space time") + last},
      {"unstated", four("11 7 5 3", behind, "") + last},
      {"none", four("3 11 7 5", in_front, "none domain domain domain") + first},
      {"first", four("3 11 7 5", in_front, "list domain domain domain") + first},
      {"packed", four("11 7 5 3", behind, "??? domain domain list", "gzip") + deflated(last)},
      {"packed-first", four("3 11 7 5", in_front, "", "gz") + deflated(first)}};
  for (const auto& [name, bytes] : files) {
    const fs::path path = workshop.write(name + ".nrrd", bytes);
    const auto found = survey(path);
    ASSERT_TRUE(found) << name;
    ASSERT_EQ(found->series.size(), 3U) << name << ": " << sentence(found->series.front().message);
    EXPECT_TRUE(found->several);
    EXPECT_EQ(readVolume(path).error().reason, "which-series");
    for (int volume = 0; volume < 3; ++volume) {
      EXPECT_EQ(found->series[std::size_t(volume)].verdict, Verdict::Sound);
      const auto v = readVolume(path, {.series = volume});
      ASSERT_TRUE(v) << name << ": " << sentence(v.error());
      ASSERT_EQ(v->grid.dims, kPartDims) << name;
      EXPECT_LT((v->grid.worldOf({1, 1, 1}) - Vec3(0.014, 0.022, 0.033)).norm(), 1e-12) << name;
      for (std::int64_t n = 0; n < 11 * 7 * 5; ++n)
        ASSERT_EQ(voxelAt(*v, n % 11, n / 11 % 7, n / 77),
                  valueAt(n % 11, n / 11 % 7, n / 77, volume))
            << name;
    }
    const auto thin = readVolume(path, {.series = 2, .part = {.step = 4}});
    ASSERT_TRUE(thin) << name;
    EXPECT_EQ(voxelAt(*thin, 2, 1, 1), valueAt(8, 4, 4, 2)) << name;
  }
}

TEST(NrrdVolumes, AxesOfOtherKindsAreRefusedByName) {
  Workshop workshop;
  const std::string vectors = "(0,2,0) (0,0,3) (4,0,0)";
  std::string bytes;
  for (int volume = 0; volume < 4; ++volume) bytes += voxels<std::int16_t>(volume);
  for (const char* kind : {"RGBA-color", "4-vector", "quaternion", "vector", "4-color", "point",
                           "normal", "stub", "scalar", "complex"}) {
    const auto v = readVolume(workshop.write(
        "v.nrrd",
        four("4 11 7 5", "none " + vectors, std::string(kind) + " space space space") + bytes));
    ASSERT_FALSE(v) << kind;
    EXPECT_EQ(v.error().reason, "not-scalar") << kind;
    std::string lower = kind;
    for (char& c : lower) c = static_cast<char>(std::tolower(c));
    EXPECT_NE(sentence(v.error()).find("Axis 1 "), std::string::npos) << sentence(v.error());
    EXPECT_NE(sentence(v.error()).find(lower), std::string::npos) << sentence(v.error());
  }
  // a list of flat pictures is no volume
  const auto flat = readVolume(workshop.write(
      "v.nrrd", headerInParts("kinds: domain domain list\nendian: little\nencoding: raw\n\n") +
                    voxels<std::int16_t>()));
  ASSERT_FALSE(flat);
  EXPECT_NE(sentence(flat.error()).find("Axis 3 "), std::string::npos) << sentence(flat.error());
  // nothing says which axis is no place
  EXPECT_EQ(readVolume(workshop.write("v.nrrd",
                                      "NRRD0005\ntype: short\ndimension: 4\nsizes: 11 7 5 "
                                      "4\nendian: little\nencoding: raw\n\n" +
                                          bytes))
                .error()
                .reason,
            "not-scalar");
  // one entry is no choice
  const auto one = survey(workshop.write(
      "v.nrrd", four("11 1 7 5", "(0,2,0) none (0,0,3) (4,0,0)", "space stub space space") +
                    voxels<std::int16_t>()));
  ASSERT_TRUE(one);
  EXPECT_FALSE(one->several);
  ASSERT_EQ(one->series.front().verdict, Verdict::Sound) << sentence(one->series.front().message);
  const auto v = readVolume(one->series.front());
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims, kPartDims);
  EXPECT_EQ(voxelAt(*v, 10, 6, 4), valueAt(10, 6, 4));
  // more than anybody could look through
  EXPECT_EQ(readVolume(workshop.write("v.nrrd", four("1 1 1 20000", vectors + " none", "") +
                                                    std::string(40000, 'a')))
                .error()
                .reason,
            "too-large");
}

StoredVolumes describedWith(const fs::path& path) {
  auto nrrd = parseNrrd(path);
  EXPECT_TRUE(nrrd) << sentence(nrrd.error());
  return std::move(nrrd->stored);
}

TEST(MappedVoxels, AreThoseOfTheFile) {
  Workshop workshop;
  // beyond a page, and not from the beginning of one
  std::string bytes;
  for (int n = 0; n < 64 * 64 * 64; ++n) bytes += asBytes(static_cast<float>(n % 1013));
  const fs::path data = workshop.write("v.raw", std::string(4100, 'x') + bytes);
  const fs::path path = workshop.write(
      "v.nhdr",
      "NRRD0005\ntype: float\ndimension: 3\nsizes: 64 64 64\nspacings: 1 1 1\nendian: "
      "little\nencoding: raw\nbyte skip: 4100\ndata file: v.raw\n");
  const auto read = readVolume(path);
  ASSERT_TRUE(read) << sentence(read.error());
  const StoredVolumes stored = describedWith(path);
  const auto mapped = mapVoxels(stored.voxels, 0);
  ASSERT_TRUE(mapped) << sentence(mapped.error());
  auto* v = static_cast<float*>(mapped->get());
  EXPECT_TRUE(std::equal(v, v + 64 * 64 * 64, static_cast<const float*>(read->voxels.get())));
  // what lies behind can be read, what is written stays in memory
  const auto* behind = reinterpret_cast<const char*>(v + 64 * 64 * 64);
  EXPECT_TRUE(std::all_of(behind, behind + haptics::kVoxelPadding, [](char c) { return c == 0; }));
  v[7] = -1.0F;
  EXPECT_EQ(differing(*read, *readVolume(path)), 0);
  // so can those of another view, which begins with the file's
  const auto memory = haptics::VoxelMemory::of(*mapped);
  ASSERT_TRUE(memory);
  const auto view = memory->privateView().value();
  const auto* w = static_cast<const float*>(view.get());
  EXPECT_TRUE(std::equal(w, w + 64 * 64 * 64, static_cast<const float*>(read->voxels.get())));

  fs::resize_file(data, 4100 + 64 * 64 * 64 * 4 - 1);
  EXPECT_EQ(mapVoxels(stored.voxels, 0).error().reason, "truncated");
}

TEST(MappedVoxels, AreAlignedAndInThisMachinesOrder) {
  StoredVoxels stored;
  stored.layout.sizes = {2048, 2048, 512, 1};
  const Window all{.count = stored.layout.dims()};
  EXPECT_TRUE(isMapped(stored, 0, all));
  EXPECT_FALSE(isMapped(stored, 0, {.count = {2048, 2048, 511}}));
  EXPECT_FALSE(isMapped(stored, 0, {.count = {1024, 1024, 256}, .step = 2}));
  const auto without = [&](auto&& change) {
    StoredVoxels other = stored;
    change(other);
    return isMapped(other, 0, {.count = other.layout.dims()});
  };
  EXPECT_FALSE(without([](StoredVoxels& s) { s.offset = 101; }));
  EXPECT_TRUE(without([](StoredVoxels& s) { s.offset = 102; }));
  EXPECT_FALSE(without([](StoredVoxels& s) { s.deflated = true; }));
  EXPECT_FALSE(without([](StoredVoxels& s) { s.layout.swapped = true; }));
  EXPECT_FALSE(without([](StoredVoxels& s) { s.layout.doubles = true; }));
  EXPECT_FALSE(without([](StoredVoxels& s) { s.layout.sizes = {64, 64, 64, 1}; }));
}

TEST(NrrdThumbnail, IsTheMiddleSlice) {
  Workshop workshop;
  const auto found = survey(workshop.write(
      "v.nrrd", headerInParts("endian: little\nencoding: raw\n\n") + voxels<std::int16_t>()));
  ASSERT_TRUE(found);
  const auto small = thumbnailOf(found->series.front(), 22);
  ASSERT_TRUE(small) << sentence(small.error());
  // 11 x 2 mm by 7 x 3 mm
  EXPECT_EQ(small->width, 22);
  EXPECT_EQ(small->height, 21);
  ASSERT_EQ(small->grey.size(), 22U * 21U);
  // its slices are sagittal, and their rows run towards the head, which is above
  EXPECT_EQ(small->plane, AnatomicalPlane::Sagittal);
  EXPECT_EQ(small->grey.at(20 * 22), 0);
  EXPECT_EQ(small->grey.at(21), 255);
  EXPECT_TRUE(std::is_sorted(small->grey.begin(), small->grey.begin() + 22));
}

TEST(NrrdWriter, AlignsWhatItWrites) {
  Workshop workshop;
  haptics::Grid grid;
  grid.dims = {3, 1, 1};
  auto memory = haptics::allocateVoxels(3, ScalarType::Float32);
  ASSERT_TRUE(memory);
  for (const double spacing : {1.0, 0.5, 0.25, 0.125, 0.0625, 1.0 / 3.0}) {
    grid.spacing = Vec3(spacing, 1, 1);
    const auto v = haptics::makeVolume(grid, ScalarType::Float32, *memory);
    ASSERT_TRUE(v && writeNrrd(*v, workshop.folder() / "v.nrrd"));
    EXPECT_EQ((fs::file_size(workshop.folder() / "v.nrrd") - 12) % 64, 0U) << spacing;
  }
}

}  // namespace
}  // namespace datasets
