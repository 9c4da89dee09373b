// SPDX-License-Identifier: BSD-3-Clause
// The bricks that are contoured anew and what is left of the mesh beside them are one surface.
#include "ui/props/carved_part.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "tests/unit/ui/volumes.h"
#include "ui/props/picture.h"

namespace {

using haptics::Vec3;
using haptics::Volume;
using haptics::VoxelBox;

constexpr double kIsovalue = 500.0;

/// A wavy solid through all bricks. Many voxels have the isovalue.
Volume wavy() {
  return volumes::made(volumes::turnedGrid({70, 65, 40}), [](const Vec3& u) {
    if (u.minCoeff() < 1.0 || (Vec3{69.0, 64.0, 39.0} - u).minCoeff() < 1.0) return 0.0;
    const double wave = std::sin(0.21 * u.x()) + std::cos(0.17 * u.y()) + std::sin(0.31 * u.z());
    return std::clamp(100.0 * std::round(5.0 + 3.0 * wave), 0.0, 1000.0);
  });
}

/// A corner or a normal, rounded to what two meshes of one surface have in common.
using Rounded = std::array<long, 3>;
Rounded rounded(const double* v, double unit) {
  return {std::lround(v[0] / unit), std::lround(v[1] / unit), std::lround(v[2] / unit)};
}

/// Its triangles, by their corners, whatever comes first; and the normals there. What two meshes
/// have both is there once.
struct Surface {
  std::set<std::array<Rounded, 3>> triangles;
  std::map<Rounded, Vec3> normals;

  void add(vtkPolyData& mesh) {
    vtkDataArray* const there = mesh.GetPointData()->GetNormals();
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    for (mesh.GetPolys()->InitTraversal(); mesh.GetPolys()->GetNextCell(count, ids);) {
      std::array<Rounded, 3> corners{};
      for (std::size_t n = 0; n < 3; ++n) {
        corners[n] = rounded(mesh.GetPoint(ids[n]), 1e-3);
        const Vec3 normal{there->GetTuple(ids[n])};
        const auto found = normals.try_emplace(corners[n], normal).first;
        EXPECT_LT((found->second - normal).norm(), 1e-3);
      }
      std::ranges::sort(corners);
      if (corners[0] == corners[1] || corners[1] == corners[2]) continue;
      triangles.insert(corners);
    }
  }
};

vtkPolyData& meshOf(ui::CarvedPart& carved) {
  carved.contour(kIsovalue, false, ui::Rgb{0.9, 0.9, 0.8});
  return *vtkPolyData::SafeDownCast(carved.actor()->GetMapper()->GetInputDataObject(0, 0));
}

TEST(CarvedPart, IsOneSurfaceWithTheMeshBesideIt) {
  const auto volume = std::make_shared<const Volume>(wavy());
  const auto whole =
      ui::isosurfaceMesh(ui::reducedImageOf(*volume, volume->grid.voxelCount()), kIsovalue, false);
  Surface expected;
  expected.add(*whole);
  ASSERT_GT(expected.triangles.size(), 10'000U);
  // nothing was cut; here and there; everywhere
  const VoxelBox all = volume->bounds();
  for (const auto& boxes : {std::vector<VoxelBox>{},
                            {{{31, 30, 4}, {34, 36, 9}}},
                            {{{2, 2, 2}, {5, 5, 5}}, {{66, 60, 36}, {70, 65, 40}}},
                            std::vector<VoxelBox>{all}}) {
    ui::CarvedPart carved;
    // half of them were cut before
    const std::size_t half = boxes.size() / 2;
    carved.begin(*volume, volume, {boxes.data(), half});
    for (std::size_t n = half; n < boxes.size(); ++n) carved.add(boxes[n]);
    Surface found;
    found.add(*carved.beside(whole));
    if (boxes.empty()) EXPECT_EQ(carved.beside(whole), whole.Get());
    const std::size_t beside = found.triangles.size();
    if (!boxes.empty()) found.add(meshOf(carved));
    EXPECT_TRUE(found.triangles == expected.triangles) << boxes.size();
    if (!boxes.empty() && boxes.front() == all)
      EXPECT_EQ(beside, 0U);
    else if (!boxes.empty())
      EXPECT_LT(beside, expected.triangles.size());
  }
}

TEST(CarvedPart, ContoursAgainWhatWasCutAndColoursIt) {
  const Volume before = wavy();
  const auto scan = std::make_shared<const Volume>(before);
  auto voxels = haptics::allocateVoxels(before.grid.voxelCount(), before.type).value();
  const auto bytes = static_cast<std::size_t>(before.grid.voxelCount()) * 2;
  std::memcpy(voxels.get(), before.voxels.get(), bytes);
  Volume live = before;
  live.voxels = voxels;
  ui::CarvedPart carved;
  carved.begin(live, scan, {});
  const VoxelBox box{{36, 28, 10}, {45, 36, 18}};
  carved.add(box);
  const auto corals = [&] {
    vtkPolyData& mesh = meshOf(carved);
    vtkDataArray* const colours = mesh.GetPointData()->GetScalars();
    int count = 0;
    for (vtkIdType n = 0; n < mesh.GetNumberOfPoints(); ++n) {
      const double* c = colours->GetTuple(n);
      if (!(c[0] > 1.4 * c[1])) continue;
      ++count;
      // within a voxel of what was cut
      for (int a = 0; a < 3; ++a) {
        const double at = mesh.GetPoint(n)[a] / (before.grid.spacing[a] * 1e3);
        const auto of = static_cast<std::size_t>(a);
        EXPECT_GE(at, static_cast<double>(box.first[of] - 1));
        EXPECT_LE(at, static_cast<double>(box.end[of]));
      }
    }
    return count;
  };
  EXPECT_EQ(corals(), 0);
  const auto& dims = before.grid.dims;
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
      std::fill_n(
          static_cast<std::int16_t*>(voxels.get()) + (k * dims[1] + j) * dims[0] + box.first[0],
          box.end[0] - box.first[0], std::int16_t{0});
  carved.add(box);
  EXPECT_GT(corals(), 50);
  // beside it the mesh of before is still right
  const auto meshOfAll = [](const Volume& volume) {
    return ui::isosurfaceMesh(ui::reducedImageOf(volume, volume.grid.voxelCount()), kIsovalue,
                              false);
  };
  Surface expected, found;
  expected.add(*meshOfAll(live));
  const auto old = meshOfAll(before);
  found.add(*carved.beside(old));
  found.add(meshOf(carved));
  EXPECT_TRUE(found.triangles == expected.triangles);
  for (const auto& [corner, normal] : expected.normals)
    EXPECT_LT((found.normals.at(corner) - normal).norm(), 1e-3);
  carved.setTint(false);
  EXPECT_EQ(corals(), 0);
}

}  // namespace
