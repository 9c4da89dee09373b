// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

class vtkOpenGLFramebufferObject;

namespace ui {

/// Draws a renderer once and keeps colour and depth, so that a tool can move in front of, behind
/// and inside a surface that is slow to draw. It draws again after forget() or a resize.
class HeldPass : public vtkRenderPass {
 public:
  static HeldPass* New();
  vtkTypeMacro(HeldPass, vtkRenderPass)

      void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void forget() { held_ = false; }

 protected:
  HeldPass();
  ~HeldPass() override;

 private:
  vtkSmartPointer<vtkRenderPass> drawing_;
  vtkSmartPointer<vtkOpenGLFramebufferObject> kept_;
  int width_ = 0, height_ = 0;
  bool held_ = false;
};

}  // namespace ui
