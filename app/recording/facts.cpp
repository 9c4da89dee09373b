// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/facts.h"

#include "app/build_info/build_info.h"

namespace app {

RecordingFacts recordingFacts() { return {versionHere(), buildHere(), machineHere().dump()}; }

}  // namespace app
