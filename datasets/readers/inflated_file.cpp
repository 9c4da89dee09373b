// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/inflated_file.h"

#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/readers/refusal.h"

namespace datasets {

using haptics::Expected;

namespace {

constexpr std::size_t kMeta = 132;  // where the file's own group begins: a preamble and a mark
constexpr std::int64_t kMost = std::int64_t{1} << 30;  // bytes, before and after
// a slice of nothing but air deflates a thousandfold; a small file must not fill the memory
constexpr std::int64_t kAnyway = std::int64_t{64} << 20;
constexpr std::int64_t kExpansion = 32;
constexpr std::string_view kExplicitLittleEndian{"1.2.840.10008.1.2.1\0", 20};

unsigned word(const std::string& bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]) | unsigned{static_cast<unsigned char>(bytes[at + 1])}
                                                     << 8;
}

/// The elements of the file's own group, which is never deflated, with another transfer syntax and
/// without their length, which readers can do without; and where they end. Empty if it is none.
std::pair<std::string, std::size_t> metaOf(const std::string& bytes) {
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
      meta += bytes.substr(at, 6) + static_cast<char>(kExplicitLittleEndian.size()) + '\0';
      meta += kExplicitLittleEndian;
    } else if (word(bytes, at + 2) != 0) {
      meta += bytes.substr(at, head + length);
    }
    at += head + length;
  }
  return {std::move(meta), at};
}

bool writeAll(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(descriptor, bytes, count);
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

/// An inflation under way; ends with it.
struct Inflation : z_stream {
  Inflation() : z_stream{} { ready = inflateInit2(this, -MAX_WBITS) == Z_OK; }
  ~Inflation() { inflateEnd(this); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  bool ready = false;
};

}  // namespace

Expected<InflatedFile> InflatedFile::of(const std::filesystem::path& deflated) {
  const auto tooLarge = [&] {
    return unsupported("too-large", quoted(deflated) +
                                        " is or inflates to more than a scan's file should; export "
                                        "it uncompressed.");
  };
  std::error_code error;
  const auto size = std::filesystem::file_size(deflated, error);
  if (error || size > static_cast<std::uintmax_t>(kMost)) return tooLarge();
  std::ifstream in(deflated, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto [meta, data] = metaOf(bytes);
  InflatedFile file{memfd_create("dicom", MFD_CLOEXEC)};
  const std::string length{"\x02\0\0\0UL\x04\0", 8};
  std::string head = bytes.substr(0, std::min(kMeta, bytes.size())) + length;
  for (int n = 0; n < 4; ++n) head += static_cast<char>(meta.size() >> (8 * n) & 0xff);
  Inflation inflation;
  if (meta.empty())
    return malformed("bad-header", "The header of " + quoted(deflated) +
                                       " cannot be understood; export it again.");
  head += meta;
  bool sound = file.descriptor_ >= 0 && inflation.ready &&
               writeAll(file.descriptor_, head.data(), head.size());
  inflation.next_in = reinterpret_cast<Bytef*>(bytes.data() + data);
  inflation.avail_in = static_cast<uInt>(bytes.size() - data);
  std::vector<char> block(std::size_t{1} << 16);
  const std::int64_t most =
      std::min(kMost, std::max(kAnyway, kExpansion * static_cast<std::int64_t>(bytes.size())));
  std::int64_t total = 0;
  for (int result = Z_OK; sound && result != Z_STREAM_END;) {
    inflation.next_out = reinterpret_cast<Bytef*>(block.data());
    inflation.avail_out = static_cast<uInt>(block.size());
    result = inflate(&inflation, Z_NO_FLUSH);
    const std::size_t made = block.size() - inflation.avail_out;
    total += static_cast<std::int64_t>(made);
    if (total > most) return tooLarge();
    sound = (result == Z_OK || result == Z_STREAM_END) &&
            writeAll(file.descriptor_, block.data(), made);
  }
  if (!sound)
    return malformed("truncated", "The compressed data of " + quoted(deflated) +
                                      " end early or are damaged; copy or fetch it again.");
  return file;
}

InflatedFile::~InflatedFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

InflatedFile::InflatedFile(InflatedFile&& other) noexcept
    : descriptor_{std::exchange(other.descriptor_, -1)} {}

std::string InflatedFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

}  // namespace datasets
