// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <QImage>
#include <QOpenGLWidget>
#include <QSize>
#include <QString>
#include <optional>

class vtkGenericOpenGLRenderWindow;
class vtkObject;

namespace ui {

/// Properties that the graphics driver reports.
struct Graphics {
  int major = 0;  ///< OpenGL version
  int minor = 0;
  QString renderer;        ///< GL_RENDERER
  int max_3d_texture = 0;  ///< voxels along an axis
  bool software() const;   ///< a software renderer: llvmpipe, softpipe, swrast
};

/// A VTK render window inside a Qt 6 OpenGL widget.
///
/// VTK draws into its own framebuffer, and only after redraw(). Qt may repaint the widget at any
/// time from the last drawing. Renderers are added to renderWindow().
class Viewport : public QOpenGLWidget {
  Q_OBJECT
 public:
  /// Sets the surface format that VTK needs. Call it before the QApplication is made.
  static void prepareApplication();
  static constexpr QSize kLeast{160, 120};  ///< of a view that nobody made smaller

  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  vtkGenericOpenGLRenderWindow* renderWindow() const;
  /// None until the widget was first shown.
  const std::optional<Graphics>& graphics() const { return graphics_; }
  /// Draws the scene again at the next paint.
  void redraw();
  /// Draws the scene once at another size, in pixels of the picture, and gives the picture back;
  /// null if the graphics cannot.
  QImage drawnAt(QSize pixels);
  /// Pictures drawn so far.
  int frames() const { return frames_; }
  QSize sizeHint() const override { return {640, 480}; }

 signals:
  void graphicsKnown(const ui::Graphics& graphics);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  /// Called with the context current just before VTK draws.
  virtual void aboutToDraw() {}

 private:
  void onVtkEvent(vtkObject* caller, unsigned long event, void* call_data);
  void releaseGl();

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  std::optional<Graphics> graphics_;
  QMetaObject::Connection context_dies_;
  bool stale_ = true;
  int frames_ = 0;
};

}  // namespace ui
