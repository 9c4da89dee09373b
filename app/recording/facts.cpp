// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/facts.h"

#include "app/build_info/build_info.h"

namespace app {

RecordingFacts recordingFacts(const std::string& program, const nlohmann::ordered_json& run) {
  nlohmann::ordered_json about{{"program", program}, {"commit", commitHere()}};
  about.update(run);
  return {versionHere(), buildHere(), machineHere().dump(), about.dump()};
}

}  // namespace app
