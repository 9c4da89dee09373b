// SPDX-License-Identifier: BSD-3-Clause
// NRRD files made here: ways to write the same voxels, refusals by name, and cancelling.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>

#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/cancelled.h"
#include "tests/unit/datasets/packed.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using testing::asBytes;
using testing::deflated;
using testing::differing;
using testing::expectCancelEnds;
using testing::expectCancelLeavesInflating;
using testing::reasonFor;
using testing::voxelAt;
using testing::Workshop;

/// 5 x 4 x 3 voxels, each different from all others.
std::string sixtyVoxels() {
  std::string bytes;
  for (std::int16_t v = 0; v < 60; ++v) bytes += asBytes(v);
  return bytes;
}

/// The same, packed by bzip2 1.0.8.
constexpr char kPackedByBzip2[] =
    "\x42\x5a\x68\x39\x31\x41\x59\x26\x53\x59\x54\xa9\xeb\xbb\x00\x00\x00\xf8\x00\x7f"
    "\xff\xff\xff\xff\xff\xff\xf8\x20\x00\x54\x66\x80\x00\x00\x00\x00\x00\x00\x1a\x0c"
    "\x06\x80\x00\x06\x80\x00\x00\x00\x07\xc3\x08\x39\x04\x80\xa2\xcc\x34\xe3\xd0\x45"
    "\x24\xd4\x55\x65\xd8\x65\xa6\xdc\x0b\xaf\x3f\x04\x31\x47\x24\xb3\x4f\x45\x35\x57"
    "\x65\xb7\x5f\x86\x39\x67\xae\xdb\xf1\xcf\x5d\xf9\xe8\x7e\x08\x00\x20\x01\xf8\xbb"
    "\x92\x29\xc2\x84\x82\xa5\x4f\x5d\xd8";

TEST(NrrdMade, EveryWayToWriteItGivesTheSameVoxels) {
  Workshop workshop;
  const std::string shape = "type: short\ndimension: 3\nsizes: 5 4 3\n",
                    raw = "endian: little\nencoding: raw\n";
  const auto plain =
      readVolume(workshop.write("plain.nrrd", "NRRD0005\n" + shape + raw + "\n" + sixtyVoxels()));
  ASSERT_TRUE(plain) << sentence(plain.error());
  std::string lines = "NRRD0004\n" + shape + raw + "\n", crlf;
  for (const char c : lines) crlf += c == '\n' ? std::string{"\r\n"} : std::string{c};
  for (int k = 0; k < 3; ++k)
    workshop.write("slice" + std::to_string(k) + ".raw",
                   sixtyVoxels().substr(std::size_t(k) * 40, 40));
  const std::map<std::string, std::string> files{
      {"bzip2.nrrd", "NRRD0004\n" + shape + "endian: little\nencoding: bzip2\n\n" +
                         std::string{kPackedByBzip2, sizeof kPackedByBzip2 - 1}},
      {"crlf.nrrd", crlf + sixtyVoxels()},
      // what the first version of the format had
      {"old.nrrd",
       "NRRD0001\ncontent: ramp\n" + shape + "spacings: 1 1 1\n" + raw + "\n" + sixtyVoxels()},
      {"keys.nrrd", "NRRD0004\n# a comment\n" + shape +
                        "min: -7\nmax: 70\nmodality:=CT\nwho:=a: b\n" + raw + "\n" + sixtyVoxels()},
      {"list.nhdr",
       "NRRD0004\n" + shape + raw + "data file: LIST\nslice0.raw\nslice1.raw\nslice2.raw\n"},
      {"pattern.nhdr", "NRRD0004\n" + shape + raw + "data file: slice%d.raw 0 2 1\n"},
      {"packed.nrrd",
       "NRRD0004\n" + shape + "endian: little\nencoding: gz\n\n" + deflated(sixtyVoxels())}};
  for (const auto& [name, bytes] : files) {
    const auto v = readVolume(workshop.write(name, bytes));
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_EQ(differing(*plain, *v), 0) << name;
  }
}

TEST(NrrdMade, NonFiniteVoxelsBecomeBackgroundAndAreCounted) {
  Workshop workshop;
  std::string bytes;
  for (int n = 0; n < 60; ++n) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    bytes += asBytes(n == 7    ? std::numeric_limits<float>::quiet_NaN()
                     : n == 20 ? kInfinite
                     : n == 41 ? -kInfinite
                               : float(n) - 5.0F);
  }
  const auto v = readVolume(workshop.write(
      "v.nrrd",
      "NRRD0004\ntype: float\ndimension: 3\nsizes: 5 4 3\nendian: little\nencoding: raw\n\n" +
          bytes));
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->replaced, 3);
  EXPECT_EQ(v->least, -5.0);
  EXPECT_EQ(v->greatest, 54.0);
  for (const int n : {7, 20, 41}) EXPECT_EQ(voxelAt(*v, n % 5, n / 5 % 4, n / 20), -5.0) << n;
}

TEST(NrrdMade, RefusesByName) {
  const std::string start = "NRRD0004\ntype: short\n", little = "endian: little\nencoding: raw\n",
                    cube = "dimension: 3\nsizes: 5 4 3\n", voxels = "\n" + sixtyVoxels();
  const std::string space = "space: left-posterior-superior\nspace directions: ";
  struct Refused {
    const char* name;
    std::string bytes;
    const char* reason;
  };
  const Refused all[] = {
      {"flat", start + "dimension: 2\nsizes: 10 6\n" + little + voxels, "not-scalar"},
      {"line", start + "dimension: 1\nsizes: 60\n" + little + voxels, "not-scalar"},
      {"vectors",
       start + "dimension: 4\nsizes: 3 5 2 2\nkinds: vector space space space\n" + little + voxels,
       "not-scalar"},
      {"several",
       start + "dimension: 4\nsizes: 5 2 2 3\nkinds: space space space list\n" + little + voxels,
       "which-series"},
      {"nan", start + cube + "spacings: 1 nan 1\n" + little + voxels, "bad-header"},
      {"sheared", start + cube + space + "(1,0,0) (0,1,0) (0,0.3,1)\n" + little + voxels,
       "sheared"},
      {"magic", "NRRD9\n" + cube + little + voxels, "bad-header"},
      {"empty", "", "bad-header"},
      {"header only", start + cube + little + "\n", "truncated"},
      {"huge", start + "dimension: 3\nsizes: 50000 40000 3000\n" + little + voxels, "truncated"},
      {"no data file", start + cube + little + "data file: absent.raw\n", "truncated"},
      {"no sizes", start + "dimension: 3\n" + little + voxels, "bad-header"},
      {"short", start + cube + little + voxels.substr(0, 100), "truncated"},
      {"gzip",
       start + cube + "endian: little\nencoding: gzip\n\n" + deflated(sixtyVoxels()).substr(0, 60),
       "truncated"},
      {"encoding", start + cube + "endian: little\nencoding: zip\n" + voxels, "unsupported-syntax"},
      {"skip", start + cube + "byte skip: -5\n" + little + voxels, "bad-header"}};
  Workshop workshop;
  for (const Refused& file : all) {
    const auto v = readVolume(workshop.write(std::string(file.name) + ".nhdr", file.bytes));
    ASSERT_FALSE(v) << file.name;
    EXPECT_EQ(v.error().reason, file.reason) << file.name << ": " << sentence(v.error());
    EXPECT_TRUE(sentence(v.error()).ends_with('.')) << sentence(v.error());
  }
}

/// A header of 5 x 4 x 3 voxels.
std::string sixtyHeader(const std::string& fields, const std::string& encoding = "raw") {
  return "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 4 3\nendian: little\nencoding: " +
         encoding + "\n" + fields;
}

TEST(NrrdMade, NumbersAreReadWholeOrRefusedByTheNameOfTheirField) {
  const std::string space = "space: left-posterior-superior\n";
  struct Written {
    std::string fields;
    const char* refused;  ///< the field that the sentence names; null: it is read
  };
  const Written all[] = {
      {"spacings: 1.5 1.5 2.5\n", nullptr},
      {"spacings: +1.5 .5 15e-1\n", nullptr},
      {"spacings: nan nan nan\n", nullptr},
      {"spacings: 1,5 1,5 2,5\n", "\"spacings\""},
      {"spacings: 1.5mm 1.5mm 2.5mm\n", "\"spacings\""},
      {"spacings: 1_5 1 1\n", "\"spacings\""},
      {"spacings: 0x10 1 1\n", "\"spacings\""},
      {"spacings: 1.5.5 1 1\n", "\"spacings\""},
      {"spacings: +-1 1 1\n", "\"spacings\""},
      {"spacings: 1 5 1 5 2 5\n", "\"spacings\""},
      {"spacings: 1 1\n", "\"spacings\""},
      {"axis mins: 0 0 0\naxis maxs: 5 4 3\n", nullptr},
      {"axis mins: 0,5 0 0\naxis maxs: 5 4 3\n", "\"axis mins\""},
      {"axismins: 0 0 0\naxismaxs: 5 4 3mm\n", "\"axis maxs\""},
      {space + "space directions: ( 1.5 , 0,0) (0,1.5,0)(0,0,25e-1)\nspace origin: (+1,-2,.5)\n",
       nullptr},
      {space + "space directions: (1.5mm,0,0) (0,1,0) (0,0,1)\n", "\"space directions\""},
      {space + "space directions: (1,5,0,0) (0,1,0) (0,0,1)\n", "\"space directions\""},
      {space + "space directions: (1.5,0,) (0,1,0) (0,0,1)\n", "\"space directions\""},
      {space + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3 mm)\n",
       "\"space origin\""},
      {"space dimension: 3D\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n", "\"space dimension\""},
      {"byte skip: 0x0\n", "\"byte skip\""},
      {"lineskip: 0,0\n", "\"line skip\""}};
  Workshop workshop;
  for (const auto& [fields, refused] : all) {
    const auto v = readVolume(workshop.write("v.nrrd", sixtyHeader(fields) + "\n" + sixtyVoxels()));
    EXPECT_EQ(v.has_value(), refused == nullptr) << fields << (v ? "" : sentence(v.error()));
    if (v || refused == nullptr) continue;
    EXPECT_EQ(v.error().reason, "bad-header") << fields;
    EXPECT_NE(sentence(v.error()).find(refused), std::string::npos)
        << fields << sentence(v.error());
  }
  for (const auto& [counts, refused] :
       {std::pair{"dimension: 3.0\nsizes: 5 4 3\n", "\"dimension\""},
        {"dimension: 3\nsizes: 5 4 3.0\n", "\"sizes\""}}) {
    const auto v = readVolume(
        workshop.write("v.nrrd", std::string("NRRD0004\ntype: short\n") + counts +
                                     "endian: little\nencoding: raw\n\n" + sixtyVoxels()));
    ASSERT_FALSE(v) << counts;
    EXPECT_NE(sentence(v.error()).find(refused), std::string::npos) << sentence(v.error());
  }
}

/// Three files of twenty voxels each, and what a header says of them.
struct InThree {
  std::string fields;                    ///< with the names
  std::string before = {}, behind = {};  ///< the voxels in each file
  const char* encoding = "raw";
  std::function<std::string(std::string)> packed = {};  ///< what each file holds of that
};

TEST(NrrdMade, VoxelsInSeveralFilesAreTakenFromEach) {
  const auto as_text = [](const std::string& bytes) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 2) {
      std::int16_t value = 0;
      std::memcpy(&value, bytes.data() + at, 2);
      text += std::to_string(value) + (at % 10 == 8 ? "\n" : " ");
    }
    return text;
  };
  const auto as_hex = [](const std::string& bytes) {
    std::string text;
    for (const char c : bytes)
      text += {"0123456789abcdef"[static_cast<unsigned char>(c) >> 4],
               "0123456789abcdef"[static_cast<unsigned char>(c) & 15]};
    return text;
  };
  const auto as_gzip = [](const std::string& bytes) { return deflated(bytes); };
  const std::string list = "data file: LIST\ns1.raw\ns2.raw\ns3.raw\n";
  const std::string pattern = "data file: s%d.raw 1 3 1\n", line = "a line\n";
  const InThree all[] = {{list},
                         {"data file: LIST  \n\ns1.raw  \n\n\ts2.raw\n   \ns3.raw\n\n\n"},
                         {"data file: LIST 2\r\ns1.raw\r\ns2.raw\r\ns3.raw\r\n"},
                         {"data file: LIST 3\n.\\s1.raw\n.\\s2.raw\n.\\s3.raw"},
                         {pattern},
                         {"data file: s%01d.raw 3 1 -1 2\n", "", "", "raw"},
                         {"byte skip: 128\n" + list, std::string(128, 'h')},
                         {"byte skip: 128\n" + list, std::string(128, 'h'), "tail"},
                         {"byte skip: -1\n" + pattern, std::string(77, 'h')},
                         {"line skip: 2\nbyte skip: 3\n" + list, line + line + "abc"},
                         {list, "", "", "gzip", as_gzip},
                         {"byte skip: 16\n" + list, std::string(16, 'h'), "tail", "gzip", as_gzip},
                         {"byte skip: -1\n" + list, std::string(33, 'h'), "", "gzip", as_gzip},
                         {list, "", "", "ascii", as_text},
                         {"line skip: 1\n" + list, "", "", "ascii",
                          [&](const std::string& bytes) { return line + as_text(bytes); }},
                         {list, "", "", "hex", as_hex}};
  Workshop workshop;
  const auto plain =
      readVolume(workshop.write("plain.nrrd", sixtyHeader("") + "\n" + sixtyVoxels()));
  ASSERT_TRUE(plain);
  int number = 0;
  for (const InThree& files : all) {
    ++number;
    const bool backwards = files.fields.find(" 3 1 -1") != std::string::npos;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string bytes =
          files.before + sixtyVoxels().substr((backwards ? 2 - k : k) * 40, 40) + files.behind;
      workshop.write("s" + std::to_string(k + 1) + ".raw",
                     files.packed ? files.packed(bytes) : bytes);
    }
    const fs::path path = workshop.write("v.nhdr", sixtyHeader(files.fields, files.encoding));
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << number << ": " << files.fields << sentence(v.error());
    EXPECT_EQ(differing(*plain, *v), 0) << number << ": " << files.fields;
    const auto part = readVolume(path, {.part = {.box = Part::Box{{1, 2, 2}, {5, 4, 3}}}});
    ASSERT_TRUE(part) << files.fields << sentence(part.error());
    EXPECT_EQ(voxelAt(*part, 3, 1, 0), 4 + 5 * (3 + 4 * 2)) << files.fields;
  }
}

TEST(NrrdMade, SeveralFilesThatAreNotThoseOfTheHeaderAreRefusedByName) {
  Workshop workshop;
  for (std::size_t k = 0; k < 3; ++k)
    workshop.write("s" + std::to_string(k + 1) + ".raw", sixtyVoxels().substr(k * 40, 40));
  const auto refused = [&](const std::string& fields, const char* encoding = "raw") {
    const auto v = readVolume(workshop.write("v.nhdr", sixtyHeader(fields, encoding)));
    return v ? "" : v.error().reason + ": " + sentence(v.error());
  };
  const auto expect = [&](const std::string& said, const char* reason, const char* words) {
    EXPECT_TRUE(said.starts_with(reason)) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  const std::string list = "data file: LIST\ns1.raw\ns2.raw\ns3.raw\n";
  EXPECT_EQ(refused(list), "");
  expect(refused("data file: LIST\ns1.raw\ns4.raw\ns3.raw\n"), "truncated", "\"s4.raw\"");
  expect(refused("data file: LIST\nslices\\s1.raw\n"), "truncated", "\"s1.raw\"");
  expect(refused("data file: s%02d.raw 1 3 1\n"), "truncated", "\"s01.raw\"");
  expect(refused("data file: absent.raw\n"), "truncated", "\"absent.raw\"");
  expect(refused("data file: LIST\ns1.raw\ns2.raw\n"), "bad-header", "2 data files");
  expect(refused("data file: LIST 1\ns1.raw\ns2.raw\ns3.raw\n"), "bad-header", "3 data files");
  expect(refused("data file: LIST two\ns1.raw\n"), "bad-header", "cannot be understood");
  expect(refused("byte skip: 1\n" + list), "truncated", "\"s1.raw\"");
  workshop.write("s2.raw", "foreign header" + sixtyVoxels().substr(40, 40));
  expect(refused(list), "bad-header", "14 bytes");
  for (std::size_t k = 0; k < 3; ++k)
    workshop.write("s" + std::to_string(k + 1) + ".raw",
                   deflated(sixtyVoxels().substr(k * 40, 40)));
  EXPECT_EQ(refused(list, "gzip"), "");
  std::string damaged = deflated(sixtyVoxels().substr(40, 40));
  damaged[damaged.size() / 2] = static_cast<char>(~damaged[damaged.size() / 2]);
  workshop.write("s2.raw", damaged);
  expect(refused(list, "gzip"), "truncated", "damaged");
}

TEST(NrrdMade, OfASpaceWithTimeTheThreePlacesCount) {
  const std::string voxels = "\n" + sixtyVoxels();
  const auto four = [](const std::string& fields, const std::string& space) {
    return "NRRD0005\ntype: short\ndimension: 4\nsizes: 5 4 1 3\nspace" + space +
           "\nendian: little\nencoding: raw\n" + fields;
  };
  const std::string origin = "space origin: (10,20,30,7)\n",
                    timed = ": left-posterior-superior-time";
  Workshop workshop;
  const auto still = readVolume(workshop.write(
      "v.nrrd", sixtyHeader("space" + timed +
                            "\nspace directions: (0,2,0,0) (0,0,3,0) (4,0,0,0)\n" + origin) +
                    voxels));
  ASSERT_TRUE(still) << sentence(still.error());
  EXPECT_TRUE(still->orientation_known);
  EXPECT_LT((still->grid.worldOf({4, 2, 1}) - haptics::Vec3(0.014, 0.028, 0.036)).norm(), 1e-12);
  const std::string directions = "space directions: (0,-2,0,0) (0,0,3,0) (-4,0,0,0) (0,0,0,0.7)\n";
  const fs::path moving =
      workshop.write("v.nrrd", four(directions + origin +
                                        "kinds: domain domain domain time\n"
                                        "space units: \"mm\" \"mm\" \"mm\" \"s\"\n",
                                    ": RAST") +
                                   voxels);
  const auto found = survey(moving);
  ASSERT_TRUE(found) << sentence(found.error());
  EXPECT_EQ(found->series.size(), 3U);
  const auto last = readVolume(moving, {.series = 2});
  ASSERT_TRUE(last) << sentence(last.error());
  EXPECT_TRUE(last->orientation_known);
  EXPECT_EQ(voxelAt(*last, 4, 3, 0), 59);
  // R and A become L and P
  EXPECT_LT((last->grid.worldOf({4, 3, 0}) - haptics::Vec3(-0.010, -0.012, 0.039)).norm(), 1e-12);
  const auto refused = [&](const std::string& bytes) {
    const auto v = readVolume(workshop.write("v.nrrd", bytes + voxels));
    return v ? "" : sentence(v.error());
  };
  // nobody says what the fourth coordinate is, or an axis leads nowhere
  EXPECT_NE(refused(four(directions + origin, " dimension: 4")).find("space of 4 dimensions"),
            std::string::npos);
  EXPECT_NE(refused(sixtyHeader("space dimension: 2\nspace directions: (1,0) (0,1) none\n"))
                .find("space of 2 dimensions"),
            std::string::npos);
  EXPECT_NE(
      refused(sixtyHeader("space" + timed + "\nspace directions: (0,2,0,0) (0,0,3,0) (0,0,0,1)\n"))
          .find("spacing and direction of every axis"),
      std::string::npos);
  EXPECT_NE(refused(four("space directions: (0,2,0,0) (0,0,3,0) (4,0,0,0) (1,0,0,1)\n", timed))
                .find("calls 4 of its four axes places"),
            std::string::npos);
}

/// A gzip file of 1 MB of noise, so many times: the noise is packed once, and its bytes repeated.
std::string packedMegabytes(unsigned count) {
  constexpr uLong kMegabyte = 1 << 20;
  std::string noise;
  std::mt19937 random(3);
  while (noise.size() < kMegabyte) noise += char('a' + random() % 16);
  const auto packed = [](const std::string& bytes, int flush) {
    return testing::deflatedWith(-MAX_WBITS, bytes, 1, flush);
  };
  const std::string once = packed(noise, Z_FULL_FLUSH);
  const uLong check_once = crc32(0, reinterpret_cast<const Bytef*>(noise.data()), kMegabyte);
  std::string bytes("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10);
  uLong check = 0;
  for (unsigned n = 0; n < count; ++n) {
    bytes += once;
    check = crc32_combine(check, check_once, kMegabyte);
  }
  return bytes + packed("", Z_FINISH) + asBytes(std::uint32_t(check)) +
         asBytes(std::uint32_t(count * kMegabyte));
}

fs::path writePackedMegabytes(const Workshop& workshop, unsigned count) {
  return workshop.write("v.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1024 1024 " +
                                      std::to_string(count) + "\nencoding: gzip\n\n" +
                                      packedMegabytes(count));
}

TEST(NrrdMade, CancelEndsTheRead) {
  Workshop workshop;
  expectCancelEnds(writePackedMegabytes(workshop, 40));
}

TEST(NrrdMade, CancelWhileAllIsInflatedAtOnceLeavesTheRestOfItBehind) {
  Workshop workshop;
  expectCancelLeavesInflating(writePackedMegabytes(workshop, 96));
}

}  // namespace
}  // namespace datasets
