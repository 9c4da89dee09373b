// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the mesh of a tool, and as a surface that marks a structure; the first byte tells
// the format.
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/labels/surface_inside.h"
#include "datasets/readers/meshes/tool_mesh.h"
#include "tests/fuzz/require.h"
#include "tests/support/scratch_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const support::ScratchFolder scratch;
  if (size == 0) return 0;
  constexpr const char* kNames[] = {"tool.stl", "tool.obj", "tool.ply"};
  const auto path = scratch.write(
      kNames[bytes[0] % 3], std::string_view(reinterpret_cast<const char*>(bytes) + 1, size - 1));
  const auto tool = datasets::readToolMesh(path, datasets::MeshUnit::Millimetre);
  if (!tool) {
    fuzz::require(!tool.error().message.empty() && !tool.error().reason.empty(),
                  "a refusal has a sentence and a reason");
    return 0;
  }
  fuzz::require(!tool->mesh.triangles.empty(), "a tool has a triangle");
  for (const auto& triangle : tool->mesh.triangles)
    for (const std::uint32_t corner : triangle)
      fuzz::require(corner < tool->mesh.vertices.size(), "a corner is a vertex");
  for (const haptics::Vec3& vertex : tool->mesh.vertices)
    fuzz::require(vertex.allFinite(), "a vertex is a place");
  haptics::Grid grid;
  grid.dims = {6, 5, 4};
  grid.spacing = haptics::Vec3::Constant(7e-3);
  auto map = datasets::LabelMap::over(grid).value();
  if (const auto added = datasets::addSurface(map, path, datasets::SurfaceSpace::Lps, {})) {
    std::int64_t counted = 0;
    for (int n = 0; n < 120; ++n) counted += map.codes()[n];
    fuzz::require(counted == map.structures().front().voxels,
                  "a structure has the voxels it states");
  } else {
    fuzz::require(!added.error().message.empty() && !added.error().reason.empty(),
                  "a refusal has a sentence and a reason");
  }
  return 0;
}
