// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/lasso.h"

#include <QKeyEvent>
#include <QLineF>
#include <QRectF>
#include <cmath>
#include <utility>

#include "ui/overlays/marks_style.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr double kLeastStep = 2.0;   // pixels between two corners of a drag
constexpr double kSameCorner = 4.0;  // pixels
constexpr qsizetype kMostCorners = 2'000;
constexpr double kLeastArea = 60.0;  // square pixels
constexpr int kProbes = 5;           // along each side of the outline's box

double areaOf(const QPolygonF& line) {
  double twice = 0.0;
  for (qsizetype n = 0; n < line.size(); ++n) {
    const QPointF p = line[n], q = line[(n + 1) % line.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

void Lasso::setActive(bool active) {
  active_ = active;
  asks_ = false;
  line_.clear();
  corners_mm_.clear();
  on_ = nullptr;
  emit changed();
}

void Lasso::setAsks(bool asks) {
  if (asks == asks_) return;
  asks_ = asks;
  emit changed();
}

void Lasso::paint(QPainter& painter, const ViewGeometry& view) const {
  if (on_ != &view.widget()) return;
  const QPolygonF corners = cornersIn(view);
  for (const QPointF corner : corners) drawHandle(painter, corner, style::kGoes, false);
  const QPolygonF& line = corners.isEmpty() ? line_ : corners;
  if (line.size() < 2) return;
  QColor fill = style::kGoes;
  fill.setAlpha(50);
  painter.setPen(QPen(style::kGoes, 1.8));
  painter.setBrush(fill);
  painter.drawPolygon(line);
}

QPolygonF Lasso::cornersIn(const ViewGeometry& view) const {
  QPolygonF corners;
  for (const Eigen::Vector3d& corner : corners_mm_) corners << view.projected(corner);
  return corners;
}

/// Adds a corner, or closes the outline if it is where the last one is.
void Lasso::setCorner(const ViewGeometry& view, QPointF at) {
  const QPolygonF corners = cornersIn(view);
  if (!corners.isEmpty() && QLineF(corners.last(), at).length() < kSameCorner) {
    corners_mm_.clear();
    on_ = nullptr;
    emit changed();
    return cut(view, corners);
  }
  const Eigen::Vector3d beside =
      corners_mm_.empty() ? Eigen::Vector3d::Zero().eval() : corners_mm_.front();
  const auto place = view.isSlice() ? view.placeUnder(at) : view.placeBeside(at, beside);
  if (place) corners_mm_.push_back(*place);
  emit changed();
}

bool Lasso::press(const ViewGeometry& view, const QMouseEvent& event) {
  if (!active_ || !isPlainLeft(event)) return false;
  if (on_ != &view.widget()) corners_mm_.clear();
  on_ = &view.widget();
  line_ = {event.position()};
  return true;
}

bool Lasso::drag(const ViewGeometry&, const QMouseEvent& event) {
  if (line_.isEmpty()) return true;
  const QPointF by = event.position() - line_.last();
  if (QPointF::dotProduct(by, by) < kLeastStep * kLeastStep) return true;
  corners_mm_.clear();
  line_ << event.position();
  emit changed();
  return true;
}

bool Lasso::release(const ViewGeometry& view, const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || line_.isEmpty()) return true;
  const QPolygonF line = std::exchange(line_, {});
  if (line.size() == 1) {
    setCorner(view, line.first());
    return true;
  }
  on_ = nullptr;
  emit changed();
  cut(view, line);
  return true;
}

void Lasso::cut(const ViewGeometry& view, const QPolygonF& line) {
  if (line.size() < 3 || areaOf(line) < kLeastArea) return;
  DrawnOutline outline;
  outline.camera = projectionOf(view);
  outline.in_slice = view.isSlice();
  // of a very long line every n-th corner
  const qsizetype step = line.size() / kMostCorners + 1;
  for (qsizetype n = 0; n < line.size(); n += step)
    outline.corners.push_back(outline.camera.acrossOf(line[n]));
  if (!outline.in_slice) {
    const QRectF box = line.boundingRect();
    for (int row = 0; row < kProbes; ++row)
      for (int column = 0; column < kProbes; ++column) {
        const QPointF at{box.left() + box.width() * (column + 0.5) / kProbes,
                         box.top() + box.height() * (row + 0.5) / kProbes};
        if (!line.containsPoint(at, Qt::OddEvenFill)) continue;
        if (const auto place = view.placeUnder(at)) outline.seen.push_back(*place);
      }
  }
  emit drawn(outline);
}

bool Lasso::key(const ViewGeometry&, const QKeyEvent& event) {
  const Binding* meaning = meaningOf(Where::View, event, Gesture::Key, Over::Editing);
  if (active_ && asks_ && meaning != nullptr && meaning->action == Action::SetPlaceOfEdit) {
    emit confirmed();
    return true;
  }
  const bool back = meaning != nullptr && meaning->action == Action::TakeCornerBack;
  if (!active_ || !back || corners_mm_.empty()) return false;
  corners_mm_.pop_back();
  emit changed();
  return true;
}

QString Lasso::hint() const {
  if (!active_) return {};
  if (asks_)
    return tr("%1: cuts what is hatched. Escape: keeps it. Drag: draws another outline.")
        .arg(keyOf(Action::SetPlaceOfEdit));
  return tr("Drag: draws the outline of a cut. Or click, or %1 at the crosshair: sets a corner; "
            "at the last one again: closes it. %2: takes it back.")
      .arg(keyOf(Action::SetPlaceOfEdit), keyOf(Action::TakeCornerBack));
}

bool Lasso::hover(const ViewGeometry& view, const QMouseEvent&) {
  return active_ && !view.isSlice();
}

void PlacePick::setActive(bool active) {
  active_ = active;
  emit changed();
}

bool PlacePick::press(const ViewGeometry& view, const QMouseEvent& event) {
  if (!active_ || !isPlainLeft(event)) return false;
  const auto place = view.placeUnder(event.position());
  if (!place) return false;  // beside the surface: the picture may be turned
  emit picked(*place);
  return true;
}

QString PlacePick::hint() const {
  return active_ ? tr("Click a piece, or %1 at the crosshair: shows it. Escape: ends.")
                       .arg(keyOf(Action::SetPlaceOfEdit))
                 : QString();
}

bool PlacePick::drag(const ViewGeometry&, const QMouseEvent&) { return true; }
bool PlacePick::release(const ViewGeometry&, const QMouseEvent&) { return true; }

bool PlacePick::hover(const ViewGeometry& view, const QMouseEvent&) {
  return active_ && !view.isSlice();
}

}  // namespace ui
