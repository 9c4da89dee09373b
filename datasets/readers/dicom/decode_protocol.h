// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "datasets/readers/dicom/codestream.h"

namespace datasets::decode {

// The protocol between the readers and one palpate-decode. Both ends run on one machine and come
// from one build, so numbers have their layout in memory. The socket is the program's standard
// input and output, the shared memory its third descriptor. The readers send a Room, once; then,
// for each frame, they put its bytes at the beginning of the memory and send a Request; the program
// clears the memory for the pixels, decodes into it, and sends an Answer. At the end of the input
// the program ends.

inline constexpr int kMemoryDescriptor = 3;
inline constexpr std::uint64_t kMostBytes = std::uint64_t{1}
                                            << 40;  ///< of either part of the memory

/// How the shared memory is divided: codestream, then pixels.
struct Room {
  std::uint64_t codestream_bytes = 0;
  std::uint64_t pixel_bytes = 0;
};

/// A frame to decode, as the DICOM header describes it: one component, one value per pixel. Pixels
/// come in rows without gaps, in this machine's byte order, as bits. Bits above the depth of the
/// coded values are 0, or the sign if the coding is signed.
struct Request {
  std::uint64_t codestream_bytes = 0;
  Coding coding = Coding::JpegBaseline;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::uint32_t bytes_per_pixel = 0;  ///< 1, 2 or 4
  std::uint32_t bits_stored = 0;      ///< 1 to 8 bytes_per_pixel
  std::uint32_t is_signed = 0;
};

/// The frame's own header, which all codings but RLE have.
struct FrameHeader {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::uint32_t components = 0;  ///< of RLE, its segments
  std::uint32_t precision = 0;   ///< bits of a coded value
};

enum class Verdict : std::uint32_t {
  Ready,  ///< to the Room
  Decoded,
  Damaged,
  // the frame's own header is at odds with the request, in this:
  Components,
  Size,
  Depth,
  Sign,
  Process,  ///< another way of coding
  Loss,     ///< under a lossless syntax
  Segments
};

struct Answer {
  Verdict verdict = Verdict::Damaged;
  FrameHeader frame = {};
};

}  // namespace datasets::decode
