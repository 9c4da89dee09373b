// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace datasets {

// Corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2). Edges 0 to 3 are along i, 4 to 7 along j,
// 8 to 11 along k.

struct CellEdge {
  int from, to;  ///< corners
};
inline constexpr std::array<CellEdge, 12> kCellEdges{{{0, 1},
                                                      {2, 3},
                                                      {4, 5},
                                                      {6, 7},
                                                      {0, 2},
                                                      {1, 3},
                                                      {4, 6},
                                                      {5, 7},
                                                      {0, 4},
                                                      {1, 5},
                                                      {2, 6},
                                                      {3, 7}}};
/// The corners of each face, anticlockwise as seen from outside.
inline constexpr std::array<std::array<int, 4>, 6> kCellFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// The triangles of one cell, in a right-handed grid turned away from the solid.
struct CellTriangles {
  /// Edges of the cell with a corner of the surface. The number 12 + n is the middle of loop n of
  /// `middles`.
  std::vector<std::array<std::uint8_t, 3>> triangles;
  std::vector<std::vector<std::uint8_t>> middles;  ///< the edges of the loop around each
};

/// Marching cubes in which both cells of a face agree about it, so the surface is closed. The lines
/// in which it meets the faces of a cell are joined to loops. A loop is filled without a diagonal
/// on a face, which the cell beyond could have too, or by triangles around its middle. So each edge
/// has two triangles.
class CellCases {
 public:
  /// `solid`: a bit for each corner. `joined`: a bit for each face whose two solid corners, across
  /// from each other, are connected on it.
  const CellTriangles& of(unsigned solid, unsigned joined);

 private:
  std::array<std::unique_ptr<const CellTriangles>, 256 * 64> made_;
};

}  // namespace datasets
