// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function that runs inside the servo period. It may not allocate, lock, wait,
/// throw, log or touch a file; neither may anything it calls. tests/support/no_allocation.h
/// holds every hand and scene to it.
#define HAPTICS_RT noexcept
