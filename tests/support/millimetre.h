// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "haptics/core/budget.h"

/// What tests on small volumes share.
namespace millimetre {

inline constexpr double h = 1e-3;  ///< m: the voxel of the volumes made for them

/// A budget that cuts nothing.
inline haptics::Budget unlimited() {
  return haptics::Budget::counted(std::numeric_limits<std::int64_t>::max());
}

}  // namespace millimetre
