// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "app/fetch/archive.h"

namespace app::fetch {

/// A server of DICOMweb: QIDO-RS and WADO-RS over HTTP/1.1. Needs a QCoreApplication.
haptics::Expected<std::unique_ptr<Archive>> openWeb(const Server& server, const Login& login);

}  // namespace app::fetch
