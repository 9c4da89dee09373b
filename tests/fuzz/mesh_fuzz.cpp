// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the mesh of a tool; the first byte tells the format.
#include <cstdint>
#include <string>
#include <string_view>

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
  return 0;
}
