// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/codestream.h"

#include <array>
#include <utility>

namespace datasets {
namespace {

constexpr std::array<std::pair<std::string_view, Coding>, 9> kSyntaxes{{
    {"1.2.840.10008.1.2.4.50", Coding::JpegBaseline},
    {"1.2.840.10008.1.2.4.51", Coding::JpegExtended},
    {"1.2.840.10008.1.2.4.57", Coding::JpegLossless},
    {"1.2.840.10008.1.2.4.70", Coding::JpegLossless},
    {"1.2.840.10008.1.2.4.80", Coding::JpegLsLossless},
    {"1.2.840.10008.1.2.4.81", Coding::JpegLs},
    {"1.2.840.10008.1.2.4.90", Coding::Jpeg2000Lossless},
    {"1.2.840.10008.1.2.4.91", Coding::Jpeg2000},
    {"1.2.840.10008.1.2.5", Coding::Rle},
}};

}  // namespace

std::optional<Coding> codingOf(std::string_view syntax) {
  for (const auto& [uid, coding] : kSyntaxes)
    if (uid == syntax) return coding;
  return {};
}

bool beginsCodestream(Coding coding, std::span<const std::byte> bytes) {
  if (coding == Coding::Rle) return true;
  const bool is_2000 = coding == Coding::Jpeg2000Lossless || coding == Coding::Jpeg2000;
  return bytes.size() >= 2 && bytes[0] == std::byte{0xff} &&
         bytes[1] == (is_2000 ? std::byte{0x4f} : std::byte{0xd8});
}

}  // namespace datasets
