// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>

#include "datasets/labels/label_map.h"

namespace datasets {

/// The structures of a named phantom over a grid, in the order of phantomStructures(): a voxel
/// belongs to those whose distance at its centre is at most 0. A phantom without structures gives a
/// map without any. Refuses what LabelMap refuses. Once `cancel` is true, the result is
/// Error::Kind::Cancelled.
haptics::Expected<LabelMap> phantomLabels(const std::string& phantom, const haptics::Grid& grid,
                                          const std::atomic<bool>* cancel = nullptr);

}  // namespace datasets
