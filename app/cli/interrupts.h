// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <thread>

namespace app::cli {

/// True after the user asked to stop.
const std::atomic<bool>& interruption();
inline bool interrupted() { return interruption(); }

/// While it lives, its own thread waits for SIGINT, SIGTERM and SIGHUP (unless nohup ignores it).
/// The first signal sets interruption(). A command that does not check it, such as a call into a
/// library, is ended half a second later: no partial file remains, and the exit code is 130. The
/// next signal ends the program in any case. Make only one at a time, before another thread exists.
class Interrupts {
 public:
  /// `json`: report the end as JSON.
  explicit Interrupts(bool json);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

 private:
  void wait(bool json);

  std::atomic<bool> over_{false};
  std::thread thread_;
};

/// While it lives, the command is not ended after half a second, so that it can close a recording
/// or write a report. The command must check interruption().
class Closing {
 public:
  Closing();
  ~Closing();
  Closing(const Closing&) = delete;
  Closing& operator=(const Closing&) = delete;
};

}  // namespace app::cli
