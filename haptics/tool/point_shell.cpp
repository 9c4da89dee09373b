// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/tool/point_shell.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace haptics {
namespace {

constexpr double kFarthest = 10.0;    // m, of a tool's points from their centroid
constexpr double kSameHeight = 1e-4;  // m: points that make up the tip

/// The median over (at most 512 of) the points of the distance to the nearest other point.
double medianSpacing(const std::vector<Vec3>& points) {
  if (points.size() < 2) return 0.0;
  std::vector<double> nearest;
  const std::size_t step = std::max<std::size_t>(1, points.size() / 512);
  for (std::size_t i = 0; i < points.size(); i += step) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i) least = std::min(least, (points[j] - points[i]).squaredNorm());
    nearest.push_back(std::sqrt(least));
  }
  std::nth_element(nearest.begin(), nearest.begin() + std::ssize(nearest) / 2, nearest.end());
  return nearest[nearest.size() / 2];
}

/// `count` points spread evenly by area: one at every count-th part of the total area along the
/// triangles' order, placed inside its triangle by the Kronecker sequence of the plastic number.
std::vector<Vec3> sampleByArea(const TriangleMesh& mesh, int count) {
  std::vector<double> cumulative;
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 ab = mesh.vertices[b] - mesh.vertices[a], ac = mesh.vertices[c] - mesh.vertices[a];
    area += 0.5 * ab.cross(ac).norm();
    cumulative.push_back(area);
  }
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  constexpr double kPlastic = 1.32471795724474602596;
  double x = 0.5, y = 0.5;
  for (int n = 0; n < count; ++n) {
    const double at = (n + 0.5) / count * area;
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), at);
    const auto t = std::min<std::size_t>(static_cast<std::size_t>(found - cumulative.begin()),
                                         cumulative.size() - 1);
    x += 1.0 / kPlastic;
    y += 1.0 / (kPlastic * kPlastic);
    x -= std::floor(x);
    y -= std::floor(y);
    // the square folded onto the triangle
    const double u = x + y > 1.0 ? 1.0 - x : x, v = x + y > 1.0 ? 1.0 - y : y;
    const auto& [a, b, c] = mesh.triangles[t];
    points.push_back(mesh.vertices[a] + u * (mesh.vertices[b] - mesh.vertices[a]) +
                     v * (mesh.vertices[c] - mesh.vertices[a]));
  }
  return points;
}

}  // namespace

Vec3 tipOf(const std::vector<Vec3>& points) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : points) lowest = std::min(lowest, p.z());
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const Vec3& p : points)
    if (p.z() < lowest + kSameHeight) {
      sum += p;
      ++count;
    }
  return sum / count;
}

Expected<PointShell> makeShell(std::vector<Vec3> points) {
  if (points.empty()) return tl::unexpected(Error{Error::Kind::Malformed, {"tool-no-points", {}}});
  for (const Vec3& p : points)
    if (!p.allFinite())
      return tl::unexpected(Error{Error::Kind::Malformed, {"tool-point-no-number", {}}});
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& p : points) centroid += p;
  centroid /= double(points.size());
  for (const Vec3& p : points)
    if (!((p - centroid).cwiseAbs().maxCoeff() <= kFarthest))
      return tl::unexpected(Error{Error::Kind::Malformed, {"tool-point-too-far", {}}});

  PointShell shell;
  shell.origin = centroid;
  shell.points = std::move(points);
  Mat3 inertia = Mat3::Zero();
  for (Vec3& p : shell.points) {
    p -= centroid;
    shell.radius = std::max(shell.radius, p.norm());
    inertia += p.squaredNorm() * Mat3::Identity() - p * p.transpose();
  }
  inertia /= double(shell.points.size());
  // a line of points has directions without inertia; a point has none at all, and a unit stands in
  shell.inertia = shell.radius > 0.0
                      ? Mat3{inertia + 1e-6 * shell.radius * shell.radius * Mat3::Identity()}
                      : Mat3::Identity();
  shell.spacing = medianSpacing(shell.points);
  shell.tip = tipOf(shell.points);
  return shell;
}

double gyrationOf(const PointShell& shell) HAPTICS_RT {
  return std::sqrt(shell.inertia.trace() / 3.0);
}

double largestInertia(const Mat3& inertia) {
  return Eigen::SelfAdjointEigenSolver<Mat3>{inertia, Eigen::EigenvaluesOnly}.eigenvalues()[2];
}

Expected<Tool> makeTool(std::string name, TriangleMesh mesh, int point_count) {
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle)
      if (v >= mesh.vertices.size())
        return tl::unexpected(
            Error{Error::Kind::Malformed, {"mesh-face-wrong", {'"' + name + '"'}}});
  if (point_count > 0 && mesh.triangles.empty())
    return tl::unexpected(Error{Error::Kind::Malformed, {"mesh-no-triangle", {'"' + name + '"'}}});
  std::vector<Vec3> points = point_count > 0 ? sampleByArea(mesh, point_count) : mesh.vertices;
  Expected<PointShell> shell = makeShell(std::move(points));
  if (!shell) return tl::unexpected(shell.error());
  for (Vec3& v : mesh.vertices) v -= shell->origin;
  return Tool{std::move(name), std::move(mesh), std::move(*shell)};
}

}  // namespace haptics
