// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_view.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/controls/bindings.h"
#include "ui/controls/lengths.h"
#include "ui/props/contour.h"
#include "ui/props/section.h"
#include "ui/style/scene_colours.h"
#include "ui/views/plane_colours.h"
#include "ui/views/slice_readout.h"

namespace ui {
namespace {

constexpr double kRoom = 1.04;             // of the picture, around a whole slice
constexpr double kObliqueView_mm = 120.0;  // that an oblique view shows at first, at most
constexpr double kFarthest = 0.25;         // least zoom
constexpr double kNearest_px = 60.0;       // for a voxel, at most
constexpr double kVisible_px = 0.25;       // a tool that moved less is not drawn again
constexpr int kBodyCell = 4;               // px
constexpr double kCrossRoom_px = 12.0;     // about a crosshair at the edge

QString nameOf(Plane plane) {
  switch (plane) {
    case Plane::Axial:
      return SliceView::tr("Axial");
    case Plane::Coronal:
      return SliceView::tr("Coronal");
    case Plane::Sagittal:
      return SliceView::tr("Sagittal");
    case Plane::Oblique:
      break;
  }
  return SliceView::tr("Tool");
}

}  // namespace

/// What overlays know of a slice.
class SliceView::Geometry : public ViewGeometry {
 public:
  explicit Geometry(const SliceView& view) : view_(view) {}

  bool isSlice() const override { return true; }
  QPointF projected(const Eigen::Vector3d& p_W_mm) const override {
    return view_.projected(p_W_mm);
  }
  Eigen::Matrix3d axes() const override {
    Eigen::Matrix3d axes;
    axes << view_.axes_.right, view_.axes_.up, towards();
    return axes;
  }
  std::optional<Eigen::Vector3d> placeUnder(QPointF at) const override {
    return view_.placeUnder(at);
  }
  Eigen::Vector3d placeBeside(QPointF at, const Eigen::Vector3d& p_W_mm) const override {
    const Eigen::Vector3d p = view_.placeUnder(at);
    return p + towards() * towards().dot(p_W_mm - p);
  }
  void sight(QPointF at, Eigen::Vector3d& from_W_mm, Eigen::Vector3d& along_W) const override {
    from_W_mm = view_.placeUnder(at);
    along_W = -towards();
  }
  double mmPerPixel(const Eigen::Vector3d&) const override { return view_.mmPerPixel(); }
  double offset_mm(const Eigen::Vector3d& p_W_mm) const override {
    return towards().dot(p_W_mm - view_.through_mm_);
  }
  const QWidget& widget() const override { return view_; }
  QRectF room() const override { return view_.pictureRect(); }
  bool showsBody(const QRectF& box) const override { return view_.showsBody(box); }

 private:
  Eigen::Vector3d towards() const { return view_.axes_.right.cross(view_.axes_.up); }

  const SliceView& view_;
};

SliceView::SliceView(Plane plane, QWidget* parent)
    : QWidget(parent),
      plane_(plane),
      axes_(axesOf(plane)),
      name_(nameOf(plane)),
      patch_(std::make_unique<Patch>()),
      geometry_(std::make_unique<Geometry>(*this)) {
  offerSpoken();
  setMouseTracking(true);
  setMinimumSize(120, 100);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(name_);
  setAttribute(Qt::WA_OpaquePaintEvent);
  whenKeysChange(*this, [this] { emit hintChanged(hint()); });
  whenLengthUnitChanges(*this, [this] { update(); });
  refine_.setObjectName("refine");
  refine_.setSingleShot(true);
  refine_.setInterval(kRestMs);
  connect(&refine_, &QTimer::timeout, this, [this] {
    contour_stale_ = true;
    contour_age_.invalidate();
    update();
  });
}

SliceView::~SliceView() = default;

void SliceView::take(const Picture& picture) {
  slice_.show(picture);
  volume_ = picture.volume;
  box_mm_ = boxOf_mm(volume_->grid);
  body_mm_ = picture.body_mm;
  changed();
}

void SliceView::show(const Picture& picture) {
  X_WP_.reset();
  X_WD_.reset();
  take(picture);
  fitBody();
}

void SliceView::replace(const Picture& picture) { take(picture); }

void SliceView::showLive(const haptics::Volume& voxels) {
  slice_.showLive(voxels);
  changed();
}

void SliceView::carve() {
  slice_.carve();
  changed();
}

void SliceView::renew(std::shared_ptr<const haptics::Volume> volume) {
  volume_ = std::move(volume);
  slice_.renew(volume_);
  changed();
}

void SliceView::changed() {
  stale_ = true;
  contour_stale_ = true;
  update();
  // of what the user goes through; the others follow unsaid
  if (hasFocus()) tellSpokenName(*this);
}

QString SliceView::spokenName() const {
  const SliceReadout said = readout();
  const QString name = tr("%1 slice").arg(said.name);
  return said.place.isEmpty() ? name : tr("%1: %2").arg(name, said.place.simplified());
}

void SliceView::setMesh(std::shared_ptr<const haptics::TriangleMesh> mesh) {
  mesh_ = std::move(mesh);
  tool_radius_mm_ = 0.0;
  if (mesh_)
    for (const haptics::Vec3& v : mesh_->vertices)
      tool_radius_mm_ = std::max(tool_radius_mm_, v.norm() * kMmPerM);
  update();
}

void SliceView::setCross(const Eigen::Vector3d& cross_W_mm) {
  cross_mm_ = cross_W_mm;
  if (plane_ == Plane::Oblique) return update();
  // a move within the slice leaves its picture as it is
  const bool other = std::abs(axes_.normal.dot(cross_W_mm - through_mm_)) > 1e-6;
  through_mm_ = cross_W_mm;
  if (other) changed();
  if (drag_ == Drag::None && volume_) findCross();
  update();
}

void SliceView::findCross() {
  const Eigen::Vector2d before = pan_mm_;
  if (fitted_) pan_mm_ = bodyPan_mm();
  const QRectF picture = pictureRect();
  const QPointF at = projected(cross_mm_);
  if (!picture.contains(at)) {
    const QRectF room =
        picture.adjusted(kCrossRoom_px, kCrossRoom_px, -kCrossRoom_px, -kCrossRoom_px);
    const QPointF to = fitted_ ? QPointF{std::clamp(at.x(), room.left(), room.right()),
                                         std::clamp(at.y(), room.top(), room.bottom())}
                               : picture.center();
    pan_mm_ += Eigen::Vector2d{at.x() - to.x(), to.y() - at.y()} * mmPerPixel();
  }
  if (pan_mm_ != before) changed();
}

void SliceView::setPlane(const PlaneAxes& axes, const Eigen::Vector3d& through_W_mm,
                         const QString& name, const QString& place) {
  if (name != name_) setAccessibleName(name);
  name_ = name;
  place_ = place;
  axes_ = axes;
  through_mm_ = through_W_mm;
  changed();
}

void SliceView::setCrossedPlanes(std::vector<CrossedPlane> planes) {
  if (planes == crossed_) return;
  crossed_ = std::move(planes);
  update();
}

void SliceView::setGrey(const GreyWindow& grey) {
  grey_ = grey;
  grey_stale_ = true;
  update();
}

void SliceView::setLook(const SliceLook& look) {
  if (look == look_) return;
  look_ = look;
  stale_ = true;
  update();
}

void SliceView::setIsovalue(double isovalue) {
  if (isovalue == isovalue_) return;
  isovalue_ = isovalue;
  contour_stale_ = true;
  update();
}

void SliceView::setContourShown(bool shown) {
  contour_shown_ = shown;
  contour_stale_ = true;
  update();
}

void SliceView::setStructures(const Structures& structures) {
  structures_ = structures;
  structures_stale_ = true;
  update();
}

void SliceView::setTouched(const TouchedSurface& touched) {
  touched_ = touched;
  contour_stale_ = true;
  update();
}

double SliceView::apart_mm(const haptics::Pose& a, const haptics::Pose& b) const {
  return (a.translation() - b.translation()).norm() * kMmPerM +
         (a.linear() - b.linear()).cwiseAbs().maxCoeff() * tool_radius_mm_;
}

void SliceView::setTool(const haptics::Pose& X_WP, const haptics::Pose& X_WD) {
  const double least = kVisible_px * mmPerPixel();
  if (X_WP_ && X_WD_ && apart_mm(*X_WP_, X_WP) < least && apart_mm(*X_WD_, X_WD) < least) return;
  // what it leaves, and where it comes: the buttons over a slice need not be painted with it
  QRegion painted = toolRect();
  X_WP_ = X_WP;
  X_WD_ = X_WD;
  painted += toolRect();
  update(painted);
}

QRect SliceView::pictureRect() const { return pictureIn(rect(), plane_ == Plane::Oblique); }

ReadoutLayout SliceView::readoutLayout(const QString& note) const {
  SliceReadout said = readout();
  said.note = note;
  return layOut(said, font(), rect(), pictureRect(), button_room_, mmPerPixel());
}

bool SliceView::showsBody(const QRectF& box) const {
  const QRect picture = pictureRect();
  const double scale = image_.devicePixelRatio();
  if (slice_.empty() || image_.isNull()) return false;
  const int cell = qRound(kBodyCell * scale);
  if (body_before_.empty()) {
    body_cells_ = {(image_.width() + cell - 1) / cell, (image_.height() + cell - 1) / cell};
    body_before_ = slice_.bodyBefore(cell, body_cells_);
  }
  const QRectF in = box.intersected(picture).translated(-picture.topLeft());
  if (in.isEmpty()) return false;
  const auto before = [&](int x, int y) {
    return body_before_[static_cast<std::size_t>(y * (body_cells_.width() + 1) + x)];
  };
  const auto along = [&](double at, int most, bool up) {
    const double cells = at * scale / cell;
    return std::clamp(static_cast<int>(up ? std::ceil(cells) : std::floor(cells)), 0, most);
  };
  const int left = along(in.left(), body_cells_.width(), false);
  const int right = along(in.right(), body_cells_.width(), true);
  const int top = along(in.top(), body_cells_.height(), false);
  const int bottom = along(in.bottom(), body_cells_.height(), true);
  return before(right, bottom) - before(left, bottom) - before(right, top) + before(left, top) > 0;
}

double SliceView::fittingMmPerPixel() const { return box_mm_.isEmpty() ? 1.0 : fitting(box_mm_); }

double SliceView::fitting(const Eigen::AlignedBox3d& box_mm) const {
  const QRect picture = pictureRect();
  double across = 0.0, upward = 0.0;
  if (plane_ == Plane::Oblique) {  // the same whichever way it lies
    across = upward = std::min(kObliqueView_mm, box_mm_.diagonal().norm());
  } else {
    across = axes_.right.cwiseAbs().dot(box_mm.sizes());
    upward = axes_.up.cwiseAbs().dot(box_mm.sizes());
  }
  return std::max({kRoom * across / std::max(1, picture.width()),
                   kRoom * upward / std::max(1, picture.height()), 1e-3});
}

double SliceView::mmPerPixel() const { return fittingMmPerPixel() / zoom_; }

Eigen::Vector3d SliceView::middle_mm() const {
  Eigen::Vector3d middle = through_mm_;
  if (plane_ != Plane::Oblique && !box_mm_.isEmpty()) {
    middle = box_mm_.center();
    middle += axes_.normal * axes_.normal.dot(through_mm_ - middle);
  }
  return middle + axes_.right * pan_mm_.x() + axes_.up * pan_mm_.y();
}

QPointF SliceView::projected(const Eigen::Vector3d& p_W_mm) const {
  const Eigen::Vector3d p = p_W_mm - middle_mm();
  const double scale = 1.0 / mmPerPixel();
  const QPointF centre = QRectF(pictureRect()).center();
  return {centre.x() + axes_.right.dot(p) * scale, centre.y() - axes_.up.dot(p) * scale};
}

Eigen::Vector3d SliceView::placeUnder(QPointF at) const {
  const double scale = mmPerPixel();
  const QPointF by = at - QRectF(pictureRect()).center();
  return middle_mm() + axes_.right * (by.x() * scale) - axes_.up * (by.y() * scale);
}

void SliceView::fitBody() {
  if (!volume_) return;
  zoom_ = allowedZoom(fittingMmPerPixel() / fitting(body_mm_));
  pan_mm_ = bodyPan_mm();
  fitted_ = true;
  changed();
}

Eigen::Vector2d SliceView::bodyPan_mm() const {
  if (plane_ == Plane::Oblique) return Eigen::Vector2d::Zero();
  const Eigen::Vector3d by = body_mm_.center() - box_mm_.center();
  return {axes_.right.dot(by), axes_.up.dot(by)};
}

void SliceView::resetView() {
  fitted_ = false;
  zoom_ = 1.0;
  pan_mm_.setZero();
  changed();
}

double SliceView::allowedZoom(double zoom) const {
  const double voxel_mm = volume_->grid.spacing.minCoeff() * kMmPerM;
  const double most = std::max(1.0, fittingMmPerPixel() * kNearest_px / voxel_mm);
  return std::clamp(zoom, kFarthest, most);
}

void SliceView::setFrame(const SliceFrame& frame) {
  if (!volume_) return;
  fitted_ = false;
  zoom_ = allowedZoom(frame.zoom);
  pan_mm_ = frame.shift_mm;
  changed();
}

void SliceView::zoom(double factor, QPointF at) {
  if (!volume_) return;
  fitted_ = false;
  const Eigen::Vector3d before = placeUnder(at);
  zoom_ = allowedZoom(zoom_ * factor);
  const Eigen::Vector3d by = before - placeUnder(at);
  pan_mm_ += Eigen::Vector2d{axes_.right.dot(by), axes_.up.dot(by)};
  changed();
}

void SliceView::pan(QPointF by) {
  fitted_ = false;
  pan_mm_ += Eigen::Vector2d{-by.x(), by.y()} * mmPerPixel();
  changed();
}

std::optional<int> SliceView::gridAxis() const {
  for (int a = 0; volume_ && a < 3; ++a)
    if (std::abs(volume_->grid.direction.col(a).dot(axes_.normal)) > 1.0 - 1e-6) return a;
  return {};
}

double SliceView::step_mm() const {
  if (!volume_) return 1.0;
  const std::optional<int> axis = gridAxis();
  return (axis ? volume_->grid.spacing[*axis] : volume_->grid.spacing.minCoeff()) * kMmPerM;
}

void SliceView::scroll(int slices) {
  if (!volume_ || slices == 0) return;
  if (plane_ == Plane::Oblique) return emit depthChanged(slices * step_mm());
  moveCrossTo(cross_mm_ + axes_.normal * (slices * step_mm()));
}

void SliceView::scrollToEnd(bool last) {
  if (!volume_ || plane_ == Plane::Oblique) return;
  const Eigen::Vector3d end = last ? box_mm_.max() : box_mm_.min();
  moveCrossTo(cross_mm_ + axes_.normal * axes_.normal.dot(end - cross_mm_));
}

void SliceView::moveCrossTo(const Eigen::Vector3d& p_W_mm) {
  if (volume_) emit crossMoved(p_W_mm.cwiseMax(box_mm_.min()).cwiseMin(box_mm_.max()));
}

void SliceView::shiftGrey(double level, double width) {
  if (!volume_) return;
  const double full = std::max(volume_->greatest - volume_->least, 1e-6);
  GreyWindow grey = grey_;
  grey.width = std::clamp(grey.width * std::exp(width * 0.01), 1e-4 * full, 2.0 * full);
  grey.level += level * 0.003 * grey.width;
  emit greyChanged(grey);
}

void SliceView::resizeEvent(QResizeEvent*) {
  if (fitted_)
    fitBody();
  else
    changed();
}

void SliceView::addOverlay(Overlay& overlay) {
  overlays_.add(overlay);
  connect(&overlay, &Overlay::changed, this, [this] { emit hintChanged(hint()); });
}

}  // namespace ui
