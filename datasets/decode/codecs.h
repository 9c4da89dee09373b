// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "datasets/readers/dicom/decode_protocol.h"

namespace datasets::decode {

/// Decodes a codestream that parseCodestream accepted, into exactly rows x columns pixels. Returns
/// false if the decoder reports an error or a warning, needs more data than there are, or makes an
/// image of another size; the pixels are then invalid. Throws the exceptions of the codecs.
bool decodeFrame(const Request& request, std::span<const std::byte> codestream,
                 std::span<std::byte> pixels);

}  // namespace datasets::decode
