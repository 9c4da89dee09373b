// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <span>

#include "haptics/core/triangle_mesh.h"
#include "haptics/snapshot.h"
#include "ui/controls/bindings.h"
#include "ui/controls/mouse_choices.h"
#include "ui/controls/spoken.h"
#include "ui/overlays/overlay_stack.h"
#include "ui/props/orientation.h"
#include "ui/props/structure_props.h"
#include "ui/props/tool_prop.h"
#include "ui/props/view_look.h"
#include "ui/props/viewport.h"
#include "ui/props/volume_prop.h"
#include "ui/views/space_camera.h"
#include "ui/views/touched_surface.h"

class vtkRenderer;

namespace ui {

class HeldPass;
class ThroughPass;
class VeilPass;

/// The 3-D view: isosurface, a second surface as a veil, structures, proxy, device, contacts and
/// orientation, in W, millimetres. Keys and mouse are in ui/controls/bindings.h. The mouse is a
/// hand in a mode of its own, and wherever it takes hold of the tool that is drawn. C and H are
/// released when the view loses the focus.
class VolumeView : public Viewport, public Spoken {
  Q_OBJECT
 public:
  explicit VolumeView(QWidget* parent = nullptr);
  ~VolumeView() override;

  void show(const Picture& picture, double isovalue);
  void show(const haptics::TriangleMesh& tool);
  void setIsovalue(double isovalue);
  void setSurfaceWish(std::optional<SurfaceMode> wish);
  /// Shows other voxels of the same grid; camera, mode and isovalues stay.
  void replace(const Picture& picture);
  /// As VolumeProp's.
  void showLive(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan,
                std::span<const haptics::VoxelBox> cut_before);
  void carve(const haptics::VoxelBox& box);
  void renew(const Picture& picture);
  /// Whether faces that were cut have a colour of their own.
  void setTint(bool on);
  bool isTinted() const { return surface_.carved().isTinted(); }
  /// What is on view; its volume is null before the first.
  const Picture& picture() const { return surface_.picture(); }
  void display(const haptics::Snapshot& snapshot);
  /// Whether the mouse can hold the tool; a hand that was held before is let go.
  void setMouseHand(bool on);
  /// The hand is at this pose from now on.
  void placeHand(const haptics::Pose& X_WH);
  /// Takes the tool with the mouse, or lets it go. Without the mouse as the hand nothing is taken.
  void setMouseMode(MouseMode mode);
  MouseMode mouseMode() const { return mode_; }
  bool mouseHand() const { return mouse_hand_; }
  /// What it does from now on, and at first whenever the mouse becomes the hand.
  void setMouse(const MouseChoices& mouse);
  const MouseChoices& mouse() const { return mouse_; }
  void setColouring(const Colouring& colouring);
  /// A second surface, which is seen through and not felt; none: no second.
  void setSecondSurface(std::optional<double> isovalue);
  void setSecondOpacity(double opacity);
  double secondOpacity() const;
  /// Shows these structures, each as soon as it has a shape.
  void show(const Structures& structures);
  void showShape(std::size_t number, vtkPolyData* mesh);
  /// Looks at the first of these places of a structure [mm], from where the solid hides as little
  /// of them as can be, and from not too far.
  void lookAtPlaces(const std::vector<Eigen::Vector3d>& places_W_mm);
  /// Shows where the tool is touched and the force on it.
  void showContacts(bool on);
  /// Shows the mesh requested by fineMeshWanted.
  void showFine(vtkPolyData* mesh, double isovalue);
  /// Whether nothing has moved for a while, and the finer mesh is shown if somebody makes it.
  bool isAtRest() const { return !still_.isActive() && !fine_awaited_; }
  /// The surface that is touched; given with every scene.
  void setTouched(const TouchedSurface& touched) { touched_ = touched; }
  const TouchedSurface& touched() const { return touched_; }
  /// Draws this above the picture, and asks it first for mouse and keys.
  void addOverlay(Overlay& overlay);
  void resetCamera() { lookFrom(Side::Anterior); }
  /// Shows everything, from a side of the patient.
  void lookFrom(Side side);
  /// Shows everything, from the device's side.
  void lookFromTool();
  /// Writes the camera into `look`.
  void tell(ViewLook& look) const;
  /// Takes the camera of `look`.
  void look(const ViewLook& look);
  /// Looks as another view does.
  void follow(const VolumeView& other);
  /// Words in its upper left corner, or fewer where it has no room for the `widest`; empty: none.
  void setCaption(const QString& words, const QString& fewer, const QString& widest);
  /// Looks at the tip from behind the tool.
  void lookAlongTool();
  void setParallel(bool parallel);
  bool isParallel() const { return camera_.isParallel(); }

  /// Widget coordinates of a point of W [m].
  QPointF projected(const haptics::Vec3& p_W) const;
  Eigen::Matrix3d viewAxes() const { return camera_.axes(); }  ///< right, up, towards the viewer
  VolumeProp& surface() { return surface_; }
  const ToolProp& tool() const { return tool_; }
  vtkCamera* camera() const { return camera_.vtk(); }
  /// Whether the mouse would take hold of the tool there.
  bool isOnTool(QPointF at) const;
  /// What lies over the view: the words in it keep clear of that.
  void setCovered(std::vector<QRectF> parts);
  /// The boxes of the words in it, and of its cube, apart from those of overlays.
  std::vector<QRectF> wordBoxes() const;
  /// Whether something of the tool is drawn in this part of the view.
  bool isToolIn(const QRect& part) const;
  /// Whether something there can be dragged.
  bool isHandleIn(const QRect& part) const;
  /// What the mouse does here, in a line.
  QString hint() const;
  /// The view's picture, `scale` times as large as its widget: with letters and overlays. Null if
  /// the graphics cannot draw it.
  QImage picture(double scale);

  QAccessible::Role spokenRole() const override { return QAccessible::Canvas; }
  /// What is on view.
  QString spokenName() const override;

 signals:
  void forceOffWanted();
  /// The tool is to come to this place of the surface [m], with its normal (unit, out of the
  /// solid).
  void toolWanted(const haptics::Vec3& p_W, const haptics::Vec3& normal_W);
  void toolToCrossWanted();
  void crossToToolWanted();
  void mouseModeChanged(ui::MouseMode mode);
  /// The mouse does something else from now on.
  void hintChanged(const QString& hint);
  /// Value and place of the touched surface under the pointer; empty: none.
  void pointedChanged(const QString& words);
  void mouseHandChanged(bool possible);
  void parallelChanged(bool parallel);
  /// The camera was moved here; follow() is told by nobody.
  void cameraChanged();
  /// Another isovalue, or other colours.
  void lookChanged();
  void clutchHeld(bool held);
  void forceHeld(bool held);
  void cutHeld(bool held);
  /// The pose to which the mouse pulls the tool, W.
  void handPulled(const haptics::Pose& X_WH);
  void surfaceChosen(const ui::SurfaceChoice& choice);
  /// Another second surface, or none, or another opacity.
  void secondSurfaceChanged();
  /// Nothing has moved for a while; a finer mesh may be shown.
  void fineMeshWanted(double isovalue);

 protected:
  void aboutToDraw() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  class Geometry;
  static constexpr double kLeastForce = 0.02;  ///< N: less is not shown
  /// What a drag does until its button is released.
  struct Grasp {
    Action action;
    Eigen::Vector3d zoom_at_mm;
  };

  void chooseMode();
  void redrawSurface();
  /// What was drawn and kept is drawn again.
  void forgetDrawn();
  void cameraMoved();
  void showMoved();
  void settle();
  void lookAtFirst();
  void frameSurface(const Eigen::Vector3d& from, const Eigen::Vector3d& up);
  void zoom(double factor, QPointF at);
  /// What the sight through a pixel is about: the surface, or the plane of the focal point.
  Eigen::Vector3d aimUnder(QPointF at) const;
  std::optional<SurfacePlace> surfaceUnder(QPointF at) const;
  /// Does what a key means here; false: nothing.
  bool perform(const Binding& meaning);
  /// Where the key of clutch, hold-to-run or burr is held: its scan code; 0: nowhere, or unknown.
  quint32& heldPlace(Action action);
  void hold(Action action, bool on, quint32 place);
  void dragBy(QPointF by, Qt::KeyboardModifiers modifiers);
  void bringTool(QPointF at);
  haptics::Pose& handTarget();
  void moveHand(QPointF by, bool turn);
  void pushHand(double notches);
  void moveByKey(const Binding& meaning);
  void chooseCursor(QPointF at);
  void fitClippingRange();
  void tellPointed();
  /// Structures at a place that is seen.
  struct NamedPlace {
    QString names = {};                        ///< empty: there is none
    std::optional<haptics::Vec3> p_W_mm = {};  ///< none: that of the surface
  };
  /// Those that are seen or touched under a pixel, where the surface is met there, or not.
  NamedPlace structuresUnder(QPointF at, const std::optional<SurfacePlace>& met) const;
  /// Whether the box that the surface fills is seen in a box of the view.
  bool showsBody(const QRectF& box);
  void paintOver(QPainter& painter) const;
  void paintContacts(QPainter& painter) const;
  /// Whether there is room for the cube beside the caption.
  bool showsCube() const;
  std::optional<Side> cubeSideAt(QPointF at) const;
  PlatedWords caption() const;
  /// Words below the cube where left and right are not known.
  PlatedWords unknownSides() const;
  /// What the letters at the edges keep clear of.
  std::vector<QRectF> besideLetters() const;

  SpaceCamera camera_{*this};
  vtkSmartPointer<vtkRenderer> surface_layer_;
  vtkSmartPointer<vtkRenderer> through_layer_;
  vtkSmartPointer<vtkRenderer> proxy_layer_;
  vtkSmartPointer<vtkRenderer> veil_layer_;
  vtkSmartPointer<vtkRenderer> overlay_layer_;
  vtkSmartPointer<HeldPass> held_;
  vtkSmartPointer<ThroughPass> through_;
  vtkSmartPointer<VeilPass> veil_;
  VolumeProp surface_;
  StructureProps structures_;
  ToolProp tool_;
  haptics::TriangleMesh tool_mesh_;
  Eigen::AlignedBox3d box_mm_;
  haptics::Grid grid_;
  bool orientation_known_ = false;
  std::optional<SurfaceMode> wish_;
  double isovalue_ = 0.0;
  double tool_radius_ = 0.0;  ///< m
  haptics::Snapshot last_;
  bool displayed_ = false;
  bool contacts_shown_ = false;
  /// Where the corners of the surface's box are seen: labels ask at very many places.
  struct BodyCorners {
    std::uint64_t camera = 0;  ///< its time
    QSize size;
    Eigen::AlignedBox3d body;
    std::array<QPointF, 8> corners;
  };
  BodyCorners body_corners_;
  std::vector<QRectF> covered_;
  QString caption_, short_caption_, widest_caption_;
  bool mouse_hand_ = false;
  MouseMode mode_ = MouseMode::Look;
  MouseChoices mouse_;
  std::optional<Grasp> grasp_;
  std::array<quint32, 3> held_places_{};  ///< heldPlace()
  std::optional<haptics::Pose> hand_target_;
  QPointF last_mouse_, press_;
  QTimer still_{this};
  QTimer pointed_{this};  ///< runs after the pointer moved
  bool pointer_in_ = false;
  bool fine_awaited_ = false;  ///< a finer mesh is being made
  TouchedSurface touched_;
  std::unique_ptr<ViewGeometry> geometry_;
  OverlayStack overlays_{*this};
};

}  // namespace ui
