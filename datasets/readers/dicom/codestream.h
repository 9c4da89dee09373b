// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace datasets {

/// How the pixels of a frame are compressed, one for each transfer syntax that is read.
enum class Coding : std::uint32_t {
  JpegBaseline = 1,
  JpegExtended,
  JpegLossless,
  JpegLsLossless,
  JpegLs,
  Jpeg2000Lossless,
  Jpeg2000,
  Rle
};

/// Nullopt for a syntax whose pixels are not compressed, or that is not supported.
std::optional<Coding> codingOf(std::string_view syntax);

/// Whether a fragment begins like a codestream of this kind; RLE has no mark.
bool beginsCodestream(Coding coding, std::span<const std::byte> bytes);

}  // namespace datasets
