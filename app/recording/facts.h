// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/recording/recorder.h"

namespace app {

/// Version, commit, build and machine for a recording made by this program: only facts on which its
/// numbers depend, and no name of a user or host. `run`: how a run was asked for, one number or
/// word for each name.
RecordingFacts recordingFacts(const std::string& program,
                              const nlohmann::ordered_json& run = nlohmann::ordered_json::object());

/// That a recording begins now, in ns since 1970 UTC: only if the user asked for it.
nlohmann::ordered_json beganNow();

}  // namespace app
