// SPDX-License-Identifier: BSD-3-Clause
#include "app/read_ahead.h"

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <exception>
#include <utility>

#include "datasets/readers/volume_header.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kLook{20};  // between looks at Cancel

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
    if (!datasets::isVolumeFile(file_)) return;
    auto header = datasets::headerOf(file_);
    if (!header || !(*header)->isReadAlone()) return;
    const SignalsBlocked blocked;
    volume_ = std::async(std::launch::async,
                         [this, header = std::move(*header)]() -> std::optional<haptics::Volume> {
                           const datasets::ReadProgress progress{
                               .advanced = [this](double f) { fraction_ = f; }, .cancel = &cancel_};
                           try {
                             auto volume = datasets::readOnly(*header, progress);
                             if (!volume || !header->isUpToDate()) return {};
                             return std::move(*volume);
                           } catch (const std::exception&) {  // no memory, say
                             return {};
                           }
                         });
  } catch (const std::exception&) {
    // no thread, or a file that cannot be looked at: the loader reads
  }
}

ReadAhead::~ReadAhead() { cancel_ = true; }

std::optional<haptics::Volume> ReadAhead::take(const datasets::ReadProgress& progress) {
  if (!volume_.valid()) return {};
  while (volume_.wait_for(kLook) != std::future_status::ready) {
    if (progress.isCancelled()) return {};
    progress.advanced(fraction_);
  }
  return volume_.get();
}

}  // namespace app
