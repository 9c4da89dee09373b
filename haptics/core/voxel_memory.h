// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "haptics/core/error.h"

namespace haptics {

/// The memory object that the voxels of a scan lie in: anonymous memory, or a part of a file that
/// is used directly. A view of it is one mapping; it keeps the object, and the object keeps no
/// view. Views may be made on any thread. Core dumps hold none.
class VoxelMemory : public std::enable_shared_from_this<VoxelMemory> {
 public:
  /// Memory for this many bytes, all zero; untouched pages cost nothing. Refuses 0 bytes and more
  /// than the machine has, reason "too-large".
  static Expected<std::shared_ptr<VoxelMemory>> allocate(std::size_t bytes);
  /// The bytes of an open file from `offset` on, which need not lie at a page. `file` may be closed
  /// afterwards. The file must not change meanwhile: if it is cut short, reading its voxels ends
  /// the process.
  static Expected<std::shared_ptr<VoxelMemory>> ofFile(int file, std::size_t offset,
                                                       std::size_t bytes);
  ~VoxelMemory();
  VoxelMemory(const VoxelMemory&) = delete;
  VoxelMemory& operator=(const VoxelMemory&) = delete;

  std::size_t bytes() const { return bytes_; }

  /// The view that a reader fills; what is written there is seen by all views. Of allocated memory
  /// only.
  Expected<std::shared_ptr<void>> sharedView();
  /// A writable view of its own: a write copies the page that it touches, and nobody else sees it.
  /// The first byte is the first voxel's. kVoxelPadding readable bytes follow the last.
  Expected<std::shared_ptr<void>> privateView() const;
  /// The object that these voxels are a view of; null if they are none from its first byte on.
  static std::shared_ptr<VoxelMemory> of(const std::shared_ptr<const void>& voxels);

  /// Elements of a float volume, one behind the other.
  struct Floats {
    std::size_t first, count;
  };
  bool isOfFile() const { return of_file_; }
  /// Makes every private view from now on begin with this value at these places. For voxels that
  /// are no numbers, in a file that must not be written.
  void replaceInViews(std::vector<Floats> places, float value);

 private:
  struct Unmap;
  VoxelMemory(int file, std::size_t offset, std::size_t bytes, bool of_file)
      : file_{file}, offset_{offset}, bytes_{bytes}, of_file_{of_file} {}
  /// Mapped with these flags of mmap.
  Expected<std::shared_ptr<void>> view(int flags) const;

  int file_;
  std::size_t offset_, bytes_;
  bool of_file_;
  std::vector<Floats> replaced_;
  float replacement_ = 0.0F;
};

}  // namespace haptics
