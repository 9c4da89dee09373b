// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace haptics {

/// Sets every motor to zero force permanently. Every watchdog of the process stops its device
/// within a millisecond, and none releases it. A device with a thread of its own has sent the zero
/// some 6 ms later. Callable from any thread and any signal handler.
void stopAllMotors() noexcept;
bool motorsAreStopped() noexcept;

/// Call it in the first line of main(). From then on a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL,
/// SIGABRT) stops all motors, waits 20 ms for that, and then ends the process as usual. A stack
/// overflow does so only in the thread that called this function. If the thread that writes to a
/// device crashes, the device keeps the last force written.
void installCrashStop() noexcept;

/// What a crash does besides, after the motors were stopped and before the process ends: once, in
/// the thread that crashed, for the first crash. `context`: as sigaction() has it. It may do only
/// what a signal handler may; after 5 s the process ends. Null: nothing.
using AfterCrashStop = void (*)(int signal, void* context);
void setAfterCrashStop(AfterCrashStop call) noexcept;

/// Stops all motors in exit(), whoever calls it, before exit handlers and static destructors that
/// were registered earlier. So each watchdog calls this when it starts.
void stopAtExit() noexcept;

}  // namespace haptics
