// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/emergency.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>

namespace haptics {
namespace {

std::atomic<bool> stopped{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

constexpr long kGraceNs = 20'000'000;

extern "C" void onCrash(int signal) {
  const int error = errno;
  stopAllMotors();
  timespec left{0, kGraceNs};
  while (nanosleep(&left, &left) != 0 && errno == EINTR) {
  }
  errno = error;
  // what was done before happens again, now without us; abort() and kill() do not come back
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

void stopAllMotors() noexcept { stopped.store(true, std::memory_order_release); }
bool motorsAreStopped() noexcept { return stopped.load(std::memory_order_acquire); }

void installCrashStop() noexcept {
  struct sigaction action {};
  action.sa_handler = onCrash;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigaction(signal, &action, nullptr);
}

}  // namespace haptics
