// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/volume_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr double kContactMark = 5.0;     // px, radius
constexpr double kArrowOfHeight = 0.25;  // of the view's height, for kArrowForce
constexpr double kArrowForce = 5.0;      // N
constexpr double kCaptionMargin = 6.0;   // px

using style::kViewGround;

}  // namespace

void VolumeView::paintGL() {
  Viewport::paintGL();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintOver(painter);
  if (!hasFocus()) return;
  // of the widget alone, and in no picture; as slices show it
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style::kViewFocus, 1.0, Qt::DotLine));
  painter.drawRect(rect().adjusted(1, 1, -2, -2));
}

void VolumeView::paintOver(QPainter& painter) const {
  if (!box_mm_.isEmpty()) {
    if (contacts_shown_) paintContacts(painter);
    overlays_.paint(painter, *geometry_);
    const Eigen::Matrix3d axes = viewAxes();
    if (showsCube())
      OrientationCube::paint(painter, OrientationCube::placeIn(size()), axes, orientation_known_);
    if (!caption_.isEmpty()) paintPlated(painter, caption(), font(), style::kViewText);
    if (orientation_known_)
      for (const PlatedWords& letters : edgeLettersIn(rect(), axes, besideLetters()))
        paintPlated(painter, letters, edgeLetterFont(), style::kLetter);
    else
      paintPlated(painter, unknownSides(), font(), style::kContact);
  } else {
    overlays_.paint(painter, *geometry_);
  }
}

void VolumeView::setCaption(const QString& words, const QString& fewer, const QString& widest) {
  caption_ = words;
  widest_caption_ = widest;
  short_caption_ = fewer;
  update();
}

PlatedWords VolumeView::caption() const {
  const double left = OrientationCube::placeIn(size()).left() - 2.0 * kCaptionMargin;
  const bool fits = plateSize(font(), widest_caption_).width() <= left;
  const QString& words = fits ? caption_ : short_caption_;
  return {words, {{kCaptionMargin, kCaptionMargin}, plateSize(font(), words)}};
}

bool VolumeView::showsCube() const {
  return caption_.isEmpty() ||
         caption().plate.right() + kCaptionMargin <= OrientationCube::placeIn(size()).left();
}

PlatedWords VolumeView::unknownSides() const {
  const QString text = tr("left/right unknown");
  QRectF plate(QPointF{}, plateSize(font(), text));
  plate.moveTopRight(OrientationCube::placeIn(size()).bottomRight());
  return {text, plate};
}

std::vector<QRectF> VolumeView::besideLetters() const {
  std::vector<QRectF> parts = covered_;
  if (showsCube()) parts.push_back(OrientationCube::placeIn(size()));
  if (!caption_.isEmpty())
    parts.push_back(caption().plate.adjusted(0.0, 0.0, kCaptionMargin, kCaptionMargin));
  return parts;
}

std::vector<QRectF> VolumeView::wordBoxes() const {
  if (box_mm_.isEmpty()) return {};
  std::vector<QRectF> boxes;
  if (showsCube()) boxes.push_back(OrientationCube::placeIn(size()));
  if (!caption_.isEmpty()) boxes.push_back(caption().plate);
  if (!orientation_known_) {
    boxes.push_back(unknownSides().plate);
    return boxes;
  }
  for (const PlatedWords& letters : edgeLettersIn(rect(), viewAxes(), besideLetters()))
    boxes.push_back(letters.plate);
  return boxes;
}

void VolumeView::paintContacts(QPainter& painter) const {
  if (!displayed_ || last_.contacts <= 0) return;
  painter.save();
  const auto count = std::min(static_cast<std::size_t>(last_.contacts), last_.places.size());
  haptics::Vec3 middle = haptics::Vec3::Zero();
  double pushed = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const haptics::ContactPlace& place = last_.places[i];
    const haptics::Vec3 p_W{place.p_W[0], place.p_W[1], place.p_W[2]};
    middle += (place.push + 1e-6) * p_W;
    pushed += place.push + 1e-6;
    painter.setPen(QPen(kViewGround, 3.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(projected(p_W), kContactMark, kContactMark);
    painter.setPen(QPen(style::kContact, 1.5));
    painter.drawEllipse(projected(p_W), kContactMark, kContactMark);
  }
  const haptics::Vec3& force = last_.felt_W.force;
  if (force.norm() > kLeastForce && pushed > 0.0) {
    middle /= pushed;
    const double height_m = camera_.mmPerPixel(middle * kMmPerM) * height() / kMmPerM;
    const double share = std::min(force.norm() / kArrowForce, 2.0) * kArrowOfHeight;
    const QPointF foot = projected(middle);
    const QPointF head = projected(middle + force.normalized() * (share * height_m));
    const double length = std::hypot(head.x() - foot.x(), head.y() - foot.y());
    QPainterPath arrow;
    arrow.moveTo(foot);
    arrow.lineTo(head);
    if (length > 1.0) {
      const QPointF along = (head - foot) / length, aside{-along.y(), along.x()};
      const double barb = std::min(10.0, 0.5 * length);
      arrow.moveTo(head - barb * along + 0.5 * barb * aside);
      arrow.lineTo(head);
      arrow.lineTo(head - barb * along - 0.5 * barb * aside);
    }
    for (const auto& [colour, width] :
         {std::pair{kViewGround, 5.0}, std::pair{style::kForceArrow, 2.5}}) {
      painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(arrow);
    }
    const QString text = tr("%L1 N").arg(force.norm(), 0, 'f', 1);
    QRectF plate(QPointF{}, plateSize(font(), text));
    plate.moveBottomLeft(head + QPointF{8.0, -2.0});
    // the card has it, too
    const std::vector<QRectF> taken = geometry_->taken();
    if (std::ranges::none_of(taken, [&](const QRectF& part) { return part.intersects(plate); }))
      paintPlated(painter, {text, plate}, font(), style::kContact);
  }
  painter.restore();
}

QImage VolumeView::picture(double scale) {
  // what VTK draws in pixels follows
  const float line = tool_.device()->GetProperty()->GetLineWidth();
  const auto ratio = static_cast<float>(scale / devicePixelRatioF());
  tool_.device()->GetProperty()->SetLineWidth(line * ratio);
  forgetDrawn();
  QImage image = drawnAt((QSizeF(size()) * scale).toSize());
  tool_.device()->GetProperty()->SetLineWidth(line);
  redrawSurface();
  if (image.isNull()) return image;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  painter.setFont(font());
  paintOver(painter);
  if (const QString note = overlays_.note(); !note.isEmpty())
    paintPlated(
        painter,
        {note, {{6.0, height() - 6.0 - plateSize(font(), note).height()}, plateSize(font(), note)}},
        font(), style::kContact);
  return image;
}

}  // namespace ui
