// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/held_pass.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

namespace ui {

vtkStandardNewMacro(HeldPass);

HeldPass::HeldPass() : drawing_(vtkSmartPointer<vtkRenderStepsPass>::New()) {}
HeldPass::~HeldPass() = default;

void HeldPass::Render(const vtkRenderState* state) {
  auto* window = static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  vtkOpenGLFramebufferObject* picture = window->GetRenderFramebuffer();
  const int w = window->GetSize()[0], h = window->GetSize()[1];

  if (kept_ == nullptr || w != width_ || h != height_) {
    // the format of the window's own framebuffer: depth is copied between equal formats only
    GLint depth_bits = 24;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                          GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &depth_bits);
    gl->PushFramebufferBindings();
    kept_ = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    kept_->SetContext(window);
    kept_->PopulateFramebuffer(w, h, true, 1, VTK_UNSIGNED_CHAR, true, depth_bits, 0,
                               window->GetStencilCapable() != 0);
    gl->PopFramebufferBindings();
    width_ = w;
    height_ = h;
    held_ = false;
  }

  const auto copy = [&](vtkOpenGLFramebufferObject* from, vtkOpenGLFramebufferObject* to) {
    gl->PushFramebufferBindings();
    from->Bind(GL_READ_FRAMEBUFFER);
    from->ActivateReadBuffer(0);
    to->Bind(GL_DRAW_FRAMEBUFFER);
    to->ActivateDrawBuffer(0);
    gl->vtkglDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    gl->PopFramebufferBindings();
  };

  if (held_) {
    copy(kept_, picture);
    return;
  }
  drawing_->Render(state);
  copy(picture, kept_);
  held_ = true;
}

void HeldPass::ReleaseGraphicsResources(vtkWindow* window) {
  drawing_->ReleaseGraphicsResources(window);
  if (kept_ != nullptr) kept_->ReleaseGraphicsResources(window);
  kept_ = nullptr;
  held_ = false;
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace ui
