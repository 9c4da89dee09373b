// SPDX-License-Identifier: BSD-3-Clause
// palpate-decode: decodes compressed frames for the readers, confined to that. See README.md.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <new>
#include <span>

#include "datasets/decode/sandbox.h"
#include "datasets/decode/service.h"
#include "datasets/readers/dicom/decode_protocol.h"

namespace {

using namespace datasets::decode;

enum Exit { kDone = 0, kFailed = 1, kUsage = 2 };

/// False at the end of the input, or within what is read.
template <class T>
bool readWhole(T& value) {
  auto* to = reinterpret_cast<char*>(&value);
  for (std::size_t got = 0; got < sizeof value;) {
    const ssize_t count = read(STDIN_FILENO, to + got, sizeof value - got);
    if (count <= 0) return false;
    got += static_cast<std::size_t>(count);
  }
  return true;
}

bool say(const Answer& answer) {
  return write(STDOUT_FILENO, &answer, sizeof answer) == sizeof answer;
}

/// What the codecs need beside the frame: four copies as their widest numbers, and tables.
std::uint64_t workingBytes(const Room& room) {
  constexpr std::uint64_t kTables = std::uint64_t{96} << 20;
  return kTables + 4 * (room.codestream_bytes + 4 * room.pixel_bytes);
}

int serve() {
  Room room;
  if (!readWhole(room) || room.codestream_bytes > kMostBytes || room.pixel_bytes > kMostBytes)
    return kUsage;
  const std::uint64_t all = room.codestream_bytes + room.pixel_bytes;
  void* memory = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_SHARED, kMemoryDescriptor, 0);
  if (memory == MAP_FAILED) return kFailed;
  close(kMemoryDescriptor);
  if (!confine(workingBytes(room)) || !say({Verdict::Ready})) return kFailed;
  auto* first = static_cast<std::byte*>(memory);
  const std::span codestreams{first, room.codestream_bytes};
  const std::span pixels{first + room.codestream_bytes, room.pixel_bytes};
  Request request;
  while (readWhole(request)) {
    if (!isSound(request, room)) return kUsage;
    // the readers wait less; this ends what they left behind
    constexpr unsigned kLongest = 600;  // s
    alarm(kLongest);
    if (!say(answer(request, codestreams, pixels))) return kFailed;
    alarm(0);
  }
  return kDone;
}

}  // namespace

int main(int count, char**) {
  if (count > 1) {
    std::fputs("palpate-decode serves Palpate's readers and takes no arguments.\n", stderr);
    return kUsage;
  }
  // at once: what libraries would do at the end may ask for more than is allowed
  _exit(serve());
}
