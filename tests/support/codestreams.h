// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

/// Compressed frames, made by the codecs' own encoders.
namespace support {

/// Values of a picture, row by row; of several components, pixel by pixel.
struct Raster {
  int columns = 0, rows = 0;
  int bits = 16;       ///< of a value, 2 to 16
  int components = 1;  ///< 1 or 3
  std::span<const std::uint16_t> values;
};

/// `near`: the greatest loss of a value; 0 for none.
std::string asJpegLs(const Raster& raster, int near = 0);
struct Jpeg2000Ways {
  bool is_signed = false;
  bool with_loss = false;
  int tile = 0;  ///< its side; 0: one for all
};
std::string asJpeg2000(const Raster& raster, const Jpeg2000Ways& ways = {});
/// Lossless, by dcmtk's first predictor; of one component.
std::string asLosslessJpeg(const Raster& raster);
/// The bytes of each value from high to low; of one component, 8 or 16 bits.
std::string asRle(const Raster& raster);

}  // namespace support
