// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "haptics/core/error.h"

namespace app::fetch {

/// An entry of the desktop's keyring, found by its attributes: `application` (palpate), `server`
/// (host and port) and `user`, which is empty for a token. The functions wait while the desktop
/// asks to unlock the keyring.
struct KeyringEntry {
  std::string server, user;
};

haptics::Expected<std::string> secretOf(const KeyringEntry& entry);
/// Replaces what the keyring has for the entry.
haptics::Expected<void> remember(const KeyringEntry& entry, const std::string& secret);
/// Refused if there is no such entry.
haptics::Expected<void> forget(const KeyringEntry& entry);

}  // namespace app::fetch
