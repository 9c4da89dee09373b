// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "datasets/readers/scan.h"

namespace datasets {

/// How many threads onAllCores uses for so many pieces.
std::size_t workersFor(std::size_t count);

/// Calls `work(i)` for each i below `count`, from several threads of low priority, one a core; the
/// caller reports the progress meanwhile. False if it was cancelled, or once `work` returns false;
/// what `work` throws is thrown on.
bool onAllCores(std::size_t count, const ReadProgress& progress,
                const std::function<bool(std::size_t)>& work);

}  // namespace datasets
