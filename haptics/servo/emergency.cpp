// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/emergency.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <ctime>

namespace haptics {
namespace {

std::atomic<bool> stopped{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

std::atomic<AfterCrashStop> after_crash_stop{nullptr};
static_assert(std::atomic<AfterCrashStop>::is_always_lock_free);
std::atomic<pid_t> crashed{0};  // the first thread that did
static_assert(std::atomic<pid_t>::is_always_lock_free);

constexpr long kGraceNs = 20'000'000;
constexpr unsigned kMostSeconds = 5;  // of what a crash does besides
constexpr std::size_t kStackBytes = 65'536;

void stopAndWait() noexcept {
  stopAllMotors();
  timespec left{0, kGraceNs};
  while (nanosleep(&left, &left) != 0 && errno == EINTR) {
  }
}

extern "C" void onExit() {
  if (!motorsAreStopped()) stopAndWait();
}

extern "C" void onCrash(int signal, siginfo_t*, void* context) {
  const int error = errno;
  stopAndWait();
  // a thread that crashes meanwhile does not end the process: the first one does
  pid_t first = 0;
  if (!crashed.compare_exchange_strong(first, gettid()) && first != gettid())
    for (;;) pause();
  // if it crashes as well, the kernel or this function again ends the process; if it waits for
  // ever, for a lock or a disk, the alarm does
  if (const AfterCrashStop call = after_crash_stop.exchange(nullptr)) {
    alarm(kMostSeconds);
    call(signal, context);
  }
  errno = error;
  // what was done before happens again, now without us; abort() and kill() do not come back
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

void stopAllMotors() noexcept { stopped.store(true, std::memory_order_release); }
bool motorsAreStopped() noexcept { return stopped.load(std::memory_order_acquire); }

void setAfterCrashStop(AfterCrashStop call) noexcept { after_crash_stop.store(call); }

// the display's library ends the process so when the display is gone
void stopAtExit() noexcept { std::atexit(onExit); }

void installCrashStop() noexcept {
  // where the stack has ended the handler needs another
  static std::array<std::byte, kStackBytes> spare;
  stack_t stack{};
  stack.ss_sp = spare.data();
  stack.ss_size = spare.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_sigaction = onCrash;
  action.sa_flags = SA_ONSTACK | SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigaction(signal, &action, nullptr);
}

}  // namespace haptics
