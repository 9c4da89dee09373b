// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "haptics/core/geometry.h"

namespace haptics {

/// A shell's points in the order of a tree of bounding spheres: neighbours lie together, by
/// coordinate, sixteen to a leaf. Built once a tool; in the tool frame [m].
class ShellTree {
 public:
  static constexpr int kLeaf = 16;

  /// A sphere around some of the points. Nodes are in preorder: the first child of a node follows
  /// it, and `next` is the node after the subtree.
  struct Node {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
    double arm = 0.0;  ///< distance of the farthest of its points from the tool's origin
    int next = 0;
    int first = 0;  ///< first of its points, in tree order
    int count = 0;
    bool leaf = false;
  };

  /// The box of a node: its principal axes, around all of its points.
  struct Box {
    Vec3 centre = Vec3::Zero();
    Mat3 half = Mat3::Zero();  ///< columns: from the centre to a face, the thinnest last
    /// Places of points at its corners, and the farthest either way along the thinnest axis. One of
    /// them stands for the node in the rows of step 3.
    static constexpr int kOutermost = 10;
    std::array<int, kOutermost> outermost{};
  };
  static constexpr int kDense = 4096;   ///< a tool with more points has boxes
  static constexpr int kLeastBox = 32;  ///< points; the boxes of smaller nodes are empty

  explicit ShellTree(const std::vector<Vec3>& points);

  int size() const { return static_cast<int>(index.size()); }
  std::size_t bytes() const;

  std::vector<Node> nodes;
  std::vector<Box> boxes;       ///< of the nodes of a dense tool; empty otherwise
  std::vector<int> index;       ///< index into the shell's points, for each place in tree order
  std::vector<double> x, y, z;  ///< coordinates in tree order, followed by kLeaf zeros
  std::vector<double> arm;      ///< distance from the tool's origin
};

}  // namespace haptics
