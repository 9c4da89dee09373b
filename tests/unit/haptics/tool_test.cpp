// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "datasets/phantoms/making.h"
#include "haptics/solver/mass_metric.h"
#include "haptics/tool/point_shell.h"
#include "haptics/tool/shell_tree.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::makeShell;
using haptics::makeTool;
using haptics::Mat3;
using haptics::PointShell;
using haptics::TriangleMesh;
using haptics::Vec3;

/// A box of two triangles a side.
TriangleMesh box(const Vec3& half) {
  TriangleMesh mesh;
  for (int c = 0; c < 8; ++c)
    mesh.vertices.push_back(
        half.cwiseProduct(Vec3{c & 1 ? 1. : -1., c & 2 ? 1. : -1., c & 4 ? 1. : -1.}));
  for (const auto& quad : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                           {4, 5, 7, 6},
                           {0, 1, 5, 4},
                           {2, 6, 7, 3},
                           {0, 4, 6, 2},
                           {1, 3, 7, 5}}) {
    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
  }
  return mesh;
}

TEST(PointShell, IsCentredOnItsPointsAndKnowsItsRadius) {
  Random random{71};
  std::vector<Vec3> points;
  for (int n = 0; n < 200; ++n) points.push_back(Vec3{0.5, -0.2, 0.1} + random.box(0.02));
  const PointShell shell = makeShell(points).value();
  Vec3 sum = Vec3::Zero();
  double farthest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += shell.points[i];
    farthest = std::max(farthest, shell.points[i].norm());
    EXPECT_TRUE((shell.points[i] - shell.points[0]).isApprox(points[i] - points[0], 1e-12) ||
                i == 0);
  }
  EXPECT_LT(sum.norm() / 200, 1e-16);
  EXPECT_EQ(shell.radius, farthest);
}

// mean inertia of eight corners: per axis the two other half sides squared; of a thin ring r²/2
TEST(PointShell, HasTheInertiaOfKnownShapes) {
  const PointShell corners = makeShell(box({1e-2, 2e-2, 3e-2}).vertices).value();
  const Mat3 expected = Vec3{4e-4 + 9e-4, 1e-4 + 9e-4, 1e-4 + 4e-4}.asDiagonal();
  EXPECT_TRUE(corners.inertia.isApprox(expected, 3e-6));  // the regularisation is 1e-6 r²
  EXPECT_NEAR(corners.spacing, 2e-2, 1e-15);
  std::vector<Vec3> ring;
  for (int n = 0; n < 360; ++n)
    ring.push_back({0.01 * std::cos(n * M_PI / 180), 0.01 * std::sin(n * M_PI / 180), 0.0});
  const PointShell hoop = makeShell(ring).value();
  const Mat3 of_hoop = 1e-4 * Vec3{0.5, 0.5, 1.0}.asDiagonal().toDenseMatrix();
  EXPECT_TRUE(hoop.inertia.isApprox(of_hoop, 3e-6));
}

// what has no extent in a direction still has an inertia that can be inverted
TEST(PointShell, OfOneTwoOrThreeCollinearPointsHasAnInertiaThatInverts) {
  const std::vector<std::vector<Vec3>> shells{{{0.1, 0.2, 0.3}},
                                              {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}},
                                              {{0, 0, 0}, {0, 0, 0.01}},
                                              {{0, 0, 0}, {0.01, 0, 0}, {0.02, 0, 0}}};
  for (const auto& points : shells) {
    const PointShell shell = makeShell(points).value();
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen{shell.inertia};
    EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.0);
    EXPECT_LE(eigen.eigenvalues().maxCoeff() / eigen.eigenvalues().minCoeff(), 1.1e6);
    const haptics::MassMetric metric{shell.inertia};
    const haptics::Twist V{{1, 2, 3}, {4, 5, 6}};
    const auto back = metric.twist(metric.whitened(V, Mat3::Identity()), Mat3::Identity());
    EXPECT_TRUE(back.angular.isApprox(V.angular, 1e-9));
  }
}

TEST(PointShell, RefusesNoPointAndNumbersThatAreNone) {
  EXPECT_FALSE(makeShell({}));
  for (const double bad : {double(NAN), double(INFINITY)})
    EXPECT_FALSE(makeShell({Vec3::Zero(), {0, bad, 0}}));
}

TEST(PointShell, RefusesWhatNoHandHolds) {
  EXPECT_TRUE(makeShell({{0, 0, 100}, {0, 0, 101}}));
  for (const double far : {25.0, 1e155, 1e308})
    EXPECT_FALSE(makeShell({{0, 0, 0}, {far, 0, 0}})) << far;
}

TEST(MassMetric, MeasuresAPointsDisplacementOverTheShell) {
  Random random{72};
  std::vector<Vec3> points;
  for (int n = 0; n < 50; ++n) points.push_back(Vec3{2, 1, 0.5}.cwiseProduct(random.box(0.01)));
  const PointShell shell = makeShell(points).value();
  const haptics::MassMetric metric{shell.inertia};
  for (int n = 0; n < 100; ++n) {
    const Mat3 R = random.rotation().toRotationMatrix();
    const haptics::Twist V{random.box(1e-3), random.box(0.1)};
    double mean = 0.0;
    for (const Vec3& p : shell.points)
      mean += (V.linear + V.angular.cross(R * p)).squaredNorm() / 50;
    // the centroid is the origin, so the mixed term vanishes; 1e-6 r² is the regularisation
    EXPECT_NEAR(metric.whitened(V, R).squaredNorm(), mean, 1e-5 * mean);
    const Vec3 normal = random.direction(), r = random.box(0.02);
    EXPECT_NEAR(metric.row(normal, r, R).dot(metric.whitened(V, R)),
                normal.dot(V.linear + V.angular.cross(r)), 1e-15);
  }
}

TEST(Tool, WithoutANumberOfPointsIsItsVerticesAndMeshAndShellShareAFrame) {
  TriangleMesh mesh = box({1e-2, 2e-2, 3e-2});
  for (Vec3& v : mesh.vertices) v += Vec3{1, 1, 1};
  const haptics::Tool tool = makeTool("box", mesh).value();
  ASSERT_EQ(tool.shell.points.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_LT((tool.shell.points[i] - tool.mesh.vertices[i]).norm(), 1e-15);
}

TEST(Tool, KnowsWhereItsOriginWasInTheFrameItWasMadeIn) {
  TriangleMesh mesh = box(Vec3{0.01, 0.02, 0.03});
  const Vec3 away{0.1, -0.2, 0.3};
  for (Vec3& v : mesh.vertices) v += away;
  EXPECT_TRUE(makeTool("box", mesh)->shell.origin.isApprox(away, 1e-12));
  EXPECT_TRUE(makeShell(mesh.vertices)->origin.isApprox(away, 1e-12));
  // with points spread evenly it is their centroid, to which the mesh was moved as well
  const auto sampled = makeTool("box", mesh, 500);
  EXPECT_TRUE(Vec3{sampled->mesh.vertices[7] + sampled->shell.origin}.isApprox(mesh.vertices[7]));
  EXPECT_NEAR((sampled->shell.origin - away).norm(), 0.0, 1e-3);
}

TEST(Tool, EvenSamplingIsTheSameEveryTimeAndEvenByArea) {
  const Vec3 half{1e-2, 2e-2, 3e-2};
  const haptics::Tool tool = makeTool("box", box(half), 2000).value();
  const haptics::Tool again = makeTool("box", box(half), 2000).value();
  ASSERT_EQ(tool.shell.points.size(), 2000u);
  EXPECT_EQ(tool.shell.points, again.shell.points);
  // the points are about their own centroid, and so is the mesh: the box's middle is the mean of
  // its corners
  Vec3 middle = Vec3::Zero();
  for (const Vec3& v : tool.mesh.vertices) middle += v / 8.0;
  EXPECT_LT(middle.norm(), 5e-4);
  double area = 0.0, counted[3] = {};
  for (const Vec3& p : tool.shell.points) {
    const Vec3 q = (p - middle).cwiseQuotient(half).cwiseAbs();
    int axis = 0;
    EXPECT_NEAR(q.maxCoeff(&axis), 1.0, 1e-9);  // on a side
    ++counted[axis];
  }
  const double side[3] = {half.y() * half.z(), half.x() * half.z(), half.x() * half.y()};
  for (const double a : side) area += a;
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(counted[axis], 2000.0 * side[axis] / area, 4.0);  // a point a triangle
  // evenly within a side too: quarters of the largest, 27 % of the points each fourth
  int quarter[4] = {};
  int on_side = 0;
  for (const Vec3& p : tool.shell.points) {
    const Vec3 q = (p - middle).cwiseQuotient(half);
    if (q.x() < 0.999999) continue;
    ++on_side;
    ++quarter[(q.y() > 0 ? 1 : 0) + (q.z() > 0 ? 2 : 0)];
  }
  for (const int count : quarter) EXPECT_NEAR(count, on_side / 4.0, 0.12 * on_side / 4.0);
}

TEST(Tool, RefusesIndicesOutOfRangeAndPointsWithoutTriangles) {
  TriangleMesh mesh = box({1e-2, 1e-2, 1e-2});
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_FALSE(makeTool("bad", mesh));
  EXPECT_FALSE(makeTool("cloud", {box({1, 1, 1}).vertices, {}}, 100));
  EXPECT_FALSE(makeTool("empty", {}));
}

// what a box leaves out could go through the surface with the rest of its node
TEST(ShellTree, BoxesOfADenseToolHoldAllPointsOfTheirNodes) {
  const haptics::ShellTree tree{datasets::ballPoints(6000, 9e-3)};
  ASSERT_EQ(tree.boxes.size(), tree.nodes.size());
  int held = 0;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const auto& node = tree.nodes[n];
    if (node.count < haptics::ShellTree::kLeastBox) continue;
    const auto& around = tree.boxes[n];
    Vec3 farthest = Vec3::Zero();
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Vec3 p = Vec3{tree.x[at], tree.y[at], tree.z[at]} - around.centre;
      for (int axis = 0; axis < 3; ++axis) {
        const double half = around.half.col(axis).norm();
        const double far = std::abs(around.half.col(axis).dot(p)) / half;
        ASSERT_LE(far, half * (1.0 + 1e-12)) << n;
        farthest[axis] = std::max(farthest[axis], far / half);
      }
      ++held;
    }
    EXPECT_GT(farthest.minCoeff(), 1.0 - 1e-6) << "wider than its points: " << n;
  }
  EXPECT_GT(held, 6000);
}

}  // namespace
