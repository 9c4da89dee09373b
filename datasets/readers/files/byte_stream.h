// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "datasets/readers/scan.h"

namespace datasets {

/// Bytes that are read forwards, in blocks: before each block the reader may report and stop.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// Goes on to a byte, at or after the present one. False at the end, on damage and on Cancel.
  bool advanceTo(std::int64_t at);
  /// The next `count` bytes; false as above.
  bool read(void* to, std::int64_t count);
  /// From here on, `advanced` runs from 0 to 1 at byte `end`. Not to outlive the progress.
  void watch(const ReadProgress& progress, std::int64_t end);
  /// Reads to the end: how many bytes there are in all.
  std::int64_t length();
  /// Whether what is left is whole, where that can be told: a checksum stands at the end.
  virtual bool endsWell() { return true; }

 protected:
  ByteStream();
  /// Up to `size` bytes; 0 at the end and on damage.
  virtual std::int64_t fill(char* block, std::int64_t size) = 0;
  /// Passes over so many bytes without reading them; how many it could.
  virtual std::int64_t leap(std::int64_t) { return 0; }

 private:
  bool refill();
  std::vector<char> block_;
  std::int64_t next_ = 0, end_ = 0;  ///< in the block
  std::int64_t at_ = 0;              ///< in the stream
  const ReadProgress* progress_ = nullptr;
  std::int64_t last_ = 1;
};

/// The bytes of a file from `offset` on; inflated, where they are a gzip or zlib stream.
std::unique_ptr<ByteStream> openBytes(const std::filesystem::path& file, std::int64_t offset,
                                      bool deflated);
/// Bytes that lie in memory, and stay there.
std::unique_ptr<ByteStream> bytesOf(const void* memory, std::int64_t size);

}  // namespace datasets
