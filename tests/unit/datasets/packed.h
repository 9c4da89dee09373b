// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <zlib.h>

#include <string>

namespace datasets::testing {

/// What zlib makes of it; `window`: bare (negative), in zlib's own frame, or as a gzip file (16
/// more).
inline std::string deflatedWith(int window, const std::string& bytes, int level = 6,
                                int flush = Z_FINISH) {
  z_stream zlib{};
  deflateInit2(&zlib, level, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&zlib, bytes.size()) + 64, '\0');
  zlib.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  zlib.avail_in = static_cast<uInt>(bytes.size());
  zlib.next_out = reinterpret_cast<Bytef*>(out.data());
  zlib.avail_out = static_cast<uInt>(out.size());
  deflate(&zlib, flush);
  out.resize(zlib.total_out);
  deflateEnd(&zlib);
  return out;
}

/// Deflated as a gzip file, or as the zlib stream that MetaImage holds.
inline std::string deflated(const std::string& bytes, bool as_gzip = true) {
  return deflatedWith(MAX_WBITS + (as_gzip ? 16 : 0), bytes);
}

/// Every `size` bytes turned about.
inline std::string swapped(std::string bytes, std::size_t size) {
  for (std::size_t i = 0; i < bytes.size(); i += size)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + size));
  return bytes;
}

/// Numbers as they lie in memory.
template <class T>
std::string asBytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

}  // namespace datasets::testing
