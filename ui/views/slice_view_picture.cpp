// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/controls/lengths.h"
#include "ui/props/contour.h"
#include "ui/props/section.h"
#include "ui/style/scene_colours.h"
#include "ui/views/plane_colours.h"
#include "ui/views/slice_readout.h"

namespace ui {
namespace {

constexpr double kTipRing_px = 4.0;       // radius of what stands for a tool beside the plane
constexpr double kFarthestTip_mm = 30.0;  // from the plane: beyond it nothing is drawn
constexpr double kStructureLine_px = 1.5;
constexpr double kCrossGap = 8.0;  // px, around the crosshair's middle

QString shortNameOf(Plane plane) {
  switch (plane) {
    case Plane::Axial:
      return SliceView::tr("Ax.", "axial");
    case Plane::Coronal:
      return SliceView::tr("Cor.", "coronal");
    case Plane::Sagittal:
      return SliceView::tr("Sag.", "sagittal");
    case Plane::Oblique:
      break;
  }
  return SliceView::tr("Tool");
}

}  // namespace

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

void SliceView::drawStructures(double scale) {
  structure_cut_.cut(*structures_.map, axes_, middle_mm(), image_.size(), mmPerPixel() / scale);
  structures_image_ =
      structure_cut_.picture(structures_, std::max(1, qRound(kStructureLine_px * scale)));
  structures_image_.setDevicePixelRatio(scale);
  structures_stale_ = false;
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
  draw(painter, overlays_.note());
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

void SliceView::draw(QPainter& painter, const QString& note) {
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
    structures_stale_ = true;
    body_before_.clear();
  }
  if (grey_stale_) {
    image_ = slice_.picture(grey_);
    image_.setDevicePixelRatio(scale);
    grey_stale_ = false;
  }
  painter.setClipRect(picture);
  painter.drawImage(picture.topLeft(), image_);
  const auto lay_structures = [&] {
    if (!structures_.map) return;
    if (structures_stale_) drawStructures(scale);
    painter.drawImage(picture.topLeft(), structures_image_);
  };
  // an outline that runs along the bone is seen on its contour, a fill below it
  if (structures_.filled) lay_structures();
  if (contour_shown_ && touched_.value) {
    if (contour_stale_) makeContour();
    if (contour_stale_ || scale != contour_image_.devicePixelRatio()) drawContour(scale);
    contour_stale_ = false;
    painter.drawImage(picture.topLeft(), contour_image_);
  }
  if (!structures_.filled) lay_structures();
  painter.setRenderHint(QPainter::Antialiasing);
  drawCrossedPlanes(painter);
  drawTool(painter);
  overlays_.paint(painter, *geometry_);
  painter.setClipping(false);
  painter.setRenderHint(QPainter::Antialiasing, false);
  drawReadout(painter, readoutLayout(note));
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
  if (apart_mm(*X_WP_, *X_WD_) > mmPerPixel()) lines.device = outline(*X_WD_);
  lines.proxy = outline(*X_WP_);
  if (!lines.proxy.empty()) return lines;
  // the tool lies in front of the plane or behind it: where its tip is
  const Eigen::Vector3d tip =
      (mesh_ ? Eigen::Vector3d{*X_WP_ * tipOf(*mesh_)} : Eigen::Vector3d{X_WP_->translation()}) *
      kMmPerM;
  if (std::abs(axes_.normal.dot(tip - middle)) <= kFarthestTip_mm) lines.tip = projected(tip);
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
  // off the plane: dashed, as marks are
  QPen dashed(style::kProxyLine, 1.0, Qt::SolidLine, Qt::FlatCap);
  dashed.setDashPattern({2.0, 2.0});
  painter.setPen(dashed);
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(*lines.tip, kTipRing_px, kTipRing_px);
}

SliceReadout SliceView::readout() const {
  SliceReadout readout{
      .name = name_, .short_name = shortNameOf(plane_), .colour = colourOf(plane_)};
  if (!volume_) return readout;
  readout.sides_known = volume_->orientation_known;
  if (readout.sides_known) readout.letters = lettersOf(axes_);
  readout.place = place_;
  if (plane_ != Plane::Oblique) {
    int along = 0;
    axes_.normal.cwiseAbs().maxCoeff(&along);
    const QString mm = positionWords(through_mm_, along) + ' ' + lengthUnitName();
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
        (look_.slab == SlabKind::Maximum   ? tr("maximum of %1")
         : look_.slab == SlabKind::Minimum ? tr("minimum of %1")
                                           : tr("mean of %1"))
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
      readout.structures = structures_.namesAt(placeUnder(*hover_));
      readout.position = positionWords(placeUnder(*hover_), volume_->orientation_known);
    }
  }
  return readout;
}

}  // namespace ui
