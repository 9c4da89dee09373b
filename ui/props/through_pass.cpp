// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/through_pass.h"

#include <qopengl.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <vector>

namespace ui {
namespace {

constexpr float kBetweenOutlines = 0.22F;  // opacity between the outlines

constexpr const char* kOutlineShader = R"(//VTK::System::Dec
in vec2 texCoord;
uniform sampler2D colours;
uniform vec2 pixel;
uniform int line;
uniform float within;
//VTK::Output::Dec
void main()
{
  vec4 here = texture2D(colours, texCoord);
  if (here.a < 0.5) discard;
  bool edge = false;
  for (int by = 1; by <= line; ++by)
    for (int way = 0; way < 4; ++way)
    {
      vec2 along = way < 2 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
      if ((way & 1) == 1) along = -along;
      vec4 beside = texture2D(colours, texCoord + float(by) * along * pixel);
      edge = edge || distance(beside, here) > 0.01;
    }
  gl_FragData[0] = vec4(here.rgb, edge ? 1.0 : within);
}
)";

double sizeOf(vtkProp* prop) {
  const double* b = prop->GetBounds();
  return (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]);
}

}  // namespace

vtkStandardNewMacro(ThroughPass);

ThroughPass::ThroughPass() = default;
ThroughPass::~ThroughPass() = default;

void ThroughPass::Render(const vtkRenderState* state) {
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  const int w = window->GetSize()[0], h = window->GetSize()[1];

  if (canvas_ == nullptr || w != width_ || h != height_) {
    colour_ = vtkSmartPointer<vtkTextureObject>::New();
    colour_->SetContext(window);
    colour_->Create2D(static_cast<unsigned>(w), static_cast<unsigned>(h), 4, VTK_UNSIGNED_CHAR,
                      false);
    canvas_ = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    canvas_->SetContext(window);
    width_ = w;
    height_ = h;
    held_ = false;
  }
  gl->vtkglViewport(0, 0, w, h);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  gl->vtkglDisable(GL_DEPTH_TEST);
  if (!held_) {
    std::vector<vtkProp*> props(state->GetPropArray(),
                                state->GetPropArray() + state->GetPropArrayCount());
    std::ranges::sort(props, std::greater{}, sizeOf);
    gl->PushFramebufferBindings();
    canvas_->Bind();
    canvas_->AddColorAttachment(0, colour_);
    canvas_->ActivateDrawBuffer(0);
    gl->vtkglDisable(GL_BLEND);
    gl->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl->vtkglClear(GL_COLOR_BUFFER_BIT);
    for (vtkProp* prop : props) prop->RenderOpaqueGeometry(renderer);
    gl->PopFramebufferBindings();
    held_ = true;
  }

  if (quad_ == nullptr)
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kOutlineShader, nullptr);
  else
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  if (quad_->Program != nullptr) {
    gl->vtkglDepthMask(GL_FALSE);
    gl->vtkglEnable(GL_BLEND);
    gl->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                               GL_ONE_MINUS_SRC_ALPHA);
    colour_->Activate();
    const float pixel[2] = {1.0F / static_cast<float>(w), 1.0F / static_cast<float>(h)};
    quad_->Program->SetUniformi("colours", colour_->GetTextureUnit());
    quad_->Program->SetUniform2f("pixel", pixel);
    quad_->Program->SetUniformi("line", line_);
    quad_->Program->SetUniformf("within", kBetweenOutlines);
    quad_->Render();
    colour_->Deactivate();
  }
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglDepthMask(GL_TRUE);
}

void ThroughPass::ReleaseGraphicsResources(vtkWindow* window) {
  quad_.reset();
  if (colour_ != nullptr) colour_->ReleaseGraphicsResources(window);
  if (canvas_ != nullptr) canvas_->ReleaseGraphicsResources(window);
  canvas_ = nullptr;
  colour_ = nullptr;
  held_ = false;
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace ui
