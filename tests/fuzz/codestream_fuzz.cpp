// SPDX-License-Identifier: BSD-3-Clause
// By the first byte: a request to palpate-decode; compressed pixel data as they lie in a file.
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

/// A request over a small memory, of a coding whose header is parsed here.
void answerRequest(std::span<const std::byte> bytes) {
  decode::Request request;
  if (bytes.size() < sizeof request) return;
  std::memcpy(&request, bytes.data(), sizeof request);
  const auto coded = bytes.subspan(sizeof request);
  request.codestream_bytes = coded.size();
  const std::vector<std::byte> codestreams(coded.begin(), coded.end());
  std::vector<std::byte> pixels(4096, std::byte{0xab});
  if (!decode::isSound(request, {codestreams.size(), pixels.size()}) ||
      (request.coding > Coding::JpegLossless && request.coding != Coding::Rle))
    return;
  const decode::Answer answer = decode::answer(request, codestreams, pixels);
  const std::size_t count = std::size_t{request.columns} * request.rows * request.bytes_per_pixel;
  fuzz::require(std::all_of(pixels.begin() + static_cast<std::ptrdiff_t>(count), pixels.end(),
                            [](std::byte b) { return b == std::byte{0xab}; }),
                "nothing is written beyond the pixels");
  fuzz::require(answer.verdict != decode::Verdict::Decoded || request.coding == Coding::Rle ||
                    (answer.frame.columns == request.columns && answer.frame.rows == request.rows &&
                     answer.frame.components == 1),
                "a decoded frame has the request's size");
}

void findFrames(std::span<const std::byte> bytes) {
  static const support::ScratchFolder folder;
  if (bytes.empty()) return;
  const int frame_count = 1 + std::to_integer<int>(bytes.front()) % 8;
  const auto data = bytes.subspan(1);
  const auto path = folder.write(
      "pixels", std::string_view{reinterpret_cast<const char*>(data.data()), data.size()});
  for (const Coding coding : {Coding::JpegBaseline, Coding::Jpeg2000, Coding::Rle}) {
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
  if (bytes[0] % 2 == 0)
    answerRequest(rest);
  else
    findFrames(rest);
  return 0;
}
