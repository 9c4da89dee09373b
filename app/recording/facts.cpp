// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/facts.h"

#include <chrono>

#include "app/build_info/build_info.h"

namespace app {

RecordingFacts recordingFacts(const std::string& program, const nlohmann::ordered_json& run) {
  nlohmann::ordered_json about{{"program", program}, {"commit", commitHere()}};
  if (!run.empty()) about.update(run);
  return {versionHere(), buildHere(), machineHere().dump(), about.dump()};
}

nlohmann::ordered_json beganNow() {
  return {{"began_unix_ns", std::chrono::duration_cast<std::chrono::nanoseconds>(
                                std::chrono::system_clock::now().time_since_epoch())
                                .count()}};
}

}  // namespace app
