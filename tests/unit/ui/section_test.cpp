// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using haptics::Vec3;

// an octahedron, 5 mm from its middle to its corners
haptics::TriangleMesh octahedron() {
  haptics::TriangleMesh mesh;
  for (int a = 0; a < 3; ++a)
    for (const double side : {5e-3, -5e-3}) mesh.vertices.push_back(Vec3::Unit(a) * side);
  for (const std::uint32_t x : {0U, 1U})
    for (const std::uint32_t y : {2U, 3U})
      for (const std::uint32_t z : {4U, 5U}) mesh.triangles.push_back({x, y, z});
  return mesh;
}

TEST(Section, OfAMeshIsTheLineInWhichThePlaneMeetsIt) {
  const haptics::TriangleMesh mesh = octahedron();
  const haptics::Pose X_WM =
      haptics::poseOf({0.1, -0.2, 0.3}, haptics::Quat(Eigen::AngleAxisd(0.4, Vec3::UnitZ())));
  const ui::PlaneAxes axes = ui::axesOf(ui::Plane::Axial);
  // 2 mm above its middle: a square whose corners are 3 mm from the axis
  const Vec3 origin_mm{95.0, -196.0, 302.0};
  const auto lines = ui::sectionOf(mesh, X_WM, axes, origin_mm);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 5);
  EXPECT_TRUE(lines[0].isClosed());
  for (qsizetype n = 0; n < 4; ++n) {
    const QPointF a = lines[0][n], b = lines[0][n + 1];
    EXPECT_NEAR(std::hypot(b.x() - a.x(), b.y() - a.y()), 3.0 * std::sqrt(2.0), 1e-9);
    const Vec3 p = origin_mm + axes.right * a.x() + axes.up * a.y();
    EXPECT_NEAR((p - Vec3{100.0, -200.0, 302.0}).norm(), 3.0, 1e-9);
  }
  EXPECT_TRUE(ui::sectionOf(mesh, X_WM, axes, {100.0, -200.0, 305.1}).empty());
}

TEST(Section, OfAnOpenMeshIsALineWithTwoEnds) {
  haptics::TriangleMesh mesh = octahedron();
  mesh.triangles.erase(mesh.triangles.begin() + 2);
  const auto lines =
      ui::sectionOf(mesh, haptics::Pose::Identity(), ui::axesOf(ui::Plane::Axial), {0.0, 0.0, 0.0});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].isClosed());
  EXPECT_EQ(lines[0].size(), 4);
}

TEST(Section, KnowsTheTipOfATool) {
  EXPECT_LT((ui::tipOf(octahedron()) - Vec3{0.0, 0.0, -5e-3}).norm(), 1e-12);
  haptics::TriangleMesh blunt;  // a tube that ends in a ring
  for (int n = 0; n < 8; ++n) {
    const double turn = n * 0.25 * M_PI;
    for (const double z : {-0.03, 0.05})
      blunt.vertices.emplace_back(1e-3 + 2e-3 * std::cos(turn), 2e-3 * std::sin(turn), z);
  }
  EXPECT_LT((ui::tipOf(blunt) - Vec3{1e-3, 0.0, -0.03}).norm(), 1e-12);
  EXPECT_EQ(ui::tipOf({}).norm(), 0.0);
}

}  // namespace
