// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Error for a file that violates its format.
tl::unexpected<haptics::Error> malformed(std::string reason, haptics::Message message);
/// Error for a valid file that is not supported.
tl::unexpected<haptics::Error> unsupported(std::string reason, haptics::Message message);
tl::unexpected<haptics::Error> notFound(const std::filesystem::path& path);
tl::unexpected<haptics::Error> cancelled();

/// One sentence behind another.
haptics::Message bothOf(haptics::Message first, haptics::Message second);

/// The path's last part in quotes, for messages to the person who typed it.
std::string quoted(const std::filesystem::path& path);
/// A number with at most four significant digits: "0.3379", "16.5".
haptics::Message brief(double number);
/// The shortest text that reads back as the same double, whatever the locale.
std::string exact(double number);

/// Memory that programs could get now without swapping, bytes.
double freeMemory();

/// Refuses ("too-large") a volume that exceeds the free memory, before it is allocated. `advice` is
/// an alternative to reading a part.
haptics::Expected<void> checkRoom(std::int64_t voxels, std::int64_t bytes_per_voxel,
                                  haptics::Message advice = {"advice-close-programs", {}});

}  // namespace datasets
