// SPDX-License-Identifier: BSD-3-Clause
#include "ui/slice_view.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/bindings.h"
#include "ui/lengths.h"
#include "ui/plane_colours.h"
#include "ui/props/contour.h"
#include "ui/props/section.h"
#include "ui/slice_readout.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr int kSideMargin = 28, kEndMargin = 20;  // px, for the letters
constexpr double kRoom = 1.04;                    // of the picture, around a whole slice
constexpr double kObliqueView_mm = 120.0;         // that an oblique view shows at first, at most
constexpr double kFarthest = 0.25;                // least zoom
constexpr double kNearest_px = 60.0;              // for a voxel, at most
constexpr double kZoomNotch = 1.2;
constexpr double kStill_px = 4.0;     // a right button that moved less was clicked
constexpr int kPage = 10;             // slices
constexpr double kPanKey = 24.0;      // px
constexpr int kRestMs = 150;          // without a change: the contour is followed finely
constexpr double kVisible_px = 0.25;  // a tool that moved less is not drawn again
constexpr double kTipRing_px = 4.0;   // radius of what stands for a tool beside the plane
constexpr double kCrossGap = 8.0;     // px, around the crosshair's middle

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

/// Rounded as the voxels' type allows.
QString intensityWords(double value, const haptics::Volume& volume) {
  const bool whole = volume.type != haptics::ScalarType::Float32 || std::abs(value) >= 1000.0;
  const QString number = whole ? readoutLocale().toString(std::round(value) + 0.0, 'f', 0)
                               : readoutLocale().toString(value, 'g', 4);
  return volume.unit.empty() ? number : number + ' ' + QString::fromStdString(volume.unit);
}

double apart_mm(const haptics::Pose& a, const haptics::Pose& b, double radius_mm) {
  return (a.translation() - b.translation()).norm() * kMmPerM +
         (a.linear() - b.linear()).cwiseAbs().maxCoeff() * radius_mm;
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
  changed();
}

void SliceView::show(const Picture& picture) {
  X_WP_.reset();
  X_WD_.reset();
  take(picture);
  resetView();
}

void SliceView::replace(const Picture& picture) { take(picture); }

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
  // a crosshair that was moved elsewhere is looked for
  if (drag_ == Drag::None && volume_ && !QRectF(pictureRect()).contains(projected(cross_mm_))) {
    const Eigen::Vector3d by = cross_mm_ - middle_mm();
    pan_mm_ += Eigen::Vector2d{axes_.right.dot(by), axes_.up.dot(by)};
    changed();
  }
  update();
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

void SliceView::setTouched(const TouchedSurface& touched) {
  touched_ = touched;
  contour_stale_ = true;
  update();
}

void SliceView::setTool(const haptics::Pose& X_WP, const haptics::Pose& X_WD) {
  const double least = kVisible_px * mmPerPixel();
  if (X_WP_ && X_WD_ && apart_mm(*X_WP_, X_WP, tool_radius_mm_) < least &&
      apart_mm(*X_WD_, X_WD, tool_radius_mm_) < least)
    return;
  // what it leaves, and where it comes: the buttons over a slice need not be painted with it
  QRegion painted = toolRect();
  X_WP_ = X_WP;
  X_WD_ = X_WD;
  painted += toolRect();
  update(painted);
}

QRect SliceView::pictureRect() const {
  return rect().adjusted(kSideMargin, kEndMargin, -kSideMargin, -kEndMargin);
}

double SliceView::fittingMmPerPixel() const {
  if (box_mm_.isEmpty()) return 1.0;
  const QRect picture = pictureRect();
  double across = 0.0, upward = 0.0;
  if (plane_ == Plane::Oblique) {  // the same whichever way it lies
    across = upward = std::min(kObliqueView_mm, box_mm_.diagonal().norm());
  } else {
    across = axes_.right.cwiseAbs().dot(box_mm_.sizes());
    upward = axes_.up.cwiseAbs().dot(box_mm_.sizes());
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

void SliceView::resetView() {
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
  zoom_ = allowedZoom(frame.zoom);
  pan_mm_ = frame.shift_mm;
  changed();
}

void SliceView::zoom(double factor, QPointF at) {
  if (!volume_) return;
  const Eigen::Vector3d before = placeUnder(at);
  zoom_ = allowedZoom(zoom_ * factor);
  const Eigen::Vector3d by = before - placeUnder(at);
  pan_mm_ += Eigen::Vector2d{axes_.right.dot(by), axes_.up.dot(by)};
  changed();
}

void SliceView::pan(QPointF by) {
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

Patch SliceView::visiblePatch() const {
  const QRectF picture = pictureRect();
  const Eigen::Vector3d corner = placeUnder(picture.bottomLeft());
  const double scale = mmPerPixel();
  double left = 0.0, right = picture.width() * scale, low = 0.0, high = picture.height() * scale;
  // beyond the voxels the field falls to the background within one
  double most_x = left, least_x = right, most_y = low, least_y = high;
  const haptics::VoxelBox box = volume_->bounds();
  for (int n = 0; n < 8; ++n) {
    haptics::Vec3 index;
    for (int a = 0; a < 3; ++a)
      index[a] = static_cast<double>((n >> a & 1) != 0 ? box.end[a] : box.first[a] - 1);
    const Eigen::Vector3d p = volume_->grid.worldOf(index) * kMmPerM - corner;
    least_x = std::min(least_x, axes_.right.dot(p));
    most_x = std::max(most_x, axes_.right.dot(p));
    least_y = std::min(least_y, axes_.up.dot(p));
    most_y = std::max(most_y, axes_.up.dot(p));
  }
  left = std::max(left, least_x);
  right = std::min(right, most_x);
  low = std::max(low, least_y);
  high = std::min(high, most_y);
  return {.corner_W_mm = corner + axes_.right * left + axes_.up * low,
          .right = axes_.right,
          .up = axes_.up,
          .width_mm = right - left,
          .height_mm = high - low};
}

void SliceView::makeContour() {
  // one change may be fine; those that follow soon are coarse until there is rest
  contour_coarse_ = contour_age_.isValid() && contour_age_.elapsed() < kRestMs;
  contour_age_.start();
  if (contour_coarse_)
    refine_.start();
  else
    refine_.stop();
  const double voxel_mm = volume_->grid.spacing.minCoeff() * kMmPerM;
  double step_mm = std::min(voxel_mm, std::max(2.0 * mmPerPixel(), 0.25 * voxel_mm));
  if (contour_coarse_) step_mm = std::max(2.0 * step_mm, 3.0 * mmPerPixel());
  *patch_ = visiblePatch();
  contour_ = contourOf(touched_.value, isovalue_, *patch_,
                       {.step_mm = step_mm, .voxel_mm = voxel_mm, .bent = !contour_coarse_});
}

void SliceView::drawContour(double scale) {
  contour_image_ = QImage(image_.size(), QImage::Format_ARGB32_Premultiplied);
  contour_image_.setDevicePixelRatio(scale);
  contour_image_.fill(Qt::transparent);
  QPainter painter(&contour_image_);
  painter.setRenderHint(QPainter::Antialiasing);
  // finer than a slice's structures where they are small
  const double voxel_px = volume_->grid.spacing.minCoeff() * kMmPerM / mmPerPixel();
  painter.setPen(QPen(style::kContour, std::clamp(voxel_px, 0.6, 1.25)));
  const QPointF origin = projected(patch_->corner_W_mm) - pictureRect().topLeft();
  const double px = 1.0 / mmPerPixel();
  std::vector<QLineF> lines;
  lines.reserve(contour_.size());
  for (const QLineF& piece : contour_)
    lines.emplace_back(origin.x() + piece.x1() * px, origin.y() - piece.y1() * px,
                       origin.x() + piece.x2() * px, origin.y() - piece.y2() * px);
  painter.drawLines(lines.data(), static_cast<int>(lines.size()));
}

std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> SliceView::contour_W_mm() const {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> pieces;
  for (const QLineF& piece : contour_)
    pieces.emplace_back(patch_->at(piece.p1()), patch_->at(piece.p2()));
  return pieces;
}

QImage SliceView::picture(int scale) {
  QImage image(size() * scale, QImage::Format_RGB32);
  if (image.isNull()) return image;
  image.setDevicePixelRatio(scale);
  QPainter painter(&image);
  painter.setFont(font());
  draw(painter);
  painter.end();
  image.setDevicePixelRatio(1.0);
  return image;
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
  if (!hasFocus() || slice_.empty()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colourOf(plane_), 1.0, Qt::DotLine));
  painter.drawRect(pictureRect());
}

void SliceView::draw(QPainter& painter) {
  painter.fillRect(rect(), style::kSliceGround);
  const QRect picture = pictureRect();
  if (slice_.empty() || picture.isEmpty()) return;
  // of the screen, or of a picture that is taken
  const double scale = painter.deviceTransform().m11();
  if (stale_ || scale != image_.devicePixelRatio()) {
    const QSize pixels{qRound(picture.width() * scale), qRound(picture.height() * scale)};
    slice_.cut(axes_, middle_mm(), pixels, mmPerPixel() / scale, look_);
    stale_ = false;
    grey_stale_ = true;
  }
  if (grey_stale_) {
    image_ = slice_.picture(grey_);
    image_.setDevicePixelRatio(scale);
    grey_stale_ = false;
  }
  painter.setClipRect(picture);
  painter.drawImage(picture.topLeft(), image_);
  if (contour_shown_ && touched_.value) {
    if (contour_stale_) makeContour();
    if (contour_stale_ || scale != contour_image_.devicePixelRatio()) drawContour(scale);
    contour_stale_ = false;
    painter.drawImage(picture.topLeft(), contour_image_);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  drawCrossedPlanes(painter);
  drawTool(painter);
  // below the overlays: a handle at the border of the picture is not crossed by it
  painter.setRenderHint(QPainter::Antialiasing, false);
  drawRuler(painter, mmPerPixel(), picture);
  painter.setRenderHint(QPainter::Antialiasing);
  overlays_.paint(painter, *geometry_);
  painter.setClipping(false);
  painter.setRenderHint(QPainter::Antialiasing, false);
  drawReadout(painter, readout(), rect(), picture);
}

void SliceView::drawCrossedPlanes(QPainter& painter) const {
  const QRectF picture = pictureRect();
  const QPointF cross = projected(cross_mm_);
  const double reach = picture.width() + picture.height();
  for (const CrossedPlane& plane : crossed_) {
    // n . (p - through) = 0 in the picture's own axes
    const Eigen::Vector2d n{plane.normal_W.dot(axes_.right), plane.normal_W.dot(axes_.up)};
    if (n.norm() < 0.05) continue;
    const Eigen::Vector3d middle = middle_mm();
    const double off_mm = plane.normal_W.dot(plane.through_W_mm - middle) / n.squaredNorm();
    const QPointF foot =
        projected(middle + axes_.right * (n.x() * off_mm) + axes_.up * (n.y() * off_mm));
    const Eigen::Vector2d unit = n.normalized();
    const QPointF along{unit.y(), unit.x()};  // widget's y goes down
    const double at = QPointF::dotProduct(cross - foot, along);
    const QPointF nearest = foot + along * at;
    const bool meets = std::hypot(nearest.x() - cross.x(), nearest.y() - cross.y()) < 2.0;
    const double gap = meets ? kCrossGap : 0.0;
    QColor colour = plane.colour;
    colour.setAlpha(200);
    painter.setPen(QPen(colour, 1.0));
    painter.drawLine(nearest + along * gap, nearest + along * reach);
    painter.drawLine(nearest - along * gap, nearest - along * reach);
  }
}

SliceView::ToolLines SliceView::toolLines() const {
  ToolLines lines;
  if (!X_WP_ || !X_WD_) return lines;
  const double px = 1.0 / mmPerPixel();
  const Eigen::Vector3d middle = middle_mm();
  const QPointF centre = QRectF(pictureRect()).center();
  const auto outline = [&](const haptics::Pose& X) {
    std::vector<QPolygonF> drawn;
    if (!mesh_) return drawn;
    for (const QPolygonF& line : sectionOf(*mesh_, X, axes_, middle)) {
      QPolygonF& polygon = drawn.emplace_back();
      for (const QPointF& p : line)
        polygon << QPointF{centre.x() + p.x() * px, centre.y() - p.y() * px};
    }
    return drawn;
  };
  if (apart_mm(*X_WP_, *X_WD_, tool_radius_mm_) > mmPerPixel()) lines.device = outline(*X_WD_);
  lines.proxy = outline(*X_WP_);
  if (!lines.proxy.empty()) return lines;
  // the tool lies in front of the plane or behind it: where its tip is
  const Eigen::Vector3d tip =
      (mesh_ ? Eigen::Vector3d{*X_WP_ * tipOf(*mesh_)} : Eigen::Vector3d{X_WP_->translation()}) *
      kMmPerM;
  lines.tip = projected(tip);
  return lines;
}

QRect SliceView::toolRect() const {
  const ToolLines lines = toolLines();
  QRectF around;
  for (const auto* outlines : {&lines.proxy, &lines.device})
    for (const QPolygonF& line : *outlines) {
      const QRectF box = line.boundingRect();
      // a line along an axis has an empty box, which would not count
      around |= box.adjusted(-1.0, -1.0, 1.0, 1.0);
    }
  if (lines.tip)
    around |=
        QRectF{*lines.tip, QSizeF{}}.adjusted(-kTipRing_px, -kTipRing_px, kTipRing_px, kTipRing_px);
  return around.isNull() ? QRect{} : around.toAlignedRect().adjusted(-2, -2, 2, 2) & pictureRect();
}

void SliceView::drawTool(QPainter& painter) const {
  const ToolLines lines = toolLines();
  painter.setPen(QPen(style::kDeviceLine, 1.25, Qt::DashLine));
  for (const QPolygonF& line : lines.device) painter.drawPolyline(line);
  painter.setPen(QPen(style::kProxyLine, 1.5));
  for (const QPolygonF& line : lines.proxy) painter.drawPolyline(line);
  if (!lines.tip) return;
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(*lines.tip, kTipRing_px, kTipRing_px);
}

SliceReadout SliceView::readout() const {
  SliceReadout readout{.name = name_, .colour = colourOf(plane_)};
  if (!volume_) return readout;
  readout.sides_known = volume_->orientation_known;
  if (readout.sides_known) readout.letters = lettersOf(axes_);
  readout.place = place_;
  if (plane_ != Plane::Oblique) {
    int along = 0;
    axes_.normal.cwiseAbs().maxCoeff(&along);
    const QString mm =
        positionWords(through_mm_, along, volume_->orientation_known) + ' ' + lengthUnitName();
    const std::optional<int> axis = gridAxis();
    readout.place = mm;
    if (axis) {
      const double index = volume_->grid.indexOf(through_mm_ / kMmPerM)[*axis];
      readout.place = QStringLiteral("%1 / %2   %3")
                          .arg(std::lround(index) + 1)
                          .arg(volume_->grid.dims[static_cast<std::size_t>(*axis)])
                          .arg(mm);
    }
  }
  if (look_.slab != SlabKind::None)
    readout.slab =
        (look_.slab == SlabKind::Maximum ? tr("maximum of %1") : tr("mean of %1"))
            .arg(readoutLocale().toString(look_.thickness_mm / mmPerLengthUnit(), 'g', 3) + ' ' +
                 lengthUnitName());
  const int digits = std::abs(grey_.width) < 10.0 ? 2 : 0;
  readout.grey = tr("W %1  L %2")
                     .arg(readoutLocale().toString(grey_.width, 'f', digits),
                          readoutLocale().toString(grey_.level, 'f', digits));
  if (hover_ && QRectF(pictureRect()).contains(*hover_)) {
    const double scale = image_.devicePixelRatio();
    const QPointF at = (*hover_ - pictureRect().topLeft()) * scale;
    const std::optional<double> value =
        slice_.valueAt({static_cast<int>(at.x()), static_cast<int>(at.y())});
    if (value) {
      readout.value = intensityWords(*value, *volume_);
      readout.position = positionWords(placeUnder(*hover_), volume_->orientation_known);
    }
  }
  return readout;
}

void SliceView::resizeEvent(QResizeEvent*) { changed(); }

void SliceView::mousePressEvent(QMouseEvent* event) {
  last_mouse_ = event->position();
  dragged_ = false;
  drag_ = Drag::None;
  if (overlays_.press(*geometry_, *event)) return;
  if (event->button() == Qt::MiddleButton ||
      (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier) != 0)) {
    drag_ = Drag::Pan;
  } else if (event->button() == Qt::LeftButton) {
    drag_ = Drag::Cross;
    moveCrossTo(placeUnder(event->position()));
  } else if (event->button() == Qt::RightButton) {
    drag_ = Drag::Grey;
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_mouse_;
  hover_ = event->position();
  update();
  // until then last_mouse_ is where the button was pressed
  if (drag_ == Drag::Grey && !dragged_ && std::hypot(by.x(), by.y()) < kStill_px) return;
  last_mouse_ = event->position();
  if (overlays_.move(*geometry_, *event)) return;
  if (event->buttons() == Qt::NoButton || by.isNull()) return;
  dragged_ = true;
  switch (drag_) {
    case Drag::Cross:
      return moveCrossTo(placeUnder(event->position()));
    case Drag::Pan:
      return pan(by);
    case Drag::Grey:
      return shiftGrey(-by.y(), by.x());
    case Drag::None:
      break;
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = drag_ == Drag::Grey && !dragged_;
  drag_ = Drag::None;
  if (overlays_.release(*geometry_, *event)) return;
  if (clicked) emit menuWanted(event->globalPosition().toPoint());
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (overlays_.doubleClick(*geometry_, *event)) return;
  if (event->button() == Qt::LeftButton && volume_ && (event->modifiers() & Qt::ShiftModifier) == 0)
    emit doubleClicked(placeUnder(event->position()));
  else
    mousePressEvent(event);
}

void SliceView::contextMenuEvent(QContextMenuEvent* event) {
  // the mouse's comes with its release: a drag is no wish for a menu
  const QKeyEvent key(QEvent::KeyPress, Qt::Key_Menu, Qt::NoModifier);
  const Binding* meaning = meaningOf(Where::Slice, key);
  if (event->reason() == QContextMenuEvent::Keyboard && meaning != nullptr) perform(*meaning);
  event->accept();
}

bool SliceView::perform(const Binding& meaning) {
  const QPointF way = wayOf(meaning);
  const QPointF at = hover_.value_or(QRectF(pictureRect()).center());
  switch (meaning.action) {
    case Action::NextSlice:
      scroll(1);
      break;
    case Action::SliceBefore:
      scroll(-1);
      break;
    case Action::TenSlicesOn:
      scroll(kPage);
      break;
    case Action::TenSlicesBack:
      scroll(-kPage);
      break;
    case Action::FirstSlice:
      scrollToEnd(false);
      break;
    case Action::LastSlice:
      scrollToEnd(true);
      break;
    case Action::Nearer:
      zoom(kZoomNotch, at);
      break;
    case Action::Farther:
      zoom(1.0 / kZoomNotch, at);
      break;
    case Action::ShowEverything:
      resetView();
      emit resetWanted();
      break;
    case Action::Pan:
      pan(way * -kPanKey);
      break;
    case Action::Grey:
      shiftGrey(-10.0 * way.y(), 10.0 * way.x());
      break;
    case Action::MoveCross:
      moveCrossTo(cross_mm_ + (axes_.right * way.x() - axes_.up * way.y()) *
                                  (volume_ ? volume_->grid.spacing.minCoeff() * kMmPerM : 1.0));
      break;
    case Action::ToolToCross:
      emit toolToCrossWanted();
      break;
    case Action::CrossToTool:
      emit crossToToolWanted();
      break;
    case Action::SliceMenu:
      emit menuWanted(mapToGlobal(pictureRect().center()));
      break;
    default:
      return false;
  }
  return true;
}

void SliceView::addOverlay(Overlay& overlay) {
  overlays_.add(overlay);
  connect(&overlay, &Overlay::changed, this, [this] { emit hintChanged(hint()); });
}

QString SliceView::hint() const {
  const QString over = overlays_.hint();
  if (!over.isEmpty()) return over;
  return tr(
      "Wheel: slices. Drag: crosshair. Right drag: brightness, contrast. Ctrl and wheel: "
      "nearer. Middle drag: shifts.");
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (overlays_.key(*geometry_, *event, projected(cross_mm_))) return;
  // Qt's own wish for a menu comes beside the menu key
  const bool wish = event->key() == Qt::Key_Menu;
  const Binding* meaning = meaningOf(Where::Slice, *event);
  if (wish || meaning == nullptr || !perform(*meaning)) QWidget::keyPressEvent(event);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if ((event->modifiers() & Qt::ControlModifier) != 0)
    return zoom(
        std::pow(kZoomNotch, (mouse_.zoom_reversed ? -1 : 1) * event->angleDelta().y() / 120.0),
        event->position());
  // whole slices: a touch pad sends parts of a notch
  wheel_ += (mouse_.slices_reversed ? -1 : 1) * event->angleDelta().y();
  const int notches = wheel_ / 120;
  wheel_ -= notches * 120;
  scroll(notches);
}

void SliceView::leaveEvent(QEvent*) {
  hover_.reset();
  update();
}

}  // namespace ui
