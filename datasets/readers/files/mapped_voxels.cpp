// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/stored_voxels.h"
#include "haptics/core/voxel_memory.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr double kMappedFrom = 1024.0 * 1024.0 * 1024.0;  // bytes

/// Bytes of the file before this volume; the volume must be in one piece.
std::int64_t beginOf(const StoredVoxels& stored, int number) {
  const auto [i, j, k] = stored.layout.dims();
  return stored.offset + stored.skip + number * i * j * k * stored.layout.bytesPerVoxel();
}

tl::unexpected<haptics::Error> notMapped(const fs::path& file) {
  return unsupported("too-large", {"voxels-not-mappable", {quoted(file)}});
}

}  // namespace

bool isMapped(const StoredVoxels& stored, int number, const Window& window) {
  const VoxelLayout& layout = stored.layout;
  if (stored.deflated || stored.skip < 0 || layout.doubles || layout.swapped ||
      layout.volume_axis != 3 || window.step != 1 || window.count != layout.dims())
    return false;
  if (beginOf(stored, number) % layout.bytesPerVoxel() != 0) return false;
  const auto [i, j, k] = layout.dims();
  const double bytes = static_cast<double>(i * j * k * layout.bytesPerVoxel());
  return bytes >= std::min(kMappedFrom, 0.5 * freeMemory());
}

Expected<std::shared_ptr<void>> mapVoxels(const StoredVoxels& stored, int number) {
  const auto [i, j, k] = stored.layout.dims();
  const std::int64_t begin = beginOf(stored, number);
  const std::int64_t bytes = i * j * k * stored.layout.bytesPerVoxel();

  std::error_code error;
  const auto length = static_cast<std::int64_t>(fs::file_size(stored.file, error));
  if (error || length < begin + bytes)
    return malformed("truncated", {"file-shorter-than-header", {quoted(stored.file)}});
  const int file = open(stored.file.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return notFound(stored.file);
  const auto memory = haptics::VoxelMemory::ofFile(file, static_cast<std::size_t>(begin),
                                                   static_cast<std::size_t>(bytes));
  close(file);
  if (!memory) return notMapped(stored.file);
  // writable, and nothing of it in the file: voxels that are no numbers are replaced
  auto voxels = (*memory)->privateView();
  if (!voxels) return notMapped(stored.file);
  return voxels;
}

}  // namespace datasets
