// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "datasets/edits/walls.h"
#include "haptics/scene/watch.h"

namespace app {

/// The structures of a watch that are solid or not there, as the touched volume has them; null:
/// none.
std::vector<datasets::StructureWall> wallsOf(const haptics::Watch* watch);

}  // namespace app
