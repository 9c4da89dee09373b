// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/volume_view.h"

#include <vtkCamera.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/controls/latin_key.h"

namespace ui {
namespace {

constexpr double kHandTurn = 0.008;                 // rad of hand for a pixel
constexpr double kHandStep = 0.002;                 // m of depth for a notch of the wheel
constexpr double kViewZoomNotch = 1.1;              // nearer for a notch of the wheel
constexpr double kZoomPixel = 1.006;                // nearer for a pixel of a drag
constexpr double kTurnKey = 1.0 / 36.0;             // of the view, as a drag: 5 degrees
constexpr double kShiftKey = 24.0;                  // px
constexpr double kMoveKey = 1e-3, kFineKey = 1e-4;  // m, of the tool for a key
constexpr double kToolTurnKey = 5.0 * std::numbers::pi / 180.0;  // rad
constexpr double kGrab = 8.0;  // px about the tool that count as on it

double fromSegment(QPointF p, QPointF a, QPointF b) {
  const QPointF along = b - a;
  const double length = QPointF::dotProduct(along, along);
  const double share =
      length > 0.0 ? std::clamp(QPointF::dotProduct(p - a, along) / length, 0.0, 1.0) : 0.0;
  return std::hypot(p.x() - a.x() - share * along.x(), p.y() - a.y() - share * along.y());
}

/// Whether a line from `a` to `b` passes through a box.
bool crosses(const QRectF& box, QPointF a, QPointF b) {
  double from = 0.0, to = 1.0;
  const auto clip = [&](double start, double step, double least, double most) {
    if (step == 0.0) return start >= least && start <= most;
    const double one = (least - start) / step, other = (most - start) / step;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    return from <= to;
  };
  return clip(a.x(), b.x() - a.x(), box.left(), box.right()) &&
         clip(a.y(), b.y() - a.y(), box.top(), box.bottom());
}

/// Whether a point lies in a triangle, whichever way round its corners go.
bool isWithin(QPointF p, QPointF a, QPointF b, QPointF c) {
  const auto side = [](QPointF u, QPointF v, QPointF w) {
    return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
  };
  const double x = side(a, b, p), y = side(b, c, p), z = side(c, a, p);
  return (x >= 0.0 && y >= 0.0 && z >= 0.0) || (x <= 0.0 && y <= 0.0 && z <= 0.0);
}

constexpr std::array kHeld{Action::Clutch, Action::HoldToRun, Action::Cut};

}  // namespace

void VolumeView::setMouseHand(bool on) {
  const bool begins = on && !mouse_hand_;
  mouse_hand_ = on;
  hand_target_.reset();
  displayed_ = false;  // the next hand starts elsewhere
  if (!on) setMouseMode(MouseMode::Look);
  emit mouseHandChanged(on);
  if (begins) setMouseMode(mouse_.at_first);
  emit hintChanged(hint());
}

void VolumeView::setMouse(const MouseChoices& mouse) {
  const bool other = mouse.at_first != mouse_.at_first;
  mouse_ = mouse;
  if (other) setMouseMode(mouse.at_first);
}

void VolumeView::placeHand(const haptics::Pose& X_WH) { hand_target_ = X_WH; }

void VolumeView::setMouseMode(MouseMode mode) {
  if (mode == MouseMode::Hand && !mouse_hand_) mode = MouseMode::Look;
  if (mode == mode_) return;
  mode_ = mode;
  grasp_.reset();
  chooseCursor(last_mouse_);
  emit mouseModeChanged(mode);
  emit hintChanged(hint());
}

haptics::Pose& VolumeView::handTarget() {
  if (!hand_target_) hand_target_ = last_.X_WD;
  return *hand_target_;
}

void VolumeView::moveHand(QPointF by, bool turn) {
  haptics::Pose& X_WH = handTarget();
  const Eigen::Matrix3d axes = viewAxes();
  if (turn) {
    const Eigen::Vector3d about = axes.col(0) * by.y() + axes.col(1) * by.x();
    const double angle = about.norm() * kHandTurn;
    if (angle > 0.0)
      X_WH.linear() = (Eigen::AngleAxisd(angle, about.normalized()) * haptics::rotationOf(X_WH))
                          .toRotationMatrix();
  } else {
    const double m = camera_.mmPerPixel(X_WH.translation() * kMmPerM) / kMmPerM;
    X_WH.translation() += (by.x() * axes.col(0) - by.y() * axes.col(1)) * m;
  }
  emit handPulled(X_WH);
}

void VolumeView::pushHand(double notches) {
  haptics::Pose& X_WH = handTarget();
  X_WH.translation() -= viewAxes().col(2) * (notches * kHandStep);
  emit handPulled(X_WH);
}

void VolumeView::moveByKey(const Binding& meaning) {
  if (!displayed_) return;
  const QPointF way = wayOf(meaning);
  const int key = meaning.at_first.key();
  // along right, up and towards the viewer
  const Eigen::Vector3d along =
      viewAxes() * Eigen::Vector3d{way.x(), -way.y(),
                                   double(key == Qt::Key_PageDown) - double(key == Qt::Key_PageUp)};
  haptics::Pose& X_WH = handTarget();
  if (meaning.action != Action::TurnTool) {
    const bool fine = meaning.at_first.keyboardModifiers() & Qt::ControlModifier;
    X_WH.translation() += along * (fine ? kFineKey : kMoveKey);
  } else {
    // what is at the front turns the way of the arrow
    const Eigen::Vector3d towards = viewAxes().col(2);
    const Eigen::Vector3d about = way.isNull() ? along : towards.cross(along);
    X_WH.linear() =
        (Eigen::AngleAxisd(kToolTurnKey, about) * haptics::rotationOf(X_WH)).toRotationMatrix();
  }
  emit handPulled(X_WH);
}

bool VolumeView::isOnTool(QPointF at) const {
  if (!mouse_hand_ || !displayed_) return false;
  double nearest_mm = INFINITY;  // from the viewer
  const Eigen::Vector3d eye{camera()->GetPosition()}, away = -viewAxes().col(2);
  const auto look = [&](const haptics::Pose& X) {
    std::vector<QPointF> seen;
    std::vector<double> depth_mm;
    for (const haptics::Vec3& v : tool_mesh_.vertices) {
      const Eigen::Vector3d p_mm = (X * v) * kMmPerM;
      seen.push_back(camera_.projected(p_mm));
      depth_mm.push_back(away.dot(p_mm - eye));
    }
    for (const auto& [a, b, c] : tool_mesh_.triangles)
      if (isWithin(at, seen[a], seen[b], seen[c]) || fromSegment(at, seen[a], seen[b]) < kGrab ||
          fromSegment(at, seen[b], seen[c]) < kGrab || fromSegment(at, seen[c], seen[a]) < kGrab)
        nearest_mm = std::min(nearest_mm, std::min({depth_mm[a], depth_mm[b], depth_mm[c]}));
    if (tool_mesh_.triangles.empty())
      for (std::size_t i = 0; i < seen.size(); ++i)
        if (fromSegment(at, seen[i], seen[i]) < kGrab)
          nearest_mm = std::min(nearest_mm, depth_mm[i]);
  };
  // the wireframe is seen through everything
  if (tool_.deviceShown()) {
    look(last_.X_WD);
    if (std::isfinite(nearest_mm)) return true;
  }
  look(last_.X_WP);
  if (!std::isfinite(nearest_mm)) return false;
  const auto before = surfaceUnder(at);
  return !before || away.dot(before->p_W * kMmPerM - eye) > nearest_mm - 1.0;
}

bool VolumeView::isToolIn(const QRect& part) const {
  if (!displayed_) return false;
  const QRectF box(part);
  const auto isIn = [&](const haptics::Pose& X) {
    std::vector<QPointF> seen;
    for (const haptics::Vec3& v : tool_mesh_.vertices) seen.push_back(projected(X * v));
    for (const auto& [a, b, c] : tool_mesh_.triangles)
      if (isWithin(box.center(), seen[a], seen[b], seen[c]) || crosses(box, seen[a], seen[b]) ||
          crosses(box, seen[b], seen[c]) || crosses(box, seen[c], seen[a]))
        return true;
    return std::ranges::any_of(seen, [&](QPointF p) { return box.contains(p); });
  };
  return isIn(last_.X_WP) || (tool_.deviceShown() && isIn(last_.X_WD));
}

void VolumeView::bringTool(QPointF at) {
  if (const auto met = surfaceUnder(at)) emit toolWanted(met->p_W, met->normal_W);
}

QString VolumeView::hint() const {
  const QString over = overlays_.hint();
  if (!over.isEmpty()) return over;
  const QString cuts =
      last_.can_cut ? tr("Hold %1: cuts.").arg(keyOf(Action::Cut)) + ' ' : QString{};
  if (mode_ == MouseMode::Hand)
    return cuts +
           tr("Drag or arrow keys: move the tool. Shift: turns it. Wheel: pushes it. Right drag: "
              "turns the picture. %1: lets go.")
               .arg(keyOf(Action::TakeTool));
  if (mouse_hand_)
    return cuts + tr("Drag: turns. Wheel: nearer. To touch: drag the tool, or take it with %1. "
                     "Double-click: brings it there. Middle drag: shifts.")
                      .arg(keyOf(Action::TakeTool));
  return cuts +
         tr("Drag: turns. Wheel: nearer. Middle drag: shifts. %1 takes the tool only while the "
            "mouse "
            "is the hand (tab Touch).")
             .arg(keyOf(Action::TakeTool));
}

void VolumeView::mousePressEvent(QMouseEvent* event) {
  last_mouse_ = press_ = event->position();
  grasp_.reset();
  event->accept();
  if (overlays_.press(*geometry_, *event)) return;
  if (event->button() == Qt::LeftButton && cubeSideAt(press_)) return;  // the release looks from it
  const bool on_tool = event->button() == Qt::LeftButton && isOnTool(press_);
  const auto action =
      actionOf(Where::Space, mode_, Gesture::Drag, event->button(), event->modifiers(), on_tool);
  if (!action) return;
  const bool hand = *action == Action::MoveTool || *action == Action::TurnTool;
  if (hand && !displayed_) return;  // the last pose was another hand's
  grasp_ = Grasp{*action, *action == Action::Zoom ? aimUnder(press_) : Eigen::Vector3d::Zero()};
  chooseCursor(press_);
}

std::optional<Side> VolumeView::cubeSideAt(QPointF at) const {
  if (box_mm_.isEmpty() || !showsCube()) return {};
  return OrientationCube::sideAt(at, OrientationCube::placeIn(size()), viewAxes());
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
  if (overlays_.release(*geometry_, *event)) return;
  const bool dragged = grasp_.has_value();
  if (event->buttons() == Qt::NoButton) grasp_.reset();
  chooseCursor(event->position());
  if (dragged || event->button() != Qt::LeftButton) return;
  const auto pressed = cubeSideAt(press_);
  if (pressed && pressed == cubeSideAt(event->position())) lookFrom(*pressed);
}

void VolumeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (overlays_.doubleClick(*geometry_, *event)) return;
  const auto action =
      actionOf(Where::Space, mode_, Gesture::DoubleClick, event->button(), event->modifiers());
  if (cubeSideAt(event->position()) || action != Action::BringTool || isOnTool(event->position()))
    return mousePressEvent(event);
  bringTool(event->position());
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_mouse_;
  last_mouse_ = event->position();
  pointer_in_ = true;
  if (!pointed_.isActive()) pointed_.start();
  if (overlays_.move(*geometry_, *event)) return;
  if (grasp_)
    dragBy(by, event->modifiers());
  else if (event->buttons() == Qt::NoButton)
    chooseCursor(event->position());
}

void VolumeView::dragBy(QPointF by, Qt::KeyboardModifiers modifiers) {
  switch (grasp_->action) {
    case Action::MoveTool:
    case Action::TurnTool:
      // Shift may come and go while the tool is held
      moveHand(by, modifiers & Qt::ShiftModifier);
      break;
    case Action::Rotate:
      camera_.rotate(by);
      cameraMoved();
      break;
    case Action::Pan:
      camera_.pan(by);
      cameraMoved();
      break;
    case Action::Zoom:
      camera_.zoom(std::pow(kZoomPixel, -by.y()), grasp_->zoom_at_mm);
      cameraMoved();
      break;
    default:
      break;
  }
}

void VolumeView::chooseCursor(QPointF at) {
  const bool held =
      grasp_ && (grasp_->action == Action::MoveTool || grasp_->action == Action::TurnTool);
  const bool could = mode_ == MouseMode::Hand || (!grasp_ && isOnTool(at));
  const Qt::CursorShape shape = held    ? Qt::ClosedHandCursor
                                : could ? Qt::OpenHandCursor
                                        : Qt::ArrowCursor;
  if (cursor().shape() != shape) setCursor(shape);
}

void VolumeView::wheelEvent(QWheelEvent* event) {
  event->accept();
  const double notches = event->angleDelta().y() / 120.0;
  // while the tool is held it goes into the depth, in any mode
  const bool held =
      grasp_ && (grasp_->action == Action::MoveTool || grasp_->action == Action::TurnTool);
  const auto action =
      actionOf(Where::Space, held ? MouseMode::Hand : mode_, Gesture::Wheel, 0, event->modifiers());
  if (action == Action::PushTool && displayed_)
    pushHand(notches);
  else
    zoom(std::pow(kViewZoomNotch, mouse_.zoom_reversed ? -notches : notches), event->position());
}

void VolumeView::follow(const VolumeView& other) {
  const bool was_parallel = isParallel();
  camera_.take(other.camera_);
  showMoved();
  if (isParallel() != was_parallel) emit parallelChanged(isParallel());
}

bool VolumeView::perform(const Binding& meaning) {
  const Action action = meaning.action;
  const QPointF way = wayOf(meaning);
  const QPointF at = underMouse() ? last_mouse_ : QRectF(rect()).center();
  switch (action) {
    case Action::Rotate:
      camera_.rotate({way.x() * width() * kTurnKey, way.y() * height() * kTurnKey});
      cameraMoved();
      break;
    case Action::Pan:
      // as in slices: towards what lies there
      camera_.pan(way * -kShiftKey);
      cameraMoved();
      break;
    case Action::Nearer:
      zoom(kViewZoomNotch, at);
      break;
    case Action::Farther:
      zoom(1.0 / kViewZoomNotch, at);
      break;
    case Action::ForceOff:
      emit forceOffWanted();
      break;
    case Action::MoveTool:
    case Action::TurnTool:
    case Action::PushTool:
      moveByKey(meaning);
      break;
    case Action::ToolToCross:
      emit toolToCrossWanted();
      break;
    case Action::CrossToTool:
      emit crossToToolWanted();
      break;
    case Action::LookAlongTool:
      lookAlongTool();
      break;
    case Action::LookFromTool:
      lookFromTool();
      break;
    case Action::ShowEverything:
      resetCamera();
      break;
    case Action::ViewAnterior:
    case Action::ViewPosterior:
    case Action::ViewLeft:
    case Action::ViewRight:
    case Action::ViewSuperior:
    case Action::ViewInferior:
      lookFrom(kSides.at(static_cast<std::size_t>(action) -
                         static_cast<std::size_t>(Action::ViewAnterior)));
      break;
    case Action::ParallelProjection:
      setParallel(!isParallel());
      break;
    default:
      return false;
  }
  return true;
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space && overlays_.key(*geometry_, *event, QRectF(rect()).center()))
    return;
  const Binding* held = meaningOf(Where::Space, *event, Gesture::HeldKey);
  const Binding* meaning = meaningOf(Where::Space, *event, Gesture::Key, Over::Nothing, mode_);
  // the layout may have changed since it was pressed
  const bool still_held = event->isAutoRepeat() && event->nativeScanCode() != 0 &&
                          std::ranges::count(held_places_, event->nativeScanCode()) > 0;
  if (held != nullptr) {
    // a key that repeats itself is held already, or was let go by what came between
    if (!event->isAutoRepeat()) hold(held->action, true, event->nativeScanCode());
  } else if (!still_held && (meaning == nullptr || !perform(*meaning))) {
    Viewport::keyPressEvent(event);
  }
}

void VolumeView::keyReleaseEvent(QKeyEvent* event) {
  // a key that is held repeats itself as releases and presses
  if (event->isAutoRepeat()) return Viewport::keyReleaseEvent(event);
  const quint32 place = event->nativeScanCode();
  // whatever else is held meanwhile
  const QKeyEvent alone(event->type(), event->key(), Qt::NoModifier, place,
                        event->nativeVirtualKey(), event->nativeModifiers());
  const Binding* held = meaningOf(Where::Space, alone, Gesture::HeldKey);
  // a letter that could be any: what is in doubt is let go
  const bool unknown = place == 0 && latinKey(alone) >= 0x80 && latinKey(alone) < Qt::Key_Escape;
  bool released = false;
  for (const Action action : kHeld) {
    const quint32 at = heldPlace(action);
    const bool of_key = held != nullptr && held->action == action;
    if (!of_key && !unknown && (at == 0 || at != place)) continue;
    hold(action, false, 0);
    released = true;
  }
  if (!released) Viewport::keyReleaseEvent(event);
}

quint32& VolumeView::heldPlace(Action action) {
  return held_places_.at(
      static_cast<std::size_t>(std::ranges::find(kHeld, action) - kHeld.begin()));
}

void VolumeView::hold(Action action, bool on, quint32 place) {
  heldPlace(action) = place;
  if (action == Action::Clutch)
    emit clutchHeld(on);
  else if (action == Action::HoldToRun)
    emit forceHeld(on);
  else
    emit cutHeld(on);
}

void VolumeView::resizeEvent(QResizeEvent* event) {
  Viewport::resizeEvent(event);
  if (!box_mm_.isEmpty() && camera_.refit()) cameraMoved();
}

void VolumeView::leaveEvent(QEvent* event) {
  pointer_in_ = false;
  if (!pointed_.isActive()) pointed_.start();
  Viewport::leaveEvent(event);
}

void VolumeView::focusOutEvent(QFocusEvent* event) {
  // the release would go elsewhere
  for (const Action action : kHeld) hold(action, false, 0);
  Viewport::focusOutEvent(event);
}

}  // namespace ui
