// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <list>
#include <memory>
#include <new>
#include <stop_token>
#include <thread>
#include <utility>

#include "haptics/core/error.h"

namespace app::background {

/// Reasons of errors made from an exception. The message is a sentence for kNoMemory, and the
/// exception's own text for kThrew; the caller may replace it by a better one.
inline constexpr const char* kNoMemory = "no-memory";
inline constexpr const char* kThrew = "exception";

/// The calling thread, and those that it starts, get the time that the touch, the window and other
/// work leave.
void goLast();

class Threads;

/// The connection from the work to its owner. Valid while the work runs, on its thread.
class Watch {
 public:
  /// Whether the work should stop. `cancel` and `stop` give the same answer.
  bool cancelled() const { return cancel; }
  const std::atomic<bool>& cancel;
  std::stop_token stop;

  /// Reports the completed fraction, 0 to 1. Steps below 0.002, and those within 0.1 s of a
  /// report, are not reported.
  void advanced(double fraction) const;
  /// Calls `action` on the owner's thread, in order, before the result is delivered. Dropped if the
  /// task was abandoned, started again or destroyed.
  void tell(std::function<void()> action) const;

 private:
  friend class Threads;
  Watch(Threads& owner, std::uint64_t number, const std::atomic<bool>& cancelled,
        std::stop_token token)
      : cancel{cancelled}, stop{std::move(token)}, owner_{owner}, number_{number} {}

  Threads& owner_;
  std::uint64_t number_;
  mutable double told_ = 0.0;
  mutable std::chrono::steady_clock::time_point told_at_;
};

/// The part of Task that does not depend on the type of the result. All calls must come from the
/// thread that made it, which needs an event loop.
class Threads {
 public:
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  /// Asks the work to stop. Its result still arrives, for example if a file was finished
  /// nevertheless.
  void cancel();
  /// Asks the work to stop, and drops its later reports and its result.
  void abandon();
  /// Whether a result is still expected.
  bool isRunning() const { return running_; }
  /// Waits until all threads have ended. The result arrives afterwards, as an event.
  void wait();

 protected:
  explicit Threads(std::function<void(double)> progressed) : progressed_{std::move(progressed)} {}
  /// Cancels and waits. Undelivered reports and results are dropped.
  ~Threads();
  /// Runs `work` on a new thread, and later `done` on this thread, also if no thread could be
  /// started.
  void begin(std::function<void(const Watch&)> work, std::function<void()> done);

 private:
  friend class Watch;
  struct Job {
    std::atomic<bool> cancel{false};
    std::atomic<bool> ended{false};  ///< its thread has finished its work
    std::jthread thread;
  };
  void post(std::uint64_t number, std::function<void()> action);
  void postDone(std::uint64_t number, std::function<void()> done);

  std::function<void(double)> progressed_;
  std::uint64_t number_ = 0;  ///< number of the newest work; reports of other works are dropped
  bool running_ = false;
  QObject context_;  ///< lives on the owner's thread; its pending events are dropped with it
  /// The newest last; the others are cancelled, and kept until they have ended.
  std::list<Job> jobs_;
};

/// The error if no thread could be started.
haptics::Error noThread();
/// The error for std::bad_alloc.
haptics::Error noMemory();
/// The error for any other exception, with the exception's text.
haptics::Error threw(const char* words);

/// Runs work on its own thread. The result arrives on the thread that started it.
///
/// A task has one work at a time. A second start() cancels the previous work and drops its result,
/// without waiting; the old thread ends beside the new one. `done` is called exactly once for a
/// work that is not dropped. An exception that leaves the work arrives as an Error. Only wait() and
/// the destructor wait for a thread.
template <class T>
class Task : public Threads {
 public:
  using Result = haptics::Expected<T>;

  /// `progressed` is called on the owner's thread with the completed fraction.
  explicit Task(std::function<void(double fraction)> progressed = {})
      : Threads{std::move(progressed)} {}

  /// `work` is called and destroyed on the new thread, `done` on the owner's thread. `done` may
  /// start the task again, but must not destroy it.
  void start(std::function<Result(const Watch&)> work, std::function<void(Result)> done) {
    const auto result = std::make_shared<Result>(tl::unexpected(noThread()));
    begin([work = std::move(work), result](const Watch& watch) { *result = resultOf(work, watch); },
          [done = std::move(done), result] { done(std::move(*result)); });
  }

 private:
  static Result resultOf(const std::function<Result(const Watch&)>& work, const Watch& watch) {
    try {
      return work(watch);
    } catch (const std::bad_alloc&) {
      return tl::unexpected(noMemory());
    } catch (const std::exception& thrown) {
      return tl::unexpected(threw(thrown.what()));
    } catch (...) {
      return tl::unexpected(threw("unknown"));
    }
  }
};

}  // namespace app::background
