// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "app/recording/scene_words.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace app {

/// Sets the application's names for Qt, which determine the folders of settings and files. Folders
/// in the environment (XDG_DATA_HOME and so on) that are not absolute are ignored. Call it once,
/// before any file is written and before another thread exists.
void nameApplication();

/// The secret key of this installation. It is made at its first use and kept in the user's own
/// folder, readable only by the user. Hashes made with it cannot be recognised by others. If
/// several processes make it at once, all get the same key. Refuses, reason "no-key", if the key
/// can be neither read nor written, or is damaged; a damaged key is never replaced.
haptics::Expected<QByteArray> installationKey();

/// HMAC-SHA256 over geometry and voxels of the scan, whatever was taken away from it. Takes seconds
/// for a large volume. Nullopt if `key` is empty, or once `cancel` is true.
std::optional<VolumeHash> hashOf(const haptics::Volume& volume, const QByteArray& key,
                                 const std::atomic<bool>& cancel);

/// SHA-256 of the scan's voxels alone, as they lie in memory: little-endian numbers of their type,
/// i fastest. In hexadecimal. Everybody who has the voxels can make it, so it identifies a scan.
/// Nullopt once `cancel` is true.
std::optional<std::string> openHashOfVoxels(const haptics::Volume& volume,
                                            const std::atomic<bool>& cancel);

/// The keyed hash of a file, such as a tool's. Nullopt if it cannot be read or is larger than 1 GB.
std::optional<VolumeHash> hashOfFile(const std::filesystem::path& path, const QByteArray& key);

}  // namespace app
