// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "haptics/core/error.h"

namespace datasets {

/// How the pixels of a frame are compressed.
enum class Coding : std::uint32_t { Jpeg = 1, JpegLs, Jpeg2000, Rle };

/// A compressed frame as the DICOM header describes it: one component, one value per pixel.
struct CodedImage {
  std::string_view syntax;  ///< TransferSyntaxUID
  std::int64_t columns = 0;
  std::int64_t rows = 0;
  int bits_allocated = 0;  ///< 8, 16 or 32
  int bits_stored = 0;     ///< 1 to bits_allocated
  bool is_signed = false;

  std::size_t byteCount() const {
    return static_cast<std::size_t>(columns * rows * (bits_allocated / 8));
  }
};

/// Nullopt for a syntax whose pixels are not compressed, or that is not supported.
std::optional<Coding> codingOf(std::string_view syntax);

/// The frame's own header, if it agrees with the DICOM header.
struct Codestream {
  Coding coding = Coding::Jpeg;
  int precision = 0;     ///< bits of a value as it was coded
  std::size_t size = 0;  ///< bytes, without the padding of the last fragment
};

/// Why a frame must not reach its decoder.
struct CodestreamFault {
  bool disagrees =
      false;  ///< with the DICOM header; false: it is damaged, or in a form that is not supported
  haptics::Message why;  ///< a clause: "its JPEG frame has 64 x 32 pixels, not 512 x 512"
};

/// Parses all of a compressed frame except the coded data: the frame header of every JPEG process
/// with its segments (T.81), JPEG-LS with its preset parameters (T.87), the main and tile-part
/// headers of JPEG 2000 (T.800), the segment table of RLE (PS3.5 Annex G). An accepted frame has
/// the stated size, depth and single component, uses the stated process, ends at its end marker,
/// and is large enough for its pixels.
std::optional<CodestreamFault> parseCodestream(std::span<const std::byte> bytes,
                                               const CodedImage& image, Codestream& parsed);

/// Whether a fragment begins like a codestream of this kind; RLE has no mark.
bool beginsCodestream(Coding coding, std::span<const std::byte> bytes);

}  // namespace datasets
