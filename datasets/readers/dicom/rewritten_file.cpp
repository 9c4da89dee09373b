// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/rewritten_file.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;

namespace {

constexpr std::size_t kMeta = 132;  // where the file's own group begins: a preamble and a mark
constexpr std::int64_t kMost = std::int64_t{1} << 30;  // bytes, before and after
// a slice of nothing but air deflates a thousandfold; a small file must not fill the memory
constexpr std::int64_t kRewrittenAnyway = std::int64_t{64} << 20;
constexpr std::int64_t kMostExpansion = 32;
constexpr std::string_view kImplicitLittleEndian = "1.2.840.10008.1.2";
constexpr std::string_view kExplicitLittleEndian = "1.2.840.10008.1.2.1";
constexpr std::string_view kExplicitBigEndian = "1.2.840.10008.1.2.2";

unsigned word(const std::string& bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]) | unsigned{static_cast<unsigned char>(bytes[at + 1])}
                                                     << 8;
}

/// The element that names the transfer syntax.
std::string syntaxElement(std::string_view syntax) {
  const std::size_t length = syntax.size() + syntax.size() % 2;
  std::string element{"\x02\0\x10\0UI", 6};
  element += static_cast<char>(length);
  element += '\0';
  element += syntax;
  if (length > syntax.size()) element += '\0';
  return element;
}

/// The elements of the file's own group, which is never deflated, with another transfer syntax and
/// without their length, which readers can do without; and where they end. Empty if it is none.
std::pair<std::string, std::size_t> inflatedMetaOf(const std::string& bytes) {
  std::string meta;
  std::size_t at = kMeta;
  while (at + 8 <= bytes.size() && word(bytes, at) == 2) {
    const std::string_view representation{bytes.data() + at + 4, 2};
    const bool is_long = representation == "OB" || representation == "UN";
    const std::size_t head = is_long ? 12 : 8;
    if (at + head > bytes.size()) return {};
    const std::size_t length = is_long
                                   ? word(bytes, at + 8) | std::size_t{word(bytes, at + 10)} << 16
                                   : word(bytes, at + 6);
    if (length > bytes.size() - at - head) return {};
    if (word(bytes, at + 2) == 0x10) {
      meta += syntaxElement(kExplicitLittleEndian);
    } else if (word(bytes, at + 2) != 0) {
      meta += bytes.substr(at, head + length);
    }
    at += head + length;
  }
  return {std::move(meta), at};
}

/// An inflation under way; ends with it.
struct Inflation : z_stream {
  Inflation() : z_stream{} { ready = inflateInit2(this, -MAX_WBITS) == Z_OK; }
  ~Inflation() { inflateEnd(this); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  bool ready = false;
};

enum class Inflated { Whole, Damaged, TooLarge };

/// Inflates what begins at `data` of the bytes, and writes it.
Inflated inflateTo(MemoryFile& file, std::string& bytes, std::size_t data, std::int64_t most) {
  Inflation inflation;
  if (!inflation.ready) return Inflated::Damaged;
  inflation.next_in = reinterpret_cast<Bytef*>(bytes.data() + data);
  inflation.avail_in = static_cast<uInt>(bytes.size() - data);
  std::vector<char> block(std::size_t{1} << 16);
  std::int64_t total = 0;
  for (int result = Z_OK; result != Z_STREAM_END;) {
    inflation.next_out = reinterpret_cast<Bytef*>(block.data());
    inflation.avail_out = static_cast<uInt>(block.size());
    result = inflate(&inflation, Z_NO_FLUSH);
    const std::size_t made = block.size() - inflation.avail_out;
    total += static_cast<std::int64_t>(made);
    if (total > most) return Inflated::TooLarge;
    if ((result != Z_OK && result != Z_STREAM_END) || !file.append({block.data(), made}))
      return Inflated::Damaged;
  }
  return Inflated::Whole;
}

}  // namespace

std::optional<BareDataSet> bareDataSetOf(std::string_view beginning) {
  const std::string_view b = beginning.substr(0, kMeta + 8);
  BareDataSet set;
  if (b.size() == kMeta + 8 && b.compare(kMeta - 4, 4, "DICM") == 0) set.begin = kMeta;
  if (b.size() < set.begin + 8) return {};
  // an element of the group 8, among the first of the standard
  const std::string_view head = b.substr(set.begin, 8);
  const auto isLetter = [](char c) { return c >= 'A' && c <= 'Z'; };
  const bool is_explicit = isLetter(head[4]) && isLetter(head[5]);
  if (is_explicit && head.substr(0, 3) == std::string_view{"\0\x08\0", 3})
    set.syntax = kExplicitBigEndian;
  else if (head[0] != 8 || head[1] != 0 || head[3] != 0)
    return {};
  else if (is_explicit)
    set.syntax = kExplicitLittleEndian;
  else if (head[6] == 0 && head[7] == 0)
    set.syntax = kImplicitLittleEndian;
  else
    return {};
  return set;
}

bool BareDataSet::needsRewriting() const { return begin > 0 || syntax == kExplicitBigEndian; }

Expected<RewrittenFile> RewrittenFile::of(const std::filesystem::path& path) {
  const auto tooLarge = [&] {
    return unsupported("too-large", {"dicom-file-too-large", {quoted(path)}});
  };
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > static_cast<std::uintmax_t>(kMost)) return tooLarge();
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto bare = bareDataSetOf(bytes);
  const auto [meta, data] =
      bare ? std::pair{syntaxElement(bare->syntax), bare->begin} : inflatedMetaOf(bytes);
  if (meta.empty()) return malformed("bad-header", {"header-unreadable", {quoted(path)}});
  RewrittenFile file;
  std::string head = std::string(kMeta - 4, '\0') + "DICM" + std::string{"\x02\0\0\0UL\x04\0", 8};
  for (int n = 0; n < 4; ++n) head += static_cast<char>(meta.size() >> (8 * n) & 0xff);
  head += meta;
  bool sound = file.file_.append(head);
  if (bare) {
    sound = sound && file.file_.append(std::string_view{bytes}.substr(data));
  } else {
    const std::int64_t most = std::min(
        kMost,
        std::max(kRewrittenAnyway, kMostExpansion * static_cast<std::int64_t>(bytes.size())));
    const Inflated outcome = inflateTo(file.file_, bytes, data, most);
    if (outcome == Inflated::TooLarge) return tooLarge();
    sound = sound && outcome == Inflated::Whole;
  }
  if (!sound) return malformed("truncated", {"file-damaged", {quoted(path)}});
  return file;
}

Expected<RewrittenFile> RewrittenFile::beginningOf(const std::filesystem::path& file,
                                                   std::int64_t count) {
  const auto unreadable = [&] {
    return malformed("unreadable", {"file-unreadable", {quoted(file)}});
  };
  if (count > kRewrittenAnyway) return unreadable();
  std::string bytes(static_cast<std::size_t>(count), '\0');
  std::ifstream in(file, std::ios::binary);
  RewrittenFile copy;
  if (!in.read(bytes.data(), count) || !copy.file_.append(bytes)) return unreadable();
  return copy;
}

}  // namespace datasets
