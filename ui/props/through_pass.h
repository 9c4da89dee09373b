// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkTextureObject;

namespace ui {

/// Draws the outlines of what a renderer holds over the picture, with a breath of its colour
/// within, whatever lies before it. Small props lie over large ones. It neither reads nor writes
/// the picture's depth, is drawn once and kept, and again after forget() or a resize.
class ThroughPass : public vtkRenderPass {
 public:
  static ThroughPass* New();
  vtkTypeMacro(ThroughPass, vtkRenderPass)

      void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void forget() { held_ = false; }
  /// How wide the outlines are, in pixels of the picture.
  void setLine(int pixels) { line_ = pixels; }

 protected:
  ThroughPass();
  ~ThroughPass() override;

 private:
  vtkSmartPointer<vtkOpenGLFramebufferObject> canvas_;
  vtkSmartPointer<vtkTextureObject> colour_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
  int line_ = 2;
  int width_ = 0, height_ = 0;
  bool held_ = false;
};

}  // namespace ui
