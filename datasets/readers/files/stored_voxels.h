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

/// Advice, for checkRoom(), on a file that does not fit into memory and could be mapped if it were
/// stored plain.
inline haptics::Message adviceToSaveRaw() { return {"advice-save-raw", {}}; }

/// Layout of the voxels of one volume, or of several volumes in one block.
struct VoxelLayout {
  std::array<std::int64_t, 4> sizes{1, 1, 1, 1};  ///< voxels along each axis, the fastest first
  int volume_axis = 3;                            ///< the axis that counts the volumes
  haptics::ScalarType type = haptics::ScalarType::Int16;  ///< in memory
  bool doubles = false;  ///< stored as double, converted to float32
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
  std::int64_t offset = 0;  ///< bytes of the file before the voxels or the deflated data
  bool deflated = false;
  std::int64_t skip = 0;  ///< inflated bytes before the voxels; -1: the voxels are the last bytes
  VoxelLayout layout;
};

/// The voxels of a window of one of the volumes, in the order of the file. Refuses a stream that
/// ends too early ("truncated"; `file` is named in the message) and a window that exceeds the free
/// memory ("too-large").
haptics::Expected<std::shared_ptr<void>> pickVoxels(ByteStream& from, std::int64_t begin,
                                                    const VoxelLayout& layout, int number,
                                                    const Window& window,
                                                    const std::filesystem::path& file,
                                                    const ReadProgress& progress);

/// The same from a file: all voxels of a gzip stream of up to 512 MiB at once, which reports no
/// progress meanwhile; all else block by block.
haptics::Expected<std::shared_ptr<void>> readVoxels(const StoredVoxels& stored, int number,
                                                    const Window& window,
                                                    const ReadProgress& progress);

/// Whether to map: a whole volume, stored plain and as in memory, of at least 1 GiB or half the
/// free memory, whichever is less. Smaller volumes are read in a second or two, so that no tick
/// waits for a disk. A copy of a larger volume would displace other programs from memory, whereas
/// the system can drop mapped pages.
bool isMapped(const StoredVoxels& stored, int number, const Window& window);

/// Maps one whole volume privately; writes do not reach the file. The file must not change while it
/// is mapped: if it is cut short, the process ends.
haptics::Expected<std::shared_ptr<void>> mapVoxels(const StoredVoxels& stored, int number);

}  // namespace datasets
