// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/section.h"

#include <QPainter>
#include <QVBoxLayout>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kHead = 36;  // px high
constexpr double kArrow = 4.0;

}  // namespace

SectionHead::SectionHead(const QString& title, QWidget* parent) : QAbstractButton(parent) {
  offerSpoken();
  setText(title);
  setCheckable(true);
  setFont(style::font(style::Type::Section));
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SectionHead::spokenState(QAccessible::State& state) const {
  state.expandable = true;
  state.expanded = isChecked();
  state.collapsed = !isChecked();
}

QSize SectionHead::sizeHint() const {
  return {2 * style::kEdge + fontMetrics().horizontalAdvance(text()) + 24, kHead};
}

QSize SectionHead::minimumSizeHint() const { return sizeHint(); }

void SectionHead::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (hasFocus()) {
    painter.setPen(QPen(c.accent, 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(5.0, 5.0, -5.0, -5.0), style::kCorner,
                            style::kCorner);
  }
  painter.setPen(underMouse() ? c.text : c.dim);
  const QRect room = rect().adjusted(style::kEdge, 0, -style::kEdge, 0);
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text());
  painter.setPen(QPen(c.dim, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.translate(room.right() - kArrow, 0.5 * height());
  if (!isChecked()) painter.rotate(-90.0);
  painter.drawPolyline(
      QPolygonF({{-kArrow, -0.5 * kArrow}, {0.0, 0.5 * kArrow}, {kArrow, -0.5 * kArrow}}));
}

Section::Section(const QString& title, QWidget* panel, bool folded_at_first, QWidget* parent)
    : QWidget(parent),
      head_(new SectionHead(title)),
      body_(new QWidget),
      panel_(panel),
      folded_at_first_(folded_at_first) {
  auto* inside = new QVBoxLayout(body_);
  inside->setContentsMargins(style::kEdge, 0, style::kEdge, style::kEdge);
  inside->addWidget(panel);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 1);  // the line below it
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(body_);
  head_->setObjectName("sectionHead");
  connect(head_, &SectionHead::clicked, this, [this](bool open) {
    setFolded(!open);
    emit foldedChanged();
  });
  setFolded(folded_at_first);
}

bool Section::folded() const { return !head_->isChecked(); }

void Section::setFolded(bool folded) {
  head_->setChecked(!folded);
  head_->setToolTip(folded ? tr("Unfold") : tr("Fold"));
  head_->setAccessibleName(folded ? tr("%1, folded").arg(head_->text())
                                  : tr("%1, unfolded").arg(head_->text()));
  body_->setVisible(!folded);
}

void Section::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(QRect(0, height() - 1, width(), 1), style::colours().line);
}

}  // namespace ui
