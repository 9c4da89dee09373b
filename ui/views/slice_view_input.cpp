// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_view.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/controls/bindings.h"

namespace ui {
namespace {

constexpr double kZoomNotch = 1.2;
constexpr double kStill_px = 4.0;  // a right button that moved less was clicked
constexpr int kPage = 10;          // slices
constexpr double kPanKey = 24.0;   // px

}  // namespace

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
    case Action::FitBody:
      emit fitWanted();
      break;
    case Action::GreySoftTissue:
    case Action::GreyBone:
    case Action::GreyLung:
    case Action::GreyBrain:
    case Action::GreyMediastinum:
    case Action::GreyTemporalBone:
    case Action::GreyAtFirst:
    case Action::TypeGrey:
      emit greyWanted(meaning.action);
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

QString SliceView::hint() const {
  const QString over = overlays_.hint();
  if (!over.isEmpty()) return over;
  return tr("Wheel: slices. Drag: crosshair. Right drag: grey. Ctrl+wheel: nearer. %1: fits all.")
      .arg(keyOf(Action::FitBody));
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
