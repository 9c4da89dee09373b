// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "app/fetch/archive.h"

namespace app::fetch {

/// A server of DIMSE: C-ECHO, C-FIND, C-GET, and C-MOVE where the server has it switched on. One in
/// a process; takes SIGTERM as the wish to stop. `fetches`: a transfer follows the search, on the
/// same association.
haptics::Expected<std::unique_ptr<Archive>> openDimse(const Server& server, const Login& login,
                                                      bool fetches);

}  // namespace app::fetch
