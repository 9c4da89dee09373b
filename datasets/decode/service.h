// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "datasets/readers/dicom/decode_protocol.h"

namespace datasets::decode {

/// What a request may ask of a memory divided like this: frames of at least one pixel that fit.
bool isSound(const Request& request, const Room& room);

/// Answers one sound request: clears its pixels, then decodes into them. Nothing is thrown.
Answer answer(const Request& request, std::span<const std::byte> codestreams,
              std::span<std::byte> pixels);

}  // namespace datasets::decode
