// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCamera.h>

#include <QTimer>
#include <memory>
#include <optional>

#include "haptics/snapshot.h"
#include "ui/overlay_stack.h"
#include "ui/props/letters.h"
#include "ui/props/tool_prop.h"
#include "ui/props/volume_prop.h"
#include "ui/touched_surface.h"
#include "ui/view_look.h"
#include "ui/viewport.h"

class vtkRenderer;

namespace ui {

class HeldPass;

/// The 3-D view: isosurface, proxy, device and orientation letters, in W, millimetres.
///
/// Left drag turns the camera, or with the mouse as hand moves the hand in the view plane (Shift
/// turns it, the wheel pushes it away); right drag always turns the camera, middle drag shifts it,
/// Ctrl and wheel (without a mouse hand the wheel alone) zoom. Space requests force off, R shows
/// everything, T shows everything from the tool's side. C held down is the clutch, H held down is
/// hold-to-run; both are released when the view loses the focus.
class VolumeView : public Viewport {
  Q_OBJECT
 public:
  explicit VolumeView(QWidget* parent = nullptr);
  ~VolumeView() override;

  void show(const Picture& picture, double isovalue);
  void show(const haptics::TriangleMesh& tool);
  void setIsovalue(double isovalue);
  void setSurfaceWish(std::optional<SurfaceMode> wish);
  void display(const haptics::Snapshot& snapshot);
  void setMouseHand(bool on);
  /// Shows the mesh requested by fineMeshWanted.
  void showFine(vtkPolyData* mesh, double isovalue);
  /// The surface that is touched; given with every scene.
  void setTouched(const TouchedSurface& touched) { touched_ = touched; }
  /// Draws this above the picture, and asks it first for mouse and keys.
  void addOverlay(Overlay& overlay) { overlays_.add(overlay); }
  void resetCamera();
  /// Shows everything, from the device's side.
  void lookFromTool();
  /// Writes the camera into `look`.
  void tell(ViewLook& look) const;
  /// Takes the camera of `look`.
  void look(const ViewLook& look);

  /// Widget coordinates of a point of W [m].
  QPointF projected(const haptics::Vec3& p_W) const;
  Eigen::Vector3d letterPosition_mm(char letter) const { return letters_->positionOf(letter); }
  Eigen::Matrix3d viewAxes() const;  ///< columns: right, up, towards the viewer; in W
  VolumeProp& surface() { return surface_; }
  vtkCamera* camera() const { return camera_; }

 signals:
  void forceOffWanted();
  void clutchHeld(bool held);
  void forceHeld(bool held);
  /// The pose to which the mouse pulls the tool, W.
  void handPulled(const haptics::Pose& X_WH);
  void surfaceChosen(const ui::SurfaceChoice& choice);
  /// Nothing has moved for a while; a finer mesh may be shown.
  void fineMeshWanted(double isovalue);

 protected:
  void aboutToDraw() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void paintGL() override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  class Geometry;

  void chooseMode();
  void redrawSurface();
  void cameraMoved();
  void settle();
  void frameSurface(const Eigen::Vector3d& from);
  void rotateCamera(QPointF by);
  void panCamera(QPointF by);
  void zoomCamera(double factor);
  haptics::Pose& handTarget();
  void moveHand(QPointF by, bool turn);
  /// Metres across one widget pixel at a point of W.
  double metresPerPixel(const haptics::Vec3& p_W) const;
  void fitClippingRange();

  vtkSmartPointer<vtkCamera> camera_;
  vtkSmartPointer<vtkRenderer> surface_layer_;
  vtkSmartPointer<vtkRenderer> proxy_layer_;
  vtkSmartPointer<vtkRenderer> overlay_layer_;
  vtkSmartPointer<HeldPass> held_;
  VolumeProp surface_;
  ToolProp tool_;
  std::unique_ptr<Letters> letters_;
  Eigen::AlignedBox3d box_mm_;
  haptics::Grid grid_;
  std::optional<SurfaceMode> wish_;
  double isovalue_ = 0.0;
  double tool_radius_ = 0.0;  ///< m
  haptics::Snapshot last_;
  bool displayed_ = false;
  bool mouse_hand_ = false;
  std::optional<haptics::Pose> hand_target_;
  QPointF last_mouse_;
  QTimer still_;
  TouchedSurface touched_;
  std::unique_ptr<Geometry> geometry_;
  OverlayStack overlays_{*this};
};

}  // namespace ui
