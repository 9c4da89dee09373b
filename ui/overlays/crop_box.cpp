// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/crop_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/overlays/marks_style.h"
#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

/// The corners of a face, in order around it.
std::array<Eigen::Vector3d, 4> faceOf(const BoxCorners& corners, int axis, bool far_side) {
  const std::size_t side = far_side ? std::size_t{1} << axis : 0;
  const std::size_t u = std::size_t{1} << ((axis + 1) % 3), v = std::size_t{1} << ((axis + 2) % 3);
  return {corners[side], corners[side | u], corners[side | u | v], corners[side | v]};
}

/// Where a slice cuts a face; none: it does not.
std::optional<std::array<Eigen::Vector3d, 2>> cutOf(const ViewGeometry& view,
                                                    const std::array<Eigen::Vector3d, 4>& face) {
  std::array<Eigen::Vector3d, 2> ends;
  std::size_t found = 0;
  for (std::size_t n = 0; n < 4; ++n) {
    const Eigen::Vector3d &p = face[n], &q = face[(n + 1) % 4];
    const double a = view.offset_mm(p), b = view.offset_mm(q);
    if ((a < 0.0) == (b < 0.0)) continue;
    if (found < 2) ends[found] = p + (q - p) * (a / (a - b));
    ++found;
  }
  if (found != 2) return {};
  return ends;
}

/// The place of a line that stands for it in a view: the middle of what is seen of it, or what is
/// nearest to the middle of the view.
Eigen::Vector3d middleSeen(const ViewGeometry& view, const std::array<Eigen::Vector3d, 2>& line) {
  const QRectF room = view.room();
  const QPointF p = view.projected(line[0]), by = view.projected(line[1]) - p;
  double first = 0.0, last = 1.0;
  const auto keep = [&](double start, double step, double low, double high) {
    if (std::abs(step) < 1e-9) {
      if (start < low || start > high) last = -1.0;
      return;
    }
    const auto [in, out] = std::minmax({(low - start) / step, (high - start) / step});
    first = std::max(first, in);
    last = std::min(last, out);
  };
  keep(p.x(), by.x(), room.left(), room.right());
  keep(p.y(), by.y(), room.top(), room.bottom());
  double at = 0.5 * (first + last);
  if (first > last) {
    const double length = QPointF::dotProduct(by, by);
    at = length > 0.0 ? QPointF::dotProduct(room.center() - p, by) / length : 0.5;
    at = std::clamp(at, 0.0, 1.0);
  }
  return line[0] + (line[1] - line[0]) * at;
}

/// The same place, or beside it so that its handle is seen whole. None: it lies behind the viewer.
std::optional<Eigen::Vector3d> within(const ViewGeometry& view, const Eigen::Vector3d& p_mm) {
  if (!view.isSlice()) {
    const Projection camera = projectionOf(view);
    if (!camera.parallel && !(camera.depthOf(p_mm) > 1.0)) return {};
  }
  const QRectF room = view.room().adjusted(kHandleRoom, kHandleRoom, -kHandleRoom, -kHandleRoom);
  const QPointF at = view.projected(p_mm);
  if (room.isEmpty() || room.contains(at)) return p_mm;
  return view.placeBeside({std::clamp(at.x(), room.left(), room.right()),
                           std::clamp(at.y(), room.top(), room.bottom())},
                          p_mm);
}

}  // namespace

void CropBox::show(const haptics::Grid& grid, const haptics::VoxelBox& box) {
  grid_ = grid;
  box_ = box;
  held_.reset();
  emit changed();
}

void CropBox::hide() {
  grid_.reset();
  held_.reset();
  emit changed();
}

std::optional<Eigen::Vector3d> CropBox::handleOf(const ViewGeometry& view, int axis,
                                                 bool far_side) const {
  if (!grid_) return {};
  const auto face = faceOf(cornersOf_mm(*grid_, box_), axis, far_side);
  if (!view.isSlice()) return within(view, 0.25 * (face[0] + face[1] + face[2] + face[3]));
  const auto cut = cutOf(view, face);
  if (!cut) return {};
  return within(view, middleSeen(view, *cut));
}

std::int64_t& CropBox::edgeOf(const Face& face) {
  const auto axis = static_cast<std::size_t>(face.axis);
  return face.far_side ? box_.end[axis] : box_.first[axis];
}

void CropBox::paint(QPainter& painter, const ViewGeometry& view) const {
  if (!grid_) return;
  const BoxCorners corners = cornersOf_mm(*grid_, box_);
  bool met = !view.isSlice();
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far_side : {false, true}) {
      const auto face = faceOf(corners, axis, far_side);
      if (view.isSlice()) {
        const auto cut = cutOf(view, face);
        if (!cut) continue;
        met = true;
        painter.setPen(QPen(style::kOutline, 1.5));
        painter.drawLine(view.projected((*cut)[0]), view.projected((*cut)[1]));
        continue;
      }
      // each edge belongs to two faces; what looks away is fainter
      const Eigen::Vector3d out = grid_->direction.col(axis) * (far_side ? 1.0 : -1.0);
      Eigen::Vector3d from, along;
      view.sight(view.projected(face[0]), from, along);
      const bool front = out.dot(along) < 0.0;
      QColor colour = style::kOutline;
      colour.setAlpha(front ? 255 : 90);
      painter.setPen(QPen(colour, front ? 1.6 : 1.0));
      for (std::size_t n = 0; n < 4; ++n)
        painter.drawLine(view.projected(face[n]), view.projected(face[(n + 1) % 4]));
    }
  if (!met) {
    // beside the slice: where it lies, without handles
    painter.setPen(QPen(style::kOutline, 1.0, Qt::DashLine));
    for (const bool far_side : {false, true})
      for (int axis = 0; axis < 3; ++axis) {
        const auto face = faceOf(corners, axis, far_side);
        for (std::size_t n = 0; n < 4; ++n)
          painter.drawLine(view.projected(face[n]), view.projected(face[(n + 1) % 4]));
      }
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far_side : {false, true})
      if (const auto handle = handleOf(view, axis, far_side))
        drawHandle(painter, view.projected(*handle), style::kOutline,
                   held_ == Face{axis, far_side});
}

std::optional<CropBox::Face> CropBox::faceAt(const ViewGeometry& view, QPointF at) const {
  if (!grid_) return {};
  std::optional<Face> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far_side : {false, true}) {
      const auto handle = handleOf(view, axis, far_side);
      if (!handle || !isNear(view.projected(*handle), at)) continue;
      // of two that lie behind each other, the one in front
      Eigen::Vector3d from, along;
      view.sight(at, from, along);
      const double depth = along.dot(*handle - from);
      if (depth >= nearest) continue;
      nearest = depth;
      found = Face{axis, far_side};
    }
  return found;
}

QString CropBox::hint() const {
  return isShown() ? tr("Drag a handle: moves a face of the crop box. Escape: ends.") : QString();
}

bool CropBox::press(const ViewGeometry& view, const QMouseEvent& event) {
  if (!isPlainLeft(event)) return false;
  const auto face = faceAt(view, event.position());
  if (!face) return false;
  const auto handle = handleOf(view, face->axis, face->far_side);
  const auto grip = alongLine(view, event.position(), *handle, grid_->direction.col(face->axis));
  if (!grip) return false;
  held_ = face;
  held_at_ = *handle;
  held_edge_ = edgeOf(*face);
  grip_mm_ = *grip;
  emit changed();
  return true;
}

bool CropBox::drag(const ViewGeometry& view, const QMouseEvent& event) {
  if (!held_ || !grid_) return true;
  const int axis = held_->axis;
  const auto at = alongLine(view, event.position(), held_at_, grid_->direction.col(axis));
  if (!at) return true;
  const auto a = static_cast<std::size_t>(axis);
  const std::int64_t edge =
      held_edge_ + std::llround((*at - grip_mm_) / (grid_->spacing[axis] * kMmPerM));
  const std::int64_t kept = held_->far_side ? std::clamp(edge, box_.first[a] + 1, grid_->dims[a])
                                            : std::clamp<std::int64_t>(edge, 0, box_.end[a] - 1);
  if (kept == edgeOf(*held_)) return true;
  edgeOf(*held_) = kept;
  emit changed();
  emit moved();
  return true;
}

bool CropBox::release(const ViewGeometry&, const QMouseEvent&) {
  if (!held_) return true;
  const bool went = edgeOf(*held_) != held_edge_;
  held_.reset();
  emit changed();
  if (went) emit released();
  return true;
}

bool CropBox::hover(const ViewGeometry& view, const QMouseEvent& event) {
  return faceAt(view, event.position()).has_value();
}

}  // namespace ui
