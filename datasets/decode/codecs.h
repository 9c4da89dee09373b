// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "datasets/readers/dicom/decode_protocol.h"

namespace datasets::decode {

/// Decodes a codestream into exactly rows x columns pixels, if its own header has the size, depth,
/// sign and single component of the request and its coding; only then is memory taken for pixels.
/// It is damaged if the codec reports an error or a warning, needs more data than there are, or
/// ends before them; the pixels are then invalid. Throws the exceptions of the codecs.
Answer decodeFrame(const Request& request, std::span<const std::byte> codestream,
                   std::span<std::byte> pixels);

}  // namespace datasets::decode
