// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/carved_part.h"

#include <vtkActor.h>
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
#include <utility>
#include <vector>

#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr std::int64_t kRoom = 2;    // voxels around what was cut
constexpr std::int64_t kGrain = 16;  // voxels by which a part grows
constexpr double kCut = 0.03;        // of isovalue over background: deeper in the scan it was cut

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

/// Gives each corner of a mesh the colour of the surface, or that of what was cut.
void tint(vtkPolyData& mesh, const haptics::Volume* scan, double isovalue, const Rgb& colour) {
  const auto bytesOf = [](const Rgb& of) {
    std::array<unsigned char, 3> bytes{};
    for (std::size_t n = 0; n < 3; ++n)
      bytes[n] = static_cast<unsigned char>(std::lround(255.0 * std::clamp(of[n], 0.0, 1.0)));
    return bytes;
  };
  const auto whole = bytesOf(colour), cut = bytesOf(style::kCutFace);
  const vtkIdType count = mesh.GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(count);
  for (vtkIdType n = 0; n < count; ++n) {
    const Eigen::Vector3d p_mm{mesh.GetPoint(n)};
    const bool deep =
        scan != nullptr && fieldAt(*scan, p_mm.cwiseQuotient(scan->grid.spacing * kMmPerM)) >
                               isovalue + kCut * std::abs(isovalue - scan->least);
    colours->SetTypedTuple(n, deep ? cut.data() : whole.data());
  }
  mesh.GetPointData()->SetScalars(colours);
}

/// A mesh without the triangles all of whose corners lie in a box of L.
vtkSmartPointer<vtkPolyData> outside(vtkPolyData& mesh, const Eigen::AlignedBox3f& box_mm) {
  const auto count = static_cast<std::size_t>(mesh.GetNumberOfPoints());
  std::vector<std::uint8_t> in(count);
  for (std::size_t n = 0; n < count; ++n) {
    double p[3];
    mesh.GetPoint(static_cast<vtkIdType>(n), p);
    in[n] = box_mm.contains(Eigen::Vector3d{p}.cast<float>());
  }
  vtkNew<vtkCellArray> kept;
  kept->AllocateEstimate(mesh.GetNumberOfPolys(), 3);
  const auto iterator = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
  vtkIdType corners = 0;
  const vtkIdType* ids = nullptr;
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    iterator->GetCurrentCell(corners, ids);
    bool within = true;
    for (vtkIdType c = 0; c < corners; ++c) within = within && in[static_cast<std::size_t>(ids[c])];
    if (!within) kept->InsertNextCell(corners, ids);
  }
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->SetPoints(mesh.GetPoints());
  rest->SetPolys(kept);
  rest->GetPointData()->ShallowCopy(mesh.GetPointData());
  return rest;
}

}  // namespace

CarvedPart::CarvedPart()
    : actor_(vtkSmartPointer<vtkActor>::New()), mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()) {
  actor_->SetMapper(mapper_);
  mapper_->SetColorModeToDirectScalars();
  end();
}

CarvedPart::~CarvedPart() = default;

void CarvedPart::begin(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan) {
  end();
  voxels_ = voxels;
  scan_ = std::move(scan);
}

void CarvedPart::end() {
  voxels_.reset();
  scan_.reset();
  carved_ = waiting_ = beside_of_ = {};
  contoured_.reset();
  mesh_ = beside_ = nullptr;
  mapper_->SetInputData(vtkSmartPointer<vtkPolyData>::New());
}

void CarvedPart::add(const haptics::VoxelBox& box) {
  if (!voxels_ || haptics::isEmpty(box)) return;
  carved_ = haptics::joined(carved_, box);
  waiting_ = haptics::joined(waiting_, box);
  contoured_.reset();
}

vtkActor* CarvedPart::actor() const { return actor_; }

bool CarvedPart::isEmpty() const { return haptics::isEmpty(carved_); }

void CarvedPart::setTint(bool on) {
  tinted_ = on;
  contoured_.reset();
}

haptics::VoxelBox CarvedPart::part() const {
  const haptics::VoxelBox bounds = voxels_->bounds();
  haptics::VoxelBox part;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t first = std::max<std::int64_t>(0, carved_.first[a] - kRoom);
    part.first[a] = std::max(bounds.first[a], first / kGrain * kGrain);
    const std::int64_t end = carved_.end[a] + kRoom;
    part.end[a] = std::min(bounds.end[a], (end + kGrain - 1) / kGrain * kGrain + 1);
  }
  return part;
}

void CarvedPart::upload(vtkOpenGLGPUVolumeRayCastMapper& caster) {
  if (!voxels_ || haptics::isEmpty(waiting_)) return;
  const auto input = caster.AssembledInputs.find(0);
  vtkVolumeTexture* textures =
      input == caster.AssembledInputs.end() ? nullptr : input->second.Texture.Get();
  vtkVolumeTexture::VolumeBlock* block =
      textures == nullptr ? nullptr : textures->GetCurrentBlock();
  // not drawn yet: the first drawing has all of it
  if (block == nullptr || block->TextureObject == nullptr) return;
  vtkTextureObject& texture = *block->TextureObject;
  const auto& dims = voxels_->grid.dims;
  std::array<GLint, 3> first{};
  std::array<GLsizei, 3> size{};
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = static_cast<GLint>(waiting_.first[a]);
    size[a] = static_cast<GLsizei>(waiting_.end[a] - waiting_.first[a]);
  }
  const int type = vtkTypeOf(voxels_->type);
  const std::int64_t at =
      (waiting_.first[2] * dims[1] + waiting_.first[1]) * dims[0] + waiting_.first[0];
  const auto* voxels = static_cast<const std::byte*>(voxels_->voxels.get()) +
                       at * static_cast<std::int64_t>(haptics::sizeOf(voxels_->type));
  texture.Activate();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(dims[0]));
  glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, static_cast<GLint>(dims[1]));
  glTexSubImage3D(GL_TEXTURE_3D, 0, first[0], first[1], first[2], size[0], size[1], size[2],
                  texture.GetFormat(type, 1, false), static_cast<GLenum>(texture.GetDataType(type)),
                  voxels);
  glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  texture.Deactivate();
  waiting_ = {};
}

void CarvedPart::contour(double isovalue, bool mirrored, const Rgb& colour) {
  const Contoured wanted{isovalue, colour};
  if (isEmpty() || contoured_ == wanted) return;
  contoured_ = wanted;
  const auto mesh = isosurfaceMesh(closedImage(*voxels_, part()), isovalue, mirrored);
  tint(*mesh, tinted_ ? scan_.get() : nullptr, isovalue, colour);
  mapper_->SetInputData(mesh);
}

vtkPolyData* CarvedPart::beside(vtkPolyData* mesh) {
  if (isEmpty() || mesh == nullptr) return mesh;
  const haptics::VoxelBox leaves = part();
  if (mesh == mesh_ && leaves == beside_of_) return beside_;
  const haptics::VoxelBox bounds = voxels_->bounds();
  Eigen::AlignedBox3f box_mm;
  for (int corner = 0; corner < 2; ++corner) {
    Eigen::Vector3f p;
    for (std::size_t a = 0; a < 3; ++a) {
      // where the volume ends its surface is closed half a voxel, or a cube of voxels, beyond
      const std::int64_t low =
          leaves.first[a] == bounds.first[a] ? bounds.first[a] - kGrain : leaves.first[a];
      const std::int64_t high =
          leaves.end[a] == bounds.end[a] ? bounds.end[a] + kGrain : leaves.end[a] - 1;
      const double spacing_mm = voxels_->grid.spacing[static_cast<Eigen::Index>(a)] * kMmPerM;
      p[static_cast<Eigen::Index>(a)] =
          static_cast<float>(static_cast<double>(corner == 0 ? low : high) * spacing_mm);
    }
    box_mm.extend(p);
  }
  mesh_ = mesh;
  beside_of_ = leaves;
  beside_ = outside(*mesh, box_mm);
  return beside_;
}

}  // namespace ui
