// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/edits/operators.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// The parts of a volume's memory that were written in a view: blocks of kBytes from its first
/// byte.
class TouchedBlocks {
 public:
  static constexpr std::size_t kBytes = 4096;
  TouchedBlocks() = default;
  explicit TouchedBlocks(const haptics::Volume& volume);

  std::size_t blocks() const { return blocks_; }
  bool has(std::size_t block) const { return (bits_[block / 64] >> (block % 64) & 1) != 0; }
  void add(std::size_t first_byte, std::size_t end_byte);
  std::size_t touched() const;
  std::size_t bytes() const { return bits_.size() * sizeof(std::uint64_t); }
  /// First byte of a block, and the byte after its last voxel.
  std::size_t begin(std::size_t block) const { return block * kBytes; }
  std::size_t end(std::size_t block) const { return std::min(size_, (block + 1) * kBytes); }

 private:
  std::size_t size_ = 0, blocks_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// A private view of a scan with these blocks of another view. Refuses a scan without a memory
/// object, reason "not-editable".
haptics::Expected<std::shared_ptr<void>> viewOf(const haptics::Volume& scan, const void* present,
                                                const TouchedBlocks& touched);

/// A digest of the voxels that differ from the scan's, in the order of memory.
std::uint64_t digestOfVoxels(const haptics::Volume& scan, const void* voxels,
                             const TouchedBlocks& touched);
/// The same, and of the crop.
std::uint64_t digestOf(std::uint64_t of_voxels, const haptics::VoxelBox& bounds);

/// Bytes of a run in a volume's memory.
struct RunBytes {
  std::size_t first, count;
};
RunBytes bytesOfRun(const haptics::Volume& volume, const haptics::VoxelRun& run);

/// The old values of the voxels that an edit lowered. Those that were the scan's are not stored.
class Journal {
 public:
  Journal() = default;
  /// Before the edit, of the volume that it was applied to.
  Journal(const haptics::Volume& scan, const void* before, const TouchedBlocks& touched,
          std::vector<haptics::VoxelRun> runs);
  /// Writes the old values into a view that has the new ones in the blocks `touched` before the
  /// edit, and the scan's elsewhere.
  void restore(const haptics::Volume& scan, void* view, const TouchedBlocks& touched) const;
  std::size_t bytes() const;

 private:
  std::vector<haptics::VoxelRun> runs_;
  std::vector<std::uint32_t> stored_;  // which of the runs have values below
  std::vector<std::uint8_t> values_;
};

/// Few boxes that hold all runs, made of cubes of kSide voxels.
class ChangedBoxes {
 public:
  static constexpr std::int64_t kSide = 32;
  explicit ChangedBoxes(const haptics::Grid& grid);
  void add(const std::vector<haptics::VoxelRun>& runs);
  /// What is in one of two crops only.
  void add(const haptics::VoxelBox& one, const haptics::VoxelBox& other);
  std::vector<haptics::VoxelBox> boxes() const;

 private:
  std::array<std::int64_t, 3> dims_, cubes_;
  std::vector<bool> changed_;
  std::vector<haptics::VoxelBox> slabs_;
};

}  // namespace datasets
