// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/recording/recorder.h"

namespace app {

/// What a recording made here says of its maker: version, build and machine, as far as numbers
/// depend on them; nothing that tells whose it is.
haptics::RecordingFacts recordingFacts();

}  // namespace app
