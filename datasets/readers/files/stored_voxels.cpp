// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/stored_voxels.h"

#include <libdeflate.h>
#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <mutex>
#include <new>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "datasets/readers/files/refusal.h"
#include "haptics/core/parallel.h"

#ifndef MADV_POPULATE_WRITE
#define MADV_POPULATE_WRITE 23  // Linux 5.14
#endif

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::int64_t kChunk = 8192;  // voxels converted at a time

/// From the window's place to that in a block of volumes.
struct Pick {
  std::array<std::int64_t, 4> first{}, count{1, 1, 1, 1}, step{1, 1, 1, 1};

  Pick(const VoxelLayout& layout, int number, const Window& window) {
    std::size_t a = 0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      if (static_cast<int>(axis) == layout.volume_axis) {
        first[axis] = number;
        continue;
      }
      first[axis] = window.first[a];
      count[axis] = window.count[a];
      step[axis] = window.step;
      ++a;
    }
  }
  std::int64_t voxelCount() const { return count[0] * count[1] * count[2] * count[3]; }
  std::int64_t last(std::size_t axis) const { return first[axis] + (count[axis] - 1) * step[axis]; }
};

void swapBytes(char* voxels, std::int64_t count, std::int64_t size) {
  for (std::int64_t i = 0; i < count; ++i) std::reverse(voxels + i * size, voxels + (i + 1) * size);
}

/// Takes stored voxels and leaves them as memory is to hold them.
class Filler {
 public:
  Filler(const VoxelLayout& layout, void* out)
      : layout_(layout),
        bytes_(layout.bytesPerVoxel()),
        chunk_(static_cast<std::size_t>(kChunk * bytes_)),
        out_(static_cast<char*>(out)) {}

  /// Of the stream's next `count` voxels each; at most the room that is left.
  bool take(ByteStream& from, std::int64_t count) {
    if (!layout_.swapped && !layout_.doubles) {
      char* const to = std::exchange(out_, out_ + count * bytes_);
      return from.read(to, count * bytes_);
    }
    if (!from.read(chunk_.data() + filled_ * bytes_, count * bytes_)) return false;
    filled_ += count;
    if (filled_ == kChunk) flush();
    return true;
  }
  std::int64_t room() const { return kChunk - filled_; }

  void flush() {
    if (filled_ == 0) return;
    if (layout_.swapped) swapBytes(chunk_.data(), filled_, bytes_);
    if (layout_.doubles) {
      for (std::int64_t i = 0; i < filled_; ++i) {
        double stored;
        std::memcpy(&stored, chunk_.data() + i * bytes_, sizeof stored);
        const auto narrow = static_cast<float>(stored);
        std::memcpy(out_ + i * std::int64_t{sizeof narrow}, &narrow, sizeof narrow);
      }
      out_ += filled_ * std::int64_t{sizeof(float)};
    } else {
      std::memcpy(out_, chunk_.data(), static_cast<std::size_t>(filled_ * bytes_));
      out_ += filled_ * bytes_;
    }
    filled_ = 0;
  }

 private:
  const VoxelLayout& layout_;
  std::int64_t bytes_;
  std::vector<char> chunk_;
  char* out_;
  std::int64_t filled_ = 0;
};

/// Has the system provide the pages of memory that is to be filled, ahead of the filling and beside
/// it. A machine without a thread or a kernel for that provides each page when it is written.
class PagesAhead {
 public:
  PagesAhead(void* memory, std::int64_t bytes) {
    if (haptics::coreCount() == 1) return;
    try {
      thread_ = std::jthread([first = static_cast<char*>(memory), bytes](std::stop_token stop) {
        for (std::int64_t at = 0; at < bytes && !stop.stop_requested(); at += kAtOnce)
          madvise(first + at, static_cast<std::size_t>(std::min(kAtOnce, bytes - at)),
                  MADV_POPULATE_WRITE);
      });
    } catch (const std::system_error&) {
    }
  }

 private:
  static constexpr std::int64_t kAtOnce = 4 << 20;  // bytes
  std::jthread thread_;
};

/// One row of the window, which begins at voxel `row` of the block.
bool takeRow(ByteStream& from, std::int64_t begin, std::int64_t row, std::int64_t bytes,
             const Pick& pick, Filler& filler) {
  const std::int64_t run = pick.step[0] == 1 ? pick.count[0] : 1;  // voxels side by side
  for (std::int64_t i = 0; i < pick.count[0];) {
    const std::int64_t at = row + pick.first[0] + i * pick.step[0];
    const std::int64_t count = std::min({run, pick.count[0] - i, filler.room()});
    if (!from.advanceTo(begin + at * bytes) || !filler.take(from, count)) return false;
    i += count;
  }
  return true;
}

/// Whether the window is all there is, stored in the type that memory holds.
bool isAll(const StoredVoxels& stored, const Window& window) {
  const VoxelLayout& layout = stored.layout;
  return window.step == 1 && window.count == layout.dims() && !layout.doubles &&
         layout.sizes[static_cast<std::size_t>(layout.volume_axis)] == 1;
}

constexpr std::int64_t kMostAtOnce = std::int64_t{1} << 29;    // bytes: some tenths of a second, or
                                                               // seconds where the voxels are noise
constexpr std::int64_t kPackedAtOnce = std::int64_t{1} << 23;  // bytes read between looks at Cancel
constexpr std::chrono::milliseconds kLook{20};                 // between looks at Cancel

/// Memory in large pages, where the system has them: to be given one costs as much as to be given a
/// small one.
using LargePages = std::unique_ptr<char, decltype(&std::free)>;
LargePages largePages(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
  LargePages memory(static_cast<char*>(std::aligned_alloc(kPage, whole)), &std::free);
  if (memory == nullptr) throw std::bad_alloc();
  madvise(memory.get(), whole, MADV_HUGEPAGE);
  return memory;
}

/// The rest of a file, one gzip stream, inflated in one call. The thread that does it has a share
/// of all that it touches, so it can be left behind: the call cannot be stopped.
struct Inflating {
  LargePages packed;
  std::size_t size = 0;
  std::shared_ptr<void> to;
  std::size_t bytes = 0;
  std::mutex guards;
  std::condition_variable has_ended;
  bool ended = false, well = false;

  explicit Inflating(LargePages file) : packed(std::move(file)) {}

  void run() {
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> with(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    std::size_t taken = 0, made = 0;
    const bool whole = with != nullptr &&
                       libdeflate_gzip_decompress_ex(with.get(), packed.get(), size, to.get(),
                                                     bytes, &taken, &made) == LIBDEFLATE_SUCCESS &&
                       taken == size && made == bytes;
    const std::lock_guard lock(guards);
    well = whole;
    ended = true;
    has_ended.notify_one();
  }
};

/// Inflates the rest of a file, one gzip stream of `bytes` bytes, in one call: several times as
/// fast as in blocks, but damage is not seen within. False for all else, which is to be read in
/// blocks, and on Cancel.
bool inflateAtOnce(const StoredVoxels& stored, const std::shared_ptr<void>& to, std::int64_t bytes,
                   const ReadProgress& progress) {
  std::error_code error;
  const auto size = static_cast<std::int64_t>(fs::file_size(stored.file, error)) - stored.offset;
  if (error || size <= 0 || size > kMostAtOnce) return false;
  const auto work = std::make_shared<Inflating>(largePages(static_cast<std::size_t>(size)));
  work->size = static_cast<std::size_t>(size);
  work->to = to;
  work->bytes = static_cast<std::size_t>(bytes);
  std::ifstream file(stored.file, std::ios::binary);
  file.seekg(stored.offset);
  for (std::int64_t at = 0; at < size; at += kPackedAtOnce)
    if (progress.isCancelled() ||
        !file.read(work->packed.get() + at, std::min(kPackedAtOnce, size - at)))
      return false;
  try {
    std::thread([work] {
      pthread_setname_np(pthread_self(), "palpate-inflate");
      work->run();
    }).detach();
  } catch (const std::system_error&) {
    work->run();
  }
  progress.advanced(0.0);  // all threads have begun
  std::unique_lock lock(work->guards);
  while (!work->has_ended.wait_for(lock, kLook, [&] { return work->ended; }))
    if (progress.isCancelled()) return false;
  return work->well;
}

tl::unexpected<haptics::Error> endsEarly(const fs::path& file) {
  return malformed("truncated", {"file-damaged", {quoted(file)}});
}

/// Memory for the voxels of a window, unless it exceeds what is free.
Expected<std::shared_ptr<void>> roomFor(std::int64_t count, haptics::ScalarType type) {
  if (auto room =
          checkRoom(count, static_cast<std::int64_t>(haptics::sizeOf(type)), adviceToSaveRaw());
      !room)
    return tl::unexpected(std::move(room.error()));
  return haptics::allocateVoxels(count, type);
}

/// All voxels of a gzip stream; null where they are to be read in blocks.
Expected<std::shared_ptr<void>> inflatedAtOnce(const StoredVoxels& stored,
                                               const ReadProgress& progress) {
  const VoxelLayout& layout = stored.layout;
  const std::int64_t bytes = layout.voxelCount() * layout.bytesPerVoxel();
  if (bytes > kMostAtOnce) return nullptr;
  auto voxels = roomFor(layout.voxelCount(), layout.type);
  if (!voxels) return voxels;
  {
    const PagesAhead pages(voxels->get(), bytes);
    const bool whole = inflateAtOnce(stored, *voxels, bytes, progress);
    if (progress.isCancelled()) return cancelled();
    if (!whole) return nullptr;
  }
  if (layout.swapped)
    swapBytes(static_cast<char*>(voxels->get()), layout.voxelCount(), layout.bytesPerVoxel());
  progress.advanced(1.0);
  return voxels;
}

}  // namespace

std::array<std::int64_t, 3> VoxelLayout::dims() const {
  std::array<std::int64_t, 3> dims{};
  std::size_t a = 0;
  for (std::size_t axis = 0; axis < 4; ++axis)
    if (static_cast<int>(axis) != volume_axis) dims[a++] = sizes[axis];
  return dims;
}

Expected<std::shared_ptr<void>> pickVoxels(ByteStream& from, std::int64_t begin,
                                           const VoxelLayout& layout, int number,
                                           const Window& window, const fs::path& file,
                                           const ReadProgress& progress) {
  const Pick pick(layout, number, window);
  const std::int64_t bytes = layout.bytesPerVoxel();
  auto voxels = roomFor(pick.voxelCount(), layout.type);
  if (!voxels) return voxels;
  const auto& s = layout.sizes;
  const auto rowAt = [&](std::int64_t a3, std::int64_t a2, std::int64_t a1) {
    return ((a3 * s[2] + a2) * s[1] + a1) * s[0];
  };
  from.watch(progress,
             begin + (rowAt(pick.last(3), pick.last(2), pick.last(1)) + pick.last(0) + 1) * bytes);
  const PagesAhead pages(
      voxels->get(), pick.voxelCount() * static_cast<std::int64_t>(haptics::sizeOf(layout.type)));
  Filler filler(layout, voxels->get());
  bool whole = true;
  for (std::int64_t a3 = pick.first[3]; whole && a3 <= pick.last(3); a3 += pick.step[3])
    for (std::int64_t a2 = pick.first[2]; whole && a2 <= pick.last(2); a2 += pick.step[2])
      for (std::int64_t a1 = pick.first[1]; whole && a1 <= pick.last(1); a1 += pick.step[1])
        whole = takeRow(from, begin, rowAt(a3, a2, a1), bytes, pick, filler);
  // a damaged file may inflate to something else
  whole = whole && from.endsWell();
  if (progress.isCancelled()) return cancelled();
  if (!whole) return endsEarly(file);
  filler.flush();
  progress.advanced(1.0);
  return voxels;
}

Expected<std::shared_ptr<void>> readVoxels(const StoredVoxels& stored, int number,
                                           const Window& window, const ReadProgress& progress) {
  std::int64_t begin = stored.skip;
  if (begin < 0) {
    // where the last bytes begin is known once all have been seen
    const ReadProgress silent{[](double) {}, progress.cancel};
    const auto all = openBytes(stored.file, stored.offset, stored.deflated);
    all->watch(silent, 1);
    begin = all->length() - stored.layout.voxelCount() * stored.layout.bytesPerVoxel();
    if (progress.isCancelled()) return cancelled();
    if (begin < 0) return endsEarly(stored.file);
  }
  if (stored.deflated && begin == 0 && isAll(stored, window)) {
    auto voxels = inflatedAtOnce(stored, progress);
    if (!voxels || *voxels != nullptr) return voxels;
  }
  const auto bytes = openBytes(stored.file, stored.offset, stored.deflated);
  return pickVoxels(*bytes, begin, stored.layout, number, window, stored.file, progress);
}

}  // namespace datasets
