// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <atomic>
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

/// Reasons of errors that stand for an exception. The message is a sentence for kNoMemory, and the
/// exception's own words for kThrew; the caller may say it better.
inline constexpr const char* kNoMemory = "no-memory";
inline constexpr const char* kThrew = "exception";

class Threads;

/// How the work sees whoever waits for it. Valid while the work runs, on its thread.
class Watch {
 public:
  /// Whether the work is to stop. The atomic and the token say the same.
  bool cancelled() const { return cancel; }
  const std::atomic<bool>& cancel;
  std::stop_token stop;

  /// Reports how much of the work is done, 0 to 1. Steps below 0.002 are left out.
  void advanced(double fraction) const;
  /// Has `action` called on the owner's thread, in order, before the result. Dropped once the task
  /// was abandoned, started again or destroyed.
  void tell(std::function<void()> action) const;

 private:
  friend class Threads;
  Watch(Threads& owner, std::uint64_t number, const std::atomic<bool>& cancelled,
        std::stop_token token)
      : cancel{cancelled}, stop{std::move(token)}, owner_{owner}, number_{number} {}

  Threads& owner_;
  std::uint64_t number_;
  mutable double told_ = 0.0;
};

/// What Task does whatever its result is. All calls come from the thread that made it, which needs
/// an event loop.
class Threads {
 public:
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  /// Asks the work to stop. Its result still comes: a file that was finished all the same is told
  /// of.
  void cancel();
  /// Asks the work to stop, and drops whatever it still reports.
  void abandon();
  /// Whether a result is still to come.
  bool isRunning() const { return running_; }
  /// Waits until no thread works any more. The result comes afterwards, as an event.
  void wait();

 protected:
  explicit Threads(std::function<void(double)> progressed) : progressed_{std::move(progressed)} {}
  /// Cancels and waits; what was not delivered is dropped.
  ~Threads();
  /// Runs `work` on a new thread and `done` on this one, later, even if there is no thread to be
  /// had.
  void begin(std::function<void(const Watch&)> work, std::function<void()> done);

 private:
  friend class Watch;
  struct Job {
    std::atomic<bool> cancel{false};
    std::atomic<bool> ended{false};  ///< its thread has nothing left to do
    std::jthread thread;
  };
  void post(std::uint64_t number, std::function<void()> action);
  void postDone(std::uint64_t number, std::function<void()> done);

  std::function<void(double)> progressed_;
  std::uint64_t number_ = 0;  ///< of the newest work; reports of another are dropped
  bool running_ = false;
  QObject context_;      ///< on the owner's thread: events that wait for it go with it
  std::list<Job> jobs_;  ///< the newest last; the others were cancelled, and are kept until ended
};

/// No thread could be had.
haptics::Error noThread();
/// The error that stands for std::bad_alloc.
haptics::Error noMemory();
/// The error that stands for any other exception, in its own words.
haptics::Error threw(const char* words);

/// Work on a thread of its own, whose result comes back to the thread that started it.
///
/// One task has one work at a time: starting again cancels the work before and drops its result,
/// without waiting for it; its thread ends beside the new one. `done` is called exactly once for a
/// work that is not dropped. An exception that leaves the work arrives as an Error. Only wait() and
/// the destructor wait for a thread.
template <class T>
class Task : public Threads {
 public:
  using Result = haptics::Expected<T>;

  /// `progressed` is called on the owner's thread with the fraction of the work that is done.
  explicit Task(std::function<void(double fraction)> progressed = {})
      : Threads{std::move(progressed)} {}

  /// `work` is called on the new thread and destroyed there; `done` on the owner's. `done` may
  /// start the task again; it may not destroy it.
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
