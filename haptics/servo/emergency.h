// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace haptics {

/// Zero to every motor within two milliseconds, for good: every watchdog of the process stops its
/// device, and none lets it go on. Any thread, and any signal handler.
void stopAllMotors() noexcept;
bool motorsAreStopped() noexcept;

/// For the first line of main(): a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) stops all
/// motors, waits 20 ms for the watchdogs to do so, and then goes its ordinary way.
void installCrashStop() noexcept;

}  // namespace haptics
