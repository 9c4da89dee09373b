// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace app {

/// Blocks SIGINT, SIGTERM, SIGHUP and SIGQUIT in this thread and in all threads that it starts.
/// Call it before any other thread exists, so that only the thread of EndingSignals receives them.
/// It also ignores SIGPIPE and the signals by which a terminal stops a process, because the motors
/// of a stopped process would keep their force.
void blockEndingSignals();

/// Waits for SIGINT, SIGTERM, SIGHUP and SIGQUIT on a thread of its own. The first signal stops the
/// motors at once and calls `end` on that thread. The second stops the motors again and ends the
/// process by the signal's default action.
class EndingSignals {
 public:
  explicit EndingSignals(std::function<void()> end);
  ~EndingSignals();  ///< later signals stay blocked
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

 private:
  void wait();

  std::function<void()> end_;
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace app
