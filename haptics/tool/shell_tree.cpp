// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/tool/shell_tree.h"

#include <algorithm>
#include <numeric>

namespace haptics {
namespace {

/// Appends the node of order[first, first + count) and all below it.
void append(const std::vector<Vec3>& points, std::vector<int>& order, int first, int count,
            std::vector<ShellTree::Node>& nodes) {
  const std::size_t at = nodes.size();
  nodes.emplace_back();
  ShellTree::Node node;
  node.first = first;
  node.count = count;
  node.leaf = count <= ShellTree::kLeaf;
  Vec3 low = points[static_cast<std::size_t>(order[static_cast<std::size_t>(first)])], high = low;
  for (int i = first; i < first + count; ++i) {
    const Vec3& p = points[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])];
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  node.centre = 0.5 * (low + high);
  for (int i = first; i < first + count; ++i) {
    const Vec3& p = points[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])];
    node.radius = std::max(node.radius, (p - node.centre).norm());
    node.arm = std::max(node.arm, p.norm());
  }
  if (!node.leaf) {
    // half of the leaves to each side of the longest axis
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const int leaves = (count + ShellTree::kLeaf - 1) / ShellTree::kLeaf;
    const int left = (leaves + 1) / 2 * ShellTree::kLeaf;
    std::nth_element(order.begin() + first, order.begin() + first + left,
                     order.begin() + first + count, [&](int a, int b) {
                       const double pa = points[static_cast<std::size_t>(a)][axis],
                                    pb = points[static_cast<std::size_t>(b)][axis];
                       return pa != pb ? pa < pb : a < b;
                     });
    append(points, order, first, left, nodes);
    append(points, order, first + left, count - left, nodes);
  }
  node.next = static_cast<int>(nodes.size());
  nodes[at] = node;
}

}  // namespace

ShellTree::ShellTree(const std::vector<Vec3>& points) : index(points.size()) {
  std::iota(index.begin(), index.end(), 0);
  if (!points.empty()) append(points, index, 0, size(), nodes);
  const std::size_t padded = points.size() + kLeaf;
  x.assign(padded, 0.0);
  y.assign(padded, 0.0);
  z.assign(padded, 0.0);
  arm.assign(padded, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[static_cast<std::size_t>(index[i])];
    x[i] = p.x();
    y[i] = p.y();
    z[i] = p.z();
    arm[i] = p.norm();
  }
}

std::size_t ShellTree::bytes() const {
  return nodes.size() * sizeof(Node) + index.size() * sizeof(int) + 4 * x.size() * sizeof(double);
}

}  // namespace haptics
