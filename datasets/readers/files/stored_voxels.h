// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "datasets/readers/files/byte_stream.h"
#include "datasets/readers/files/part.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// What to try where a file that could be mapped, were it plain, does not fit into memory.
/// For checkRoom().
inline haptics::Message adviceToSaveRaw() { return {"advice-save-raw", {}}; }

/// How the voxels of one volume, or of several in one block, follow each other.
struct VoxelLayout {
  std::array<std::int64_t, 4> sizes{1, 1, 1, 1};  ///< voxels along each axis, the fastest first
  int volume_axis = 3;                            ///< the axis that counts the volumes
  haptics::ScalarType type = haptics::ScalarType::Int16;  ///< in memory
  bool doubles = false;  ///< stored as double, of which float32 is made
  bool swapped = false;  ///< not in this machine's byte order

  std::int64_t voxelCount() const { return sizes[0] * sizes[1] * sizes[2] * sizes[3]; }
  std::int64_t bytesPerVoxel() const {  ///< stored
    return doubles ? 8 : static_cast<std::int64_t>(haptics::sizeOf(type));
  }
  std::array<std::int64_t, 3> dims() const;  ///< of one volume
};

/// Voxels in one file, plain or deflated.
struct StoredVoxels {
  std::filesystem::path file;
  std::int64_t offset = 0;  ///< bytes of the file before the voxels, or before what is deflated
  bool deflated = false;
  std::int64_t skip = 0;  ///< inflated bytes before the voxels; -1: the voxels are the last
  VoxelLayout layout;
};

/// The voxels of a window of one of the volumes, in the order of the file. Refuses a stream that
/// ends before them ("truncated"; `file` is for the sentence) and what the free memory does not
/// hold ("too-large").
haptics::Expected<std::shared_ptr<void>> pickVoxels(ByteStream& from, std::int64_t begin,
                                                    const VoxelLayout& layout, int number,
                                                    const Window& window,
                                                    const std::filesystem::path& file,
                                                    const ReadProgress& progress);

/// The same from a file, block by block.
haptics::Expected<std::shared_ptr<void>> readVoxels(const StoredVoxels& stored, int number,
                                                    const Window& window,
                                                    const ReadProgress& progress);

/// Whether a window is a whole volume that is best opened by mapping: plain voxels in the form that
/// memory holds, at least 1 GiB, or half of the free memory where that is less. Below, they
/// are read in a second or two, and then no tick of the touch ever waits for a disk; above, a copy
/// would drive other programs out of memory, and the file's own pages can be given back at need.
bool isMapped(const StoredVoxels& stored, int number, const Window& window);

/// One whole volume as the file's own pages, privately: what is written to them stays in memory.
/// The file must stay as it is while they live: pages that it loses end the process.
haptics::Expected<std::shared_ptr<void>> mapVoxels(const StoredVoxels& stored, int number);

}  // namespace datasets
