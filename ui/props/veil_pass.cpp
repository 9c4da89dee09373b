// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/veil_pass.h"

#include <qopengl.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

namespace ui {
namespace {

constexpr const char* kVeilShader = R"(//VTK::System::Dec
in vec2 texCoord;
uniform sampler2D colours;
uniform sampler2D depths;
uniform float opacity;
//VTK::Output::Dec
void main()
{
  float depth = texture2D(depths, texCoord).r;
  if (depth >= 1.0) discard;
  gl_FragDepth = depth;
  gl_FragData[0] = vec4(texture2D(colours, texCoord).rgb, opacity);
}
)";

}  // namespace

vtkStandardNewMacro(VeilPass);

VeilPass::VeilPass() : drawing_(vtkSmartPointer<vtkRenderStepsPass>::New()) {}
VeilPass::~VeilPass() = default;

void VeilPass::Render(const vtkRenderState* state) {
  if (state->GetPropArrayCount() == 0) return;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  const int w = window->GetSize()[0], h = window->GetSize()[1];

  if (canvas_ == nullptr || w != width_ || h != height_) {
    colour_ = vtkSmartPointer<vtkTextureObject>::New();
    colour_->SetContext(window);
    colour_->Create2D(static_cast<unsigned>(w), static_cast<unsigned>(h), 4, VTK_UNSIGNED_CHAR,
                      false);
    depth_ = vtkSmartPointer<vtkTextureObject>::New();
    depth_->SetContext(window);
    depth_->AllocateDepth(static_cast<unsigned>(w), static_cast<unsigned>(h),
                          vtkTextureObject::Float32);
    canvas_ = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    canvas_->SetContext(window);
    width_ = w;
    height_ = h;
    held_ = false;
  }
  if (!held_) {
    gl->PushFramebufferBindings();
    canvas_->Bind();
    canvas_->AddColorAttachment(0, colour_);
    canvas_->AddDepthAttachment(depth_);
    canvas_->ActivateDrawBuffer(0);
    gl->vtkglDisable(GL_SCISSOR_TEST);
    gl->vtkglDepthMask(GL_TRUE);
    gl->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl->vtkglClearDepth(1.0);
    gl->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawing_->Render(state);
    gl->PopFramebufferBindings();
    held_ = true;
  }

  if (quad_ == nullptr)
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kVeilShader, nullptr);
  else
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  if (quad_->Program == nullptr) return;
  gl->vtkglViewport(0, 0, w, h);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglDepthFunc(GL_LEQUAL);
  gl->vtkglDepthMask(GL_FALSE);
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  colour_->Activate();
  depth_->Activate();
  quad_->Program->SetUniformi("colours", colour_->GetTextureUnit());
  quad_->Program->SetUniformi("depths", depth_->GetTextureUnit());
  quad_->Program->SetUniformf("opacity", static_cast<float>(opacity_));
  quad_->Render();
  colour_->Deactivate();
  depth_->Deactivate();
  gl->vtkglDepthMask(GL_TRUE);
}

void VeilPass::ReleaseGraphicsResources(vtkWindow* window) {
  drawing_->ReleaseGraphicsResources(window);
  quad_.reset();
  if (colour_ != nullptr) colour_->ReleaseGraphicsResources(window);
  if (depth_ != nullptr) depth_->ReleaseGraphicsResources(window);
  if (canvas_ != nullptr) canvas_->ReleaseGraphicsResources(window);
  canvas_ = nullptr;
  colour_ = nullptr;
  depth_ = nullptr;
  held_ = false;
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace ui
