// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/tour.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kWidth = 300, kTail = 10;  // px

}  // namespace

Tour::Tour(QWidget& window)
    : QWidget(&window),
      window_(window),
      title_(new QLabel),
      sentence_(new QLabel),
      count_(new QLabel),
      next_(new QPushButton) {
  setObjectName("tour");
  style::setType(*title_, style::Type::Section);
  sentence_->setObjectName("tourSentence");
  sentence_->setWordWrap(true);
  style::setDim(*count_);
  auto* skip = new QPushButton(tr("Skip"));
  skip->setObjectName("tourSkip");
  skip->setToolTip(tr("Ends the tour; Help shows it again"));
  next_->setObjectName("tourNext");
  next_->setToolTip(tr("Shows the next control"));
  // a click leaves the focus in the view
  for (QPushButton* button : {skip, next_}) button->setFocusPolicy(Qt::TabFocus);
  connect(skip, &QPushButton::clicked, this, &Tour::end);
  connect(next_, &QPushButton::clicked, this, &Tour::next);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(count_, 1);
  buttons->addWidget(skip);
  buttons->addWidget(next_);
  auto* column = new QVBoxLayout(this);
  constexpr int kInset = style::kEdge + kTail;
  column->setContentsMargins(kInset, kInset, kInset, kInset);
  column->setSpacing(style::kGap);
  column->addWidget(title_);
  column->addWidget(sentence_);
  column->addLayout(buttons);
  hide();
}

void Tour::begin(std::vector<TourStep> steps) {
  steps_ = std::move(steps);
  if (steps_.empty()) return;
  window_.installEventFilter(this);
  show(0);
}

void Tour::show(int step) {
  if (target_) target_->removeEventFilter(this);
  step_ = step;
  const TourStep& now = steps_[static_cast<std::size_t>(step)];
  if (now.reveal) now.reveal();
  target_ = now.target;
  target_->installEventFilter(this);
  title_->setText(now.title);
  sentence_->setText(now.sentence);
  const int count = static_cast<int>(steps_.size());
  count_->setText(tr("%1 of %2").arg(step + 1).arg(count));
  next_->setText(step + 1 < count ? tr("Next") : tr("Done"));
  setAccessibleName(now.title);
  setAccessibleDescription(now.sentence);
  QWidget::show();
  raise();
  place();
}

void Tour::next() {
  if (step_ + 1 < static_cast<int>(steps_.size())) return show(step_ + 1);
  end();
}

bool Tour::close() {
  if (step_ < 0) return false;
  end();
  return true;
}

void Tour::end() {
  window_.removeEventFilter(this);
  if (target_) target_->removeEventFilter(this);
  target_ = nullptr;
  step_ = -1;
  hide();
  emit ended();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
      if (step_ >= 0) place();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

/// Beside the control, on the first side with room; inside a control that leaves no room, and in
/// the middle of the window if the control is out of view.
void Tour::place() {
  const int height = std::max(heightForWidth(kWidth), layout()->heightForWidth(kWidth));
  resize(kWidth, std::max(height, minimumSizeHint().height()));
  const QRect room = window_.rect();
  QRect bubble = rect();
  side_ = Side::None;
  if (target_ && target_->isVisible()) {
    const QRect target(target_->mapTo(&window_, QPoint{}), target_->size());
    const auto beside = [&](Side side) {
      QRect at = bubble;
      at.moveCenter(target.center());
      if (side == Side::Left) at.moveLeft(target.right() + 1);
      if (side == Side::Right) at.moveRight(target.left() - 1);
      if (side == Side::Above) at.moveTop(target.bottom() + 1);
      if (side == Side::Below) at.moveBottom(target.top() - 1);
      // along the side it may be shifted, as long as it still points at the control
      if (side == Side::Left || side == Side::Right)
        at.moveTop(std::clamp(at.top(), 0, std::max(0, room.height() - at.height())));
      else
        at.moveLeft(std::clamp(at.left(), 0, std::max(0, room.width() - at.width())));
      return at;
    };
    for (const Side side : std::array{Side::Above, Side::Left, Side::Right, Side::Below})
      if (const QRect at = beside(side); side_ == Side::None && room.contains(at)) {
        side_ = side;
        bubble = at;
      }
    if (side_ == Side::None) {
      // a control as large as the window, such as the 3-D view: at its upper left, over nothing
      bubble.moveTopLeft(target.topLeft() + QPoint{style::kGap, 2 * style::kBarButton});
    } else {
      tip_ = target.center() - bubble.topLeft();
      tip_.setX(std::clamp(tip_.x(), 2 * kTail, width() - 2 * kTail));
      tip_.setY(std::clamp(tip_.y(), 2 * kTail, this->height() - 2 * kTail));
    }
  } else {
    bubble.moveCenter(room.center());
  }
  move(bubble.topLeft());
  update();
}

void Tour::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath shape;
  const QRectF box = QRectF(rect()).adjusted(kTail, kTail, -kTail, -kTail);
  shape.addRoundedRect(box, style::kLargeCorner, style::kLargeCorner);
  const auto tail = [&](QPointF tip, QPointF across, QPointF foot) {
    QPainterPath triangle;
    triangle.addPolygon(QPolygonF({tip, foot + across, foot - across, tip}));
    shape = shape.united(triangle);
  };
  constexpr double kHalf = kTail;
  const QPointF along_x(kHalf, 0.0), along_y(0.0, kHalf);
  const double x = tip_.x(), y = tip_.y();
  if (side_ == Side::Left) tail({1.0, y}, along_y, {box.left() + 1.0, y});
  if (side_ == Side::Right) tail({width() - 1.0, y}, along_y, {box.right() - 1.0, y});
  if (side_ == Side::Above) tail({x, 1.0}, along_x, {x, box.top() + 1.0});
  if (side_ == Side::Below) tail({x, height() - 1.0}, along_x, {x, box.bottom() - 1.0});
  painter.setPen(QPen(c.accent, 1.5));
  painter.setBrush(c.panel);
  painter.drawPath(shape);
}

}  // namespace ui
