// SPDX-License-Identifier: BSD-3-Clause
#include "resources/named_tools.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/sentence.h"

namespace resources {
namespace {

using haptics::TriangleMesh;
using haptics::Vec3;

TriangleMesh meshOf(const std::string& name) { return namedToolMesh(name).value(); }

const NamedTool& toolNamed(const char* name) { return *findNamedTool(name); }

struct Box {
  Vec3 low, high;
  Vec3 extent() const { return high - low; }
};

Box boxOf(const TriangleMesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vec3& v : mesh.vertices)
    box = {.low = box.low.cwiseMin(v), .high = box.high.cwiseMax(v)};
  return box;
}

TEST(NamedTools, AreListedByUse) {
  std::map<std::string, std::vector<std::string>> listed;
  std::vector<std::string> uses;
  for (const NamedTool& tool : namedTools()) {
    listed[tool.use].push_back(tool.name);
    if (uses.empty() || uses.back() != tool.use) uses.push_back(tool.use);
  }
  EXPECT_EQ(uses, (std::vector<std::string>{"Drilling", "Probing", "Trial shapes"}));
  using Names = std::vector<std::string>;
  EXPECT_EQ(listed["Drilling"], (Names{"burr-1", "burr-2", "burr-3", "burr-4", "burr-6", "drill"}));
  EXPECT_EQ(listed["Probing"], (Names{"probe", "curved-probe", "hook", "elevator", "needle"}));
  EXPECT_EQ(listed["Trial shapes"], (Names{"sphere", "cane", "wrench", "peg"}));
  EXPECT_EQ(toolNamed("curved-probe").title, "Curved probe");
  EXPECT_EQ(findNamedTool("spoon"), nullptr);
}

// recordings and studies name them: their shells stay
TEST(NamedTools, OfThePaperHaveItsNumbersOfPoints) {
  // [Chan 2011], Table 1: without a number of points the vertices are the shell
  EXPECT_EQ(meshOf("cane").vertices.size(), 403u);
  EXPECT_EQ(meshOf("wrench").vertices.size(), 2126u);
  EXPECT_EQ(meshOf("peg").vertices.size(), 1307u);
  EXPECT_EQ(meshOf("drill").vertices.size(), 518u);
  EXPECT_EQ(meshOf("probe").vertices.size(), 403u);
  EXPECT_NEAR(static_cast<double>(meshOf("sphere").vertices.size()), 400.0, 20.0);
}

TEST(NamedTools, AnUnknownNameIsToldTheKnownOnes) {
  const auto mesh = namedToolMesh("spoon");
  ASSERT_FALSE(mesh.has_value());
  for (const NamedTool& tool : namedTools())
    EXPECT_NE(sentence(mesh.error()).find(tool.name), std::string::npos) << tool.name;
}

TEST(NamedTools, AreClosedManifoldsTurnedOutwards) {
  for (const NamedTool& tool : namedTools()) {
    SCOPED_TRACE(tool.name);
    const TriangleMesh mesh = meshOf(tool.name);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0.0;  // m^3
    for (const auto& t : mesh.triangles) {
      for (std::size_t q = 0; q < 3; ++q) {
        ASSERT_LT(t[q], mesh.vertices.size());
        ++edges[{t[q], t[(q + 1) % 3]}];
      }
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      EXPECT_GT((b - a).cross(c - a).norm(), 1e-9);  // m^2: not degenerate
      volume += a.dot(b.cross(c)) / 6.0;
    }
    for (const auto& [edge, uses] : edges) {
      EXPECT_EQ(uses, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    EXPECT_GT(volume, 0.0);
    // one piece without handles: V - E + F = 2
    EXPECT_EQ(mesh.vertices.size() + mesh.triangles.size(), edges.size() / 2 + 2);
    const auto less = [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    const std::set<Vec3, decltype(less)> distinct(mesh.vertices.begin(), mesh.vertices.end(), less);
    EXPECT_EQ(distinct.size(), mesh.vertices.size());
  }
}

TEST(NamedTools, HaveVerticesThatAreEvenlySpacedOrDenseAtTheTip) {
  const std::set<std::string> dense{"burr-1",       "burr-2", "burr-3",   "burr-4", "burr-6",
                                    "curved-probe", "hook",   "elevator", "needle"};
  for (const NamedTool& tool : namedTools()) {
    SCOPED_TRACE(tool.name);
    const TriangleMesh mesh = meshOf(tool.name);
    const double tip = boxOf(mesh).low.z() + std::min(tool.tip, 0.002);  // m
    std::vector<double> lengths, at_tip;                                 // m
    for (const auto& t : mesh.triangles) {
      std::array<double, 3> sides{};
      double z = 0.0;
      for (std::size_t q = 0; q < 3; ++q) {
        sides[q] = (mesh.vertices[t[q]] - mesh.vertices[t[(q + 1) % 3]]).norm();
        z = std::max(z, mesh.vertices[t[q]].z());
      }
      std::ranges::sort(sides);
      EXPECT_LT(sides[2] / sides[0], 5.0);  // no sliver
      lengths.insert(lengths.end(), sides.begin(), sides.end());
      if (z < tip) at_tip.insert(at_tip.end(), sides.begin(), sides.end());
    }
    std::ranges::sort(lengths);
    const double median = lengths[lengths.size() / 2];
    if (!dense.contains(tool.name)) {
      EXPECT_LT(lengths.back() / median, 3.0);
      EXPECT_GT(lengths.front() / median, 0.3);
      continue;
    }
    EXPECT_GT(mesh.vertices.size(), 500u);
    EXPECT_LT(mesh.vertices.size(), 1000u);
    ASSERT_GT(at_tip.size(), 40u);
    std::ranges::sort(at_tip);
    EXPECT_LT(at_tip[at_tip.size() / 2], std::max(0.45e-3, tool.tip / 9.0));
    EXPECT_LT(at_tip.back(), std::max(0.6e-3, tool.tip / 7.0));
    EXPECT_LT(at_tip.back(), 0.45 * median + tool.tip / 8.0);  // denser than the handle
  }
}

TEST(NamedTools, HaveTheirSizesAndPointDown) {
  for (const NamedTool& tool : namedTools()) {
    SCOPED_TRACE(tool.name);
    const Vec3 extent = boxOf(meshOf(tool.name)).extent();
    EXPECT_EQ(tool.length, extent.z());
    // what makeTool and the readers call usual
    EXPECT_GT(extent.minCoeff(), 0.001);
    EXPECT_LT(extent.norm(), 0.5);
    EXPECT_GE(extent.z(), std::max(extent.x(), extent.y()));
  }
  EXPECT_LT((boxOf(meshOf("peg")).extent() - Vec3{0.015, 0.015, 0.050}).norm(), 1e-9);
  EXPECT_NEAR(toolNamed("cane").length, 0.120, 0.004);
  EXPECT_NEAR(toolNamed("wrench").length, 0.130, 0.004);
  EXPECT_NEAR(toolNamed("probe").length, 0.100, 0.001);
  EXPECT_NEAR(toolNamed("drill").length, 0.086, 0.001);
  EXPECT_NEAR(toolNamed("burr-2").length, 0.145, 1e-9);
  for (const Vec3& v : meshOf("sphere").vertices) EXPECT_NEAR(v.norm(), 0.0025, 1e-6);
}

/// The ball through these points, by least squares: centre and radius.
Eigen::Vector4d ballThrough(const std::vector<Vec3>& points) {
  // |p|² = 2 c·p + (r² - |c|²)
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  const Vec3 middle = points.front();
  for (const Vec3& p : points) {
    const Vec3 mm = 1e3 * (p - middle);
    const Eigen::Vector4d row{2.0 * mm.x(), 2.0 * mm.y(), 2.0 * mm.z(), 1.0};
    A += row * row.transpose();
    b += row * mm.squaredNorm();
  }
  const Eigen::Vector4d fit = A.ldlt().solve(b);
  const Vec3 centre = middle + 1e-3 * fit.head<3>();
  return {centre.x(), centre.y(), centre.z(),
          1e-3 * std::sqrt(fit[3] + fit.head<3>().squaredNorm())};
}

/// The vertices that lie at most so high above the lowest one.
std::vector<Vec3> lowest(const TriangleMesh& mesh, double height) {
  const double low = boxOf(mesh).low.z();
  std::vector<Vec3> found;
  for (const Vec3& v : mesh.vertices)
    if (v.z() <= low + height) found.push_back(v);
  return found;
}

TEST(NamedTools, HaveTipsOfTheStatedDiameter) {
  // a ball at the end along -z: the nearest vertices lie on it, all around
  for (const char* name : {"burr-1", "burr-2", "burr-3", "burr-4", "burr-6", "drill", "probe",
                           "curved-probe", "needle", "sphere"}) {
    SCOPED_TRACE(name);
    const double tip = toolNamed(name).tip;
    const TriangleMesh mesh = meshOf(name);
    const std::vector<Vec3> end = lowest(mesh, 0.45 * tip);
    ASSERT_GT(end.size(), 6u);
    const Eigen::Vector4d ball = ballThrough(end);
    EXPECT_NEAR(2.0 * ball[3], tip, 0.02 * tip);
    for (const Vec3& v : end) EXPECT_NEAR((v - ball.head<3>()).norm(), ball[3], 2e-6);
  }
  // its extent, as one would measure it with a gauge
  for (const char* name : {"burr-1", "burr-2", "burr-3", "burr-4", "burr-6"}) {
    SCOPED_TRACE(name);
    const double tip = toolNamed(name).tip;
    const Vec3 extent = boxOf({.vertices = lowest(meshOf(name), tip), .triangles = {}}).extent();
    EXPECT_NEAR(extent.x(), tip, 0.02 * tip);
    EXPECT_NEAR(extent.y(), tip, 0.02 * tip);
  }
  EXPECT_EQ(toolNamed("burr-2").tip, 2e-3);
  EXPECT_EQ(toolNamed("burr-4").tip, 4e-3);
  EXPECT_EQ(toolNamed("burr-6").tip, 6e-3);

  const auto across = [](const char* name, int axis, double height) {
    return boxOf({.vertices = lowest(meshOf(name), height), .triangles = {}}).extent()[axis];
  };
  // the wires, across their bend; the blade's width and its thickness; the wrench's thickness
  EXPECT_NEAR(across("hook", 1, 0.001), toolNamed("hook").tip, 0.02e-3);
  EXPECT_NEAR(across("cane", 1, 0.020), toolNamed("cane").tip, 0.16e-3);
  EXPECT_NEAR(across("elevator", 0, 0.010), toolNamed("elevator").tip, 0.1e-3);
  EXPECT_NEAR(across("wrench", 1, 0.020), toolNamed("wrench").tip, 1e-9);
  EXPECT_NEAR(across("peg", 0, 0.010), toolNamed("peg").tip, 1e-9);
}

TEST(NamedTools, AreBentWhereTheirNamesSaySo) {
  // the end lies beside the axis of the handle, towards +x
  for (const auto& [name, least] : {std::pair{"curved-probe", 0.008}, std::pair{"hook", 0.0025}}) {
    const TriangleMesh mesh = meshOf(name);
    EXPECT_GT(boxOf({.vertices = lowest(mesh, 0.0008), .triangles = {}}).high.x(), least) << name;
    double far_x = 0.0;
    int far = 0;
    for (const Vec3& v : mesh.vertices)
      if (v.z() > 0.100) far_x += v.x(), ++far;
    EXPECT_LT(std::abs(far_x / far), 0.0005) << name;
  }
}

}  // namespace
}  // namespace resources
