// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/picture.h"

#include <vtkBinnedDecimation.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
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
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace ui {
namespace {

constexpr std::int64_t kReducedVoxels = 1'500'000;  // about 100,000 triangles
constexpr std::int64_t kHistogramVoxels = 4'000'000;
constexpr int kHistogramBins = 256;
constexpr double kPerBin = 2.6;  // triangles for a bin's face of surface, in a binned mesh

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

/// The cubes that a reduced image averages, within a volume's bounds.
struct Reduction {
  std::array<std::int64_t, 3> first{};   ///< voxel where the cubes begin
  std::array<std::int64_t, 3> blocks{};  ///< cubes along i, j, k
  std::int64_t factor = 1;               ///< voxels along a cube
};

Reduction reductionOf(const haptics::VoxelBox& box, std::int64_t most_voxels) {
  std::array<std::int64_t, 3> size{};
  for (std::size_t a = 0; a < 3; ++a) size[a] = box.end[a] - box.first[a];
  const std::int64_t thinnest = *std::min_element(size.begin(), size.end());
  const auto count = static_cast<double>(size[0] * size[1] * size[2]);
  const auto factor = static_cast<std::int64_t>(
      std::ceil(std::cbrt(count / static_cast<double>(most_voxels)) - 1e-9));
  Reduction cubes{.first = box.first, .factor = std::clamp<std::int64_t>(factor, 1, thinnest)};
  for (std::size_t a = 0; a < 3; ++a) cubes.blocks[a] = size[a] / cubes.factor;
  return cubes;
}

/// A box of cubes, [first, end), that holds all those with a voxel of `voxels` in them.
haptics::VoxelBox cubesOver(const haptics::VoxelBox& voxels, const Reduction& cubes) {
  haptics::VoxelBox over;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t from = std::max<std::int64_t>(0, voxels.first[a] - cubes.first[a]);
    const std::int64_t to = std::max<std::int64_t>(0, voxels.end[a] - cubes.first[a]);
    over.first[a] = std::min(from / cubes.factor, cubes.blocks[a]);
    over.end[a] = std::min((to + cubes.factor - 1) / cubes.factor, cubes.blocks[a]);
  }
  return over;
}

/// Writes the averages of these cubes into an image that has a rim of one block.
template <class T>
void averageBlocks(const T* all, const std::array<std::int64_t, 3>& dims, const Reduction& cubes,
                   const haptics::VoxelBox& wanted, float* out, const std::atomic<bool>* cancel) {
  // whole numbers of up to 16 bits are added without a conversion to double: exact, and quick
  using Sum = std::conditional_t<std::is_integral_v<T> && sizeof(T) <= 2, std::int32_t, double>;
  const std::int64_t factor = cubes.factor;
  const std::int64_t row = cubes.blocks[0] + 2;
  const std::int64_t slab = row * (cubes.blocks[1] + 2);
  const double share = 1.0 / static_cast<double>(factor * factor * factor);
  const std::int64_t begin = cubes.first[0] + wanted.first[0] * factor;
  const std::int64_t length = std::max<std::int64_t>(0, wanted.end[0] - wanted.first[0]) * factor;
  std::vector<Sum> sums(static_cast<std::size_t>(length));
  for (std::int64_t K = wanted.first[2]; K < wanted.end[2]; ++K)
    for (std::int64_t J = wanted.first[1]; J < wanted.end[1]; ++J) {
      if (cancel != nullptr && *cancel) return;
      // the rows of a line of cubes first, as one row
      std::fill(sums.begin(), sums.end(), Sum{});
      for (std::int64_t k = 0; k < factor; ++k)
        for (std::int64_t j = 0; j < factor; ++j) {
          const T* v =
              all + begin +
              ((cubes.first[2] + K * factor + k) * dims[1] + cubes.first[1] + J * factor + j) *
                  dims[0];
          for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += static_cast<Sum>(v[i]);
        }
      float* line = out + (K + 1) * slab + (J + 1) * row + 1;
      const Sum* at = sums.data();
      for (std::int64_t I = wanted.first[0]; I < wanted.end[0]; ++I) {
        double sum = 0.0;
        for (std::int64_t i = 0; i < factor; ++i) sum += static_cast<double>(*at++);
        line[I] = static_cast<float>(sum * share);
      }
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

/// The triangles of a mesh with their places.
class Corners {
 public:
  explicit Corners(vtkPolyData* mesh) : mesh_(mesh) {}
  /// Calls f(p, q, r, ids) for each.
  template <class F>
  void each(F&& f) const {
    const auto iterator = vtk::TakeSmartPointer(mesh_->GetPolys()->NewIterator());
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
      iterator->GetCurrentCell(count, ids);
      if (count == 3) f(at(ids[0]), at(ids[1]), at(ids[2]), ids);
    }
  }

 private:
  Eigen::Vector3d at(vtkIdType n) const {
    Eigen::Vector3d p;
    mesh_->GetPoint(n, p.data());
    return p;
  }
  vtkPolyData* mesh_;
};

/// The sides of a thin wall that fell into one place have normals that cancel each other out: there
/// the wall's own takes their place, towards either side.
void unfoldNormals(vtkPolyData* mesh) {
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (normals == nullptr) return;
  constexpr double kCancelled = 0.5;  // length of a mean of unit vectors
  std::vector<Eigen::Vector3d> own(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  std::vector<bool> folded(own.size());
  for (std::size_t n = 0; n < own.size(); ++n) {
    own[n].setZero();
    folded[n] = Eigen::Vector3d{normals->GetTuple3(static_cast<vtkIdType>(n))}.norm() < kCancelled;
  }
  Corners(mesh).each([&](const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                         const Eigen::Vector3d& r, const vtkIdType* ids) {
    const Eigen::Vector3d normal = (q - p).cross(r - p);
    for (int c = 0; c < 3; ++c) {
      const auto n = static_cast<std::size_t>(ids[c]);
      if (folded[n]) own[n] += own[n].dot(normal) < 0.0 ? Eigen::Vector3d{-normal} : normal;
    }
  });
  for (std::size_t n = 0; n < own.size(); ++n)
    if (folded[n] && own[n].norm() > 0.0)
      normals->SetTuple(static_cast<vtkIdType>(n), own[n].normalized().eval().data());
}

/// Of the voxels of the body those that hang together, as far as the reduced image shows it,
/// without table and holder. The volume where nothing tells the body from what is around it.
Eigen::AlignedBox3d bodyOf_mm(const haptics::Volume& volume, vtkImageData& reduced) {
  const Eigen::AlignedBox3d all = boxOf_mm(volume.grid, volume.bounds());
  if (volume.unit != "HU") return all;
  const int* dims = reduced.GetDimensions();
  const std::array<std::int64_t, 3> step{1, dims[0], std::int64_t{dims[0]} * dims[1]};
  const auto* values = static_cast<const float*>(reduced.GetScalarPointer());
  const auto count = static_cast<std::size_t>(reduced.GetNumberOfPoints());
  std::vector<std::uint8_t> waits(count);
  const auto least = static_cast<float>(bodyFrom(volume));
  // the rim is background, even if its value is none: no neighbour lies outside the image
  for (std::int64_t k = 1; k + 1 < dims[2]; ++k)
    for (std::int64_t j = 1; j + 1 < dims[1]; ++j)
      for (std::int64_t i = 1; i + 1 < dims[0]; ++i) {
        const auto n = static_cast<std::size_t>(i + j * step[1] + k * step[2]);
        waits[n] = values[n] >= least;
      }
  std::vector<std::int64_t> heap;
  std::size_t most = 0;
  Eigen::AlignedBox3i body;
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (waits[seed] == 0) continue;
    waits[seed] = 0;
    heap.assign(1, static_cast<std::int64_t>(seed));
    Eigen::AlignedBox3i box;
    for (std::size_t n = 0; n < heap.size(); ++n) {
      const std::int64_t i = heap[n];
      box.extend(Eigen::Vector3i{static_cast<int>(i % dims[0]),
                                 static_cast<int>(i / step[1] % dims[1]),
                                 static_cast<int>(i / step[2])});
      for (const std::int64_t by : step)
        for (const std::int64_t next : {i - by, i + by}) {
          std::uint8_t& there = waits[static_cast<std::size_t>(next)];
          if (there == 0) continue;
          there = 0;
          heap.push_back(next);
        }
    }
    if (heap.size() <= most) continue;
    most = heap.size();
    body = box;
  }
  if (most == 0) return all;
  const Eigen::Vector3d origin{reduced.GetOrigin()}, spacing{reduced.GetSpacing()};
  const haptics::Grid& grid = volume.grid;
  Eigen::AlignedBox3d found;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d p;
    for (int a = 0; a < 3; ++a)
      p[a] = origin[a] +
             spacing[a] * ((corner >> a & 1) != 0 ? body.max()[a] + 0.5 : body.min()[a] - 0.5);
    found.extend(Eigen::Vector3d{grid.direction * p + grid.origin * kMmPerM});
  }
  return found.intersection(all);
}

Picture pictureWith(std::shared_ptr<const haptics::Volume> volume,
                    vtkSmartPointer<vtkImageData> reduced) {
  const haptics::Grid& grid = volume->grid;
  Picture picture;
  picture.image = imageOf(*volume);
  picture.reduced = std::move(reduced);
  picture.histogram = histogramOf(*volume, kHistogramBins);
  picture.X_WL_mm.linear() = grid.direction;
  picture.X_WL_mm.translation() = grid.origin * kMmPerM;
  picture.body_mm = bodyOf_mm(*volume, *picture.reduced);
  picture.volume = std::move(volume);
  return picture;
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
  const Reduction cubes = reductionOf(volume.bounds(), most_voxels);
  std::array<int, 3> size{};
  double origin_mm[3], spacing_mm[3];
  for (std::size_t a = 0; a < 3; ++a) {
    const double voxel_mm = grid.spacing[static_cast<Eigen::Index>(a)] * kMmPerM;
    size[a] = static_cast<int>(cubes.blocks[a] + 2);
    spacing_mm[a] = voxel_mm * static_cast<double>(cubes.factor);
    // a block's centre, and one block further out for the rim
    origin_mm[a] =
        (static_cast<double>(cubes.first[a]) + 0.5 * static_cast<double>(cubes.factor - 1)) *
            voxel_mm -
        spacing_mm[a];
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetOrigin(origin_mm);
  image->SetSpacing(spacing_mm);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(out, image->GetNumberOfPoints(), static_cast<float>(volume.least));
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    averageBlocks(voxels, grid.dims, cubes, {{}, cubes.blocks}, out, cancel);
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
  const std::int64_t lines = rows * (box.end[2] - box.first[2]);
  // whole rows, which lie in memory as they are read; an odd stride does not fall in step with rows
  const std::int64_t step = (row * lines / kHistogramVoxels) | 1;
  const auto binOf = [&](double value) {
    const auto bin = static_cast<int>((value - volume.least) / width);
    return static_cast<std::size_t>(std::clamp(bin, 0, bins - 1));
  };
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    using T = std::remove_cvref_t<decltype(*voxels)>;
    const auto eachRow = [&](auto&& take) {
      for (std::int64_t line = 0; line < lines; line += step) {
        const std::int64_t j = box.first[1] + line % rows, k = box.first[2] + line / rows;
        const T* first = voxels + (k * dims[1] + j) * dims[0] + box.first[0];
        std::for_each(first, first + row, take);
      }
    };
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
      // a count for each value there is, so that a bin is found once a value
      constexpr int kLeast = std::numeric_limits<T>::lowest();
      std::vector<std::uint32_t> of_value(std::size_t{1} << (8 * sizeof(T)));
      eachRow([&](T value) { ++of_value[static_cast<std::size_t>(value - kLeast)]; });
      for (std::size_t n = 0; n < of_value.size(); ++n)
        if (of_value[n] != 0)
          histogram.counts[binOf(static_cast<int>(n) + kLeast)] += static_cast<double>(of_value[n]);
    } else {
      eachRow([&](T value) { histogram.counts[binOf(static_cast<double>(value))] += 1.0; });
    }
  });
  return histogram;
}

Picture pictureOf(std::shared_ptr<const haptics::Volume> volume, const std::atomic<bool>* cancel) {
  auto reduced = reducedImageOf(*volume, kReducedVoxels, cancel);
  return pictureWith(std::move(volume), std::move(reduced));
}

Picture pictureOf(std::shared_ptr<const haptics::Volume> volume, const Picture& before,
                  std::span<const haptics::VoxelBox> changed) {
  if (volume->bounds() != before.volume->bounds()) return pictureOf(std::move(volume));
  const Reduction cubes = reductionOf(volume->bounds(), kReducedVoxels);
  auto reduced = vtkSmartPointer<vtkImageData>::New();
  reduced->DeepCopy(before.reduced);
  auto* out = static_cast<float*>(reduced->GetScalarPointer());
  haptics::visitVoxels(volume->type, volume->voxels.get(), [&](const auto* voxels) {
    for (const haptics::VoxelBox& box : changed)
      averageBlocks(voxels, volume->grid.dims, cubes, cubesOver(box, cubes), out, nullptr);
  });
  return pictureWith(std::move(volume), std::move(reduced));
}

double fieldAt(const haptics::Volume& volume, const Eigen::Vector3d& index) {
  const haptics::VoxelBox box = volume.bounds();
  const auto& dims = volume.grid.dims;
  std::array<std::int64_t, 3> low{}, high{};
  Eigen::Vector3d part;
  for (int a = 0; a < 3; ++a) {
    const auto of = static_cast<std::size_t>(a);
    const double at = std::clamp(index[a], static_cast<double>(box.first[of]),
                                 static_cast<double>(box.end[of] - 1));
    low[of] = static_cast<std::int64_t>(std::floor(at));
    high[of] = std::min(low[of] + 1, box.end[of] - 1);
    part[a] = at - static_cast<double>(low[of]);
  }
  return haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1.0;
      std::array<std::int64_t, 3> at{};
      for (int a = 0; a < 3; ++a) {
        const auto of = static_cast<std::size_t>(a);
        const bool upper = (corner >> a & 1) != 0;
        at[of] = upper ? high[of] : low[of];
        weight *= upper ? part[a] : 1.0 - part[a];
      }
      if (weight > 0.0)
        sum += weight * static_cast<double>(voxels[(at[2] * dims[1] + at[1]) * dims[0] + at[0]]);
    }
    return sum;
  });
}

int vtkTypeOf(haptics::ScalarType type) { return emptyArray(type)->GetDataType(); }

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

vtkSmartPointer<vtkPolyData> lightMesh(vtkPolyData* mesh, std::int64_t most_triangles) {
  const std::int64_t triangles = mesh->GetNumberOfPolys();
  if (triangles <= most_triangles) return mesh;
  const double* b = mesh->GetBounds();
  const Eigen::Vector3d sizes{b[1] - b[0], b[3] - b[2], b[5] - b[4]};
  // a surface crosses bins in proportion to their inverse area, and has about kPerBin triangles in
  // each: as many as it has for each square of the mean length of its edges
  double area = 0.0;
  Corners corners(mesh);
  corners.each([&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                   const vtkIdType*) { area += 0.5 * (q - p).cross(r - p).norm(); });
  const double bin = std::sqrt(area * kPerBin / static_cast<double>(most_triangles));
  vtkNew<vtkBinnedDecimation> bins;
  bins->SetInputData(mesh);
  bins->AutoAdjustNumberOfDivisionsOff();
  const auto divisions = [&](int axis) {
    return std::max(1, static_cast<int>(std::ceil(sizes[axis] / bin)));
  };
  bins->SetNumberOfDivisions(divisions(0), divisions(1), divisions(2));
  bins->SetPointGenerationModeToBinAverages();
  bins->ProducePointDataOn();
  bins->Update();
  vtkSmartPointer<vtkPolyData> light = bins->GetOutput();
  unfoldNormals(light);
  return light;
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

double bodyFrom(const haptics::Volume& volume) {
  constexpr double kBody_HU = -400.0;    // between air and fat
  constexpr double kBodyOfRange = 0.15;  // above the least voxel, where the unit is another
  if (volume.unit == "HU") return kBody_HU;
  return volume.least + kBodyOfRange * (volume.greatest - volume.least);
}

Eigen::AlignedBox3d boxOf_mm(const haptics::Grid& grid) { return boxOf_mm(grid, {{}, grid.dims}); }

Eigen::AlignedBox3d boxOf_mm(const haptics::Volume& volume) {
  return boxOf_mm(volume.grid, volume.bounds());
}

}  // namespace ui
