// SPDX-License-Identifier: BSD-3-Clause
#include "resources/named_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "tests/support/sentence.h"

namespace resources {
namespace {

using haptics::TriangleMesh;
using haptics::Vec3;

TriangleMesh meshOf(const std::string& name) { return namedToolMesh(name).value(); }

TEST(NamedTools, AreTheSixOfThePaperAndOurs) {
  EXPECT_EQ(namedTools(),
            (std::vector<std::string>{"sphere", "probe", "drill", "cane", "wrench", "peg"}));
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
  for (const std::string& name : namedTools())
    EXPECT_NE(sentence(mesh.error()).find(name), std::string::npos) << name;
}

TEST(NamedTools, AreClosedManifoldsTurnedOutwards) {
  for (const std::string& name : namedTools()) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = meshOf(name);
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

TEST(NamedTools, HaveEvenlySpacedVertices) {
  for (const std::string& name : namedTools()) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = meshOf(name);
    std::vector<double> lengths;  // m
    for (const auto& t : mesh.triangles)
      for (std::size_t q = 0; q < 3; ++q)
        lengths.push_back((mesh.vertices[t[q]] - mesh.vertices[t[(q + 1) % 3]]).norm());
    std::sort(lengths.begin(), lengths.end());
    const double median = lengths[lengths.size() / 2];
    EXPECT_LT(lengths.back() / median, 3.0);
    EXPECT_GT(lengths.front() / median, 0.3);
  }
}

TEST(NamedTools, HaveTheirSizesAndPointDown) {
  const auto extent = [](const TriangleMesh& mesh) {
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& v : mesh.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    return Vec3{high - low};
  };
  EXPECT_LT((extent(meshOf("peg")) - Vec3{0.015, 0.015, 0.050}).norm(), 1e-9);
  EXPECT_NEAR(extent(meshOf("cane")).z(), 0.120, 0.004);
  EXPECT_NEAR(extent(meshOf("wrench")).z(), 0.130, 0.004);
  EXPECT_NEAR(extent(meshOf("probe")).z(), 0.100, 0.001);
  EXPECT_NEAR(extent(meshOf("drill")).z(), 0.086, 0.001);
  for (const Vec3& v : meshOf("sphere").vertices) EXPECT_NEAR(v.norm(), 0.0025, 1e-6);

  // the tips are balls on -z: every vertex near the end lies on them
  for (const auto& [name, radius] : {std::pair{"probe", 0.0025}, std::pair{"drill", 0.002}}) {
    int on_tip = 0;
    for (const Vec3& v : meshOf(name).vertices)
      if (v.z() < radius) {
        EXPECT_NEAR((v - Vec3{0, 0, radius}).norm(), radius, 1e-6) << name;
        ++on_tip;
      }
    EXPECT_GT(on_tip, 15) << name;
  }
}

}  // namespace
}  // namespace resources
