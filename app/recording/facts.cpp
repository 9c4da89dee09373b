// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/facts.h"

#include "app/study/report/machine.h"

namespace app {

haptics::RecordingFacts recordingFacts() {
  return {study::versionHere(), study::buildHere(), study::machineHere().dump()};
}

}  // namespace app
