// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "haptics/core/error.h"

namespace app::cli {

/// Exit codes of palpate-cli.
enum class Exit : int { Done = 0, Usage = 2, Refused = 3, Failed = 4, Interrupted = 130 };

/// Result of a command: one object for --json, text for people, and the exit code. If the code is
/// not Done, `error` is the sentence for standard error.
struct Outcome {
  Exit code = Exit::Done;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text = {};  ///< for people; empty: made from the JSON
  std::string error = {};
  /// Standard output is used for the requested data; the report goes to standard error.
  bool aside = false;
};

/// An object as lines "name: value" for people; a line for each object of a list.
std::string linesOf(const nlohmann::ordered_json& json);

/// A refusal, with further known facts.
Outcome refused(const haptics::Error& error, nlohmann::ordered_json known = {});
Outcome usage(std::string what);

Outcome failed(std::string what);
/// The user asked to stop; partial results are not reported.
Outcome stopped();

/// Prints the outcome and returns its exit code, or Failed if it was Done and cannot be printed.
/// Prints once in a program. If another thread is printing, waits for the end of the process.
int print(const Outcome& outcome, bool json);
/// The same, but returns if another thread prints or has printed.
void printUnlessPrinted(const Outcome& outcome, bool json);

}  // namespace app::cli
