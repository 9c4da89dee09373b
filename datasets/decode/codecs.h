// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "datasets/readers/dicom/decode_protocol.h"

namespace datasets::decode {

/// Decodes a codestream that parseCodestream let pass into exactly rows x columns pixels. False
/// where the decoder reports an error or a warning, wants more data than there are, or makes
/// another image than was asked for; the pixels are then of no use. Throws what the codecs throw.
bool decodeFrame(const Request& request, std::span<const std::byte> codestream,
                 std::span<std::byte> pixels);

}  // namespace datasets::decode
