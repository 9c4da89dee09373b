// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>

#include "haptics/scene/scene.h"

namespace haptics {
namespace {

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string valueOf(double x) {
  // as it is written in a C locale, whichever the window has set
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return {text.data(), end};
}

}  // namespace

PlanLines linesOf(const Plan& plan, const SceneOptions& options, const Volume& volume,
                  const ShellTree& tree) {
  const auto points = static_cast<std::size_t>(tree.size());
  std::size_t leaves = 0;
  for (const ShellTree::Node& node : tree.nodes) leaves += node.leaf ? 1 : 0;
  const std::string off = "it was switched off";
  PlanLines lines;
  lines[0] = {
      &Plan::free_space, "collision detection and contact rows in free space", plan.free_space,
      plan.free_space ? "in a tick in which every point of the tool has more room than the hand "
                        "moved, nothing can be met; so it is always above " +
                            valueOf(volume.greatest) + ", the greatest value of the volume"
      : options.plan.free_space ? "it rests on another that was switched off"
                                : off};
  lines[1] = {
      &Plan::empty_space, "sampling where the pyramid's bounds prove the volume free",
      plan.empty_space,
      plan.empty_space
          ? (leaves > 1 ? "a block below the isovalue proves whole branches of the tool free (" +
                              counted(points, "point", "points") + " in " +
                              counted(leaves, "leaf", "leaves") + "), and paths"
                        : "a block below the isovalue proves what lies in it free, points and "
                          "paths; branches there are none, the tool is one leaf of " +
                              counted(points, "point", "points"))
          : off};
  lines[2] = {
      &Plan::unspent_room, "another look at points whose room is not used up", plan.unspent_room,
      plan.unspent_room ? "what was proven free stays so until the tool has moved that far" : off};
  lines[3] = {
      &Plan::far_gradients, "gradients of points beyond the contact band", plan.far_gradients,
      plan.far_gradients ? "only a point within a tenth of a voxel of the surface has a row" : off};
  lines[4] = {&Plan::central_differences, "central differences", plan.central_differences,
              plan.central_differences ? "the rows take another normal: six of a point's seven "
                                         "samples would be for nothing"
              : options.normal == NormalKind::Central ? "the rows take them for their normals"
                                                      : off};
  lines[5] = {&Plan::still_rows, "rows anew while the tool is still", plan.still_rows,
              plan.still_rows ? "at the same pose they are the same" : off};
  return lines;
}

}  // namespace haptics
