// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/triangle_mesh.h"

namespace resources {

/// sphere, probe, drill, cane, wrench, peg: drawn by resources/tools/draw_tools.py, compiled in.
std::vector<std::string> namedTools();

/// A named tool's mesh in metres; an unknown name lists the known ones.
haptics::Expected<haptics::TriangleMesh> namedToolMesh(const std::string& name);

}  // namespace resources
