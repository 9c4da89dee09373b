// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/top_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <cmath>

#include "ui/controls/state_chip.h"
#include "ui/controls/time_words.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kBar = 46;  // px high
constexpr int kKeySide = 6;

/// A line between groups.
class Divider : public QWidget {
 public:
  Divider() { setFixedSize(2 * style::kGap + 1, style::kBarButton); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter(this).fillRect(QRect(style::kGap, 6, 1, height() - 12), style::colours().line);
  }
};

QString keyWords() { return StopButton::tr("Esc"); }

}  // namespace

StopButton::StopButton(QWidget* parent) : QToolButton(parent) {
  setObjectName("forceOff");
  setText(tr("STOP FORCE"));
  setAccessibleName(tr("Stop force (Escape)"));
  setToolTip(tr("Zero force at once (Escape anywhere, Space in the 3-D view)"));
  QFont bold = style::font(style::Type::Body);
  bold.setWeight(QFont::DemiBold);
  setFont(bold);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
}

void StopButton::setForce(bool force) {
  if (force == force_) return;
  force_ = force;
  if (underMouse() || hasFocus()) update();
}

QSize StopButton::sizeHint() const {
  const QFontMetrics small(style::font(style::Type::Small));
  return {fontMetrics().horizontalAdvance(text()) + small.horizontalAdvance(keyWords()) +
              2 * kKeySide + 3 * 14,
          style::kBarButton};
}

void StopButton::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool filled = isDown() || (force_ && (underMouse() || hasFocus()));
  const double width = hasFocus() ? 2.5 : 1.5;
  const QRectF box = QRectF(rect()).adjusted(0.5 * width, 0.5 * width, -0.5 * width, -0.5 * width);
  painter.setPen(QPen(c.stop, width));
  painter.setBrush(filled ? QBrush(c.stop_fill) : underMouse() ? QBrush(c.hover) : Qt::NoBrush);
  painter.drawRoundedRect(box, style::kLargeCorner, style::kLargeCorner);
  const QColor words = filled ? c.on_stop : c.stop_words;
  painter.setPen(words);
  painter.drawText(rect().adjusted(14, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text());
  // the key, as a key looks
  const QFont small = style::font(style::Type::Small);
  painter.setFont(small);
  const QFontMetrics metrics(small);
  QRectF key(0.0, 0.0, metrics.horizontalAdvance(keyWords()) + 2.0 * kKeySide,
             metrics.height() + 4.0);
  key.moveCenter(QPointF(0.0, 0.5 * height()));
  key.moveRight(rect().right() + 1 - 14.0);
  painter.setPen(QPen(words, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(key.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  painter.drawText(key, Qt::AlignCenter, keyWords());
}

TopBar::TopBar(QWidget* parent)
    : QWidget(parent), force_(new StateChip), recording_(new StateChip), stop_(new StopButton) {
  setObjectName("forceBar");
  setFixedHeight(kBar);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(style::kGap, 0, style::kGap + 2, 0);
  row->setSpacing(0);
  for (QHBoxLayout*& group : groups_) {
    group = new QHBoxLayout;
    group->setSpacing(2);
    row->addLayout(group);
    row->addWidget(new Divider);
  }
  force_->setObjectName("forceStateBar");
  force_->setAccessibleName(tr("State of the force"));
  row->addWidget(force_);
  row->addSpacing(style::kGap);
  recording_->setObjectName("recordingChip");
  recording_->setAccessibleName(tr("Recording"));
  recording_->setFont(style::tabular(recording_->font()));
  recording_->hide();
  row->addWidget(recording_);
  row->addStretch(1);
  row->addSpacing(style::kEdge);
  row->addWidget(stop_);
  connect(stop_, &QToolButton::clicked, this, &TopBar::stopWanted);
}

QToolButton* TopBar::addButton(BarGroup group, const char* icon) {
  auto* button = new QToolButton;
  button->setIcon(style::icon(icon));
  button->setIconSize({style::kIcon, style::kIcon});
  button->setFixedSize(style::kBarButton, style::kBarButton);
  button->setAutoRaise(true);
  // a click leaves the focus in the view
  button->setFocusPolicy(Qt::TabFocus);
  groups_[static_cast<std::size_t>(group)]->addWidget(button);
  return button;
}

void TopBar::add(BarGroup group, QAction& action, const char* icon) {
  QToolButton* button = addButton(group, icon);
  const QString name = action.objectName() + "Button";
  action.setIcon(style::icon(icon));
  action.setIconVisibleInMenu(false);
  button->setDefaultAction(&action);
  button->setObjectName(name);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void TopBar::add(BarGroup group, QMenu& menu, const char* icon, const QString& tip) {
  QToolButton* button = addButton(group, icon);
  button->setObjectName(menu.objectName() + "Button");
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  connect(button, &QToolButton::clicked, &menu, [button, &menu] {
    menu.popup(button->mapToGlobal(QPoint{0, button->height()}));
  });
}

void TopBar::showRecording(std::optional<double> elapsed) {
  if (elapsed)
    recording_->show(Mark::Recording, tr("REC %1").arg(clockTime(std::floor(*elapsed), 0)));
  const bool begins = elapsed && recording_->isHidden();
  recording_->setVisible(elapsed.has_value());
  if (begins) tellSpokenName(*recording_);
}

void TopBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), style::colours().panel);
  painter.fillRect(QRect(0, height() - 1, width(), 1), style::colours().line);
}

}  // namespace ui
