// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/structure_shape.h"

#include <vtkCallbackCommand.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricDecimation.h>
#include <vtkReverseSense.h>
#include <vtkSmartPointer.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/props/picture.h"

namespace ui {
namespace {

constexpr double kMostVoxels = 24e6;  // of a mask: beyond that they are averaged
constexpr int kPlaces = 12;
// the mask is 0 and 255: half-way for whole voxels; of averages less, so that thin walls stay
constexpr double kWholeLevel = 127.5, kAverageLevel = 60.0;
constexpr int kSmoothings = 20;
constexpr double kPassBand = 0.08;
constexpr double kMostMoved = 0.3;
// that edges are collapsed of: some seconds; what has more is binned before
constexpr std::int64_t kMostCollapsed = 1'000'000;

using VoxelIndex = std::array<std::int64_t, 3>;

/// Calls f(index, code) for the voxels of a box, until it is cancelled.
template <class F>
void eachVoxel(const StructureMap& map, const haptics::VoxelBox& box,
               const std::atomic<bool>& cancel, F&& f) {
  const auto& dims = map.grid.dims;
  VoxelIndex at{};
  for (at[2] = box.first[2]; at[2] < box.end[2] && !cancel; ++at[2])
    for (at[1] = box.first[1]; at[1] < box.end[1]; ++at[1]) {
      const std::uint8_t* row = map.codes.get() + (at[2] * dims[1] + at[1]) * dims[0];
      for (at[0] = box.first[0]; at[0] < box.end[0]; ++at[0]) f(at, row[at[0]]);
    }
}

Eigen::Vector3d placeOf(const haptics::Grid& grid, const VoxelIndex& at) {
  return grid.worldOf({double(at[0]), double(at[1]), double(at[2])}) * kMmPerM;
}

/// The points of a smoothed surface, no farther from where they were than kMostMoved of a block:
/// what is one voxel thin would be smoothed to a line.
vtkSmartPointer<vtkPoints> held(vtkPolyData& smoothed, vtkPolyData& before,
                                const Eigen::Vector3d& block_mm) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->DeepCopy(smoothed.GetPoints());
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n) {
    const Eigen::Vector3d from(before.GetPoint(n));
    const Eigen::Vector3d by = Eigen::Vector3d(points->GetPoint(n)) - from;
    const double blocks = by.cwiseQuotient(block_mm).norm();
    if (blocks <= kMostMoved) continue;
    const Eigen::Vector3d to = from + by * (kMostMoved / blocks);
    points->SetPoint(n, to.data());
  }
  return points;
}

/// At most so many triangles. Edges are collapsed: bins would merge the two sides of a thin wall.
vtkSmartPointer<vtkPolyData> lightened(vtkPolyData* mesh, std::int64_t most_triangles,
                                       const std::atomic<bool>& cancel) {
  if (mesh->GetNumberOfPolys() <= most_triangles) return mesh;
  const vtkSmartPointer<vtkPolyData> input = lightMesh(mesh, kMostCollapsed);
  vtkNew<vtkQuadricDecimation> collapse;
  collapse->SetInputData(input);
  collapse->SetTargetReduction(1.0 - double(most_triangles) / double(input->GetNumberOfPolys()));
  collapse->VolumePreservationOn();
  vtkNew<vtkCallbackCommand> end;
  end->SetClientData(const_cast<std::atomic<bool>*>(&cancel));
  end->SetCallback([](vtkObject* filter, unsigned long, void* flag, void*) {
    if (*static_cast<const std::atomic<bool>*>(flag))
      static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
  });
  collapse->AddObserver(vtkCommand::ProgressEvent, end);
  collapse->Update();
  return collapse->GetOutput();
}

}  // namespace

std::vector<haptics::VoxelBox> boxesOf(const StructureMap& map, std::size_t structures) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  std::vector<haptics::VoxelBox> of_codes(256, {{kFar, kFar, kFar}, {0, 0, 0}});
  const std::atomic<bool> never{false};
  eachVoxel(map, {{}, map.grid.dims}, never, [&](const VoxelIndex& at, std::uint8_t code) {
    if (code == 0) return;
    haptics::VoxelBox& box = of_codes[code];
    for (std::size_t a = 0; a < 3; ++a) {
      box.first[a] = std::min(box.first[a], at[a]);
      box.end[a] = std::max(box.end[a], at[a] + 1);
    }
  });
  std::vector<haptics::VoxelBox> boxes(structures, of_codes[0]);
  for (std::size_t code = 0; code < map.sets.size(); ++code)
    for (const std::uint8_t number : map.sets[code])
      for (std::size_t a = 0; a < 3; ++a) {
        boxes[number].first[a] = std::min(boxes[number].first[a], of_codes[code].first[a]);
        boxes[number].end[a] = std::max(boxes[number].end[a], of_codes[code].end[a]);
      }
  return boxes;
}

StructureShape shapeOf(const StructureMap& map, std::uint8_t number, const haptics::VoxelBox& box,
                       std::int64_t most_triangles, const std::atomic<bool>& cancel) {
  if (box.first[0] >= box.end[0]) return {};
  std::array<bool, 256> in{};
  for (std::size_t code = 0; code < map.sets.size(); ++code)
    in[code] = std::ranges::binary_search(map.sets[code], number);
  const haptics::Grid& grid = map.grid;
  VoxelIndex size{}, blocks{};
  double voxels = 1.0;
  for (std::size_t a = 0; a < 3; ++a) voxels *= double(size[a] = box.end[a] - box.first[a]);
  const auto factor =
      std::max<std::int64_t>(1, std::int64_t(std::ceil(std::cbrt(voxels / kMostVoxels))));

  // how much of each block belongs to it, with a rim of nothing, so that it is closed
  vtkNew<vtkImageData> mask;
  Eigen::Vector3d origin_mm, block_mm;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    blocks[a] = (size[a] + factor - 1) / factor + 2;
    block_mm[axis] = grid.spacing[axis] * kMmPerM * double(factor);
    origin_mm[axis] =
        (double(box.first[a]) + 0.5 * double(factor - 1)) * grid.spacing[axis] * kMmPerM -
        block_mm[axis];
  }
  mask->SetDimensions(int(blocks[0]), int(blocks[1]), int(blocks[2]));
  mask->SetSpacing(block_mm.data());
  mask->SetOrigin(origin_mm.data());
  mask->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(mask->GetScalarPointer());
  std::fill(out, out + blocks[0] * blocks[1] * blocks[2], 0.0F);
  const auto share = static_cast<float>(255.0 / double(factor * factor * factor));
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  std::int64_t count = 0;
  eachVoxel(map, box, cancel, [&](const VoxelIndex& at, std::uint8_t code) {
    if (!in[code]) return;
    std::int64_t block = 0;
    for (const std::size_t a : {2U, 1U, 0U})
      block = block * blocks[a] + (at[a] - box.first[a]) / factor + 1;
    out[block] += share;
    middle += Eigen::Vector3d(double(at[0]), double(at[1]), double(at[2]));
    ++count;
  });
  if (count == 0 || cancel) return {};

  StructureShape shape;
  middle /= double(count);
  VoxelIndex nearest{};
  double least = std::numeric_limits<double>::infinity();
  std::int64_t seen = 0;
  eachVoxel(map, box, cancel, [&](const VoxelIndex& at, std::uint8_t code) {
    if (!in[code]) return;
    const double away = (Eigen::Vector3d(double(at[0]), double(at[1]), double(at[2])) - middle)
                            .cwiseProduct(grid.spacing)
                            .squaredNorm();
    if (away < least) {
      least = away;
      nearest = at;
    }
    if (seen++ % (count / kPlaces + 1) == 0) shape.places_mm.push_back(placeOf(grid, at));
  });
  shape.places_mm.insert(shape.places_mm.begin(), placeOf(grid, nearest));

  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(mask);
  edges->SetValue(0, factor == 1 ? kWholeLevel : kAverageLevel);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(edges->GetOutputPort());
  smooth->SetNumberOfIterations(kSmoothings);
  smooth->SetPassBand(kPassBand);
  smooth->BoundarySmoothingOff();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NonManifoldSmoothingOn();
  smooth->NormalizeCoordinatesOn();
  smooth->Update();
  const auto rounded = vtkSmartPointer<vtkPolyData>::New();
  rounded->ShallowCopy(smooth->GetOutput());
  rounded->SetPoints(held(*smooth->GetOutput(), *edges->GetOutput(), block_mm));
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(lightened(rounded, most_triangles, cancel));
  normals->SplittingOff();
  normals->ConsistencyOff();
  vtkAlgorithm* last = normals;
  vtkNew<vtkReverseSense> reverse;
  if (grid.direction.determinant() < 0.0) {
    reverse->SetInputConnection(normals->GetOutputPort());
    reverse->ReverseCellsOn();
    reverse->ReverseNormalsOff();
    last = reverse;
  }
  last->Update();
  if (cancel) return {};
  shape.mesh = vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
  return shape;
}

}  // namespace ui
