// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/projection.h"

#include <QWidget>
#include <algorithm>
#include <cmath>

#include "ui/props/picture.h"

namespace ui {
namespace {

constexpr double kSameDirection = 1e-9;
constexpr double kNearlyParallel = 0.02;  // squared sine between a line and the sight

/// x, y in the camera's axes of the line of sight through a pixel.
Eigen::Vector2d sightAcross(const ViewGeometry& view, const Projection& camera, QPointF at) {
  Eigen::Vector3d from, along;
  view.sight(at, from, along);
  if (camera.parallel) return (camera.axes.transpose() * (from - camera.eye)).head<2>();
  const Eigen::Vector3d c = camera.axes.transpose() * along;
  return c.head<2>() / -c.z();
}

}  // namespace

QPointF Projection::of(const Eigen::Vector3d& p_W_mm) const {
  const Eigen::Vector3d c = axes.transpose() * (p_W_mm - eye);
  const double s = parallel ? scale : scale / std::max(-c.z(), 1e-6);
  return {centre.x() + c.x() * s, centre.y() - c.y() * s};
}

std::array<double, 2> Projection::acrossOf(QPointF at) const {
  return {(at.x() - centre.x()) / scale, (centre.y() - at.y()) / scale};
}

Projection projectionOf(const ViewGeometry& view) {
  const double w = std::max(view.widget().width(), 4), h = std::max(view.widget().height(), 4);
  const QPointF one{0.25 * w, 0.75 * h}, other{0.75 * w, 0.25 * h};
  Projection camera;
  camera.axes = view.axes();
  Eigen::Vector3d from, along, along_other;
  view.sight(other, from, along_other);
  view.sight(one, from, along);
  camera.parallel = (along - along_other).norm() < kSameDirection;
  if (camera.parallel) view.sight({0.5 * w, 0.5 * h}, from, along);
  camera.eye = from;
  const Eigen::Vector2d a = sightAcross(view, camera, one), b = sightAcross(view, camera, other);
  camera.scale = (other.x() - one.x()) / (b.x() - a.x());
  camera.centre = {one.x() - a.x() * camera.scale, one.y() + a.y() * camera.scale};
  return camera;
}

std::optional<double> alongLine(const ViewGeometry& view, QPointF at, const Eigen::Vector3d& p,
                                const Eigen::Vector3d& along) {
  Eigen::Vector3d from, sight;
  view.sight(at, from, sight);
  const double cosine = along.dot(sight);
  const double apart = 1.0 - cosine * cosine;
  if (apart < kNearlyParallel) return {};
  const Eigen::Vector3d between = p - from;
  return (cosine * sight.dot(between) - along.dot(between)) / apart;
}

BoxCorners cornersOf_mm(const haptics::Grid& grid, const haptics::VoxelBox& box) {
  BoxCorners corners;
  for (int corner = 0; corner < 8; ++corner) {
    haptics::Vec3 index;
    for (int a = 0; a < 3; ++a)
      index[a] = static_cast<double>((corner >> a) & 1 ? box.end[a] : box.first[a]) - 0.5;
    corners[static_cast<std::size_t>(corner)] = grid.worldOf(index) * kMmPerM;
  }
  return corners;
}

std::vector<Eigen::Vector3d> sectionOf(const BoxCorners& corners, const Eigen::Vector3d& point,
                                       const Eigen::Vector3d& normal) {
  std::vector<Eigen::Vector3d> polygon;
  for (std::size_t one = 0; one < 8; ++one)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t other = one | (std::size_t{1} << axis);
      if (other == one) continue;
      const double a = normal.dot(corners[one] - point), b = normal.dot(corners[other] - point);
      if ((a < 0.0) == (b < 0.0)) continue;
      polygon.emplace_back(corners[one] + (corners[other] - corners[one]) * (a / (a - b)));
    }
  if (polygon.size() < 3) return {};
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : polygon) middle += p / static_cast<double>(polygon.size());
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::ranges::sort(polygon, {}, [&](const Eigen::Vector3d& p) {
    return std::atan2(v.dot(p - middle), u.dot(p - middle));
  });
  return polygon;
}

std::vector<Eigen::Vector3d> clipped(const std::vector<Eigen::Vector3d>& polygon,
                                     const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const Eigen::Vector3d& p = polygon[n];
    const Eigen::Vector3d& q = polygon[(n + 1) % polygon.size()];
    const double a = normal.dot(p - point), b = normal.dot(q - point);
    if (a >= 0.0) kept.push_back(p);
    if ((a >= 0.0) != (b >= 0.0)) kept.emplace_back(p + (q - p) * (a / (a - b)));
  }
  return kept;
}

}  // namespace ui
