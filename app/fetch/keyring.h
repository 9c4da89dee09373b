// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "haptics/core/error.h"

namespace app::fetch {

/// The secret that the desktop's keyring has for a server, under the attributes `application`
/// (palpate), `server` (host and port) and, unless it is empty, `user`. Waits while the desktop
/// asks to unlock it.
haptics::Expected<std::string> secretOf(const std::string& server, const std::string& user);

}  // namespace app::fetch
