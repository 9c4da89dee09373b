// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace haptics {

/// Zero to every motor, for good: every watchdog of the process stops its device within a
/// millisecond, and none lets it go on; a device with a thread of its own has sent it some 6 ms
/// later. Any thread, and any signal handler.
void stopAllMotors() noexcept;
bool motorsAreStopped() noexcept;

/// For the first line of main(): a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) stops all
/// motors, waits 20 ms for that, and then goes its ordinary way. So does the stack's end of the
/// thread that calls this; of others it does not. A crash of the very thread that a device is
/// written on ends with what was written last.
void installCrashStop() noexcept;

/// The same for exit(), whoever calls it. Before all that was registered or made static earlier, so
/// each watchdog says it as it starts.
void stopAtExit() noexcept;

}  // namespace haptics
