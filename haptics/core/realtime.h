// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function that runs inside the servo period. It may not allocate, lock, wait,
/// throw, log or use a file, nor call a function that does. Tests check it with
/// tests/support/no_allocation.h for every hand and scene.
#define HAPTICS_RT noexcept
