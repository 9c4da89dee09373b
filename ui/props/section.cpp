// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/section.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "ui/props/picture.h"

namespace ui {

std::vector<QPolygonF> sectionOf(const haptics::TriangleMesh& mesh, const haptics::Pose& X_WM,
                                 const PlaneAxes& axes, const Eigen::Vector3d& origin_W_mm) {
  // columns: right, up, towards the viewer
  Eigen::Matrix3d A_WS;
  A_WS << axes.right, axes.up, axes.right.cross(axes.up);
  const Eigen::Matrix3d A_SM = A_WS.transpose() * X_WM.linear() * kMmPerM;
  const Eigen::Vector3d origin_S = A_WS.transpose() * (X_WM.translation() * kMmPerM - origin_W_mm);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const haptics::Vec3& v : mesh.vertices) vertices.emplace_back(A_SM * v + origin_S);

  // each triangle that is cut joins two of its edges; an edge knows the triangles that end on it
  using Edge = std::uint64_t;
  std::vector<std::array<Edge, 2>> cuts;
  std::unordered_map<Edge, std::vector<std::size_t>> at_edge;
  std::unordered_map<Edge, QPointF> places;
  for (const auto& triangle : mesh.triangles) {
    std::array<Edge, 2> edges{};
    std::size_t n = 0;
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t from = std::min(triangle[e], triangle[(e + 1) % 3]);
      const std::uint32_t to = std::max(triangle[e], triangle[(e + 1) % 3]);
      const Eigen::Vector3d &a = vertices[from], &b = vertices[to];
      if ((a.z() >= 0.0) == (b.z() >= 0.0)) continue;
      const Eigen::Vector3d p = a + (b - a) * (a.z() / (a.z() - b.z()));
      const Edge edge = Edge{from} << 32U | to;
      places[edge] = {p.x(), p.y()};
      if (n < 2) edges[n++] = edge;
    }
    if (n < 2) continue;
    for (const Edge edge : edges) at_edge[edge].push_back(cuts.size());
    cuts.push_back(edges);
  }

  std::vector<bool> used(cuts.size(), false);
  const auto follow = [&](Edge edge, QPolygonF& line) {
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const std::size_t next : at_edge[edge]) {
        if (used[next]) continue;
        used[next] = goes_on = true;
        edge = cuts[next][0] == edge ? cuts[next][1] : cuts[next][0];
        line << places[edge];
        break;
      }
    }
  };
  std::vector<QPolygonF> lines;
  for (std::size_t first = 0; first < cuts.size(); ++first) {
    if (used[first]) continue;
    used[first] = true;
    // from one triangle to both edges; a closed line is back after the first
    QPolygonF line{places[cuts[first][0]], places[cuts[first][1]]};
    follow(cuts[first][1], line);
    QPolygonF back;
    follow(cuts[first][0], back);
    std::reverse(back.begin(), back.end());
    lines.push_back(back + line);
  }
  return lines;
}

haptics::Vec3 tipOf(const haptics::TriangleMesh& mesh) {
  double least = std::numeric_limits<double>::infinity(), radius = 0.0;
  for (const haptics::Vec3& v : mesh.vertices) {
    least = std::min(least, v.z());
    radius = std::max(radius, v.norm());
  }
  // the middle of what ends there: one vertex, or a ring of them
  haptics::Vec3 sum = haptics::Vec3::Zero();
  int count = 0;
  for (const haptics::Vec3& v : mesh.vertices)
    if (v.z() <= least + 1e-3 * radius) {
      sum += v;
      ++count;
    }
  return count > 0 ? haptics::Vec3{sum / count} : sum;
}

}  // namespace ui
