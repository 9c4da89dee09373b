// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

namespace haptics {

/// Threads that the machine runs at once; at least 1.
int coreCount();

/// Calls work(n) once for each n below `count`, in no order, on this thread and up to `threads` - 1
/// more. Returns once all have ended. What `work` throws is thrown on; the rest is then left out.
void inParallel(std::int64_t count, const std::function<void(std::int64_t)>& work,
                int threads = coreCount());

}  // namespace haptics
