// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/volume.h"

class vtkTextureObject;
class vtkVolume;

namespace ui {

/// Gives the ray-cast surface of a volume another colour where the scan was solid before it was
/// cut: it brings the scan's voxels of a box to the shader, two bytes each. The texture is made
/// when the volume is drawn next. GUI thread.
class CutTint : public vtkOpenGLRenderPass {
 public:
  static CutTint* New();
  vtkTypeMacro(CutTint, vtkOpenGLRenderPass)

      /// What the shader declares: bool isCut(vec3), of a texture coordinate of the volume.
      static const char* const kDeclared;

  /// Colours this volume, which has its mapper.
  void attachTo(vtkVolume& volume);
  /// `scan` has more than one value.
  void show(const haptics::Volume& scan, const haptics::VoxelBox& box);
  /// Nothing was cut.
  void forget();
  bool isOn() const { return on_; }
  /// The smallest difference of the scan's values that is told.
  double step() const;
  /// Where the scan's field is above this value, the surface was cut.
  void setAbove(double value);

  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
                           vtkOpenGLVertexArrayObject* VAO) override;
  void Render(const vtkRenderState*) override {}
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  CutTint();
  ~CutTint() override;

 private:
  /// The volume was drawn: gives the texture unit back.
  void leave();

  std::vector<std::uint16_t> texels_ = {0};  ///< of the box
  std::array<unsigned, 3> size_{1, 1, 1};
  std::array<float, 3> first_{}, scale_{1.0F, 1.0F, 1.0F};
  double least_ = 0.0, greatest_ = 1.0;
  float above_ = 2.0F;  ///< of the texture's 0 to 1
  bool on_ = false;
  bool is_new_ = true;  ///< the texture has others
  vtkSmartPointer<vtkTextureObject> texture_;
};

}  // namespace ui
