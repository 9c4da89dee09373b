// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "app/recording/database.h"
#include "haptics/core/error.h"

namespace app {

/// The name of a recording while it is being written: NAME.part, and where a name may not be so
/// long, a shorter one.
std::filesystem::path partOf(const std::filesystem::path& target);

/// The refusal ("beside") of a recording that has a file beside it which SQLite would take for a
/// log of it, and which Palpate did not make: SQLite obeys such a file, and empties or deletes it.
std::optional<haptics::Error> foreignBeside(const std::filesystem::path& recording);

/// Whether a process is writing `NAME.part` or recovering it. Nothing is written.
bool isInUse(const std::filesystem::path& part);

/// Makes a finished recording of an unfinished one: checks `NAME.part` and renames it to NAME, or
/// NAME-2 if NAME exists. Refuses a file that is being written, reason "in-use", a file without a
/// step, reason "empty", and what Palpate did not make, reason "no-recording"; one that has another
/// name too, or a foreign log beside it, reason "beside".
haptics::Expected<std::filesystem::path> recover(const std::filesystem::path& part);

/// Brings the log into the file, checks it, closes it and gives it its name.
haptics::Expected<std::filesystem::path> completed(std::optional<Database>& database,
                                                   const std::filesystem::path& part,
                                                   const std::filesystem::path& target);

/// Once a folder is synced, the names in it survive the power.
void syncFolderOf(const std::filesystem::path& path);

}  // namespace app
