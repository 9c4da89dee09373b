// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QPolygonF>
#include <QRect>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/core/triangle_mesh.h"
#include "ui/controls/mouse_choices.h"
#include "ui/controls/spoken.h"
#include "ui/overlays/overlay_stack.h"
#include "ui/props/slice.h"
#include "ui/props/structures.h"
#include "ui/props/view_look.h"
#include "ui/views/touched_surface.h"

namespace ui {

struct Patch;
struct ReadoutLayout;
struct SliceReadout;

/// A plane that another view shows, drawn as the line in which it meets a slice.
struct CrossedPlane {
  QColor colour;
  Eigen::Vector3d through_W_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();

  bool operator==(const CrossedPlane&) const = default;
};

/// One slice: the picture, structures, the contour of the touched surface, the lines of the other
/// planes, the outline of proxy (solid) and device (dashed), and what is said on the margin around
/// it.
/// Zoomed and shifted on its own; what concerns all slices is asked for by signals.
///
/// Keys and mouse are in ui/controls/bindings.h.
class SliceView : public QWidget, public Spoken {
  Q_OBJECT
 public:
  explicit SliceView(Plane plane, QWidget* parent = nullptr);
  ~SliceView() override;

  /// Shows another volume, as a whole.
  void show(const Picture& picture);
  using QWidget::show;
  /// Shows other voxels on the same grid: what is on view stays.
  void replace(const Picture& picture);
  /// As SliceSet's.
  void showLive(const haptics::Volume& voxels);
  void carve();
  void renew(std::shared_ptr<const haptics::Volume> volume);
  /// The tool, in its own frame; null: none.
  void setMesh(std::shared_ptr<const haptics::TriangleMesh> mesh);
  void setCross(const Eigen::Vector3d& cross_W_mm);
  /// For an oblique view: its plane. The place is the middle of its picture, if it was not shifted.
  void setPlane(const PlaneAxes& axes, const Eigen::Vector3d& through_W_mm, const QString& name,
                const QString& place);
  void setCrossedPlanes(std::vector<CrossedPlane> planes);
  void setGrey(const GreyWindow& grey);
  void setLook(const SliceLook& look);
  void setIsovalue(double isovalue);
  void setContourShown(bool shown);
  void setStructures(const Structures& structures);
  /// Sets the poses of proxy and device. It is drawn again if they moved visibly.
  void setTool(const haptics::Pose& X_WP, const haptics::Pose& X_WD);

  /// The surface that is touched; given with every scene.
  void setTouched(const TouchedSurface& touched);
  /// Draws this above the slice, and asks it first for mouse and keys.
  void addOverlay(Overlay& overlay);
  void setMouse(const MouseChoices& mouse) { mouse_ = mouse; }
  /// So many pixels at the right of the upper edge are covered by buttons.
  void setButtonRoom(int pixels) { button_room_ = pixels; }
  /// What the mouse does here, in a line.
  QString hint() const;

  Plane plane() const { return plane_; }
  const PlaneAxes& axes() const { return axes_; }
  /// A place in the plane.
  const Eigen::Vector3d& through_mm() const { return through_mm_; }
  /// Widget coordinates of a point of W, mm.
  QPointF projected(const Eigen::Vector3d& p_W_mm) const;
  /// The place of W, mm, under a pixel, in the plane of the slice.
  Eigen::Vector3d placeUnder(QPointF at) const;
  double mmPerPixel() const;
  /// The part of the widget in which the picture is; around it is the margin with the words.
  QRect pictureRect() const;
  /// The contour as it was last drawn: ends of pieces, W, mm.
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> contour_W_mm() const;
  /// What is written on the margin, and where.
  SliceReadout readout() const;
  ReadoutLayout readoutLayout(const QString& note = {}) const;
  /// Whether the picture, as it was last cut, shows some of the body in a box.
  bool showsBody(const QRectF& box) const;
  QSize sizeHint() const override { return {300, 260}; }
  /// What is on view, cut and drawn with so many pixels for one of the widget. Null if it would be
  /// too large.
  QImage picture(int scale);

  QAccessible::Role spokenRole() const override { return QAccessible::Canvas; }
  /// The plane, and where it lies.
  QString spokenName() const override;

  /// How near the picture is and where its middle lies, and the same again.
  SliceFrame frame() const { return {zoom_, pan_mm_}; }
  void setFrame(const SliceFrame& frame);
  /// Shows the whole slice.
  void resetView();
  /// Shows the body, as large as it can be, also after the widget's size has changed.
  void fitBody();
  /// Above 1: nearer. What is under `at` stays there.
  void zoom(double factor, QPointF at);
  void pan(QPointF by);
  /// So many slices along the normal.
  void scroll(int slices);
  /// The first slice, or the last.
  void scrollToEnd(bool last);

 signals:
  void crossMoved(const Eigen::Vector3d& cross_W_mm);
  void greyChanged(const ui::GreyWindow& grey);
  /// In an oblique view: its plane shall move so far along its normal.
  void depthChanged(double by_mm);
  void doubleClicked(const Eigen::Vector3d& p_W_mm);
  void menuWanted(QPoint at);
  void resetWanted();
  /// All slices shall show the body.
  void fitWanted();
  void toolToCrossWanted();
  void crossToToolWanted();
  /// The user wants a usual grey window, or to type one.
  void greyWanted(ui::Action which);
  void hintChanged(const QString& hint);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  class Geometry;
  enum class Drag { None, Cross, Pan, Grey };
  static constexpr int kRestMs = 150;  ///< without a change: the contour is followed finely

  void take(const Picture& picture);
  void draw(QPainter& painter, const QString& note = {});
  void changed();
  void moveCrossTo(const Eigen::Vector3d& p_W_mm);
  /// Brings a crosshair that was moved elsewhere into the picture. One that is fitted to the body
  /// gives way no farther than it must, and comes back.
  void findCross();
  /// Of a picture with the body in its middle.
  Eigen::Vector2d bodyPan_mm() const;
  /// The middle of the picture: a place in the plane.
  Eigen::Vector3d middle_mm() const;
  double fittingMmPerPixel() const;
  /// How large a pixel is if a box just fits.
  double fitting(const Eigen::AlignedBox3d& box_mm) const;
  /// The nearest zoom that is possible.
  double allowedZoom(double zoom) const;
  /// The axis of the grid along which the slices lie; none if they are oblique to it.
  std::optional<int> gridAxis() const;
  double step_mm() const;
  void shiftGrey(double level, double width);
  /// Cuts the structures as the picture is cut, and draws them.
  void drawStructures(double scale);
  /// What is visible of the volume, for the contour; empty where it is not.
  Patch visiblePatch() const;
  void makeContour();
  void drawContour(double scale);
  void drawCrossedPlanes(QPainter& painter) const;
  /// The lines of the tool in widget coordinates: outlines, or where its tip is beside the plane,
  /// if not far.
  struct ToolLines {
    std::vector<QPolygonF> proxy = {}, device = {};
    std::optional<QPointF> tip = {};
  };
  ToolLines toolLines() const;
  /// How far points of the tool are apart at two poses, at most.
  double apart_mm(const haptics::Pose& a, const haptics::Pose& b) const;
  QRect toolRect() const;  ///< that holds them
  void drawTool(QPainter& painter) const;
  /// Does what a key means here; false: nothing.
  bool perform(const Binding& meaning);

  Plane plane_;
  PlaneAxes axes_;
  QString name_, place_;
  Slice slice_;
  Structures structures_;
  StructureCut structure_cut_;
  QImage image_, structures_image_, contour_image_;
  bool stale_ = true;       ///< the cut
  bool grey_stale_ = true;  ///< its grey
  bool structures_stale_ = true;
  std::shared_ptr<const haptics::Volume> volume_;
  Eigen::AlignedBox3d box_mm_, body_mm_;
  bool fitted_ = false;  ///< to the body, and neither zoomed nor shifted since
  int button_room_ = 0;
  mutable std::vector<int> body_before_;  ///< of the cut's cells; empty: not yet looked for
  mutable QSize body_cells_;
  Eigen::Vector3d cross_mm_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d through_mm_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d pan_mm_ = Eigen::Vector2d::Zero();  ///< of the middle, along right and up
  double zoom_ = 1.0;
  std::vector<CrossedPlane> crossed_;
  GreyWindow grey_;
  SliceLook look_;

  TouchedSurface touched_;
  double isovalue_ = 0.0;
  bool contour_shown_ = true;
  bool contour_stale_ = true, contour_coarse_ = false;
  std::unique_ptr<Patch> patch_;
  std::vector<QLineF> contour_;  ///< in the patch
  QElapsedTimer contour_age_;
  QTimer refine_{this};  ///< runs after the contour changed while moving

  std::shared_ptr<const haptics::TriangleMesh> mesh_;
  double tool_radius_mm_ = 0.0;
  std::optional<haptics::Pose> X_WP_, X_WD_;

  Drag drag_ = Drag::None;
  bool dragged_ = false;  ///< the mouse moved since the press
  QPointF last_mouse_;
  std::optional<QPointF> hover_;
  int wheel_ = 0;  ///< of a notch, not yet used
  MouseChoices mouse_;
  std::unique_ptr<ViewGeometry> geometry_;
  OverlayStack overlays_{*this};
};

}  // namespace ui
