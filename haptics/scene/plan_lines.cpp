// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <string>

#include "haptics/scene/scene.h"

namespace haptics {
namespace {

Message valueOf(double x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return Message::numbers({text.data(), end});
}

Message proofsOf(std::size_t points, std::size_t leaves) {
  const std::string count = std::to_string(points);
  if (leaves > 1) return {"plan-empty-space-why", {count, std::to_string(leaves)}};
  if (points == 1) return {"plan-empty-space-one-point", {}};
  return {"plan-empty-space-one-leaf", {count}};
}

}  // namespace

PlanLines linesOf(const Plan& plan, const SceneOptions& options, const Volume& volume,
                  const ShellTree& tree) {
  const auto points = static_cast<std::size_t>(tree.size());
  std::size_t leaves = 0;
  for (const ShellTree::Node& node : tree.nodes) leaves += node.leaf ? 1 : 0;
  const Message off{"plan-switched-off", {}};
  PlanLines lines;
  lines[0] = {&Plan::free_space,
              {"plan-free-space", {}},
              plan.free_space,
              plan.free_space           ? Message{"plan-free-space-why", {valueOf(volume.greatest)}}
              : options.plan.free_space ? Message{"plan-rests-on-another", {}}
                                        : off};
  lines[1] = {&Plan::empty_space,
              {"plan-empty-space", {}},
              plan.empty_space,
              plan.empty_space ? proofsOf(points, leaves) : off};
  lines[2] = {&Plan::unspent_room,
              {"plan-unspent-room", {}},
              plan.unspent_room,
              plan.unspent_room ? Message{"plan-unspent-room-why", {}} : off};
  lines[3] = {&Plan::far_gradients,
              {"plan-far-gradients", {}},
              plan.far_gradients,
              plan.far_gradients ? Message{"plan-far-gradients-why", {}} : off};
  lines[4] = {&Plan::central_differences,
              {"plan-central-differences", {}},
              plan.central_differences,
              plan.central_differences ? Message{"plan-central-differences-why", {}}
              : options.normal == NormalKind::Central
                  ? Message{"plan-central-differences-taken", {}}
                  : off};
  lines[5] = {&Plan::still_rows,
              {"plan-still-rows", {}},
              plan.still_rows,
              plan.still_rows ? Message{"plan-still-rows-why", {}} : off};
  return lines;
}

}  // namespace haptics
