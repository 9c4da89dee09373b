// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/voxel_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>

#include "haptics/core/volume.h"

#ifndef MADV_POPULATE_READ
#define MADV_POPULATE_READ 22  // Linux 5.14
#endif

namespace haptics {
namespace {

tl::unexpected<Error> noRoom(std::size_t bytes) {
  return tl::unexpected(Error{Error::Kind::Unsupported,
                              {"volume-memory", {std::to_string(bytes / 1'000'000)}},
                              "too-large"});
}

}  // namespace

/// Ends a view. It is how a pointer to voxels knows its object.
struct VoxelMemory::Unmap {
  std::shared_ptr<const VoxelMemory> memory;
  const void* first;  // voxel
  std::size_t reserved;

  void operator()(char* base) const { munmap(base, reserved); }
};

Expected<std::shared_ptr<VoxelMemory>> VoxelMemory::allocate(std::size_t bytes) {
  // a memory object may be larger than memory, and would end the process when it is filled
  struct sysinfo machine {};
  sysinfo(&machine);
  const double all = double(machine.totalram + machine.totalswap) * double(machine.mem_unit);
  if (bytes == 0 || double(bytes) > all) return noRoom(bytes);
  const int file = memfd_create("voxels", MFD_CLOEXEC);
  if (file < 0) return noRoom(bytes);
  std::shared_ptr<VoxelMemory> memory(new VoxelMemory(file, 0, bytes, false));
  if (ftruncate(file, static_cast<off_t>(bytes)) != 0) return noRoom(bytes);
  return memory;
}

Expected<std::shared_ptr<VoxelMemory>> VoxelMemory::ofFile(int file, std::size_t offset,
                                                           std::size_t bytes) {
  const int own = fcntl(file, F_DUPFD_CLOEXEC, 0);
  if (own < 0 || bytes == 0) {
    if (own >= 0) close(own);
    return noRoom(bytes);
  }
  return std::shared_ptr<VoxelMemory>(new VoxelMemory(own, offset, bytes, true));
}

VoxelMemory::~VoxelMemory() { close(file_); }

Expected<std::shared_ptr<void>> VoxelMemory::view(int flags) const {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = offset_ % page;  // of the first page
  const std::size_t mapped = before + bytes_;
  const std::size_t reserved = mapped + page + kVoxelPadding;
  // the pages behind the last are memory: what reads a little too far finds zeros
  void* base =
      mmap(nullptr, reserved, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (base == MAP_FAILED) return noRoom(bytes_);
  char* const first = static_cast<char*>(base) + before;
  const std::shared_ptr<char> pages(static_cast<char*>(base),
                                    Unmap{shared_from_this(), first, reserved});
  const void* at = mmap(base, mapped, PROT_READ | PROT_WRITE, flags | MAP_FIXED | MAP_NORESERVE,
                        file_, static_cast<off_t>(offset_ - before));
  if (at == MAP_FAILED) return noRoom(bytes_);
  return std::shared_ptr<void>(pages, first);
}

Expected<std::shared_ptr<void>> VoxelMemory::sharedView() { return view(MAP_SHARED); }

Expected<std::shared_ptr<void>> VoxelMemory::privateView() const {
  auto voxels = view(MAP_PRIVATE);
  if (!voxels) return voxels;
  // the pages are there, only this view's table of them is empty: filled now, so that no tick
  // waits for it. A kernel that cannot fills it page by page.
  if (!of_file_) madvise(voxels->get(), bytes_, MADV_POPULATE_READ);
  auto* const elements = static_cast<float*>(voxels->get());
  for (const Floats& run : replaced_) std::fill_n(elements + run.first, run.count, replacement_);
  return voxels;
}

std::shared_ptr<VoxelMemory> VoxelMemory::of(const std::shared_ptr<const void>& voxels) {
  const auto* view = std::get_deleter<Unmap>(voxels);
  if (view == nullptr || view->first != voxels.get()) return {};
  return std::const_pointer_cast<VoxelMemory>(view->memory);
}

void VoxelMemory::replaceInViews(std::vector<Floats> places, float value) {
  replaced_ = std::move(places);
  replacement_ = value;
}

}  // namespace haptics
