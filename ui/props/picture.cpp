// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/picture.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkShortArray.h>
#include <vtkSignedCharArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace ui {
namespace {

constexpr std::int64_t kReducedVoxels = 1'500'000;  // about 100,000 triangles
constexpr std::int64_t kHistogramVoxels = 4'000'000;
constexpr int kHistogramBins = 256;

vtkSmartPointer<vtkDataArray> emptyArray(haptics::ScalarType type) {
  using haptics::ScalarType;
  switch (type) {
    case ScalarType::UInt8:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    // plain VTK_CHAR is a type that the ray caster does not know
    case ScalarType::Int8:
      return vtkSmartPointer<vtkSignedCharArray>::New();
    case ScalarType::UInt16:
      return vtkSmartPointer<vtkUnsignedShortArray>::New();
    case ScalarType::Int16:
      return vtkSmartPointer<vtkShortArray>::New();
    case ScalarType::UInt32:
      return vtkSmartPointer<vtkUnsignedIntArray>::New();
    case ScalarType::Int32:
      return vtkSmartPointer<vtkIntArray>::New();
    case ScalarType::Float32:
      break;
  }
  return vtkSmartPointer<vtkFloatArray>::New();
}

void destroyShare(void* share) { delete static_cast<std::shared_ptr<const void>*>(share); }

/// Averages cubes of `factor` voxels, from voxel `first` on.
template <class T>
void averageBlocks(const T* all, const std::array<std::int64_t, 3>& dims,
                   const std::array<std::int64_t, 3>& first, std::int64_t factor,
                   const std::array<std::int64_t, 3>& blocks, float background, float* out,
                   const std::atomic<bool>* cancel) {
  const T* voxels = all + (first[2] * dims[1] + first[1]) * dims[0] + first[0];
  const std::int64_t row = blocks[0] + 2;
  const std::int64_t slab = row * (blocks[1] + 2);
  std::fill(out, out + slab * (blocks[2] + 2), background);
  for (std::int64_t K = 0; K < blocks[2] && (cancel == nullptr || !*cancel); ++K)
    for (std::int64_t J = 0; J < blocks[1]; ++J)
      for (std::int64_t I = 0; I < blocks[0]; ++I) {
        double sum = 0.0;
        for (std::int64_t k = K * factor; k < (K + 1) * factor; ++k)
          for (std::int64_t j = J * factor; j < (J + 1) * factor; ++j) {
            const T* v = voxels + (k * dims[1] + j) * dims[0] + I * factor;
            for (std::int64_t i = 0; i < factor; ++i) sum += static_cast<double>(v[i]);
          }
        out[(K + 1) * slab + (J + 1) * row + I + 1] =
            static_cast<float>(sum / static_cast<double>(factor * factor * factor));
      }
}

Eigen::AlignedBox3d boxOf_mm(const haptics::Grid& grid, const haptics::VoxelBox& voxels) {
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner) {
    haptics::Vec3 index;
    for (std::size_t a = 0; a < 3; ++a)
      index[static_cast<Eigen::Index>(a)] =
          static_cast<double>((corner >> a) & 1 ? voxels.end[a] - 1 : voxels.first[a]);
    box.extend(Eigen::Vector3d{grid.worldOf(index) * kMmPerM});
  }
  return box;
}

}  // namespace

vtkSmartPointer<vtkImageData> imageOf(const haptics::Volume& volume) {
  const haptics::Grid& grid = volume.grid;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(grid.dims[0]), static_cast<int>(grid.dims[1]),
                       static_cast<int>(grid.dims[2]));
  const haptics::Vec3 spacing_mm = grid.spacing * kMmPerM;
  image->SetSpacing(spacing_mm.data());

  auto array = emptyArray(volume.type);
  array->SetVoidArray(const_cast<void*>(volume.voxels.get()), grid.voxelCount(), 1);
  array->SetName("intensity");
  // a command's client data dies with the array: the share of the voxels lives as long as it
  vtkNew<vtkCallbackCommand> keeper;
  keeper->SetClientData(new std::shared_ptr<const void>(volume.voxels));
  keeper->SetClientDataDeleteCallback(&destroyShare);
  array->AddObserver(vtkCommand::NoEvent, keeper);
  image->GetPointData()->SetScalars(array);
  return image;
}

vtkSmartPointer<vtkImageData> reducedImageOf(const haptics::Volume& volume,
                                             std::int64_t most_voxels,
                                             const std::atomic<bool>* cancel) {
  const haptics::Grid& grid = volume.grid;
  const haptics::VoxelBox box = volume.bounds();
  std::array<std::int64_t, 3> size{};
  for (std::size_t a = 0; a < 3; ++a) size[a] = box.end[a] - box.first[a];
  const std::int64_t thinnest = *std::min_element(size.begin(), size.end());
  const auto count = static_cast<double>(size[0] * size[1] * size[2]);
  auto factor = static_cast<std::int64_t>(
      std::ceil(std::cbrt(count / static_cast<double>(most_voxels)) - 1e-9));
  factor = std::clamp<std::int64_t>(factor, 1, thinnest);

  std::array<std::int64_t, 3> blocks{};
  double origin_mm[3], spacing_mm[3];
  for (int a = 0; a < 3; ++a) {
    blocks[a] = size[a] / factor;
    spacing_mm[a] = grid.spacing[a] * kMmPerM * static_cast<double>(factor);
    // a block's centre, and one block further out for the rim
    origin_mm[a] = (static_cast<double>(box.first[a]) + 0.5 * static_cast<double>(factor - 1)) *
                       grid.spacing[a] * kMmPerM -
                   spacing_mm[a];
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(blocks[0] + 2), static_cast<int>(blocks[1] + 2),
                       static_cast<int>(blocks[2] + 2));
  image->SetOrigin(origin_mm);
  image->SetSpacing(spacing_mm);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    averageBlocks(voxels, grid.dims, box.first, factor, blocks, static_cast<float>(volume.least),
                  out, cancel);
  });
  return image;
}

Histogram histogramOf(const haptics::Volume& volume, int bins) {
  Histogram histogram{.least = volume.least, .greatest = volume.greatest};
  histogram.counts.assign(static_cast<std::size_t>(bins), 0.0);
  const double width = (volume.greatest - volume.least) / bins;
  if (!(width > 0.0)) return histogram;
  const haptics::VoxelBox box = volume.bounds();
  const auto& dims = volume.grid.dims;
  const std::int64_t row = box.end[0] - box.first[0], rows = box.end[1] - box.first[1];
  const std::int64_t count = row * rows * (box.end[2] - box.first[2]);
  // an odd stride does not fall in step with rows
  const std::int64_t step = (count / kHistogramVoxels) | 1;
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t n = 0; n < count; n += step) {
      const std::int64_t line = n / row;
      const std::int64_t j = box.first[1] + line % rows, k = box.first[2] + line / rows;
      const std::int64_t voxel = (k * dims[1] + j) * dims[0] + box.first[0] + n % row;
      const auto bin =
          static_cast<int>((static_cast<double>(voxels[voxel]) - volume.least) / width);
      histogram.counts[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))] += 1.0;
    }
  });
  return histogram;
}

Picture pictureOf(std::shared_ptr<const haptics::Volume> volume, const std::atomic<bool>* cancel) {
  const haptics::Grid& grid = volume->grid;
  Picture picture;
  picture.image = imageOf(*volume);
  picture.reduced = reducedImageOf(*volume, kReducedVoxels, cancel);
  picture.histogram = histogramOf(*volume, kHistogramBins);
  picture.X_WL_mm.linear() = grid.direction;
  picture.X_WL_mm.translation() = grid.origin * kMmPerM;
  picture.volume = std::move(volume);
  return picture;
}

vtkSmartPointer<vtkPolyData> isosurfaceMesh(vtkImageData* image, double isovalue, bool mirrored) {
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, isovalue);
  edges->ComputeNormalsOn();
  edges->ComputeScalarsOff();
  vtkAlgorithm* last = edges;
  vtkNew<vtkReverseSense> reverse;
  if (mirrored) {
    reverse->SetInputConnection(edges->GetOutputPort());
    reverse->ReverseCellsOn();
    reverse->ReverseNormalsOff();
    last = reverse;
  }
  last->Update();
  return vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
}

vtkSmartPointer<vtkMatrix4x4> matrixOf(const Eigen::Affine3d& X) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) matrix->SetElement(r, c, X(r, c));
  return matrix;
}

vtkSmartPointer<vtkMatrix4x4> matrixOf(const haptics::Pose& X) {
  Eigen::Affine3d X_mm{X};
  X_mm.translation() *= kMmPerM;
  return matrixOf(X_mm);
}

Eigen::AlignedBox3d boxOf_mm(const haptics::Grid& grid) { return boxOf_mm(grid, {{}, grid.dims}); }

Eigen::AlignedBox3d boxOf_mm(const haptics::Volume& volume) {
  return boxOf_mm(volume.grid, volume.bounds());
}

}  // namespace ui
