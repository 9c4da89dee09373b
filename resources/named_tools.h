// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/triangle_mesh.h"

namespace resources {

/// A tool that is compiled in: a row of the table in resources/CMakeLists.txt. The meshes of
/// resources/tools are drawn by draw_tools.py.
struct NamedTool {
  std::string name;     ///< on the command line, in recordings and in views
  std::string use;      ///< the group it is listed in, English
  std::string title;    ///< English
  double length = 0.0;  ///< m, along the tool's axis z
  /// m: diameter of the ball or the wire at the tip, width of the blade, thickness of the wrench,
  /// side of the peg.
  double tip = 0.0;

  /// Whether the ball at its tip may cut.
  bool cuts() const { return use == "Drilling" || name == "sphere"; }
};

/// All of them; those of one use follow each other.
const std::vector<NamedTool>& namedTools();

/// Null if the name is none of theirs.
const NamedTool* findNamedTool(std::string_view name);

/// Their names in a sentence: "burr-2, burr-4, …".
std::string namesOfTools();
std::string namesOfCuttingTools();

/// A named tool's mesh in metres; an unknown name lists the known ones.
haptics::Expected<haptics::TriangleMesh> namedToolMesh(const std::string& name);

}  // namespace resources
