// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/volume_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "ui/props/held_pass.h"
#include "ui/props/veil_pass.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr double kContactMark = 5.0;     // px, radius
constexpr double kArrowOfHeight = 0.25;  // of the view's height, for kArrowForce
constexpr double kArrowForce = 5.0;      // N

using style::kViewGround;

}  // namespace

void VolumeView::paintGL() {
  Viewport::paintGL();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintOver(painter, size());
  if (!hasFocus()) return;
  // of the widget alone, and in no picture; as slices show it
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style::kViewFocus, 1.0, Qt::DotLine));
  painter.drawRect(rect().adjusted(1, 1, -2, -2));
}

void VolumeView::paintOver(QPainter& painter, const QSizeF& size) const {
  if (!box_mm_.isEmpty()) {
    if (contacts_shown_) paintContacts(painter);
    overlays_.paint(painter, *geometry_);
    const Eigen::Matrix3d axes = viewAxes();
    const QRectF cube = OrientationCube::placeIn(size);
    OrientationCube::paint(painter, cube, axes, orientation_known_);
    if (orientation_known_) {
      paintEdgeLetters(painter, {QPointF{}, size}, axes);
    } else {
      const QString text = tr("left/right unknown");
      const double wide = painter.fontMetrics().horizontalAdvance(text);
      paintOutlined(painter, {size.width() - wide - 10.0, cube.bottom() + 16.0}, painter.font(),
                    style::kContact, text);
    }
  } else {
    overlays_.paint(painter, *geometry_);
  }
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
    paintOutlined(painter, head + QPointF{8.0, -6.0}, painter.font(), style::kContact,
                  tr("%L1 N").arg(force.norm(), 0, 'f', 1));
  }
  painter.restore();
}

QImage VolumeView::picture(double scale) {
  // what VTK draws in pixels follows
  const float line = tool_.device()->GetProperty()->GetLineWidth();
  const auto ratio = static_cast<float>(scale / devicePixelRatioF());
  tool_.device()->GetProperty()->SetLineWidth(line * ratio);
  held_->forget();
  veil_->forget();
  QImage image = drawnAt((QSizeF(size()) * scale).toSize());
  tool_.device()->GetProperty()->SetLineWidth(line);
  redrawSurface();
  if (image.isNull()) return image;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  painter.setFont(font());
  paintOver(painter, size());
  if (const QString note = overlays_.note(); !note.isEmpty())
    paintOutlined(painter, {8.0, height() - 8.0}, font(), style::kContact, note);
  return image;
}

}  // namespace ui
