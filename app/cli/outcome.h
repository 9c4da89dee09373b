// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "haptics/core/error.h"

namespace app::cli {

/// Exit codes of palpate-cli.
enum class Exit : int { Done = 0, Usage = 2, Refused = 3, Failed = 4, Interrupted = 130 };

/// What a command came to: one object for --json, lines for people, and the exit code. On
/// anything but Done, `error` is the sentence for standard error.
struct Outcome {
  Exit code = Exit::Done;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text = {};  ///< for people; empty: made from the JSON
  std::string error = {};
};

/// A refusal with what is known beside the sentence.
Outcome refused(const haptics::Error& error, nlohmann::ordered_json known = {});
Outcome usage(std::string what);

/// Prints the outcome and returns its exit code.
int print(const Outcome& outcome, bool json);

/// True once the user asked to stop (SIGINT, SIGTERM).
bool interrupted();
void watchForInterrupts();

}  // namespace app::cli
