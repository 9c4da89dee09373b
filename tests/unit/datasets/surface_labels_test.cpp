// SPDX-License-Identifier: BSD-3-Clause
// Surfaces as structures: what lies inside, on which side, and what is refused.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "datasets/labels/label_file.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/label_scans.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Grid;
using haptics::Mat3;
using haptics::Vec3;
using namespace testing;

/// Corners in mm, and triangles of them.
struct ClosedMesh {
  std::vector<Vec3> corners;
  std::vector<std::array<int, 3>> triangles;
};

ClosedMesh boxOf(const Vec3& low, const Vec3& high) {
  ClosedMesh mesh;
  for (int n = 0; n < 8; ++n)
    mesh.corners.emplace_back(n & 1 ? high.x() : low.x(), n & 2 ? high.y() : low.y(),
                              n & 4 ? high.z() : low.z());
  for (const auto& quad : {std::array{0, 2, 3, 1},
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

std::string words(const Vec3& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

std::string stlOf(const ClosedMesh& mesh, const std::string& title) {
  std::string text = "solid " + title + "\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int n : triangle) text += "vertex " + words(mesh.corners[std::size_t(n)]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

std::string objOf(const ClosedMesh& mesh, const std::string& title) {
  std::string text = "# " + title + "\n";
  for (const Vec3& corner : mesh.corners) text += "v " + words(corner) + "\n";
  for (const auto& t : mesh.triangles)
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
            std::to_string(t[2] + 1) + "\n";
  return text;
}

std::string plyOf(const ClosedMesh& mesh, const std::string& title) {
  std::string text = "ply\nformat ascii 1.0\ncomment " + title + "\nelement vertex " +
                     std::to_string(mesh.corners.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& corner : mesh.corners) text += words(corner) + "\n";
  for (const auto& t : mesh.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            "\n";
  return text;
}

ClosedMesh turnedBy(ClosedMesh mesh, const Vec3& signs) {
  for (Vec3& corner : mesh.corners) corner = signs.cwiseProduct(corner);
  return mesh;
}

/// How many voxels of a map belong to its first structure where the formula says otherwise.
template <class Inside>
std::int64_t wrongIn(const LabelMap& map, const Inside& inside) {
  const Grid& grid = map.grid();
  std::int64_t wrong = 0;
  for (std::int64_t n = 0; n < grid.voxelCount(); ++n) {
    const Vec3 index(double(n % grid.dims[0]), double(n / grid.dims[0] % grid.dims[1]),
                     double(n / grid.dims[0] / grid.dims[1]));
    wrong += !setAt(map, int(n)).empty() != inside(Vec3(1e3 * grid.worldOf(index))) ? 1 : 0;
  }
  return wrong;
}

TEST(SurfaceLabels, OfBothSpacesLieWhereThePatientHasThemInEveryOrientation) {
  // beyond the middle of the box to the patient's left, back and head, of three unequal lengths
  const Vec3 low_mm(-21.37, 27.53, 76.21), high_mm(-12.81, 36.47, 89.89);
  const ClosedMesh mesh = boxOf(low_mm, high_mm);
  const auto inside = [&](const Vec3& p_mm) {
    return (p_mm.array() > low_mm.array()).all() && (p_mm.array() < high_mm.array()).all();
  };
  Workshop workshop;
  const ClosedMesh ras = turnedBy(mesh, Vec3(-1.0, -1.0, 1.0));
  const std::string slicer = "3D Slicer output. SPACE=";
  const std::vector<std::filesystem::path> stated{
      workshop.write("a.stl", stlOf(mesh, slicer + "LPS")),
      workshop.write("b.obj", objOf(mesh, slicer + "LPS")),
      workshop.write("c.PLY", plyOf(mesh, slicer + "LPS")),
      workshop.write("d.stl", stlOf(ras, slicer + "RAS")),
      workshop.write("e.obj", objOf(ras, slicer + "RAS")),
      workshop.write("f.ply", plyOf(ras, slicer + "RAS"))};
  const auto unstated = workshop.write("sinus.stl", stlOf(ras, "x"));
  std::vector<Grid> grids{obliqueGrid()};
  for (const Mat3& axes : turned::orientations()) grids.push_back(turned::gridAlong(axes));
  std::size_t at = 0;
  for (const Grid& grid : grids) {
    const haptics::Volume scan = scanOn(grid);
    for (const auto& path : {stated[at % 6], stated[(at + 3) % 6]}) {
      const auto map = readLabels(path, scan);
      ASSERT_TRUE(map) << sentence(map.error());
      ASSERT_EQ(map->structures().size(), 1U);
      EXPECT_GT(map->structures()[0].voxels, 100);
      ASSERT_EQ(wrongIn(*map, inside), 0) << path << '\n' << grid.direction;
    }
    const auto map = readLabels(unstated, scan, {}, {.space = SurfaceSpace::Ras});
    ASSERT_TRUE(map) << sentence(map.error());
    EXPECT_EQ(map->structures()[0].name, "sinus");
    ASSERT_EQ(wrongIn(*map, inside), 0);
    ++at;
  }
}

/// A ball of 4^n·20 triangles, with a smaller one in it as a hole.
ClosedMesh ballWithHole(const Vec3& centre, double radius, double hole) {
  ClosedMesh mesh;
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::vector<Vec3> corners{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                  {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                  {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::array<int, 3>> faces{
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  std::vector<Vec3> unit;
  for (const Vec3& corner : corners) unit.push_back(corner.normalized());
  std::map<std::pair<int, int>, int> middles;
  for (int round = 0; round < 4; ++round) {
    std::vector<std::array<int, 3>> finer;
    const auto middle = [&](int a, int b) {
      const auto [it, is_new] = middles.try_emplace(std::minmax(a, b), int(unit.size()));
      if (is_new) unit.push_back((unit[std::size_t(a)] + unit[std::size_t(b)]).normalized());
      return it->second;
    };
    for (const auto& [a, b, c] : faces) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  for (const double r : {radius, hole}) {
    const int first = int(mesh.corners.size());
    for (const Vec3& corner : unit) mesh.corners.emplace_back(centre + r * corner);
    for (const auto& [a, b, c] : faces) mesh.triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

TEST(SurfaceLabels, WhatLiesInsideIsMarkedAlsoThroughEdgesAndCorners) {
  Workshop workshop;
  Grid grid;
  grid.dims = {50, 50, 50};
  grid.spacing = Vec3::Constant(1e-3);
  const haptics::Volume scan = scanOn(grid);
  const Vec3 centre(24.3, 25.1, 23.7);
  const auto path = workshop.write("ball.obj", objOf(ballWithHole(centre, 18.0, 9.0), "SPACE=LPS"));
  const auto map = readLabels(path, scan);
  ASSERT_TRUE(map) << sentence(map.error());
  // the triangles lie within 0.05 mm of the balls
  std::int64_t unsure = 0;
  const std::int64_t wrong = wrongIn(*map, [&](const Vec3& p_mm) {
    const double r = (p_mm - centre).norm();
    unsure += std::abs(r - 18.0) < 0.05 || std::abs(r - 9.0) < 0.05 ? 1 : 0;
    return r < 18.0 && r > 9.0;
  });
  EXPECT_LE(wrong, unsure);
  EXPECT_LT(unsure, 600);
  // rows through faces, edges and corners: each is on one side, and no row leaks
  const auto exact = readLabels(
      workshop.write("box.obj", objOf(boxOf(Vec3(10, 10, 10), Vec3(20, 20, 20)), "SPACE=LPS")),
      scan);
  ASSERT_TRUE(exact) << sentence(exact.error());
  EXPECT_EQ(exact->structures()[0].voxels, 1000);
  // two boxes that share a face are one beside the other
  const auto left = readLabels(
      workshop.write("l.obj", objOf(boxOf(Vec3(10, 10, 10), Vec3(15, 20, 20)), "SPACE=LPS")), scan);
  const auto right = readLabels(
      workshop.write("r.obj", objOf(boxOf(Vec3(15, 10, 10), Vec3(20, 20, 20)), "SPACE=LPS")), scan);
  ASSERT_TRUE(left && right);
  for (std::int64_t n = 0; n < grid.voxelCount(); ++n)
    EXPECT_EQ(int(exact->codes()[n]), left->codes()[n] + right->codes()[n]);
}

TEST(SurfaceLabels, WhatIsOpenOrHasNoSpaceIsRefusedByName) {
  Workshop workshop;
  Grid grid = smallGrid();
  const haptics::Volume scan = scanOn(grid);
  const ClosedMesh box = boxOf(Vec3(0.5, -0.5, -0.5), Vec3(2.5, 1.5, 0.5));
  const auto reasonFor = [&](const std::string& name, const std::string& bytes,
                             const LabelReading& reading = {}) {
    const auto map = readLabels(workshop.write(name, bytes), scan, {}, reading);
    EXPECT_TRUE(map || !sentence(map.error()).empty());
    return reasonOf(map);
  };
  EXPECT_EQ(reasonFor("a.stl", stlOf(box, "x")), "surface-space");
  EXPECT_EQ(reasonFor("a.stl", stlOf(box, "x"), {.space = SurfaceSpace::Lps}), "");
  EXPECT_EQ(reasonFor("b.obj", objOf(box, "SPACE=LPS SPACE=RAS")), "surface-space");
  EXPECT_EQ(reasonFor("c.obj", objOf(box, "SPACE=LPS"), {.space = SurfaceSpace::Ras}),
            "surface-space");
  EXPECT_EQ(reasonFor("d.obj", objOf(box, "SPACE=RAS")), "labels-elsewhere");
  ClosedMesh open = box;
  open.triangles.pop_back();
  EXPECT_EQ(reasonFor("e.obj", objOf(open, "SPACE=LPS")), "surface-open");
  EXPECT_EQ(
      reasonOf(readLabels(workshop.write("f.obj", objOf(box, "SPACE=LPS")), scanOn(grid, false))),
      "orientation-unknown");
  EXPECT_EQ(reasonFor("g.stl", "solid"), "truncated");
  EXPECT_EQ(surfaceSpaceNamed("ras"), SurfaceSpace::Ras);
  EXPECT_EQ(surfaceSpaceNamed("SRA"), std::nullopt);
}

TEST(SurfaceLabels, DamagedOnesAreRefusedWithASentence) {
  const ClosedMesh box = boxOf(Vec3(0.5, -0.5, -0.5), Vec3(2.5, 1.5, 0.5));
  expectDamagedRefused({{"a.stl", stlOf(box, "SPACE=LPS")},
                        {"a.obj", objOf(box, "SPACE=LPS")},
                        {"a.ply", plyOf(box, "SPACE=LPS")}},
                       0);
}

}  // namespace
}  // namespace datasets
