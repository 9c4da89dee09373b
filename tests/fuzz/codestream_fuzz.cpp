// SPDX-License-Identifier: BSD-3-Clause
// By the first byte: a compressed frame beside what its header says of it; a request to
// palpate-decode; compressed pixel data as they lie in a file.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

#include "datasets/decode/service.h"
#include "datasets/readers/dicom/codestream.h"
#include "datasets/readers/dicom/encapsulated.h"
#include "tests/fuzz/require.h"
#include "tests/support/scratch_folder.h"

namespace {

using namespace datasets;

constexpr std::array<std::string_view, 9> kSyntaxes{
    "1.2.840.10008.1.2.4.50", "1.2.840.10008.1.2.4.51", "1.2.840.10008.1.2.4.57",
    "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.81",
    "1.2.840.10008.1.2.4.90", "1.2.840.10008.1.2.4.91", "1.2.840.10008.1.2.5"};

/// The numbers before the frame: syntax, size, depth and sign.
void parseFrame(std::span<const std::byte> bytes) {
  std::array<std::uint8_t, 8> head{};
  if (bytes.size() < head.size()) return;
  std::memcpy(head.data(), bytes.data(), head.size());
  constexpr std::array<int, 3> kAllocated{8, 16, 32};
  CodedImage image;
  image.syntax = kSyntaxes[head[0] % kSyntaxes.size()];
  image.columns = 1 + (head[1] | head[2] << 8);
  image.rows = 1 + (head[3] | head[4] << 8);
  image.bits_allocated = kAllocated[head[5] % kAllocated.size()];
  image.bits_stored = 1 + head[6] % image.bits_allocated;
  image.is_signed = head[7] % 2 == 1;
  const auto frame = bytes.subspan(head.size());
  Codestream parsed;
  if (const auto fault = parseCodestream(frame, image, parsed)) {
    fuzz::require(!fault->why.empty(), "a fault has its clause");
    return;
  }
  fuzz::require(parsed.size <= frame.size(), "a frame ends within its bytes");
  fuzz::require(parsed.precision == image.bits_stored || parsed.precision == image.bits_allocated ||
                    parsed.precision == 12,
                "a depth is the header's");
  const bool is_large = image.columns * image.rows > std::int64_t{1} << 24;
  fuzz::require(!is_large || frame.size() * 8 >= static_cast<std::size_t>(image.rows),
                "a small frame is no large image");
}

/// A request over a small memory, of which the codec of ours is tried.
void answerRequest(std::span<const std::byte> bytes) {
  decode::Request request;
  if (bytes.size() < sizeof request) return;
  std::memcpy(&request, bytes.data(), sizeof request);
  const auto coded = bytes.subspan(sizeof request);
  const std::vector<std::byte> codestreams(coded.begin(), coded.end());
  std::vector<std::byte> pixels(4096, std::byte{0xab});
  if (!decode::isSound(request, {codestreams.size(), pixels.size()}) ||
      request.coding != Coding::Rle)
    return;
  decode::answer(request, codestreams, pixels);
  const std::size_t count = std::size_t{request.columns} * request.rows * request.bytes_per_pixel;
  fuzz::require(std::all_of(pixels.begin() + static_cast<std::ptrdiff_t>(count), pixels.end(),
                            [](std::byte b) { return b == std::byte{0xab}; }),
                "nothing is written beyond the pixels");
}

void findFrames(std::span<const std::byte> bytes) {
  static const support::ScratchFolder folder;
  if (bytes.empty()) return;
  const int frame_count = 1 + std::to_integer<int>(bytes.front()) % 8;
  const auto data = bytes.subspan(1);
  const auto path = folder.write(
      "pixels", std::string_view{reinterpret_cast<const char*>(data.data()), data.size()});
  for (const Coding coding : {Coding::Jpeg, Coding::Jpeg2000, Coding::Rle}) {
    const auto frames = EncapsulatedFrames::of(path, 0, frame_count, coding);
    for (int n = 0; frames && n < frame_count; ++n) {
      const auto frame = frames->bytesOf(n);
      fuzz::require(frame && frame->size() <= frames->mostBytes(), "a frame is read whole");
      fuzz::require(frame->size() <= data.size(), "a frame lies in its file");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const auto rest = std::as_bytes(std::span{bytes + 1, size - 1});
  switch (bytes[0] % 3) {
    case 0:
      parseFrame(rest);
      break;
    case 1:
      answerRequest(rest);
      break;
    default:
      findFrames(rest);
  }
  return 0;
}
