// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace haptics {

/// Zero to every motor, for good: every watchdog of the process stops its device within a
/// millisecond, and none lets it go on; a device with a thread of its own has sent it some 6 ms
/// later. Any thread, and any signal handler.
void stopAllMotors() noexcept;
bool motorsAreStopped() noexcept;

/// For the first line of main(): a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) and exit(),
/// whoever calls it, stop all motors, wait 20 ms for that, and then go their ordinary way. So does
/// the stack's end of the thread that calls this; of others it does not. A crash of the very thread
/// that a device is written on ends with what was written last.
void installCrashStop() noexcept;

}  // namespace haptics
