// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/viewport.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <algorithm>

namespace ui {

bool Graphics::software() const {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"})
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) return true;
  return false;
}

void Viewport::prepareApplication() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setAlphaBufferSize(0);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

Viewport::Viewport(QWidget* parent)
    : QOpenGLWidget(parent), window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(kLeast);
  // VTK renders into its own framebuffer in Qt's context; paintGL moves the result
  window_->SetReadyForRendering(false);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetOwnContext(0);
  window_->SetMultiSamples(0);
  for (const unsigned long event :
       {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
        vtkCommand::WindowSupportsOpenGLEvent})
    window_->AddObserver(event, this, &Viewport::onVtkEvent);
}

Viewport::~Viewport() {
  disconnect(context_dies_);
  releaseGl();
  window_->RemoveAllObservers();
}

void Viewport::redraw() {
  stale_ = true;
  update();
}

void Viewport::initializeGL() {
  // reparenting gives the widget a new context, and this runs again
  disconnect(context_dies_);
  context_dies_ =
      connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGl);

  Graphics graphics;
  QOpenGLFunctions* gl = context()->functions();
  graphics.major = context()->format().majorVersion();
  graphics.minor = context()->format().minorVersion();
  graphics.renderer =
      QString::fromLatin1(reinterpret_cast<const char*>(gl->glGetString(GL_RENDERER)));
  gl->glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &graphics.max_3d_texture);
  graphics_ = graphics;

  window_->SetForceMaximumHardwareLineWidth(1);
  window_->SetReadyForRendering(true);
  window_->GetState()->Reset();
  window_->OpenGLInitContext();
  stale_ = true;
  emit graphicsKnown(graphics);
}

void Viewport::resizeGL(int, int) {
  const qreal scale = devicePixelRatioF();
  window_->SetSize(qRound(width() * scale), qRound(height() * scale));
  window_->SetDPI(qRound(72 * scale));
  stale_ = true;
}

void Viewport::paintGL() {
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  if (stale_) {
    stale_ = false;
    aboutToDraw();
    window_->Render();
    ++frames_;
  }
  const int w = window_->GetSize()[0], h = window_->GetSize()[1];
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  state->vtkglDisable(GL_SCISSOR_TEST);
  window_->BlitDisplayFramebuffer(0, 0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  // Qt composes the widget by alpha: make it opaque
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  state->vtkglClearColor(0.0, 0.0, 0.0, 1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->Pop();
}

vtkGenericOpenGLRenderWindow* Viewport::renderWindow() const { return window_; }

QImage Viewport::drawnAt(QSize pixels) {
  if (!graphics_ || context() == nullptr) return {};
  makeCurrent();
  GLint most = 0;
  context()->functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (pixels.isEmpty() || std::max(pixels.width(), pixels.height()) > most) {
    doneCurrent();
    return {};
  }
  const int w = window_->GetSize()[0], h = window_->GetSize()[1];
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  window_->SetSize(pixels.width(), pixels.height());
  aboutToDraw();
  window_->Render();
  QImage image(pixels, QImage::Format_RGBA8888);
  vtkOpenGLFramebufferObject* drawn = window_->GetDisplayFramebuffer();
  state->PushFramebufferBindings();
  drawn->Bind(GL_READ_FRAMEBUFFER);
  drawn->ActivateReadBuffer(0);
  context()->functions()->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  context()->functions()->glReadPixels(0, 0, pixels.width(), pixels.height(), GL_RGBA,
                                       GL_UNSIGNED_BYTE, image.bits());
  state->PopFramebufferBindings();
  window_->SetSize(w, h);
  state->Pop();
  doneCurrent();
  redraw();
  // OpenGL's rows go up, and its alpha is nobody's business
  return image.mirrored().convertToFormat(QImage::Format_RGB32);
}

void Viewport::onVtkEvent(vtkObject*, unsigned long event, void* call_data) {
  switch (event) {
    case vtkCommand::WindowMakeCurrentEvent:
      // makeCurrent() also binds Qt's framebuffer: not while VTK has bound its own
      if (context() != nullptr && QOpenGLContext::currentContext() != context()) makeCurrent();
      break;
    case vtkCommand::WindowIsCurrentEvent:
      *static_cast<bool*>(call_data) =
          context() != nullptr && QOpenGLContext::currentContext() == context();
      break;
    case vtkCommand::WindowSupportsOpenGLEvent:
      *static_cast<int*>(call_data) = 1;
      break;
    default:
      break;
  }
}

void Viewport::releaseGl() {
  if (context() == nullptr || !window_->GetReadyForRendering()) return;
  makeCurrent();
  window_->Finalize();
  window_->SetReadyForRendering(false);
  doneCurrent();
}

}  // namespace ui
