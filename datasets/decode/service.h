// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "datasets/readers/dicom/decode_protocol.h"

namespace datasets::decode {

/// Whether a request has at least one pixel and fits `room`.
bool isSound(const Request& request, const Room& room);

/// Answers one sound request: clears its pixels, then decodes into them. Nothing is thrown.
Answer answer(const Request& request, std::span<const std::byte> codestreams,
              std::span<std::byte> pixels);

}  // namespace datasets::decode
