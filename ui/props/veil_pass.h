// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkTextureObject;

namespace ui {

/// Draws what a renderer holds as a veil over the picture: of each line of sight only its nearest
/// surface, half transparent, and hidden by what the picture has in front of it. Nothing has to be
/// sorted. The veil is drawn once and kept, so that a tool can move before and behind it; it is
/// drawn again after forget() or a resize. Its renderer must preserve the depth of the picture.
class VeilPass : public vtkRenderPass {
 public:
  static VeilPass* New();
  vtkTypeMacro(VeilPass, vtkRenderPass)

      void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void forget() { held_ = false; }
  void setOpacity(double opacity) { opacity_ = opacity; }
  double opacity() const { return opacity_; }

 protected:
  VeilPass();
  ~VeilPass() override;

 private:
  vtkSmartPointer<vtkRenderPass> drawing_;
  vtkSmartPointer<vtkOpenGLFramebufferObject> canvas_;
  vtkSmartPointer<vtkTextureObject> colour_, depth_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
  double opacity_ = 0.4;
  int width_ = 0, height_ = 0;
  bool held_ = false;
};

}  // namespace ui
