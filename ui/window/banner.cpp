// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kSymbol = 20;

QColor groundOf(Banner::Kind kind) {
  const style::Colours& c = style::colours();
  switch (kind) {
    case Banner::Kind::Fault:
      return c.fault_ground;
    case Banner::Kind::Done:
    case Banner::Kind::Question:
      return c.panel;
    case Banner::Kind::Attention:
    case Banner::Kind::Stopped:
      break;
  }
  return c.attention_ground;
}

QColor markOf(Banner::Kind kind) {
  const style::Colours& c = style::colours();
  switch (kind) {
    case Banner::Kind::Fault:
      return c.stop_words;
    case Banner::Kind::Done:
      return c.on;
    case Banner::Kind::Question:
      return c.accent;
    case Banner::Kind::Attention:
    case Banner::Kind::Stopped:
      break;
  }
  return c.attention;
}

}  // namespace

Banner::Banner(Kind kind, const char* name, QWidget* parent)
    : QFrame(parent),
      kind_(kind),
      sentence_(new QLabel),
      parts_(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      buttons_(new QHBoxLayout) {
  offerSpoken();
  sentence_->setObjectName(name);
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  sentence_->setContentsMargins(style::kEdge + kSymbol, 0, 0, 0);
  parts_->setContentsMargins(style::kGap, 6, style::kGap, 6);
  parts_->setSpacing(style::kGap);
  parts_->addWidget(sentence_, 1);
  parts_->addLayout(buttons_);
  buttons_->setSpacing(style::kGap);
  hide();
}

QString Banner::spokenName() const { return sentence_->text(); }

void Banner::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
  tellSpokenName(*this);
}

void Banner::setSentence(const QString& sentence) {
  if (sentence == sentence_->text()) return;
  sentence_->setText(sentence);
  if (isVisible()) tellSpokenName(*this);
}

QPushButton* Banner::addButton(const char* name) {
  auto* button = new QPushButton;
  button->setObjectName(name);
  // Space in the 3-D view stays force off
  button->setFocusPolicy(Qt::TabFocus);
  buttons_->addWidget(button);
  return button;
}

void Banner::setStacked(bool stacked) {
  parts_->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

int Banner::leastWidth(bool stacked) const {
  const int words = sentence_->minimumSizeHint().width(), others = buttons_->minimumSize().width();
  const QMargins edges = parts_->contentsMargins();
  return edges.left() + edges.right() +
         (stacked ? std::max(words, others) : words + parts_->spacing() + others);
}

int Banner::heightIf(bool stacked, int width) const {
  const QMargins edges = parts_->contentsMargins();
  const QSize others = buttons_->sizeHint();
  width -= edges.left() + edges.right() + (stacked ? 0 : parts_->spacing() + others.width());
  const int words = sentence_->heightForWidth(width);
  return edges.top() + edges.bottom() +
         (stacked ? words + parts_->spacing() + others.height() : std::max(words, others.height()));
}

void Banner::addClose() {
  auto* close = new QToolButton;
  close->setObjectName(sentence_->objectName() + "Close");
  close->setIcon(style::icon("close"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close"));
  close->setAccessibleName(tr("Close"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  buttons_->addWidget(close);
}

void Banner::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.fillRect(rect(), groundOf(kind_));
  painter.fillRect(QRect(0, height() - 1, width(), 1), c.line);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = markOf(kind_);
  painter.setPen(QPen(colour, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF middle(style::kEdge + 0.5 * kSymbol, QRectF(sentence_->geometry()).center().y());
  const auto at = [&](double x, double y) { return middle + QPointF(x, y); };
  if (kind_ == Kind::Stopped) {
    // the outline of a stop sign
    painter.drawPolygon(QPolygonF({at(-3.5, -8.5), at(3.5, -8.5), at(8.5, -3.5), at(8.5, 3.5),
                                   at(3.5, 8.5), at(-3.5, 8.5), at(-8.5, 3.5), at(-8.5, -3.5)}));
    painter.drawLine(at(-3.5, 0.0), at(3.5, 0.0));
    return;
  }
  if (kind_ == Kind::Done) {
    painter.drawEllipse(middle, 8.5, 8.5);
    painter.drawPolyline(QPolygonF({at(-4.0, 0.5), at(-1.0, 3.5), at(4.5, -3.0)}));
    return;
  }
  if (kind_ == Kind::Question) {
    painter.drawEllipse(middle, 8.5, 8.5);
    painter.drawLine(at(0.0, -0.5), at(0.0, 4.5));
    painter.drawPoint(at(0.0, -4.0));
    return;
  }
  painter.drawPolygon(QPolygonF({at(0.0, -8.0), at(9.0, 7.5), at(-9.0, 7.5)}));
  painter.drawLine(at(0.0, -2.5), at(0.0, 2.0));
  painter.drawPoint(at(0.0, 4.8));
}

}  // namespace ui
