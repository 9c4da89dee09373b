// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/cut_tint.h"

#include <vtkAbstractVolumeMapper.h>
#include <vtkCommand.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>
#include <vtkVolumeInputHelper.h>
#include <vtkVolumeTexture.h>

#include <algorithm>

namespace ui {
namespace {

constexpr double kMost = 65'535.0;  // of a texel

}  // namespace

vtkStandardNewMacro(CutTint);

const char* const CutTint::kDeclared = R"(uniform sampler3D cutScan;
uniform vec3 cutFirst;
uniform vec3 cutScale;
uniform float cutAbove;
bool isCut(vec3 place)
{
  vec3 there = (place - cutFirst) * cutScale;
  vec3 edge = 0.5 / vec3(textureSize(cutScan, 0));
  return all(greaterThan(there, edge)) && all(lessThan(there, 1.0 - edge))
      && texture3D(cutScan, there).r > cutAbove;
}
)";

CutTint::CutTint() : texture_(vtkSmartPointer<vtkTextureObject>::New()) {}
CutTint::~CutTint() = default;

void CutTint::attachTo(vtkVolume& volume) {
  vtkNew<vtkInformation> keys;
  vtkOpenGLRenderPass::RenderPasses()->Append(keys, this);
  volume.SetPropertyKeys(keys);
  volume.GetMapper()->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, this, &CutTint::leave);
}

void CutTint::show(const haptics::Volume& scan, const haptics::VoxelBox& box) {
  least_ = scan.least;
  greatest_ = scan.greatest;
  const auto& dims = scan.grid.dims;
  for (std::size_t a = 0; a < 3; ++a) {
    size_[a] = static_cast<unsigned>(box.end[a] - box.first[a]);
    if (a == 0) size_[a] += size_[a] % 2;  // OpenGL's rows begin every four bytes
    first_[a] = static_cast<float>(static_cast<double>(box.first[a]) / double(dims[a]));
    scale_[a] = static_cast<float>(static_cast<double>(dims[a]) / size_[a]);
  }
  texels_.clear();
  texels_.reserve(std::size_t{size_[0]} * size_[1] * size_[2]);
  const double per_value = 1.0 / step();
  haptics::visitVoxels(scan.type, scan.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
        const auto* row = voxels + (k * dims[1] + j) * dims[0];
        for (unsigned n = 0; n < size_[0]; ++n) {
          const auto i = std::min(box.first[0] + std::int64_t{n}, dims[0] - 1);
          const double part = (static_cast<double>(row[i]) - least_) * per_value;
          texels_.push_back(static_cast<std::uint16_t>(std::clamp(part, 0.0, kMost) + 0.5));
        }
      }
  });
  is_new_ = true;
  on_ = true;
}

void CutTint::forget() {
  if (!on_) return;
  texels_ = std::vector<std::uint16_t>(1);  // its memory too
  size_ = {1, 1, 1};
  is_new_ = true;
  above_ = 2.0F;
  on_ = false;
}

double CutTint::step() const { return (greatest_ - least_) / kMost; }

void CutTint::setAbove(double value) {
  above_ = static_cast<float>((value - least_) / (greatest_ - least_));
}

bool CutTint::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp*,
                                  vtkOpenGLVertexArrayObject*) {
  auto* const caster = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper);
  if (caster == nullptr || !program->IsUniformUsed("cutScan")) return true;
  if (is_new_ || texture_->GetHandle() == 0) {
    // the volume's own texture knows the window
    texture_->SetContext(
        caster->AssembledInputs[0].Texture->GetCurrentBlock()->TextureObject->GetContext());
    texture_->Create3DFromRaw(size_[0], size_[1], size_[2], 1, VTK_UNSIGNED_SHORT, texels_.data());
    texture_->SetMagnificationFilter(vtkTextureObject::Linear);
    texture_->SetMinificationFilter(vtkTextureObject::Linear);
    is_new_ = false;
  }
  texture_->Activate();
  program->SetUniformi("cutScan", texture_->GetTextureUnit());
  program->SetUniform3f("cutFirst", first_.data());
  program->SetUniform3f("cutScale", scale_.data());
  program->SetUniformf("cutAbove", above_);
  return true;
}

void CutTint::leave() {
  if (texture_->GetHandle() != 0) texture_->Deactivate();
}

void CutTint::ReleaseGraphicsResources(vtkWindow* window) {
  texture_->ReleaseGraphicsResources(window);
}

}  // namespace ui
