// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// A file that is not what it should be.
tl::unexpected<haptics::Error> malformed(std::string reason, haptics::Message message);
/// A file that is sound and yet not for us.
tl::unexpected<haptics::Error> unsupported(std::string reason, haptics::Message message);
tl::unexpected<haptics::Error> notFound(const std::filesystem::path& path);
tl::unexpected<haptics::Error> cancelled();

/// One sentence behind another.
haptics::Message bothOf(haptics::Message first, haptics::Message second);

/// The path's last part in quotes, for sentences shown to the person who typed it.
std::string quoted(const std::filesystem::path& path);
/// A number with at most four significant digits: "0.3379", "16.5".
std::string brief(double number);
/// The shortest text that reads back as the same double, whatever the locale.
std::string exact(double number);

/// What programs could be given now without swapping, bytes.
double freeMemory();

/// Refuses ("too-large") what the free memory cannot hold, before it is asked for. `advice` is what
/// to try beside reading less.
haptics::Expected<void> checkRoom(std::int64_t voxels, std::int64_t bytes_per_voxel,
                                  haptics::Message advice = {"advice-close-programs", {}});

}  // namespace datasets
