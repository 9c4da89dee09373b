// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/tool/shell_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
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

/// The box of a node with all its points.
ShellTree::Box boxOf(const ShellTree& tree, const ShellTree::Node& node) {
  const auto first = static_cast<std::size_t>(node.first);
  const auto point = [&](int i) {
    const auto at = first + static_cast<std::size_t>(i);
    return Vec3{tree.x[at], tree.y[at], tree.z[at]};
  };
  Vec3 mean = Vec3::Zero();
  Mat3 squares = Mat3::Zero();
  for (int i = 0; i < node.count; ++i) {
    const Vec3 p = point(i) - node.centre;
    mean += p;
    squares += p * p.transpose();
  }
  mean /= node.count;
  const Mat3 spread = squares / node.count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver{spread};
  const Mat3 axes = solver.eigenvectors().rowwise().reverse();  // the thinnest last

  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  ShellTree::Box box;
  std::array<double, ShellTree::Box::kOutermost> farthest;
  farthest.fill(-std::numeric_limits<double>::infinity());
  for (int i = 0; i < node.count; ++i) {
    const Vec3 p = axes.transpose() * (point(i) - node.centre);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (std::size_t k = 0; k < farthest.size(); ++k) {
      const Vec3 way = k < 8 ? Vec3{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0}
                             : Vec3{0.0, 0.0, k == 8 ? 1.0 : -1.0};
      const double far = way.dot(p);
      if (far <= farthest[k]) continue;
      farthest[k] = far;
      box.outermost[k] = node.first + i;
    }
  }
  box.centre = node.centre + axes * (0.5 * (low + high));
  // a little wider than rounding could make a point lie
  const Vec3 half = 0.5 * (high - low) + Vec3::Constant(1e-9 * node.radius);
  box.half = axes * half.asDiagonal();
  return box;
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
  if (size() <= kDense) return;
  boxes.resize(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].count >= kLeastBox) boxes[n] = boxOf(*this, nodes[n]);
}

std::size_t ShellTree::bytes() const {
  return nodes.size() * sizeof(Node) + boxes.size() * sizeof(Box) + index.size() * sizeof(int) +
         4 * x.size() * sizeof(double);
}

}  // namespace haptics
