// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/recording/recorder.h"

namespace app {

/// Version, build and machine for a recording made by this program: only facts on which its numbers
/// depend, and no name of a user or host.
haptics::RecordingFacts recordingFacts();

}  // namespace app
