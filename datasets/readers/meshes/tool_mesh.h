// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/triangle_mesh.h"

namespace datasets {

enum class MeshUnit { Metre, Millimetre, Centimetre, Inch };

/// Of "m", "mm", "cm" or "in"; none of anything else.
std::optional<MeshUnit> meshUnitNamed(std::string_view name);

struct ToolMesh {
  haptics::TriangleMesh mesh;              ///< metres; coincident vertices merged
  std::vector<haptics::Message> warnings;  ///< open, non-manifold, suspiciously long or short
};

/// Reads STL, OBJ or PLY. Refuses a mesh without a triangle, with a non-finite
/// vertex, truncated, or with an index out of range; says when it is open or non-manifold, longer
/// than 0.5 m or shorter than 1 mm.
haptics::Expected<ToolMesh> readToolMesh(const std::filesystem::path& path, MeshUnit unit);

}  // namespace datasets
