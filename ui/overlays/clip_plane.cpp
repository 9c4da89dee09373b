// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/clip_plane.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/overlays/marks_style.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr double kArm = 60.0;           // pixels from the handle that shifts to the one that turns
constexpr double kFaceOn = 24.0;        // pixels: nearer to each other the handles lie as one
constexpr double kLeastTriangle = 0.5;  // mm: height of the triangle of the clicks
constexpr double kInSlice = 0.15;       // least sine between normal and line of sight

QPolygonF projectedOf(const ViewGeometry& view, const std::vector<Eigen::Vector3d>& polygon) {
  QPolygonF shape;
  for (const Eigen::Vector3d& p : polygon) shape << view.projected(p);
  return shape;
}

}  // namespace

void ClipPlane::begin(const haptics::Grid& grid, const haptics::VoxelBox& within) {
  shown_ = true;
  placed_ = false;
  clicks_.clear();
  held_ = Held::None;
  corners_ = cornersOf_mm(grid, within);
  emit changed();
}

void ClipPlane::place(const Eigen::Vector3d& point_W_mm, const Eigen::Vector3d& normal_W) {
  point_ = point_W_mm;
  normal_ = normal_W.normalized();
  placed_ = true;
  clicks_.clear();
  emit changed();
}

void ClipPlane::hide() {
  shown_ = placed_ = false;
  clicks_.clear();
  held_ = Held::None;
  emit changed();
}

std::vector<Eigen::Vector3d> ClipPlane::outline() const {
  return sectionOf(corners_, point_, normal_);
}

std::optional<ClipPlane::Handles> ClipPlane::handlesIn(const ViewGeometry& view) const {
  if (!shown_ || !placed_) return {};
  const std::vector<Eigen::Vector3d> shape = outline();
  if (shape.empty()) return {};
  if (!view.isSlice()) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : shape) middle += p / static_cast<double>(shape.size());
    const Eigen::Vector3d tip = middle + normal_ * (kArm * view.mmPerPixel(middle));
    const QPointF shift = view.projected(middle);
    if (held_ == Held::Turn && taken_.beside)
      return Handles{middle,
                     view.placeBeside(view.projected(taken_.turn) + dragged_ - pressed_, middle),
                     true};
    const QPointF by = view.projected(tip) - shift;
    const double length = std::hypot(by.x(), by.y());
    if (length >= kFaceOn) return Handles{middle, tip};
    const QPointF to = length > 0.5 * kFaceOn ? by / length : QPointF{0.0, -1.0};
    return Handles{middle, view.placeBeside(shift + to * kArm, middle), true};
  }
  const Eigen::Vector3d towards = view.axes().col(2);
  const Eigen::Vector3d flat = normal_ - towards * towards.dot(normal_);
  if (flat.norm() < kInSlice) return {};
  std::vector<Eigen::Vector3d> ends;
  for (std::size_t n = 0; n < shape.size(); ++n) {
    const Eigen::Vector3d &p = shape[n], &q = shape[(n + 1) % shape.size()];
    const double a = view.offset_mm(p), b = view.offset_mm(q);
    if ((a < 0.0) != (b < 0.0)) ends.emplace_back(p + (q - p) * (a / (a - b)));
  }
  if (ends.size() != 2) return {};
  const Eigen::Vector3d middle = 0.5 * (ends[0] + ends[1]);
  return Handles{middle, middle + flat.normalized() * (kArm * view.mmPerPixel(middle))};
}

void ClipPlane::paint(QPainter& painter, const ViewGeometry& view) const {
  if (!shown_) return;
  if (!placed_) {
    for (const Click& click : clicks_)
      drawHandle(painter, view.projected(click.place), style::kGoes, false);
    return;
  }
  QColor fill = style::kGoes;
  fill.setAlpha(70);
  const std::vector<Eigen::Vector3d> shape = outline();
  if (view.isSlice()) {
    // the part of the slice that goes
    const Eigen::Vector3d towards = view.axes().col(2);
    const Eigen::Vector3d in_plane = point_ - towards * view.offset_mm(point_);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(
        projectedOf(view, clipped(sectionOf(corners_, in_plane, towards), point_, normal_)));
  } else {
    painter.setPen(QPen(style::kGoes, 1.6));
    painter.setBrush(fill);
    painter.drawPolygon(projectedOf(view, shape));
  }
  const auto handles = handlesIn(view);
  if (!handles) return;
  const QPointF shift = view.projected(handles->shift), turn = view.projected(handles->turn);
  if (view.isSlice()) {
    const QPointF across{-(turn - shift).y(), (turn - shift).x()};
    painter.setPen(QPen(style::kGoes, 1.6));
    for (std::size_t n = 0; n < shape.size(); ++n) {
      const Eigen::Vector3d &p = shape[n], &q = shape[(n + 1) % shape.size()];
      const double a = view.offset_mm(p), b = view.offset_mm(q);
      if ((a < 0.0) != (b < 0.0))
        painter.drawLine(shift, view.projected(p + (q - p) * (a / (a - b))));
    }
  }
  painter.setPen(QPen(style::kGoes, 2.0));
  painter.drawLine(shift, turn);
  drawHandle(painter, shift, style::kGoes, held_ == Held::Shift);
  drawHandle(painter, turn, style::kGoes, held_ == Held::Turn);
}

void ClipPlane::setClick(const ViewGeometry& view, const Eigen::Vector3d& at_mm) {
  if (!clicks_.empty() && clicks_.back().place == at_mm) return;  // a double click sets one place
  clicks_.push_back({at_mm, view.isSlice() ? &view.widget() : nullptr,
                     view.isSlice() ? view.offset_mm(Eigen::Vector3d::Zero()) : 0.0});
  emit changed();
  if (clicks_.size() < 3) return emit moved();
  const std::vector<Click> clicks = std::move(clicks_);
  clicks_.clear();
  const Eigen::Vector3d &p = clicks[0].place, &q = clicks[1].place, &r = clicks[2].place;
  const Eigen::Vector3d towards = view.axes().col(2);
  const bool one_slice = std::ranges::all_of(clicks, [&](const Click& click) {
    return click.slice != nullptr && click.slice == clicks[0].slice &&
           std::abs(click.offset_mm - clicks[0].offset_mm) < 1e-3;
  });
  Eigen::Vector3d normal = one_slice ? towards.cross(q - p) : (q - p).cross(r - p);
  const double longest = std::max({(q - p).norm(), (r - p).norm(), (r - q).norm()});
  const double height = (q - p).cross(r - p).norm() / std::max(longest, 1e-9);
  if (height < kLeastTriangle || normal.norm() < 1e-9) {
    emit changed();
    return emit refused(
        tr("The three places lie on one line, which gives no plane; click three others."));
  }
  const Eigen::Vector3d point = one_slice ? (0.5 * (p + q)).eval() : ((p + q + r) / 3.0).eval();
  // the side that goes: the third click's, or the one that the eye is on
  Eigen::Vector3d eye, along;
  view.sight(view.projected(point), eye, along);
  if ((one_slice ? normal.dot(r - p) : -normal.dot(along)) < 0.0) normal = -normal;
  place(point, normal);
  emit moved();
}

QString ClipPlane::hint() const {
  if (!shown_) return {};
  return placed_ ? tr("Drag a handle: shifts or turns the clip plane. Escape: ends.")
                 : tr("Click, or Enter at the crosshair, three times: places the clip plane.");
}

bool ClipPlane::press(const ViewGeometry& view, const QMouseEvent& event) {
  if (!shown_ || !isPlainLeft(event)) return false;
  if (!placed_) {
    const auto place = view.placeUnder(event.position());
    if (!place) return false;  // beside the surface: the picture may be turned
    setClick(view, *place);
    return true;
  }
  const auto handles = handlesIn(view);
  if (!handles) return false;
  held_ = isNear(view.projected(handles->turn), event.position())    ? Held::Turn
          : isNear(view.projected(handles->shift), event.position()) ? Held::Shift
                                                                     : Held::None;
  if (held_ == Held::None) return false;
  taken_ = *handles;
  point_taken_ = point_;
  normal_taken_ = normal_;
  pressed_ = dragged_ = event.position();
  if (held_ == Held::Shift) {
    const auto grip = alongLine(view, event.position(), taken_.shift, normal_);
    if (!grip) {
      held_ = Held::None;
      return false;
    }
    grip_mm_ = *grip;
  }
  emit changed();
  return true;
}

bool ClipPlane::drag(const ViewGeometry& view, const QMouseEvent& event) {
  if (held_ == Held::None) return true;
  dragged_ = event.position();
  if (held_ == Held::Shift) {
    const auto at = alongLine(view, event.position(), taken_.shift, normal_);
    if (!at) return true;
    point_ = point_taken_ + normal_ * (*at - grip_mm_);
  } else if (view.isSlice()) {
    // about the line of sight
    const Eigen::Vector3d towards = view.axes().col(2);
    const Eigen::Vector3d to = view.placeBeside(event.position(), taken_.shift) - taken_.shift;
    const Eigen::Vector3d flat = normal_ - towards * towards.dot(normal_);
    if (to.norm() < 1e-6) return true;
    const double angle = std::atan2(towards.dot(flat.cross(to)), flat.dot(to));
    normal_ = Eigen::AngleAxisd(angle, towards) * normal_;
    point_ = taken_.shift;
  } else if (taken_.beside) {
    // the side towards the viewer follows the pointer
    const QPointF by = dragged_ - pressed_;
    const double length = std::hypot(by.x(), by.y());
    const Eigen::Matrix3d axes = view.axes();
    normal_ = normal_taken_;
    if (length > 0.0) {
      const Eigen::Vector3d to = (axes.col(0) * by.x() - axes.col(1) * by.y()) / length;
      normal_ = Eigen::AngleAxisd(length / kArm, axes.col(2).cross(to)) * normal_taken_;
    }
    point_ = taken_.shift;
  } else {
    // the handle stays on a ball about the other one
    Eigen::Vector3d from, along;
    view.sight(event.position(), from, along);
    const double radius = (taken_.turn - taken_.shift).norm();
    const Eigen::Vector3d foot = from + along * along.dot(taken_.shift - from);
    const Eigen::Vector3d beside = foot - taken_.shift;
    const double half = radius * radius - beside.squaredNorm();
    const bool behind = along.dot(taken_.turn - taken_.shift) > 0.0;
    Eigen::Vector3d to = beside;
    if (half > 0.0) to += along * (behind ? 1.0 : -1.0) * std::sqrt(half);
    if (to.norm() < 1e-6) return true;
    normal_ = to.normalized();
    point_ = taken_.shift;
  }
  emit changed();
  emit moved();
  return true;
}

bool ClipPlane::release(const ViewGeometry&, const QMouseEvent&) {
  held_ = Held::None;
  emit changed();
  return true;
}

bool ClipPlane::hover(const ViewGeometry& view, const QMouseEvent& event) {
  if (!shown_) return false;
  if (!placed_) return !view.isSlice();
  const auto handles = handlesIn(view);
  return handles && (isNear(view.projected(handles->turn), event.position()) ||
                     isNear(view.projected(handles->shift), event.position()));
}

}  // namespace ui
