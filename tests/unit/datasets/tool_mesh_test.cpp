// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/meshes/tool_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "tests/support/comma_locale.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::Vec3;
using testing::Workshop;

constexpr float kTetrahedron[4][3] = {{0, 0, 0}, {20, 0, 0}, {0, 30, 0}, {0, 0, 40}};
constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string binaryStl(int faces = 4, std::uint32_t stated = 4, float odd = 0.0f) {
  std::string bytes(80, ' ');
  bytes.append(reinterpret_cast<const char*>(&stated), 4);
  for (int f = 0; f < faces; ++f) {
    const float normal[3] = {0, 0, 0};
    bytes.append(reinterpret_cast<const char*>(normal), 12);
    for (const int v : kFaces[f]) {
      float p[3] = {kTetrahedron[v][0], kTetrahedron[v][1], kTetrahedron[v][2]};
      if (odd != 0.0f && v == 3) p[0] = odd;
      bytes.append(reinterpret_cast<const char*>(p), 12);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string asciiStl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& face : kFaces) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const int v : face) {
      text += "  vertex";
      for (const float x : kTetrahedron[v]) text += " " + std::to_string(x);
      text += "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

const char* const kObj = "v 0 0 0\nv 20 0 0\nv 0 30 0\nv 0 0 40\n";
const char* const kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n20 0 0\n0 30 0\n0 0 40\n";

std::string reasonForTool(const fs::path& path) {
  const auto mesh = readToolMesh(path, MeshUnit::Millimetre);
  return mesh ? "" : mesh.error().reason;
}

TEST(ToolMesh, OneTetrahedronInFourFiles) {
  Workshop workshop;
  const std::string obj = std::string(kObj) + "f 1 3 2\nf 1 2 4\nf -4 -1 -2\nf 2 3 4\n";
  const std::string ply = std::string(kPlyHeader) + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  for (const fs::path& path :
       {workshop.write("b.stl", binaryStl()), workshop.write("a.stl", asciiStl()),
        workshop.write("t.OBJ", obj), workshop.write("t.ply", ply)}) {
    const auto tool = readToolMesh(path, MeshUnit::Millimetre);
    ASSERT_TRUE(tool) << path << ": " << sentence(tool.error());
    EXPECT_EQ(tool->mesh.vertices.size(), 4u) << path;
    EXPECT_EQ(tool->mesh.triangles.size(), 4u) << path;
    EXPECT_TRUE(tool->warnings.empty()) << path << ": " << sentence(tool->warnings.front());
    // the volume, signed by the order of the corners: 20 x 30 x 40 / 6 mm^3
    double volume = 0.0;
    for (const auto& t : tool->mesh.triangles)
      volume += tool->mesh.vertices[t[0]].dot(
                    tool->mesh.vertices[t[1]].cross(tool->mesh.vertices[t[2]])) /
                6;
    EXPECT_NEAR(volume, 4e-6, 1e-15) << path;
  }
}

TEST(ToolMesh, UnitsAndTheirWarning) {
  Workshop workshop;
  const fs::path path = workshop.write("t.stl", binaryStl());
  const auto height = [&](MeshUnit unit) {
    double most = 0.0;
    const auto tool = readToolMesh(path, unit);
    for (const Vec3& v : tool->mesh.vertices) most = std::max(most, v.z());
    return most;
  };
  EXPECT_NEAR(height(MeshUnit::Millimetre), 0.040, 1e-12);
  EXPECT_NEAR(height(MeshUnit::Centimetre), 0.40, 1e-12);
  EXPECT_NEAR(height(MeshUnit::Inch), 1.016, 1e-12);
  EXPECT_NEAR(height(MeshUnit::Metre), 40.0, 1e-12);
  EXPECT_EQ(readToolMesh(path, MeshUnit::Centimetre)->warnings.size(), 0u);
  EXPECT_EQ(readToolMesh(path, MeshUnit::Inch)->warnings.size(), 1u);
}

TEST(ToolMesh, NumbersAreReadAlikeInEveryLanguage) {
  Workshop workshop;
  const fs::path files[] = {
      workshop.write("h.obj", "v 0 0 0\nv 10.5 0 0\nv 0 10.25 0\nf 1 2 3\n"),
      workshop.write("h.ply",
                     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0\n10.5 0 0\n0 10.25 0\n3 0 1 2\n"),
      workshop.write("h.stl",
                     "solid h\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10.5 0 0\n"
                     "vertex 0 10.25 0\nendloop\nendfacet\nendsolid h\n")};
  for (const fs::path& path : files) {
    std::optional<support::CommaLocale> comma(workshop.folder());
    ASSERT_TRUE(comma->isSet());
    const auto tool = readToolMesh(path, MeshUnit::Metre);
    comma.reset();
    ASSERT_TRUE(tool) << path.filename() << ": " << sentence(tool.error());
    EXPECT_EQ(tool->mesh.vertices[1].x(), 10.5) << path.filename();
  }
}

TEST(ToolMesh, ATailBehindTheTrianglesIsSaid) {
  Workshop workshop;
  const auto tool =
      readToolMesh(workshop.write("t.stl", binaryStl() + "a tail"), MeshUnit::Millimetre);
  ASSERT_FALSE(tool);
  EXPECT_NE(sentence(tool.error()).find("\"t.stl\" is damaged"), std::string::npos)
      << sentence(tool.error());
}

TEST(ToolMesh, PolygonsBecomeTriangles) {
  Workshop workshop;
  const auto tool =
      readToolMesh(workshop.write("q.obj", "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nf 1 2 3 4\n"),
                   MeshUnit::Millimetre);
  ASSERT_TRUE(tool) << sentence(tool.error());
  EXPECT_EQ(tool->mesh.triangles.size(), 2u);
  ASSERT_EQ(tool->warnings.size(), 1u);
  EXPECT_NE(sentence(tool->warnings[0]).find("4 edges"), std::string::npos)
      << sentence(tool->warnings[0]);
}

TEST(ToolMesh, BrokenFilesAreRefusedByName) {
  Workshop workshop;
  const auto reason = [&](const std::string& name, const std::string& bytes) {
    return reasonForTool(workshop.write(name, bytes));
  };
  EXPECT_EQ(reason("s.stl", binaryStl(3, 4)), "truncated");
  EXPECT_EQ(reason("s.stl", binaryStl(4, 3)), "truncated");
  EXPECT_EQ(reason("s.stl", binaryStl().substr(0, 200)), "truncated");
  EXPECT_EQ(reason("s.stl", binaryStl().substr(0, 40)), "truncated");
  EXPECT_EQ(reason("s.stl", binaryStl(0, 0)), "no-triangle");
  EXPECT_EQ(reason("s.stl", binaryStl(4, 4, std::numeric_limits<float>::quiet_NaN())),
            "non-finite");
  EXPECT_EQ(reason("s.stl", binaryStl(4, 4, std::numeric_limits<float>::infinity())), "non-finite");
  EXPECT_EQ(reason("s.stl", ""), "truncated");
  EXPECT_EQ(reason("s.stl", asciiStl().substr(0, 300)), "truncated");
  EXPECT_EQ(reason("s.stl", "solid nothing\nendsolid nothing\n"), "no-triangle");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "f 1 2 5\n"), "bad-index");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "f 1 2 0\n"), "bad-index");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "f 1 2 -5\n"), "bad-index");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "f 1//1 2//1 3//1\n"), "bad-index");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "f 1 2\n"), "bad-index");
  EXPECT_EQ(reason("o.obj", kObj), "no-triangle");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "v 1 2\nf 1 2 3\n"), "truncated");
  EXPECT_EQ(reason("o.obj", std::string(kObj) + "v nan 0 0\nf 1 2 5\n"), "non-finite");
  EXPECT_EQ(reason("s.stl",
                   "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex inf 0 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n"),
            "non-finite");
  EXPECT_EQ(reason("p.ply", std::string(kPlyHeader) + "3 0 2 1\n3 0 1 3\n"), "truncated");
  EXPECT_EQ(reason("p.ply", std::string(kPlyHeader) + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 4\n"),
            "bad-index");
  EXPECT_EQ(reason("p.ply", std::string(kPlyHeader) + "3 0 2 1\n3 0 1 3\n3 0 3 2\n2 1 2\n"),
            "bad-index");
  EXPECT_EQ(reason("p.ply", "not a mesh"), "bad-header");
  EXPECT_EQ(reason("x.3ds", binaryStl()), "unreadable");
  EXPECT_EQ(reasonForTool(workshop.folder() / "absent.stl"), "unreadable");
}

TEST(ToolMesh, APlyIsReadRowByRowHoweverItIsLaidOut) {
  for (const char* name : {"no_final_newline.ply", "faces_first.ply", "blank_line.ply"}) {
    const auto tool = readToolMesh(places::source(std::string("tests/cases/reports/ply/") + name),
                                   MeshUnit::Millimetre);
    ASSERT_TRUE(tool) << name << ": " << sentence(tool.error());
    EXPECT_EQ(tool->mesh.vertices.size(), 8u) << name;
    EXPECT_EQ(tool->mesh.triangles.size(), 12u) << name;
    EXPECT_TRUE(tool->warnings.empty()) << name;
  }
  Workshop workshop;
  // all rows on one line, a list before the coordinates, other elements between
  const std::string text =
      "ply\nformat ascii 1.0\nobj_info a\nelement camera 1\nproperty list uchar float f\n"
      "element vertex 4\nproperty list uchar short near\nproperty double z\nproperty double y\n"
      "property double x\nelement edge 0\nproperty int a\nelement face 4\n"
      "property uchar red\nproperty list uchar int vertex_index\nend_header\n"
      "2 nan 1 0 0 0 0 0 0 0 20 1 5 0 30 0 0 40 0 0 7 3 0 2 1 7 3 0 1 3 7 3 0 3 2 7 3 1 2 3";
  const auto tool = readToolMesh(workshop.write("t.ply", text), MeshUnit::Millimetre);
  ASSERT_TRUE(tool) << sentence(tool.error());
  EXPECT_EQ(tool->mesh.triangles.size(), 4u);
  EXPECT_TRUE(tool->warnings.empty());
  EXPECT_EQ(tool->mesh.vertices[1], Vec3(0.0, 0.03, 0.0));
}

TEST(ToolMesh, APlyThatFitsOnlyByGuessingIsRefused) {
  Workshop workshop;
  const fs::path hostile = places::source("tests/cases/hostile");
  EXPECT_EQ(reasonForTool(hostile / "no_z.ply"), "bad-header");
  EXPECT_EQ(reasonForTool(hostile / "long_line.ply"), "");
  const std::string rows = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const auto with = [&](const std::string& part, const std::string& instead) {
    std::string text = kPlyHeader + rows;
    text.replace(text.find(part), part.size(), instead);
    return reasonForTool(workshop.write("p.ply", text));
  };
  EXPECT_EQ(with("vertex 4", "vertex 4"), "");
  EXPECT_EQ(with("element vertex", "element vertices"), "bad-header");
  EXPECT_EQ(with("property float z\n", "property float z\nproperty float z\n"), "bad-header");
  EXPECT_EQ(with("property float z\n", "property float z\nelement vertex 0\nproperty float x\n"),
            "bad-header");
  EXPECT_EQ(with("property float z", "property list uchar float z"), "bad-header");
  EXPECT_EQ(with("vertex_indices", "corners"), "bad-header");
  EXPECT_EQ(with("format ascii 1.0", "format ascii 1.0\nrows four"), "bad-header");
  // a row has a number more than its header says
  EXPECT_EQ(with("20 0 0\n", "20 0 0 1\n"), "truncated");
  EXPECT_EQ(with("3 1 2 3\n", "3 1 2 3 0\n"), "truncated");
  EXPECT_EQ(with("20 0 0\n", "20,5 0 0\n"), "truncated");
  EXPECT_EQ(with("20 0 0\n", "1e39 0 0\n"), "non-finite");
  EXPECT_EQ(with("20 0 0\n", "nan 0 0\n"), "non-finite");
  EXPECT_EQ(with("3 1 2 3\n", "3 1 2 2.5\n"), "bad-index");
  EXPECT_EQ(with("3 1 2 3\n", "2.5 1 2 3\n"), "truncated");
  EXPECT_EQ(with("3 1 2 3\n", "3 1 2 -1\n"), "bad-index");
}

TEST(ToolMesh, APolygonWithVeryManyCornersIsRefused) {
  Workshop workshop;
  const auto withCorners = [&](int corners) {
    std::string text, face = "f";
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * M_PI * i / corners;
      text += "v " + std::to_string(9 * std::cos(turn)) + " " + std::to_string(9 * std::sin(turn)) +
              " 0\n";
      face += " " + std::to_string(i + 1);
    }
    return readToolMesh(workshop.write("p.obj", text + face + "\n"), MeshUnit::Millimetre);
  };
  const auto most = withCorners(1000);
  ASSERT_TRUE(most) << sentence(most.error());
  EXPECT_EQ(most->mesh.triangles.size(), 998u);
  const auto more = withCorners(1001);
  ASSERT_FALSE(more);
  EXPECT_NE(sentence(more.error()).find("more than 1000 corners"), std::string::npos)
      << sentence(more.error());
}

TEST(ToolMesh, FacesMayStateTextureAndNormalAtSomeCornersOnly) {
  Workshop workshop;
  const std::string lists = std::string(kObj) + "vt 0 0\nvt 1 0\nvn 0 0 1\n";
  const auto tool = readToolMesh(
      workshop.write("m.obj", lists + "f 1 3/1 2//1\nf 1/2/1 2 4\nf -4//1 -1 -2\nf 2 3 4/1\n"),
      MeshUnit::Millimetre);
  ASSERT_TRUE(tool) << sentence(tool.error());
  EXPECT_EQ(tool->mesh.triangles.size(), 4u);
  EXPECT_EQ(tool->mesh.vertices.size(), 4u);
}

}  // namespace
}  // namespace datasets
