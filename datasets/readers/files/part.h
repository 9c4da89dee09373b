// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// The voxels that a part takes of a volume: along each axis `count`, every `step`, from `first`.
struct Window {
  std::array<std::int64_t, 3> first{}, count{};
  std::int64_t step = 1;
};

/// Refuses ("no-voxels") a box that is empty or reaches beyond the volume, and a step below 1.
haptics::Expected<Window> windowOf(const Part& part, const std::array<std::int64_t, 3>& dims);

/// Where the voxels of the window lie.
haptics::Grid gridOf(const haptics::Grid& whole, const Window& window);

}  // namespace datasets
