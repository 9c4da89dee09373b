// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace app {

/// The volume before any edit: the volume itself if it has none.
std::shared_ptr<const haptics::Volume> scanOf(std::shared_ptr<const haptics::Volume> volume);

/// Writes a volume as NRRD, of a cropped one only the box, whole or not at all. `place`: where the
/// scan was read; a file that belongs to it is not written over, reason "input". Any thread.
haptics::Expected<void> writeEdited(const haptics::Volume& volume, const std::filesystem::path& out,
                                    const std::filesystem::path& place,
                                    const std::function<void(double)>& advanced,
                                    const std::atomic<bool>& cancel);

}  // namespace app
