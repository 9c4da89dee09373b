// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "datasets/readers/scan.h"

namespace datasets {

/// Bytes that are read forwards, in blocks. Before each block the stream reports progress and
/// checks for Cancel.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// Skips to byte `at`, which is not before the present one. Returns false at the end, on damage
  /// and on Cancel.
  bool advanceTo(std::int64_t at);
  /// The next `count` bytes; false as above.
  bool read(void* to, std::int64_t count);
  /// From now on `advanced` runs from 0 to 1 at byte `end`. The progress must outlive the stream.
  void watch(const ReadProgress& progress, std::int64_t end);
  /// Reads to the end. Returns the number of bytes of the whole stream.
  std::int64_t length();
  /// Whether the rest is undamaged. Only a stream with a checksum at its end can tell.
  virtual bool endsWell() { return true; }

 protected:
  ByteStream();
  /// Reads up to `size` bytes. Returns their number; 0 at the end and on damage.
  virtual std::int64_t fill(char* block, std::int64_t size) = 0;
  /// Skips up to this many bytes without reading them. Returns the number skipped.
  virtual std::int64_t leap(std::int64_t) { return 0; }

 private:
  bool refill();
  std::vector<char> block_;
  std::int64_t next_ = 0, end_ = 0;  ///< in the block
  std::int64_t at_ = 0;              ///< in the stream
  const ReadProgress* progress_ = nullptr;
  std::int64_t last_ = 1;
};

/// The bytes of a file from `offset` on; with `deflated`, the content of the gzip or zlib stream
/// there.
std::unique_ptr<ByteStream> openBytes(const std::filesystem::path& file, std::int64_t offset,
                                      bool deflated);
/// Bytes in a file, which is one of several.
struct FileBytes {
  std::filesystem::path file;
  std::int64_t offset = 0;  ///< bytes of the file before them, or before the deflated data
  bool deflated = false;
  std::int64_t skip = 0;  ///< inflated bytes before them; -1: they are the last
};
/// So many bytes of each file, one file after the other, as one stream. A file is open only while
/// it is read, and what is skipped is not looked at.
std::unique_ptr<ByteStream> joinedBytes(std::vector<FileBytes> files, std::int64_t bytes_of_each);
/// Bytes in memory, which must outlive the stream.
std::unique_ptr<ByteStream> bytesOf(const void* memory, std::int64_t size);

}  // namespace datasets
