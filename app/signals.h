// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace app {

/// Keeps SIGINT, SIGTERM, SIGHUP and SIGQUIT from this thread and all that it starts. Called before
/// there is any other thread, so that none but EndingSignals' gets them. What a terminal may stop
/// the process by, and SIGPIPE, is ignored: the motors would keep their force.
void blockEndingSignals();

/// Waits for SIGINT, SIGTERM, SIGHUP and SIGQUIT on a thread of its own. At the first the motors
/// stop at once and `end` is called, on that thread; the next one ends the process as if nobody had
/// waited, with the motors stopped again.
class EndingSignals {
 public:
  explicit EndingSignals(std::function<void()> end);
  ~EndingSignals();  ///< what comes later stays blocked
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

 private:
  void wait();

  std::function<void()> end_;
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace app
