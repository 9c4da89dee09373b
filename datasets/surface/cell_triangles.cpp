// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/surface/cell_triangles.h"

#include <algorithm>
#include <span>
#include <utility>

namespace datasets {
namespace {

constexpr int kNone = -1;

int edgeBetween(int a, int b) {
  const auto found = std::ranges::find_if(kCellEdges, [&](const CellEdge& edge) {
    return (edge.from == a && edge.to == b) || (edge.from == b && edge.to == a);
  });
  return static_cast<int>(found - kCellEdges.begin());
}

bool onOneFace(int edge, int other) {
  return std::ranges::any_of(kCellFaces, [&](const std::array<int, 4>& face) {
    const auto has = [&](int corner) { return std::ranges::find(face, corner) != face.end(); };
    const auto lies = [&](int e) { return has(kCellEdges[e].from) && has(kCellEdges[e].to); };
    return lies(edge) && lies(other);
  });
}

using Triangles = std::vector<std::array<std::uint8_t, 3>>;

/// Adds the triangles of a polygon; false, with nothing added, if a diagonal would lie on a face.
bool fill(std::span<const std::uint8_t> polygon, Triangles& triangles) {
  const std::size_t last = polygon.size() - 1;
  if (last < 2) return true;
  for (std::size_t n = 1; n < last; ++n) {
    if (n > 1 && onOneFace(polygon[0], polygon[n])) continue;
    if (n + 1 < last && onOneFace(polygon[n], polygon[last])) continue;
    const std::size_t before = triangles.size();
    triangles.push_back({polygon[0], polygon[n], polygon[last]});
    if (fill(polygon.first(n + 1), triangles) && fill(polygon.subspan(n), triangles)) return true;
    triangles.resize(before);
  }
  return false;
}

CellTriangles made(unsigned solid, unsigned joined) {
  // where the line that comes to an edge goes on
  std::array<int, 12> next;
  next.fill(kNone);
  for (std::size_t f = 0; f < kCellFaces.size(); ++f) {
    const auto& corner = kCellFaces[f];
    const auto isSolid = [&](int n) { return (solid >> corner[n & 3] & 1) != 0; };
    const auto edge = [&](int n) { return edgeBetween(corner[n & 3], corner[(n + 1) & 3]); };
    for (int n = 0; n < 4; ++n) {
      if (isSolid(n) || !isSolid(n + 1)) continue;
      // a line begins where the way around the face enters the solid, and ends where it leaves it
      int leave = n + 1;
      if ((joined >> f & 1) != 0)
        leave = n + 3;
      else
        while (isSolid(leave + 1)) ++leave;
      next[edge(n)] = edge(leave);
    }
  }
  CellTriangles cell;
  for (int first = 0; first < 12; ++first) {
    std::vector<std::uint8_t> loop;
    for (int at = first; next[at] != kNone;) {
      loop.push_back(static_cast<std::uint8_t>(at));
      at = std::exchange(next[at], kNone);
    }
    if (loop.empty() || fill(loop, cell.triangles)) continue;
    const auto middle = static_cast<std::uint8_t>(12 + cell.middles.size());
    for (std::size_t n = 0; n < loop.size(); ++n)
      cell.triangles.push_back({loop[n], loop[(n + 1) % loop.size()], middle});
    cell.middles.push_back(std::move(loop));
  }
  return cell;
}

}  // namespace

const CellTriangles& CellCases::of(unsigned solid, unsigned joined) {
  auto& cell = made_[solid << 6 | joined];
  if (!cell) cell = std::make_unique<const CellTriangles>(made(solid, joined));
  return *cell;
}

}  // namespace datasets
