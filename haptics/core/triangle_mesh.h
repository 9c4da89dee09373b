// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/geometry.h"

namespace haptics {

/// A tool as it is drawn. Vertices in metres, in the mesh's own axes; triangles index them.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace haptics
