// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/codestream.h"

#include <algorithm>
#include <array>
#include <vector>

namespace datasets {
namespace {

using Fault = std::optional<CodestreamFault>;

constexpr std::array<std::pair<std::string_view, Coding>, 9> kSyntaxes{{
    {"1.2.840.10008.1.2.4.50", Coding::Jpeg},
    {"1.2.840.10008.1.2.4.51", Coding::Jpeg},
    {"1.2.840.10008.1.2.4.57", Coding::Jpeg},
    {"1.2.840.10008.1.2.4.70", Coding::Jpeg},
    {"1.2.840.10008.1.2.4.80", Coding::JpegLs},
    {"1.2.840.10008.1.2.4.81", Coding::JpegLs},
    {"1.2.840.10008.1.2.4.90", Coding::Jpeg2000},
    {"1.2.840.10008.1.2.4.91", Coding::Jpeg2000},
    {"1.2.840.10008.1.2.5", Coding::Rle},
}};

Fault broken(haptics::Message why) { return CodestreamFault{false, std::move(why)}; }
Fault disagreeing(haptics::Message why) { return CodestreamFault{true, std::move(why)}; }

Fault cutShort() { return broken({"codestream-cut-off", {}}); }

std::string sizeText(std::int64_t columns, std::int64_t rows) {
  return std::to_string(columns) + " x " + std::to_string(rows);
}

/// Big-endian numbers, one after the other. Beyond the end they are 0 and `is_over` says so.
class Cursor {
 public:
  explicit Cursor(std::span<const std::byte> bytes, std::size_t at = 0) : bytes_{bytes}, at_{at} {}

  std::uint32_t u8() { return number(1); }
  std::uint32_t u16() { return number(2); }
  std::uint32_t u32() { return number(4); }
  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  bool isOver() const { return over_; }
  void skip(std::size_t count) {
    if (count > left())
      over_ = true;
    else
      at_ += count;
  }
  /// The next bytes as a cursor of their own.
  Cursor part(std::size_t count) {
    const std::size_t begin = at_;
    skip(count);
    if (over_) return Cursor{{}};
    return Cursor{bytes_.subspan(begin, count)};
  }

 private:
  std::uint32_t number(std::size_t count) {
    if (count > left()) {
      over_ = true;
      return 0;
    }
    std::uint32_t value = 0;
    for (; count > 0; --count) value = value << 8 | std::to_integer<std::uint32_t>(bytes_[at_++]);
    return value;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool over_ = false;
};

bool isFilling(std::byte b) { return b == std::byte{0} || b == std::byte{0xff}; }

/// What stands after a codestream's end may only fill up its fragment.
Fault checkRest(std::span<const std::byte> rest) {
  if (std::ranges::all_of(rest, isFilling)) return {};
  return broken({"codestream-continues-after-end", {}});
}

/// Of the frame header: one component of the size and depth that the DICOM header states.
Fault checkShape(const CodedImage& image, const char* what, std::int64_t columns, std::int64_t rows,
                 std::int64_t components) {
  if (components != 1)
    return disagreeing({"codestream-components", {what, std::to_string(components)}});
  if (columns != image.columns || rows != image.rows)
    return disagreeing({"codestream-size-differs",
                        {what, sizeText(columns, rows), sizeText(image.columns, image.rows)}});
  return {};
}

Fault checkPrecision(const CodedImage& image, const char* what, int precision) {
  if (precision == image.bits_stored || precision == image.bits_allocated) return {};
  return disagreeing({"codestream-depth-differs",
                      {what, std::to_string(precision), std::to_string(image.bits_stored),
                       std::to_string(image.bits_allocated)}});
}

/// No coding makes more of a byte than this; a small file must not ask for much memory.
Fault checkExpansion(std::size_t size, const CodedImage& image, std::int64_t pixels_of_a_byte) {
  if (image.columns * image.rows <= static_cast<std::int64_t>(size) * pixels_of_a_byte) return {};
  return broken(
      {"codestream-too-few-bytes", {std::to_string(size), sizeText(image.columns, image.rows)}});
}

// ---------------------------------------------------------------------------------------------
// JPEG and JPEG-LS: segments, each a marker and its length, then the scan's coded data

namespace marker {
constexpr std::uint32_t kStart = 0xd8, kEnd = 0xd9, kScan = 0xda, kRestartInterval = 0xdd;
constexpr std::uint32_t kHuffman = 0xc4, kArithmetic = 0xcc, kExtension = 0xc8;
constexpr std::uint32_t kFirstFrame = 0xc0, kLastFrame = 0xcf, kLsFrame = 0xf7, kLsPreset = 0xf8;
constexpr std::uint32_t kQuantisation = 0xdb, kComment = 0xfe;
constexpr std::uint32_t kFirstApp = 0xe0, kLastApp = 0xef;
constexpr std::uint32_t kFirstRestart = 0xd0, kLastRestart = 0xd7;
}  // namespace marker

bool isFrame(std::uint32_t m) {
  return m == marker::kLsFrame ||
         (m >= marker::kFirstFrame && m <= marker::kLastFrame && m != marker::kHuffman &&
          m != marker::kExtension && m != marker::kArithmetic);
}

/// The processes that a transfer syntax allows, by the marker of their frame header.
bool allowsProcess(std::string_view syntax, std::uint32_t frame) {
  constexpr std::uint32_t kBaseline = 0xc0, kExtended = 0xc1, kLossless = 0xc3;
  if (syntax.ends_with(".50")) return frame == kBaseline;
  if (syntax.ends_with(".51")) return frame == kBaseline || frame == kExtended;
  if (syntax.ends_with(".57") || syntax.ends_with(".70")) return frame == kLossless;
  return frame == marker::kLsFrame;
}

/// The next marker; fill bytes may stand before it. 0 where something else stands.
std::uint32_t nextMarker(Cursor& bytes) {
  if (bytes.u8() != 0xff) return 0;
  std::uint32_t m = 0xff;
  while (m == 0xff && !bytes.isOver()) m = bytes.u8();
  return m;
}

/// Huffman tables: as many codes as their counts say, and no more than a code tree has room for.
Fault checkHuffman(Cursor segment) {
  while (segment.left() > 0) {
    const std::uint32_t which = segment.u8();
    std::uint32_t count = 0, room = 1;
    bool fits = true;
    for (int length = 1; length <= 16; ++length) {
      const std::uint32_t codes = segment.u8();
      room = 2 * room;
      fits = fits && codes <= room;
      room -= std::min(codes, room);
      count += codes;
    }
    segment.skip(count);
    if (segment.isOver()) return cutShort();
    if ((which & 0xf) > 3 || which >> 4 > 1 || count > 256 || !fits)
      return broken({"codestream-huffman-table", {}});
  }
  return {};
}

/// The preset parameters of JPEG-LS, the one kind of LSE that a single-component image needs.
Fault checkPreset(Cursor segment, int precision) {
  if (segment.u8() != 1) return broken({"codestream-value-table", {}});
  const std::uint32_t most = segment.u16(), t1 = segment.u16(), t2 = segment.u16(),
                      t3 = segment.u16(), reset = segment.u16();
  if (segment.isOver() || segment.left() > 0) return cutShort();
  const std::uint32_t greatest = (1U << precision) - 1;
  // 0 stands for the usual value
  if (most > greatest || t1 > greatest || t2 > greatest || t3 > greatest ||
      (reset != 0 && (reset < 3 || reset > std::max(255U, greatest))))
    return broken({"codestream-parameters-contradict", {}});
  return {};
}

struct JpegHeader {
  std::uint32_t process = 0;  ///< marker of the frame header
  int precision = 0;
  std::uint32_t component = 0;  ///< its identifier
};

Fault parseFrame(Cursor segment, std::uint32_t process, const CodedImage& image,
                 JpegHeader& header) {
  const char* what = process == marker::kLsFrame ? "JPEG-LS frame" : "JPEG frame";
  header.process = process;
  header.precision = static_cast<int>(segment.u8());
  const std::int64_t rows = segment.u16(), columns = segment.u16(), components = segment.u8();
  if (segment.isOver()) return cutShort();
  if (!allowsProcess(image.syntax, process)) return disagreeing({"codestream-other-process", {}});
  if (const Fault fault = checkShape(image, what, columns, rows, components)) return fault;
  // the extended process knows depths of 8 and 12 bits alone
  const bool rounded_up =
      process == 0xc1 && header.precision == 12 && image.bits_stored > 8 && image.bits_stored < 12;
  if (!rounded_up)
    if (const Fault fault = checkPrecision(image, what, header.precision)) return fault;
  if (header.precision < 2 || header.precision > 16)
    return broken({"codestream-depth-unknown", {}});
  header.component = segment.u8();
  const std::uint32_t sampling = segment.u8();
  const std::uint32_t table = segment.u8();
  if (segment.isOver() || segment.left() > 0) return cutShort();
  const bool sampled =
      sampling >> 4 >= 1 && sampling >> 4 <= 4 && (sampling & 0xf) >= 1 && (sampling & 0xf) <= 4;
  if (!sampled || table > 3) return broken({"codestream-frame-header", {}});
  return {};
}

Fault parseScan(Cursor segment, const CodedImage& image, const JpegHeader& header) {
  if (header.process == 0) return broken({"codestream-data-before-size", {}});
  const std::uint32_t components = segment.u8(), component = segment.u8(), tables = segment.u8(),
                      start = segment.u8(), end = segment.u8(), approximation = segment.u8();
  if (segment.isOver() || segment.left() > 0 || components != 1 || component != header.component)
    return broken({"codestream-scan-header", {}});
  if (header.process == marker::kLsFrame) {
    // start is NEAR, end the interleaving
    if (end != 0 || tables != 0 || approximation > 15)
      return broken({"codestream-scan-header", {}});
    if (image.syntax.ends_with(".80") && start != 0)
      return disagreeing({"codestream-loss-undeclared", {}});
    return {};
  }
  const bool lossless = header.process == 0xc3;
  const bool sound = lossless ? start >= 1 && start <= 7 && end == 0 &&
                                    static_cast<int>(approximation) < header.precision
                              : start == 0 && end == 63 && approximation == 0;
  if (!sound || (tables >> 4) > 3 || (tables & 0xf) > 3)
    return broken({"codestream-scan-header", {}});
  return {};
}

/// Goes to the end of the one scan: the first marker that does not belong to the coded data.
bool skipScan(std::span<const std::byte> bytes, std::size_t& at, bool is_ls) {
  while (at + 1 < bytes.size()) {
    if (bytes[at] != std::byte{0xff}) {
      ++at;
      continue;
    }
    const auto next = std::to_integer<std::uint32_t>(bytes[at + 1]);
    const bool is_data = is_ls ? next < 0x80 : next == 0;
    const bool is_restart = next >= marker::kFirstRestart && next <= marker::kLastRestart;
    if (is_data || is_restart) {
      at += 2;
    } else if (next == 0xff) {
      ++at;
    } else {
      return true;
    }
  }
  return false;
}

Fault parseJpeg(std::span<const std::byte> bytes, const CodedImage& image, Codestream& parsed) {
  Cursor cursor{bytes};
  if (cursor.u16() != 0xffd8) return broken({"codestream-no-jpeg", {}});
  JpegHeader header;
  std::optional<Cursor> preset;
  for (bool in_scan = false; !in_scan;) {
    const std::uint32_t m = nextMarker(cursor);
    const std::uint32_t length = cursor.u16();
    if (cursor.isOver() || length < 2) return cutShort();
    const Cursor segment = cursor.part(length - 2);
    if (cursor.isOver()) return cutShort();
    Fault fault;
    if (isFrame(m)) {
      if (header.process != 0) return broken({"codestream-size-twice", {}});
      fault = parseFrame(segment, m, image, header);
    } else if (m == marker::kScan) {
      fault = parseScan(segment, image, header);
      in_scan = true;
    } else if (m == marker::kHuffman) {
      fault = checkHuffman(segment);
    } else if (m == marker::kLsPreset && !preset) {
      preset = segment;  // it may stand before the frame header
    } else if (m != marker::kQuantisation && m != marker::kComment &&
               m != marker::kRestartInterval && (m < marker::kFirstApp || m > marker::kLastApp)) {
      return broken({"codestream-marker-out-of-place", {}});
    }
    if (fault) return fault;
  }
  const bool is_ls = header.process == marker::kLsFrame;
  if (preset && !is_ls) return broken({"codestream-marker-out-of-place", {}});
  if (preset)
    if (const Fault fault = checkPreset(*preset, header.precision)) return fault;
  std::size_t at = cursor.at();
  const std::size_t scan = at;
  if (!skipScan(bytes, at, is_ls)) return cutShort();
  if (std::to_integer<std::uint32_t>(bytes[at + 1]) != marker::kEnd)
    return broken({"codestream-broken-off", {}});
  parsed.precision = header.precision;
  parsed.size = at + 2;
  // a bit a pixel at least; two a block of 64; of JPEG-LS, one a row
  const std::int64_t expansion = is_ls ? 8 * image.columns : header.process == 0xc3 ? 8 : 256;
  if (const Fault fault = checkExpansion(at - scan, image, expansion)) return fault;
  return checkRest(bytes.subspan(parsed.size));
}

// ---------------------------------------------------------------------------------------------
// JPEG 2000: the main header, then tile-parts, each with its length

namespace j2k {
constexpr std::uint32_t kStart = 0xff4f, kSize = 0xff51, kCoding = 0xff52, kCodingOf = 0xff53,
                        kQuantisation = 0xff5c, kQuantisationOf = 0xff5d, kRegion = 0xff5e,
                        kProgression = 0xff5f, kTileLengths = 0xff55, kPacketLengths = 0xff57,
                        kTilePacketLengths = 0xff58, kPackedHeaders = 0xff60,
                        kTilePackedHeaders = 0xff61, kRegistration = 0xff63, kComment = 0xff64,
                        kTilePart = 0xff90, kData = 0xff93, kEnd = 0xffd9;
}  // namespace j2k

struct TileGrid {
  std::int64_t count = 0;
};

Fault parseSize(Cursor segment, const CodedImage& image, TileGrid& tiles, Codestream& parsed) {
  const std::uint32_t capabilities = segment.u16();
  const std::int64_t x1 = segment.u32(), y1 = segment.u32(), x0 = segment.u32(), y0 = segment.u32();
  const std::int64_t tile_w = segment.u32(), tile_h = segment.u32(), tile_x0 = segment.u32(),
                     tile_y0 = segment.u32();
  const std::int64_t components = segment.u16();
  if (segment.isOver()) return cutShort();
  if (const Fault fault = checkShape(image, "JPEG 2000 image", x1 - x0, y1 - y0, components))
    return fault;
  const std::uint32_t depth = segment.u8(), step_x = segment.u8(), step_y = segment.u8();
  if (segment.isOver() || segment.left() > 0) return cutShort();
  parsed.precision = static_cast<int>(depth & 0x7f) + 1;
  if (const Fault fault = checkPrecision(image, "JPEG 2000 image", parsed.precision)) return fault;
  if ((depth >> 7 == 1) != image.is_signed) return disagreeing({"codestream-sign-differs", {}});
  constexpr std::uint32_t kHighThroughput = 0x4000;
  if ((capabilities & kHighThroughput) != 0) return broken({"codestream-high-throughput", {}});
  const bool placed =
      x0 == 0 && y0 == 0 && tile_x0 == 0 && tile_y0 == 0 && tile_w > 0 && tile_h > 0;
  if (!placed || step_x != 1 || step_y != 1) return broken({"codestream-grid", {}});
  tiles.count = ((x1 + tile_w - 1) / tile_w) * ((y1 + tile_h - 1) / tile_h);
  constexpr std::int64_t kMostTiles = 65'535;
  if (tiles.count > kMostTiles) return broken({"codestream-too-many-tiles", {}});
  return {};
}

Fault parseCodingStyle(Cursor segment, const CodedImage& image) {
  const std::uint32_t style = segment.u8(), order = segment.u8(), layers = segment.u16(),
                      colours = segment.u8(), levels = segment.u8(), width = segment.u8(),
                      height = segment.u8(), passes = segment.u8(), transform = segment.u8();
  const std::size_t precincts = (style & 1) != 0 ? levels + 1 : 0;
  if (segment.isOver() || segment.left() != precincts) return cutShort();
  const bool sound = style < 8 && order <= 4 && layers >= 1 && colours <= 1 && levels <= 32 &&
                     width <= 8 && height <= 8 && width + height <= 8 && passes < 64 &&
                     transform <= 1;
  if (!sound) return broken({"codestream-coding-style", {}});
  if (image.syntax.ends_with(".90") && transform != 1)
    return disagreeing({"codestream-loss-undeclared", {}});
  return {};
}

bool belongsInMainHeader(std::uint32_t m) {
  return m == j2k::kCodingOf || m == j2k::kQuantisation || m == j2k::kQuantisationOf ||
         m == j2k::kRegion || m == j2k::kProgression || m == j2k::kTileLengths ||
         m == j2k::kPacketLengths || m == j2k::kPackedHeaders || m == j2k::kRegistration ||
         m == j2k::kComment;
}

/// From the first tile-part on.
Fault parseTileParts(std::span<const std::byte> bytes, std::size_t begin, const TileGrid& tiles,
                     Codestream& parsed) {
  std::vector<bool> seen(static_cast<std::size_t>(tiles.count), false);
  std::size_t at = begin;
  for (;;) {
    Cursor cursor{bytes, at};
    const std::uint32_t m = cursor.u16();
    if (cursor.isOver()) return cutShort();
    if (m == j2k::kEnd) break;
    const std::uint32_t length = cursor.u16(), tile = cursor.u16();
    std::size_t size = cursor.u32();
    cursor.skip(2);
    if (cursor.isOver()) return cutShort();
    if (m != j2k::kTilePart || length != 10 || tile >= seen.size())
      return broken({"codestream-tiles-out-of-order", {}});
    // the last may leave its length open: then it reaches to the end
    if (size == 0) {
      std::size_t end = bytes.size();
      while (end > at && isFilling(bytes[end - 1])) --end;
      if (end < at + 14 || bytes[end - 1] != std::byte{0xd9} || bytes[end - 2] != std::byte{0xff})
        return cutShort();
      size = end - 2 - at;
    }
    constexpr std::size_t kLeast = 14;  // the tile-part's header and the mark of its data
    if (size < kLeast) return broken({"codestream-tiles-out-of-order", {}});
    if (size > bytes.size() - at) return cutShort();
    seen[tile] = true;
    at += size;
  }
  if (!std::ranges::all_of(seen, [](bool s) { return s; })) return cutShort();
  parsed.size = at + 2;
  return checkRest(bytes.subspan(parsed.size));
}

Fault parseJpeg2000(std::span<const std::byte> bytes, const CodedImage& image, Codestream& parsed) {
  Cursor cursor{bytes};
  if (cursor.u16() != j2k::kStart || cursor.u16() != j2k::kSize)
    return broken({"codestream-no-jpeg-2000", {}});
  TileGrid tiles;
  bool styled = false, quantised = false;
  for (std::uint32_t m = j2k::kSize;; m = cursor.u16()) {
    const std::size_t before = cursor.at() - 2;
    if (cursor.isOver()) return cutShort();
    if (m == j2k::kTilePart) {
      if (!styled || !quantised) return broken({"codestream-main-header-incomplete", {}});
      // what is all one value takes next to nothing; beyond that, a bit a block of 64 x 64
      constexpr std::int64_t kUnasked = std::int64_t{1} << 24, kMostExpansion = 8 * 64 * 64;
      if (image.columns * image.rows > kUnasked)
        if (const Fault fault = checkExpansion(bytes.size(), image, kMostExpansion)) return fault;
      return parseTileParts(bytes, before, tiles, parsed);
    }
    const std::uint32_t length = cursor.u16();
    if (cursor.isOver() || length < 2) return cutShort();
    const Cursor segment = cursor.part(length - 2);
    if (cursor.isOver()) return cutShort();
    Fault fault;
    if (m == j2k::kSize) {
      if (tiles.count > 0) return broken({"codestream-size-twice", {}});
      fault = parseSize(segment, image, tiles, parsed);
    } else if (m == j2k::kCoding) {
      fault = parseCodingStyle(segment, image);
      styled = true;
    } else if (!belongsInMainHeader(m)) {
      return broken({"codestream-marker-out-of-place", {}});
    }
    quantised = quantised || m == j2k::kQuantisation;
    if (fault) return fault;
  }
}

// ---------------------------------------------------------------------------------------------
// RLE: a table of 16 little-endian numbers, then a segment for each byte of a value

std::uint32_t littleAt(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t n = 4; n > 0; --n)
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + n - 1]);
  return value;
}

Fault parseRle(std::span<const std::byte> bytes, const CodedImage& image, Codestream& parsed) {
  constexpr std::size_t kTable = 64, kMostSegments = 15;
  if (bytes.size() < kTable) return cutShort();
  const std::size_t segments = littleAt(bytes, 0);
  const auto expected = static_cast<std::size_t>(image.bits_allocated / 8);
  if (segments != expected)
    return disagreeing({"codestream-rle-segments",
                        {std::to_string(segments), std::to_string(image.bits_allocated),
                         std::to_string(expected)}});
  std::size_t before = 0;
  for (std::size_t n = 0; n < kMostSegments; ++n) {
    const std::size_t offset = littleAt(bytes, 4 + 4 * n);
    if (n >= segments) {
      if (offset != 0) return broken({"codestream-rle-table", {}});
      continue;
    }
    if (n == 0 ? offset != kTable : offset <= before) return broken({"codestream-rle-table", {}});
    if (offset >= bytes.size()) return cutShort();
    before = offset;
  }
  parsed.precision = image.bits_allocated;
  parsed.size = bytes.size();
  // two bytes repeat one at most 128 times
  return checkExpansion(bytes.size() - kTable, image, 64);
}

}  // namespace

std::optional<Coding> codingOf(std::string_view syntax) {
  for (const auto& [uid, coding] : kSyntaxes)
    if (uid == syntax) return coding;
  return {};
}

bool beginsCodestream(Coding coding, std::span<const std::byte> bytes) {
  Cursor cursor{bytes};
  switch (coding) {
    case Coding::Jpeg:
    case Coding::JpegLs:
      return cursor.u16() == 0xffd8;
    case Coding::Jpeg2000:
      return cursor.u16() == j2k::kStart;
    case Coding::Rle:
      break;
  }
  return true;
}

std::optional<CodestreamFault> parseCodestream(std::span<const std::byte> bytes,
                                               const CodedImage& image, Codestream& parsed) {
  const auto coding = codingOf(image.syntax);
  if (!coding) return broken({"codestream-syntax-unknown", {}});
  parsed = {*coding};
  // what a decoder takes for a frame must fit any machine; mammograms have a third of it
  constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;
  if (image.columns * image.rows > kMostPixels)
    return broken({"codestream-too-many-pixels", {sizeText(image.columns, image.rows)}});
  switch (*coding) {
    case Coding::Jpeg:
    case Coding::JpegLs:
      return parseJpeg(bytes, image, parsed);
    case Coding::Jpeg2000:
      return parseJpeg2000(bytes, image, parsed);
    case Coding::Rle:
      break;
  }
  return parseRle(bytes, image, parsed);
}

}  // namespace datasets
