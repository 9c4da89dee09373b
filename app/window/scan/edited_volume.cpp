// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/edited_volume.h"

#include <QCoreApplication>
#include <cstring>
#include <system_error>
#include <utility>

#include "datasets/edits/edited.h"
#include "datasets/readers/nrrd/writer.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Whether the file is there already and is the scan, or lies in the scan's folder.
bool belongsTo(const fs::path& out, const fs::path& place) {
  std::error_code error;
  if (place.empty() || !fs::exists(out, error)) return false;
  const fs::path input = fs::weakly_canonical(place, error);
  for (fs::path at = fs::weakly_canonical(out, error); at != at.parent_path();
       at = at.parent_path())
    if (at == input) return true;
  return fs::equivalent(out, place, error);
}

haptics::Expected<haptics::Volume> boxOf(const haptics::Volume& volume,
                                         const std::atomic<bool>& cancel) {
  haptics::Volume box = volume;
  if (!volume.crop) return box;
  const haptics::VoxelBox& kept = *volume.crop;
  for (std::size_t a = 0; a < 3; ++a) box.grid.dims[a] = kept.end[a] - kept.first[a];
  box.grid.origin =
      volume.grid.worldOf({static_cast<double>(kept.first[0]), static_cast<double>(kept.first[1]),
                           static_cast<double>(kept.first[2])});
  box.crop.reset();
  auto voxels = haptics::allocateVoxels(box.grid.voxelCount(), volume.type);
  if (!voxels) return tl::unexpected(voxels.error());
  const auto bytes = static_cast<std::int64_t>(haptics::sizeOf(volume.type));
  const auto* from = static_cast<const char*>(volume.voxels.get());
  auto* to = static_cast<char*>(voxels->get());
  const auto row = static_cast<std::size_t>(box.grid.dims[0] * bytes);
  for (std::int64_t k = kept.first[2]; k < kept.end[2] && !cancel; ++k)
    for (std::int64_t j = kept.first[1]; j < kept.end[1]; ++j, to += row)
      std::memcpy(
          to, from + ((k * volume.grid.dims[1] + j) * volume.grid.dims[0] + kept.first[0]) * bytes,
          row);
  box.voxels = std::move(*voxels);
  return box;
}

}  // namespace

std::shared_ptr<const haptics::Volume> scanOf(std::shared_ptr<const haptics::Volume> volume) {
  return volume && volume->derivation ? volume->derivation->scan : volume;
}

haptics::Expected<void> writeEdited(const haptics::Volume& volume, const fs::path& out,
                                    const fs::path& place,
                                    const std::function<void(double)>& advanced,
                                    const std::atomic<bool>& cancel) {
  if (belongsTo(out, place))
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported,
        QCoreApplication::translate("app::EditController",
                                    "\"%1\" belongs to the scan that is open, and is not written "
                                    "over; choose another name.")
            .arg(QString::fromStdString(out.filename().string()))
            .toStdString(),
        "input"});
  const auto box = boxOf(volume, cancel);
  if (!box) return tl::unexpected(box.error());
  return datasets::writeNrrd(*box, out, {.advanced = advanced, .cancel = &cancel});
}

}  // namespace app
