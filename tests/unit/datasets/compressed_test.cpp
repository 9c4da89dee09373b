// SPDX-License-Identifier: BSD-3-Clause
// Compressed DICOM: what a codestream must agree with, and what becomes of one that does not
// decode.
#include <gtest/gtest.h>
#include <signal.h>

#include <array>
#include <atomic>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "datasets/decode/service.h"
#include "datasets/readers/dicom/codestream.h"
#include "datasets/readers/dicom/decoder.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/codestreams.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/made.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using support::Raster;
using testing::DicomSlice;
using testing::edited;
using testing::encapsulated;
using testing::number;
using testing::reasonFor;
using testing::voxelAt;
using testing::Workshop;

constexpr int kColumns = 24, kRows = 16;

/// A disc with noise, of unsigned values of so many bits.
std::vector<std::uint16_t> pictureOf(int columns, int rows, int bits, int components = 1) {
  std::mt19937 random(3);
  std::vector<std::uint16_t> values;
  const unsigned top = (1U << bits) - 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns * components; ++i) {
      const bool inside = std::hypot(i / components - columns / 2, j - rows / 2) < rows / 3.0;
      values.push_back(
          static_cast<std::uint16_t>((inside ? top * 2 / 3 : top / 8) + random() % (top / 20 + 1)));
    }
  return values;
}

struct Way {
  const char* name;
  const char* syntax;
  std::function<std::string(const Raster&)> encode;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all{
      {"JPEG lossless", "1.2.840.10008.1.2.4.70", support::asLosslessJpeg},
      {"JPEG-LS", "1.2.840.10008.1.2.4.80", [](const Raster& r) { return support::asJpegLs(r); }},
      {"JPEG 2000", "1.2.840.10008.1.2.4.90",
       [](const Raster& r) { return support::asJpeg2000(r); }},
      {"RLE", "1.2.840.10008.1.2.5", support::asRle}};
  return all;
}

std::span<const std::byte> asBytes(const std::string& text) {
  return std::as_bytes(std::span{text.data(), text.size()});
}

Coding codingOf(const Way& way) { return datasets::codingOf(way.syntax).value(); }

decode::Request requestFor(Coding coding, std::uint32_t bits = 16) {
  return {.coding = coding,
          .columns = kColumns,
          .rows = kRows,
          .bytes_per_pixel = bits > 8 ? 2U : 1U,
          .bits_stored = bits};
}

/// As palpate-decode answers, in this process.
decode::Answer answerTo(decode::Request request, const std::string& coded) {
  request.codestream_bytes = coded.size();
  // copies of their own size, so that a sanitizer sees what is touched beyond them
  const std::vector<std::byte> exact(asBytes(coded).begin(), asBytes(coded).end());
  std::vector<std::byte> pixels(std::size_t{request.columns} * request.rows *
                                request.bytes_per_pixel);
  return decode::answer(request, exact, pixels);
}

/// A slice of unsigned 16-bit pixels; not compressed.
std::string plainSlice(const std::vector<std::uint16_t>& values, int columns = kColumns,
                       int rows = kRows) {
  DicomSlice slice;
  slice.columns = columns;
  slice.rows = rows;
  slice.pixels.assign(values.begin(), values.end());
  return edited(bytesOf(slice), {{0x28, 0x103, "US", number(0, 2)}});
}

std::string messageFor(const std::filesystem::path& path) {
  const auto volume = readVolume(path);
  return volume ? "" : sentence(volume.error());
}

TEST(Codestream, AgreesWithItsHeaderOrIsNotDecoded) {
  const auto values = pictureOf(kColumns, kRows, 16);
  for (const Way& way : ways()) {
    SCOPED_TRACE(way.name);
    const std::string coded = way.encode({kColumns, kRows, 16, 1, values});
    const decode::Request right = requestFor(codingOf(way));
    ASSERT_EQ(answerTo(right, coded).verdict, decode::Verdict::Decoded);
    const bool is_rle = codingOf(way) == Coding::Rle;
    for (const std::uint32_t bytes : {1, 4}) {
      decode::Request wrong = right;
      wrong.bytes_per_pixel = bytes;
      wrong.bits_stored = 8 * bytes;
      EXPECT_EQ(answerTo(wrong, coded).verdict,
                is_rle ? decode::Verdict::Segments : decode::Verdict::Depth);
    }
    if (is_rle) continue;  // it states nothing else
    for (auto decode::Request::*side : {&decode::Request::columns, &decode::Request::rows}) {
      decode::Request wrong = right;
      wrong.*side += 1;
      const decode::Answer answer = answerTo(wrong, coded);
      EXPECT_EQ(answer.verdict, decode::Verdict::Size);
      EXPECT_EQ(answer.frame.columns, 0U + kColumns);
      EXPECT_EQ(answer.frame.rows, 0U + kRows);
      EXPECT_EQ(answer.frame.precision, 16U);
    }
    decode::Request wrong = right;
    wrong.is_signed = 1;
    EXPECT_EQ(answerTo(wrong, coded).verdict, codingOf(way) == Coding::Jpeg2000Lossless
                                                  ? decode::Verdict::Sign
                                                  : decode::Verdict::Decoded);
  }
}

TEST(Codestream, OfColourIsNoSlice) {
  const auto values = pictureOf(kColumns, kRows, 8, 3);
  const Raster colour{kColumns, kRows, 8, 3, values};
  for (const auto& [coding, coded] :
       {std::pair{Coding::JpegLsLossless, support::asJpegLs(colour)},
        std::pair{Coding::Jpeg2000Lossless, support::asJpeg2000(colour)}}) {
    const decode::Answer answer = answerTo(requestFor(coding, 8), coded);
    EXPECT_EQ(answer.verdict, decode::Verdict::Components);
    EXPECT_EQ(answer.frame.components, 3U);
  }
}

TEST(Codestream, WithLossIsNotWhatALosslessSyntaxNames) {
  const auto values = pictureOf(kColumns, kRows, 12);
  const Raster raster{kColumns, kRows, 12, 1, values};
  const std::string ls = support::asJpegLs(raster, 2);
  EXPECT_EQ(answerTo(requestFor(Coding::JpegLsLossless, 12), ls).verdict, decode::Verdict::Loss);
  EXPECT_EQ(answerTo(requestFor(Coding::JpegLs, 12), ls).verdict, decode::Verdict::Decoded);
  const std::string j2k = support::asJpeg2000(raster, {.with_loss = true});
  EXPECT_EQ(answerTo(requestFor(Coding::Jpeg2000Lossless, 12), j2k).verdict, decode::Verdict::Loss);
  EXPECT_EQ(answerTo(requestFor(Coding::Jpeg2000, 12), j2k).verdict, decode::Verdict::Decoded);
}

TEST(Codestream, OfAnotherProcessIsNotWhatTheSyntaxNames) {
  const auto values = pictureOf(kColumns, kRows, 16);
  const Raster raster{kColumns, kRows, 16, 1, values};
  const std::string ls = support::asJpegLs(raster), lossless = support::asLosslessJpeg(raster);
  EXPECT_EQ(answerTo(requestFor(Coding::JpegLossless), ls).verdict, decode::Verdict::Process);
  EXPECT_EQ(answerTo(requestFor(Coding::JpegLs), lossless).verdict, decode::Verdict::Process);
  EXPECT_EQ(answerTo(requestFor(Coding::JpegBaseline), lossless).verdict, decode::Verdict::Process);
  EXPECT_EQ(answerTo(requestFor(Coding::JpegExtended), lossless).verdict, decode::Verdict::Process);
  std::string progressive = lossless;
  progressive.replace(progressive.find("\xff\xc3"), 2, "\xff\xc2");
  EXPECT_EQ(answerTo(requestFor(Coding::JpegLossless), progressive).verdict,
            decode::Verdict::Process);
}

TEST(Codestream, ThatIsCutAnywhereIsRefused) {
  const auto values = pictureOf(kColumns, kRows, 16);
  for (const Way& way : ways()) {
    const decode::Request request = requestFor(codingOf(way));
    std::string coded = way.encode({kColumns, kRows, 16, 1, values});
    while (coded.back() == '\0') coded.pop_back();  // RLE and dcmtk fill up
    for (std::size_t size = 1; size < coded.size(); ++size)
      ASSERT_EQ(answerTo(request, coded.substr(0, size)).verdict, decode::Verdict::Damaged)
          << way.name << " of " << size;
    EXPECT_EQ(answerTo(request, coded + std::string(3, '\0')).verdict, decode::Verdict::Decoded);
    EXPECT_EQ(answerTo(request, coded + "more").verdict, decode::Verdict::Damaged);
    EXPECT_EQ(answerTo(request, coded + coded).verdict, decode::Verdict::Damaged);
  }
}

// planted: without the look at the tile-parts, OpenJPEG decodes the others and tells nothing
TEST(Codestream, OfTilesHasThemAll) {
  const auto values = pictureOf(kColumns, kRows, 16);
  const std::string coded = support::asJpeg2000({kColumns, kRows, 16, 1, values}, {.tile = 8});
  const decode::Request request = requestFor(Coding::Jpeg2000Lossless);
  ASSERT_EQ(answerTo(request, coded).verdict, decode::Verdict::Decoded);
  std::vector<std::size_t> tiles;
  for (std::size_t at = 0; (at = coded.find("\xff\x90", at)) != std::string::npos; ++at)
    tiles.push_back(at);
  ASSERT_EQ(tiles.size(), 6U);
  tiles.push_back(coded.size() - 2);
  for (std::size_t n = 0; n < 6; ++n) {
    std::string without = coded;
    without.erase(tiles[n], tiles[n + 1] - tiles[n]);
    EXPECT_EQ(answerTo(request, without).verdict, decode::Verdict::Damaged) << n;
  }
}

TEST(Codestream, OfRleHasATableThatFits) {
  const auto values = pictureOf(kColumns, kRows, 16);
  const std::string coded = support::asRle({kColumns, kRows, 16, 1, values});
  const auto refused = [&](std::size_t at, std::size_t value) {
    return answerTo(requestFor(Coding::Rle), std::string(coded).replace(at, 4, number(value, 4)))
               .verdict != decode::Verdict::Decoded;
  };
  for (const std::size_t segments : {0, 1, 3, 15, 16, 1 << 30}) EXPECT_TRUE(refused(0, segments));
  for (const std::size_t first : {0, 63, 65, 1 << 30}) EXPECT_TRUE(refused(4, first));
  for (const std::size_t second : {0, 64, 1 << 30}) EXPECT_TRUE(refused(8, second));
  EXPECT_TRUE(refused(12, 70));
  EXPECT_FALSE(refused(0, 2));
}

TEST(Codestream, OfASmallFileIsNoLargeImage) {
  // 8,000 x 8,000 pixels of nothing
  const auto values = pictureOf(kColumns, kRows, 16);
  std::string coded = support::asLosslessJpeg({kColumns, kRows, 16, 1, values});
  const auto frame = coded.find("\xff\xc3");
  ASSERT_NE(frame, std::string::npos);
  coded.replace(frame + 5, 4, "\x1f\x40\x1f\x40");
  // a header that states less is not followed
  EXPECT_EQ(answerTo(requestFor(Coding::JpegLossless), coded).verdict, decode::Verdict::Size);
  decode::Request request = requestFor(Coding::JpegLossless);
  request.columns = request.rows = 8'000;
  EXPECT_EQ(answerTo(request, coded).verdict, decode::Verdict::Damaged);
}

TEST(Codestream, OfAnyBytesIsReadWithinThem) {
  const auto values = pictureOf(kColumns, kRows, 16);
  std::mt19937 random(8);
  for (const Way& way : ways()) {
    // the headers that are parsed here: the codecs are confined because theirs are not ours
    if (codingOf(way) == Coding::Jpeg2000Lossless) continue;
    const std::string whole = way.encode({kColumns, kRows, 16, 1, values});
    for (int n = 0; n < made::trials(2'000); ++n) {
      std::string changed =
          whole.substr(0, random() % 4 == 0 ? random() % whole.size() : whole.size());
      for (std::size_t k = random() % 4; k > 0 && !changed.empty(); --k)
        changed[random() % std::min<std::size_t>(changed.size(), 120)] = char(random());
      if (!changed.empty()) answerTo(requestFor(codingOf(way)), changed);
    }
  }
}

TEST(CompressedSlice, IsThePlainOneToTheVoxel) {
  const auto values = pictureOf(kColumns, kRows, 16);
  Workshop workshop;
  const std::string plain = plainSlice(values);
  const auto expected = readVolume(workshop.write("plain/0", plain));
  ASSERT_TRUE(expected) << sentence(expected.error());
  for (const Way& way : ways()) {
    const std::string coded = way.encode({kColumns, kRows, 16, 1, values});
    const auto v = readVolume(
        workshop.write(std::string(way.name) + "/0", encapsulated(plain, way.syntax, {coded})));
    ASSERT_TRUE(v) << way.name << ": " << sentence(v.error());
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i)
        ASSERT_EQ(voxelAt(*v, i, j, 0), voxelAt(*expected, i, j, 0)) << way.name;
  }
}

TEST(CompressedSlice, WithSignIsThePlainOneToTheVoxel) {
  std::vector<std::uint16_t> values;
  for (int n = 0; n < kColumns * kRows; ++n)
    values.push_back(static_cast<std::uint16_t>(-1000 + 13 * n % 2047));
  Workshop workshop;
  const std::string plain = edited(plainSlice(values), {{0x28, 0x103, "US", number(1, 2)}});
  for (const Way& way : ways()) {
    const Raster raster{kColumns, kRows, 16, 1, values};
    const std::string coded = codingOf(way) == Coding::Jpeg2000Lossless
                                  ? support::asJpeg2000(raster, {.is_signed = true})
                                  : way.encode(raster);
    const auto v = readVolume(
        workshop.write(std::string(way.name) + "/0", encapsulated(plain, way.syntax, {coded})));
    ASSERT_TRUE(v) << way.name << ": " << sentence(v.error());
    for (int n = 0; n < kColumns * kRows; ++n)
      ASSERT_EQ(voxelAt(*v, n % kColumns, n / kColumns, 0),
                static_cast<std::int16_t>(values[static_cast<std::size_t>(n)]))
          << way.name;
  }
}

// the sizes that a heap was overrun with, before they were compared
TEST(CompressedSlice, OfAnotherShapeIsRefusedByName) {
  Workshop workshop;
  const std::string plain = plainSlice(pictureOf(kColumns, kRows, 16));
  for (const Way& way : ways())
    for (const auto& [columns, rows] : {std::pair{48, 32}, std::pair{480, 320}, std::pair{12, 8},
                                        std::pair{16, 24}, std::pair{1, 1}}) {
      const bool known = codingOf(way) != Coding::Rle;
      if (!known && columns * rows == kColumns * kRows) continue;
      const std::string coded = way.encode({columns, rows, 16, 1, pictureOf(columns, rows, 16)});
      const auto path = workshop.write(std::string(way.name) + "/" + std::to_string(columns),
                                       encapsulated(plain, way.syntax, {coded}));
      const std::string said = messageFor(path);
      EXPECT_NE(said.find('"' + path.filename().string() + '"'), std::string::npos)
          << way.name << " " << columns << ": " << said;
      if (known) {
        EXPECT_NE(said.find(std::to_string(columns) + " x " + std::to_string(rows)),
                  std::string::npos)
            << said;
      }
    }
}

TEST(CompressedSlice, ThatDoesNotDecodeIsRefused) {
  const auto values = pictureOf(kColumns, kRows, 16);
  Workshop workshop;
  const std::string plain = plainSlice(values);
  // the coded data of the first three have ends that are looked for; RLE has lengths
  for (const Way& way : ways()) {
    const std::string coded = way.encode({kColumns, kRows, 16, 1, values});
    std::string shorter = coded;
    if (codingOf(way) == Coding::Rle)
      shorter.resize(shorter.size() - 20);
    else if (codingOf(way) != Coding::Jpeg2000Lossless)
      shorter.erase(shorter.size() / 2, 40);  // the end still stands, and comes too early
    else
      shorter.erase(shorter.size() - 42, 40);
    const auto path =
        workshop.write(std::string(way.name) + "/0", encapsulated(plain, way.syntax, {shorter}));
    EXPECT_EQ(reasonFor(path), "truncated") << way.name;
  }
}

TEST(CompressedSlice, IsPutTogetherOfItsFragments) {
  const auto values = pictureOf(kColumns, kRows, 16);
  Workshop workshop;
  const std::string plain = plainSlice(values);
  const std::string coded = support::asJpegLs({kColumns, kRows, 16, 1, values});
  const std::vector<std::string> parts{coded.substr(0, 40), coded.substr(40, 60),
                                       coded.substr(100)};
  const std::string syntax = "1.2.840.10008.1.2.4.80";
  EXPECT_EQ(reasonFor(workshop.write("bare/0", encapsulated(plain, syntax, parts))), "");
  EXPECT_EQ(reasonFor(workshop.write("table/0", encapsulated(plain, syntax, parts, {0}))), "");
  // a single frame has all fragments, whatever the table says
  EXPECT_EQ(reasonFor(workshop.write("wrong/0", encapsulated(plain, syntax, parts, {48, 2}))), "");
  EXPECT_EQ(reasonFor(workshop.write("none/0", encapsulated(plain, syntax, {}))), "truncated");
  // a syntax of plain pixels with fragments, and one of compressed pixels without
  EXPECT_NE(reasonFor(workshop.write("plain/0", encapsulated(plain, "1.2.840.10008.1.2.1", parts))),
            "");
  std::string mislabelled = plain;
  mislabelled.replace(mislabelled.find("1.2.840.10008.1.2.1"), 19, "1.2.840.10008.1.2.5");
  EXPECT_NE(reasonFor(workshop.write("label/0", mislabelled)), "");
}

// planted: without its clearing, what the memory held would be shown
TEST(Decoding, LeavesNothingOfWhatItsMemoryHeld) {
  const std::string nothing(64, '\0');
  std::vector<std::byte> pixels(2 * kColumns * kRows, std::byte{0xab});
  const decode::Request request{nothing.size(), Coding::Rle, kColumns, kRows, 2, 16, 0};
  EXPECT_EQ(decode::answer(request, asBytes(nothing), pixels).verdict, decode::Verdict::Segments);
  for (const std::byte b : pixels) ASSERT_EQ(b, std::byte{0});
}

TEST(Decoding, AnswersNoRequestBeyondItsMemory) {
  const decode::Room room{1000, 2 * kColumns * kRows};
  const decode::Request sound{1000, Coding::JpegLs, kColumns, kRows, 2, 16, 0};
  EXPECT_TRUE(isSound(sound, room));
  const auto refuses = [&](auto change) {
    decode::Request request = sound;
    change(request);
    return !isSound(request, room);
  };
  EXPECT_TRUE(refuses([](auto& r) { r.codestream_bytes = 1001; }));
  EXPECT_TRUE(refuses([](auto& r) { r.codestream_bytes = 0; }));
  EXPECT_TRUE(refuses([](auto& r) { r.columns += 1; }));
  EXPECT_TRUE(refuses([](auto& r) { r.columns = r.rows = 0xffffffffU; }));
  EXPECT_TRUE(refuses([](auto& r) { r.rows = 0; }));
  EXPECT_TRUE(refuses([](auto& r) { r.bytes_per_pixel = 3; }));
  EXPECT_TRUE(refuses([](auto& r) { r.bytes_per_pixel = 4; }));
  EXPECT_TRUE(refuses([](auto& r) { r.bits_stored = 17; }));
  EXPECT_TRUE(refuses([](auto& r) { r.is_signed = 2; }));
  EXPECT_TRUE(refuses([](auto& r) { r.coding = Coding{9}; }));
}

/// The processes that this one has started and that run palpate-decode.
std::vector<pid_t> decodersRunning() {
  std::vector<pid_t> all;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "stat");
    std::string stat{std::istreambuf_iterator<char>(file), {}};
    const auto end = stat.rfind(')');
    if (end == std::string::npos || stat.find("(palpate-decode)") == std::string::npos) continue;
    if (std::stoi(stat.substr(end + 4)) == getpid()) all.push_back(std::stoi(name));
  }
  return all;
}

std::string statusOf(pid_t process, const std::string& key) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  std::string line;
  while (std::getline(file, line))
    if (line.starts_with(key + ":")) return line.substr(key.size() + 2);
  return "";
}

TEST(Decoder, IsAProcessOfItsOwnThatMayNothingElse) {
  auto decoder = Decoder::start(4096, 4096);
  ASSERT_TRUE(decoder) << sentence(decoder.error());
  const auto running = decodersRunning();
  ASSERT_EQ(running.size(), 1u);
  if (!made::kSanitized) {
    EXPECT_EQ(statusOf(running.front(), "Seccomp"), "2");  // filtered
    EXPECT_EQ(statusOf(running.front(), "NoNewPrivs"), "1");
  }
  int open = 0;
  for ([[maybe_unused]] const auto& fd :
       std::filesystem::directory_iterator("/proc/" + std::to_string(running.front()) + "/fd"))
    ++open;
  EXPECT_EQ(open, 3);  // input, output, and nowhere for errors
  decoder = tl::unexpected(haptics::Error{});
  EXPECT_TRUE(decodersRunning().empty());
}

TEST(Decoder, ThatDiesOrHangsIsNoneOfOurs) {
  const auto values = pictureOf(kColumns, kRows, 16);
  const Way& way = ways()[1];
  const std::string coded = way.encode({kColumns, kRows, 16, 1, values});
  const decode::Request request = requestFor(codingOf(way));
  const auto start = [&] {
    return Decoder::start(coded.size(), std::size_t{2} * kColumns * kRows).value();
  };
  using enum Decoder::Outcome;
  {
    Decoder decoder = start();
    EXPECT_EQ(decoder.decode(request, asBytes(coded), {}), Decoded);
    EXPECT_EQ(decoder.decode(request, asBytes(coded), {}), Decoded);
    kill(decodersRunning().front(), SIGKILL);
    EXPECT_EQ(decoder.decode(request, asBytes(coded), {}), Died);
    EXPECT_EQ(decoder.decode(request, asBytes(coded), {}), Died);
  }
  {
    Decoder decoder = start();
    decode::Request nonsense = request;
    nonsense.bits_stored = 40;  // it ends rather than answer
    EXPECT_EQ(decoder.decode(nonsense, asBytes(coded), {}), Died);
  }
  {
    Decoder decoder = start();
    kill(decodersRunning().front(), SIGSTOP);
    std::atomic<bool> cancel = false;
    std::jthread later([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      cancel = true;
    });
    EXPECT_EQ(decoder.decode(request, asBytes(coded), {.cancel = &cancel}), Cancelled);
  }
  EXPECT_TRUE(decodersRunning().empty());
}

}  // namespace
}  // namespace datasets
