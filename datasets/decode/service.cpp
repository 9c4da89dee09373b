// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/decode/service.h"

#include <algorithm>
#include <exception>

#include "datasets/decode/codecs.h"

namespace datasets::decode {

bool isSound(const Request& request, const Room& room) {
  const bool known = request.coding >= Coding::JpegBaseline && request.coding <= Coding::Rle;
  const std::uint32_t width = request.bytes_per_pixel;
  const bool shaped = (width == 1 || width == 2 || width == 4) && request.bits_stored >= 1 &&
                      request.bits_stored <= 8 * width && request.is_signed <= 1 &&
                      request.columns >= 1 && request.rows >= 1;
  return known && shaped && request.codestream_bytes >= 1 &&
         request.codestream_bytes <= room.codestream_bytes &&
         std::uint64_t{request.columns} * request.rows <= room.pixel_bytes / width;
}

Answer answer(const Request& request, std::span<const std::byte> codestreams,
              std::span<std::byte> pixels) {
  const std::size_t count = std::size_t{request.columns} * request.rows * request.bytes_per_pixel;
  const std::span<std::byte> place = pixels.first(count);
  std::ranges::fill(place, std::byte{0});
  try {
    const auto codestream = codestreams.first(static_cast<std::size_t>(request.codestream_bytes));
    return decodeFrame(request, codestream, place);
  } catch (const std::exception&) {
    return {Verdict::Damaged};
  }
}

}  // namespace datasets::decode
