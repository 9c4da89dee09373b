// SPDX-License-Identifier: BSD-3-Clause
#include "app/signals.h"

#include <pthread.h>

#include <csignal>
#include <utility>

#include "haptics/servo/emergency.h"

namespace app {
namespace {

sigset_t endingSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&set, signal);
  return set;
}

}  // namespace

void blockEndingSignals() {
  const sigset_t set = endingSignals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  // who is stopped, or ended by a pipe, cannot take a force back
  for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU, SIGPIPE}) std::signal(signal, SIG_IGN);
}

EndingSignals::EndingSignals(std::function<void()> end)
    : end_(std::move(end)), thread_([this] { wait(); }) {}

EndingSignals::~EndingSignals() {
  over_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

void EndingSignals::wait() {
  const sigset_t set = endingSignals();
  bool asked = false;
  for (;;) {
    int signal = 0;
    if (sigwait(&set, &signal) != 0) continue;
    if (over_) return;
    haptics::stopAllMotors();
    if (!std::exchange(asked, true)) {
      end_();
      continue;
    }
    // whatever holds the process up, the user wants it gone
    std::signal(signal, SIG_DFL);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    pthread_kill(pthread_self(), signal);
  }
}

}  // namespace app
