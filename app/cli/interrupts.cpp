// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/interrupts.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "app/cli/outcome.h"
#include "haptics/process/output_file.h"

namespace app::cli {
namespace {

using Clock = std::chrono::steady_clock;
// a terminal's Ctrl+C may come twice within it, from the shell and from a program between
constexpr std::chrono::milliseconds kPatience{500};

std::atomic<bool> asked{false};
std::atomic<int> closing{0};

sigset_t endingSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction how {};
    sigaction(signal, nullptr, &how);
    if (signal != SIGHUP || how.sa_handler != SIG_IGN) sigaddset(&set, signal);
  }
  return set;
}

[[noreturn]] void endNow(bool json) {
  haptics::discardOutputs();
  // a terminal or pipe may take nothing any more
  std::signal(SIGALRM, [](int) { ::_exit(static_cast<int>(Exit::Interrupted)); });
  ::alarm(1);
  printUnlessPrinted(stopped(), json);
  ::_exit(static_cast<int>(Exit::Interrupted));
}

}  // namespace

const std::atomic<bool>& interruption() { return asked; }

Interrupts::Interrupts(bool json) {
  // a file that may not grow, or a pipe that nobody reads, is an error like any other
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  const sigset_t set = endingSignals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  thread_ = std::thread{[this, json] { wait(json); }};
}

Interrupts::~Interrupts() {
  over_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

void Interrupts::wait(bool json) {
  const sigset_t set = endingSignals();
  Clock::time_point since{};
  for (;;) {
    constexpr timespec kLook{0, 50'000'000};
    const int signal = asked ? sigtimedwait(&set, nullptr, &kLook) : sigwaitinfo(&set, nullptr);
    if (over_) return;
    if (signal > 0 && !asked.exchange(true)) {
      since = Clock::now();
    } else if (asked && Clock::now() - since > kPatience && (signal > 0 || closing == 0)) {
      endNow(json);
    }
  }
}

Closing::Closing() { ++closing; }
Closing::~Closing() { --closing; }

}  // namespace app::cli
