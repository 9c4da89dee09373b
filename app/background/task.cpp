// SPDX-License-Identifier: BSD-3-Clause
#include "app/background/task.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QMetaObject>
#include <chrono>
#include <system_error>
#include <utility>

namespace app::background {
namespace {

// between two reports of progress; each has the window drawn anew
constexpr double kStep = 0.002;
constexpr std::chrono::milliseconds kPause{100};
constexpr int kLast = 10;  // a nice value

haptics::Error errorOf(const char* sentence, const char* reason) {
  return {haptics::Error::Kind::Unsupported,
          QCoreApplication::translate("app::background::Task", sentence).toStdString(), reason};
}

}  // namespace

void goLast() { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLast); }

haptics::Error noThread() {
  return errorOf(QT_TRANSLATE_NOOP("app::background::Task",
                                   "The system has no thread left for this; close other programs "
                                   "and try again."),
                 "no-thread");
}

haptics::Error noMemory() {
  return errorOf(
      QT_TRANSLATE_NOOP("app::background::Task",
                        "There is not enough memory for this; close other programs and try again."),
      kNoMemory);
}

haptics::Error threw(const char* words) { return {haptics::Error::Kind::Malformed, words, kThrew}; }

void Watch::advanced(double fraction) const {
  if (fraction < told_ + kStep) return;
  const auto now = std::chrono::steady_clock::now();
  if (told_ > 0.0 && now < told_at_ + kPause) return;
  told_ = fraction;
  told_at_ = now;
  Threads* owner = &owner_;
  if (owner->progressed_) owner->post(number_, [owner, fraction] { owner->progressed_(fraction); });
}

void Watch::tell(std::function<void()> action) const { owner_.post(number_, std::move(action)); }

Threads::~Threads() {
  for (Job& job : jobs_) job.cancel = true;
  for (Job& job : jobs_) job.thread.request_stop();
  wait();
}

void Threads::cancel() {
  if (jobs_.empty()) return;
  jobs_.back().cancel = true;
  jobs_.back().thread.request_stop();
}

void Threads::abandon() {
  cancel();
  ++number_;
  running_ = false;
}

void Threads::wait() {
  for (Job& job : jobs_)
    if (job.thread.joinable()) job.thread.join();
  jobs_.clear();
}

void Threads::begin(std::function<void(const Watch&)> work, std::function<void()> done) {
  abandon();
  // joined by their destructors, which have nothing to wait for
  jobs_.remove_if([](const Job& job) { return job.ended.load(); });
  running_ = true;
  const std::uint64_t number = number_;
  Job& job = jobs_.emplace_back();
  try {
    job.thread = std::jthread(
        [this, &job, number, work = std::move(work), done](const std::stop_token& stop) mutable {
          // what the work holds goes on this thread, before the result is told
          std::exchange(work, nullptr)(Watch{*this, number, job.cancel, stop});
          postDone(number, std::move(done));
          job.ended = true;
        });
  } catch (const std::system_error&) {
    jobs_.pop_back();
    postDone(number, std::move(done));
  }
}

void Threads::post(std::uint64_t number, std::function<void()> action) {
  QMetaObject::invokeMethod(
      &context_,
      [this, number, action = std::move(action)] {
        if (number == number_) action();
      },
      Qt::QueuedConnection);
}

void Threads::postDone(std::uint64_t number, std::function<void()> done) {
  post(number, [this, done = std::move(done)] {
    running_ = false;
    done();
  });
}

}  // namespace app::background
