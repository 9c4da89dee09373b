// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "haptics/core/error.h"

namespace app::fetch {

/// Exit codes of palpate-fetch.
enum class Exit : int { Done = 0, Usage = 2, Refused = 3, Failed = 4, Interrupted = 130 };

/// Result of a command: the object for --json, the text for people, and where it was not done the
/// sentence and its word for programs.
struct Outcome {
  Exit code = Exit::Done;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text = {};
  haptics::Message error = {};
  std::string reason = {};
};

Outcome outcomeOf(const haptics::Error& error);

/// A message for a program that puts it into words itself: {"id", "arguments"}, or plain text.
nlohmann::ordered_json jsonOf(const haptics::Message& message);

/// Waits for SIGINT, SIGTERM and SIGHUP, and for the end of standard input where it is watched.
/// Make it before any thread exists.
class Supervisor {
 public:
  /// `attached`: a parent program holds standard input, and its end asks to stop.
  explicit Supervisor(bool attached);

  /// Runs `work` in a child process with limits of memory, processor time and open files, without
  /// core dumps, deaf and dumb on the standard streams save standard output. The child is asked to
  /// stop with SIGTERM and killed 0.7 s later, and killed after `longest_s`. Whatever becomes of
  /// it, this returns, with a sentence.
  Outcome run(const std::function<Outcome()>& work, double longest_s);
  /// Waits until one asks to stop.
  void waitForStop();

 private:
  bool attached_;
  int signals_ = -1;
  bool stopped_ = false;

  /// Waits for `answers` (or -1) to be readable, or until asked to stop, for some time at most.
  void wait(int answers, int milliseconds);
};

}  // namespace app::fetch
