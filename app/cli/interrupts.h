// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <thread>

namespace app::cli {

/// True once the user asked to stop.
const std::atomic<bool>& interruption();
inline bool interrupted() { return interruption(); }

/// While it lives, SIGINT, SIGTERM and SIGHUP (unless nohup wards it off) are waited for on a
/// thread of its own, and interruption() tells of the first. What does not look there, such as a
/// library deep in its work, is ended half a second later: nothing half written stays, exit code
/// 130. A signal after that ends the program in any case. One at a time, before there is another
/// thread.
class Interrupts {
 public:
  /// `json`: how the end is told.
  explicit Interrupts(bool json);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

 private:
  void wait(bool json);

  std::atomic<bool> over_{false};
  std::thread thread_;
};

/// While it lives, what was begun is brought to its own end, however long that takes: a recording
/// is closed, a report written. It looks at interruption().
class Closing {
 public:
  Closing();
  ~Closing();
  Closing(const Closing&) = delete;
  Closing& operator=(const Closing&) = delete;
};

}  // namespace app::cli
