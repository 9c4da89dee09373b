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
  bool aside = false;  ///< standard output holds what was asked for: the report goes beside it
};

/// A refusal with what is known beside the sentence.
Outcome refused(const haptics::Error& error, nlohmann::ordered_json known = {});
Outcome usage(std::string what);

Outcome failed(std::string what);
/// The user asked to stop, and nothing is told of a part.
Outcome stopped();

/// Prints the outcome and returns its exit code: Failed where it was Done and cannot be told. Once
/// in a program; where another thread is at it, waits for the end.
int print(const Outcome& outcome, bool json);
/// The same, unless another thread is at it.
void printUnlessPrinted(const Outcome& outcome, bool json);

}  // namespace app::cli
