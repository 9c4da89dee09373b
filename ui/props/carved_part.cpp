// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/carved_part.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeInputHelper.h>
#include <vtkVolumeTexture.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/props/cut_tint.h"
#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr std::int64_t kBrick = 32;   // voxels along a side
constexpr std::int64_t kOverlap = 3;  // voxels by which the mesh beside goes into bricks
constexpr double kCut = 0.03;         // of isovalue over background: deeper in the scan it was cut
constexpr double kRounding = 1e-4;    // voxels: of a corner's place

/// The field of the scan above which a place of the surface was cut.
double cutAbove(const haptics::Volume& scan, double isovalue) {
  return isovalue + kCut * std::abs(isovalue - scan.least);
}

std::array<unsigned char, 3> bytesOf(const Rgb& colour) {
  std::array<unsigned char, 3> bytes{};
  for (std::size_t n = 0; n < 3; ++n)
    bytes[n] = static_cast<unsigned char>(std::lround(255.0 * std::clamp(colour[n], 0.0, 1.0)));
  return bytes;
}

/// Calls `each` with the three corners of every triangle.
template <class Each>
void eachTriangle(vtkPolyData& mesh, const Each& each) {
  const auto iterator = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    iterator->GetCurrentCell(count, ids);
    each(ids);
  }
}

/// The voxels of a box with numbers of their own, and background where the volume ends, so that a
/// surface is closed there.
vtkSmartPointer<vtkImageData> closedImage(const haptics::Volume& volume,
                                          const haptics::VoxelBox& part) {
  const haptics::VoxelBox bounds = volume.bounds();
  const auto& dims = volume.grid.dims;
  std::array<std::int64_t, 3> low{}, high{};
  std::array<int, 3> size{};
  std::array<double, 3> origin_mm{}, spacing_mm{};
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = part.first[a] - (part.first[a] == bounds.first[a] ? 1 : 0);
    high[a] = part.end[a] + (part.end[a] == bounds.end[a] ? 1 : 0);
    size[a] = static_cast<int>(high[a] - low[a]);
    spacing_mm[a] = volume.grid.spacing[static_cast<Eigen::Index>(a)] * kMmPerM;
    origin_mm[a] = static_cast<double>(low[a]) * spacing_mm[a];
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetOrigin(origin_mm.data());
  image->SetSpacing(spacing_mm.data());
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(out, image->GetNumberOfPoints(), static_cast<float>(volume.least));
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t k = part.first[2]; k < part.end[2]; ++k)
      for (std::int64_t j = part.first[1]; j < part.end[1]; ++j) {
        const auto* row = voxels + (k * dims[1] + j) * dims[0];
        float* line = out + ((k - low[2]) * size[1] + (j - low[1])) * size[0] - low[0];
        for (std::int64_t i = part.first[0]; i < part.end[0]; ++i)
          line[i] = static_cast<float>(row[i]);
      }
  });
  return image;
}

}  // namespace

CarvedPart::CarvedPart()
    : actor_(vtkSmartPointer<vtkActor>::New()),
      mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()),
      tint_(vtkSmartPointer<CutTint>::New()) {
  actor_->SetMapper(mapper_);
  mapper_->SetColorModeToDirectScalars();
  end();
}

CarvedPart::~CarvedPart() = default;

void CarvedPart::begin(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan,
                       std::span<const haptics::VoxelBox> cut_before) {
  end();
  voxels_ = voxels;
  scan_ = std::move(scan);
  for (const haptics::VoxelBox& box : cut_before) touch(box);
}

void CarvedPart::end() {
  voxels_.reset();
  scan_.reset();
  bricks_.clear();
  waiting_.clear();
  tinted_box_ = {};
  contoured_.reset();
  tint_->forget();
  mesh_ = beside_ = nullptr;
  mapper_->SetInputData(vtkSmartPointer<vtkPolyData>::New());
}

void CarvedPart::add(const haptics::VoxelBox& box) {
  if (!voxels_ || haptics::isEmpty(box)) return;
  haptics::add(box, waiting_);
  touch(box);
}

std::pair<CarvedPart::BrickIndex, CarvedPart::BrickIndex> CarvedPart::range() const {
  const haptics::VoxelBox bounds = voxels_->bounds();
  std::pair<BrickIndex, BrickIndex> range;
  for (std::size_t a = 0; a < 3; ++a) {
    range.first[a] = bounds.first[a] / kBrick;
    // a brick has the cells between its voxels and the next
    range.second[a] = std::max(range.first[a], (bounds.end[a] - 2) / kBrick);
  }
  return range;
}

void CarvedPart::touch(const haptics::VoxelBox& box) {
  if (haptics::isEmpty(box)) return;
  const auto [least, most] = range();
  BrickIndex low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    // a voxel is a corner of two cells, and counts for the normals at the corners beside it
    low[a] = std::clamp((box.first[a] - 2 - kOverlap) / kBrick, least[a], most[a]);
    high[a] = std::clamp((box.end[a] + 1 + kOverlap) / kBrick, least[a], most[a]);
  }
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
      for (std::int64_t i = low[0]; i <= high[0]; ++i) bricks_[{i, j, k}].mesh = nullptr;
  stale_ = true;
}

vtkActor* CarvedPart::actor() const { return actor_; }

void CarvedPart::setTint(bool on) {
  tinted_ = on;
  contoured_.reset();
}

void CarvedPart::upload(vtkOpenGLGPUVolumeRayCastMapper& caster) {
  if (!voxels_ || waiting_.empty()) return;
  const auto input = caster.AssembledInputs.find(0);
  vtkVolumeTexture* textures =
      input == caster.AssembledInputs.end() ? nullptr : input->second.Texture.Get();
  vtkVolumeTexture::VolumeBlock* block =
      textures == nullptr ? nullptr : textures->GetCurrentBlock();
  // not drawn yet: the first drawing has all of it
  if (block == nullptr || block->TextureObject == nullptr) return;
  vtkTextureObject& texture = *block->TextureObject;
  const auto& dims = voxels_->grid.dims;
  const int type = vtkTypeOf(voxels_->type);
  texture.Activate();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(dims[0]));
  glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, static_cast<GLint>(dims[1]));
  for (const haptics::VoxelBox& box : waiting_) {
    std::array<GLint, 3> first{};
    std::array<GLsizei, 3> size{};
    for (std::size_t a = 0; a < 3; ++a) {
      first[a] = static_cast<GLint>(box.first[a]);
      size[a] = static_cast<GLsizei>(box.end[a] - box.first[a]);
    }
    const std::int64_t at = (box.first[2] * dims[1] + box.first[1]) * dims[0] + box.first[0];
    const auto* voxels = static_cast<const std::byte*>(voxels_->voxels.get()) +
                         at * static_cast<std::int64_t>(haptics::sizeOf(voxels_->type));
    glTexSubImage3D(GL_TEXTURE_3D, 0, first[0], first[1], first[2], size[0], size[1], size[2],
                    texture.GetFormat(type, 1, false),
                    static_cast<GLenum>(texture.GetDataType(type)), voxels);
  }
  glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  texture.Deactivate();
  waiting_.clear();
}

void CarvedPart::tint(vtkVolume& volume) { tint_->attachTo(volume); }

void CarvedPart::tintFor(double isovalue) {
  // two bytes a voxel: beyond it, the colour is not worth the memory
  constexpr std::int64_t kMostVoxels = std::int64_t{1} << 27;
  if (!tinted_ || !scan_ || isEmpty() || !(scan_->least < scan_->greatest)) return tint_->forget();
  haptics::VoxelBox box;
  for (const auto& [index, brick] : bricks_) {
    haptics::VoxelBox one;
    for (std::size_t a = 0; a < 3; ++a) {
      one.first[a] = index[a] * kBrick;
      one.end[a] = std::min(scan_->grid.dims[a], (index[a] + 1) * kBrick + 1);
    }
    box = haptics::joined(box, one);
  }
  if (haptics::voxelsIn(box) > kMostVoxels) return tint_->forget();
  if (box != tinted_box_ || !tint_->isOn()) tint_->show(*scan_, box);
  tinted_box_ = box;
  // of a scan with a few values that are far off, less than a step is no difference
  tint_->setAbove(std::max(cutAbove(*scan_, isovalue), isovalue + 2.0 * tint_->step()));
}

vtkSmartPointer<vtkPolyData> CarvedPart::meshOf(const BrickIndex& brick, double isovalue,
                                                bool mirrored, const Rgb& colour) const {
  const haptics::VoxelBox bounds = voxels_->bounds();
  const auto [least, most] = range();
  haptics::VoxelBox part;  // with what the normals need
  std::array<double, 3> low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    const bool first = brick[a] == least[a], last = brick[a] == most[a];
    const std::int64_t begin = brick[a] * kBrick, end = begin + kBrick;
    part.first[a] = first ? bounds.first[a] : begin - 1;
    part.end[a] = last ? bounds.end[a] : std::min(bounds.end[a], end + 2);
    // where the volume ends its surface is closed beyond
    low[a] = first ? -HUGE_VAL : static_cast<double>(begin);
    high[a] = last ? HUGE_VAL : static_cast<double>(end);
  }
  const auto whole = isosurfaceMesh(closedImage(*voxels_, part), isovalue, mirrored);
  const Eigen::Vector3d spacing_mm = voxels_->grid.spacing * kMmPerM;
  const haptics::Volume* const scan = tinted_ ? scan_.get() : nullptr;
  const double above = scan != nullptr ? cutAbove(*scan, isovalue) : 0.0;
  Eigen::AlignedBox3d inside;
  for (int a = 0; a < 3; ++a) {
    const auto of = static_cast<std::size_t>(a);
    inside.min()[a] = static_cast<double>(bounds.first[of]);
    inside.max()[a] = static_cast<double>(bounds.end[of] - 1);
  }
  const auto plain = bytesOf(colour), cut = bytesOf(style::kCutFace);
  vtkDataArray* const normals_there = whole->GetPointData()->GetNormals();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkCellArray> triangles;
  normals->SetNumberOfComponents(3);
  colours->SetNumberOfComponents(3);
  std::vector<vtkIdType> renumbered(static_cast<std::size_t>(whole->GetNumberOfPoints()), -1);
  const auto indexOf = [&](vtkIdType id) {
    return Eigen::Vector3d{whole->GetPoint(id)}.cwiseQuotient(spacing_mm).eval();
  };
  eachTriangle(*whole, [&](const vtkIdType* ids) {
    const Eigen::Vector3d middle = (indexOf(ids[0]) + indexOf(ids[1]) + indexOf(ids[2])) / 3.0;
    for (int a = 0; a < 3; ++a) {
      const double at = middle[a] + kRounding;
      if (at < low[static_cast<std::size_t>(a)] || at >= high[static_cast<std::size_t>(a)]) return;
    }
    std::array<vtkIdType, 3> corners{};
    for (std::size_t n = 0; n < 3; ++n) {
      vtkIdType& id = renumbered[static_cast<std::size_t>(ids[n])];
      if (id < 0) {
        id = points->InsertNextPoint(whole->GetPoint(ids[n]));
        normals->InsertNextTuple(normals_there->GetTuple(ids[n]));
        const Eigen::Vector3d at = indexOf(ids[n]);
        // a face where the volume ends was not cut
        const bool deep = scan != nullptr && inside.contains(at) && fieldAt(*scan, at) > above;
        colours->InsertNextTypedTuple(deep ? cut.data() : plain.data());
      }
      corners[n] = id;
    }
    triangles->InsertNextCell(3, corners.data());
  });
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetScalars(colours);
  return mesh;
}

void CarvedPart::contour(double isovalue, bool mirrored, const Rgb& colour) {
  const Contoured wanted{isovalue, colour};
  if (isEmpty() || (contoured_ == wanted && !stale_)) return;
  vtkNew<vtkAppendPolyData> all;
  for (auto& [index, brick] : bricks_) {
    if (brick.mesh == nullptr || contoured_ != wanted)
      brick.mesh = meshOf(index, isovalue, mirrored, colour);
    all->AddInputData(brick.mesh);
  }
  all->Update();
  mapper_->SetInputData(all->GetOutput());
  contoured_ = wanted;
  stale_ = false;
}

vtkPolyData* CarvedPart::beside(vtkPolyData* mesh) {
  if (isEmpty() || mesh == nullptr) return mesh;
  if (mesh == mesh_ && beside_of_ == bricks_.size()) return beside_;
  const auto bricks = range();
  const BrickIndex &least = bricks.first, &most = bricks.second;
  BrickIndex count{};
  for (std::size_t a = 0; a < 3; ++a) count[a] = most[a] - least[a] + 1;
  const auto placeOf = [&](const BrickIndex& brick) {
    return static_cast<std::size_t>(
        ((brick[2] - least[2]) * count[1] + brick[1] - least[1]) * count[0] + brick[0] - least[0]);
  };
  std::vector<std::uint8_t> carved(static_cast<std::size_t>(count[0] * count[1] * count[2]));
  for (const auto& [index, brick] : bricks_) carved[placeOf(index)] = 1;
  const Eigen::Vector3d brick_mm = voxels_->grid.spacing * (kMmPerM * static_cast<double>(kBrick));
  // where the volume ends its surface is closed beyond
  const auto brickAt = [&](const Eigen::Vector3d& place) {
    BrickIndex brick{};
    for (std::size_t a = 0; a < 3; ++a)
      brick[a] =
          std::clamp(static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(a)])),
                     least[a], most[a]);
    return brick;
  };
  // a reduced mesh is not quite where the bricks' is: beside them the two overlap
  constexpr double kRim = static_cast<double>(kOverlap) / kBrick;
  std::vector<std::uint8_t> in(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 1);
  for (std::size_t n = 0; n < in.size(); ++n) {
    const Eigen::Vector3d at =
        Eigen::Vector3d{mesh->GetPoint(static_cast<vtkIdType>(n))}.cwiseQuotient(brick_mm);
    const BrickIndex low = brickAt(at.array() - kRim), high = brickAt(at.array() + kRim);
    for (std::int64_t k = low[2]; k <= high[2]; ++k)
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
        for (std::int64_t i = low[0]; i <= high[0]; ++i) in[n] &= carved[placeOf({i, j, k})];
  }
  vtkNew<vtkCellArray> kept;
  kept->AllocateEstimate(mesh->GetNumberOfPolys(), 3);
  eachTriangle(*mesh, [&](const vtkIdType* ids) {
    const auto isIn = [&](vtkIdType id) { return in[static_cast<std::size_t>(id)] != 0; };
    if (!isIn(ids[0]) || !isIn(ids[1]) || !isIn(ids[2])) kept->InsertNextCell(3, ids);
  });
  beside_ = vtkSmartPointer<vtkPolyData>::New();
  beside_->SetPoints(mesh->GetPoints());
  beside_->SetPolys(kept);
  beside_->GetPointData()->ShallowCopy(mesh->GetPointData());
  mesh_ = mesh;
  beside_of_ = bricks_.size();
  return beside_;
}

}  // namespace ui
