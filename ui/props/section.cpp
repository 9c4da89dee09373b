// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/section.h"

#include <algorithm>
#include <limits>

#include "ui/props/picture.h"

namespace ui {

std::vector<QLineF> sectionOf(const haptics::TriangleMesh& mesh, const haptics::Pose& X_WM,
                              const PlaneAxes& axes, const Eigen::Vector3d& origin_W_mm) {
  // columns: right, up, towards the viewer
  Eigen::Matrix3d A_WS;
  A_WS << axes.right, axes.up, axes.right.cross(axes.up);
  const Eigen::Matrix3d A_SM = A_WS.transpose() * X_WM.linear() * kMmPerM;
  const Eigen::Vector3d origin_S = A_WS.transpose() * (X_WM.translation() * kMmPerM - origin_W_mm);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const haptics::Vec3& v : mesh.vertices) vertices.emplace_back(A_SM * v + origin_S);

  std::vector<QLineF> pieces;
  for (const auto& triangle : mesh.triangles) {
    QPointF ends[2];
    int n = 0;
    for (int e = 0; e < 3; ++e) {
      const Eigen::Vector3d& a = vertices[triangle[e]];
      const Eigen::Vector3d& b = vertices[triangle[(e + 1) % 3]];
      if ((a.z() >= 0.0) == (b.z() >= 0.0)) continue;
      const Eigen::Vector3d p = a + (b - a) * (a.z() / (a.z() - b.z()));
      if (n < 2) ends[n++] = {p.x(), p.y()};
    }
    if (n == 2) pieces.emplace_back(ends[0], ends[1]);
  }
  return pieces;
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
