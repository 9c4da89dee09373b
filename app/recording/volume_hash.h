// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <atomic>
#include <optional>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/recording/scene_words.h"

namespace app {

/// Palpate's names towards Qt: where it keeps settings and files. Folders that the environment
/// names (XDG_DATA_HOME and so on) and that are not absolute are ignored. Once, before anything is
/// kept and before there is another thread.
void nameApplication();

/// The secret of this installation, made at its first use and kept in the user's own folder, for
/// his eyes only: what is hashed with it cannot be recognised elsewhere. Of several processes that
/// would make it, all have the same. Refused, reason "no-key", where it can be neither read nor
/// kept, or is damaged: it is never replaced.
haptics::Expected<QByteArray> installationKey();

/// HMAC-SHA256 over geometry and voxels. Takes seconds for a large volume. None without a key, or
/// once `cancel` is true.
std::optional<haptics::VolumeHash> hashOf(const haptics::Volume& volume, const QByteArray& key,
                                          const std::atomic<bool>& cancel);

}  // namespace app
