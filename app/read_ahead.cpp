// SPDX-License-Identifier: BSD-3-Clause
#include "app/read_ahead.h"

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <exception>
#include <utility>

namespace app {
namespace {

constexpr std::chrono::milliseconds kUnderWay{100};  // waited for the threads of a reading

/// Threads that begin meanwhile leave the signals that end a program to others.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

ReadAhead::ReadAhead(std::filesystem::path file) : file_(std::move(file)) {
  try {
    auto header = datasets::headerOf(file_);
    if (!header || !(*header)->isReadDirectly()) return;
    const SignalsBlocked blocked;
    std::future<void> under_way = under_way_.get_future();
    volume_ = std::async(std::launch::async, [this, header = std::move(*header)] {
      auto volume = read(*header);
      advanced(1.0);
      return volume;
    });
    // a thread that is to begin while a library is being loaded waits until it is loaded
    under_way.wait_for(kUnderWay);
  } catch (const std::exception&) {
    // no thread, or a file that cannot be looked at: the loader reads
  }
}

void ReadAhead::advanced(double fraction) {
  fraction_ = fraction;
  if (!is_under_way_.exchange(true)) under_way_.set_value();
}

std::optional<haptics::Volume> ReadAhead::read(const datasets::VolumeHeader& header) {
  try {
    auto volume = datasets::readDirectly(
        header, {.advanced = [this](double f) { advanced(f); }, .cancel = &cancel_});
    if (!volume || !header.isUpToDate()) return {};
    return std::move(*volume);
  } catch (const std::exception&) {  // no memory, say
    return {};
  }
}

ReadAhead::~ReadAhead() { cancel_ = true; }

std::optional<haptics::Volume> ReadAhead::take(const datasets::ReadProgress& progress) {
  return takeWhenMade(volume_, fraction_, progress);
}

}  // namespace app
