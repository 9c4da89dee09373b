// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/recording/recorder.h"

namespace app {

/// Version, build and machine for a recording made by this program: only facts on which its numbers
/// depend, and no name of a user or host.
RecordingFacts recordingFacts();

}  // namespace app
