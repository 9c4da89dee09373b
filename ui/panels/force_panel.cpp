// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ui/controls/figure.h"
#include "ui/panels/force_words.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kWidth = 248, kCompactWidth = 124;  // px
constexpr int kInside = 12;

// what the tool is at, or why a force that is wanted is withheld
QString touchWords(const haptics::Snapshot& snapshot) {
  if (snapshot.force_state == haptics::ForceState::Armed)
    return sentenceFor(snapshot.force_state, snapshot.reason, snapshot.trouble);
  if (snapshot.contacts == 0) return ForcePanel::tr("Nothing is touched");
  if (snapshot.contacts == 1) return ForcePanel::tr("Touching at one place");
  return ForcePanel::tr("Touching at %1 places").arg(snapshot.contacts);
}

constexpr double kLeastForceSaid = 0.005;  // N: shown as 0.00
constexpr double kLeastPause = 1.0;        // s between two that are said

void say(QLabel* label, const QString& words) {
  if (label->text() != words) label->setText(words);
}

}  // namespace

ForcePanel::ForcePanel(QWidget* parent)
    : QWidget(parent),
      force_(new Figure(tr("Force"), tr("N"))),
      torque_(new Figure(tr("Torque"))),
      touch_(new Figure(tr("Touch"))),
      plot_(new ForcePlot) {
  setObjectName("forceCard");
  setPalette(style::paletteOf(style::kDark));
  setFixedWidth(kWidth);
  force_->setObjectName("forceNow");
  style::setType(*force_, style::Type::Force);
  // the unit stays where it is
  force_->setMinimumWidth(force_->fontMetrics().horizontalAdvance(QStringLiteral("0.00")) + 2);
  auto* unit = new QLabel(tr("N"));
  style::setDim(*unit);
  torque_->setObjectName("torqueNow");
  torque_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  style::setDim(*torque_);
  torque_->setMinimumWidth(torque_->fontMetrics().horizontalAdvance(tr("%1 mN·m").arg(8888)) + 2);
  touch_->setObjectName("touchNow");
  touch_->setWordWrap(true);
  style::setDim(*touch_);
  style::setType(*touch_, style::Type::Small);
  touch_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // always as high, so that the card stays as it is
  touch_->setFixedHeight(2 * touch_->fontMetrics().lineSpacing() + 2);
  plot_->setObjectName("forcePlot");
  auto* figures = new QHBoxLayout;
  figures->setSpacing(6);
  figures->addWidget(force_, 0, Qt::AlignBaseline);
  figures->addWidget(unit, 0, Qt::AlignBaseline);
  figures->addStretch();
  figures->addWidget(torque_, 0, Qt::AlignBaseline);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInside, 6, kInside, style::kGap);
  column->setSpacing(style::kStep);
  column->addLayout(figures);
  column->addWidget(plot_);
  column->addWidget(touch_);
  display({});
}

void ForcePanel::display(const haptics::Snapshot& snapshot) {
  say(force_, QLocale().toString(snapshot.felt_W.force.norm(), 'f', 2));
  say(torque_, tr("%1 mN·m").arg(snapshot.felt_W.torque.norm() * 1000.0, 0, 'f', 0));
  say(touch_, touchWords(snapshot));
  sayForce(snapshot);
  sayTouch(snapshot);
}

void ForcePanel::sayForce(const haptics::Snapshot& snapshot) {
  const double force = snapshot.felt_W.force.norm();
  const bool begins = (force < kLeastForceSaid) != (said_ < kLeastForceSaid);
  const double pause = snapshot.time - said_time_;
  if ((!begins && std::abs(force - said_) < kSaid) || (pause >= 0.0 && pause < kLeastPause)) return;
  said_ = force;
  said_time_ = snapshot.time;
  tellSpokenName(*force_);
}

void ForcePanel::sayTouch(const haptics::Snapshot& snapshot) {
  const bool withheld = snapshot.force_state == haptics::ForceState::Armed;
  const int touch = withheld ? -1 : std::min(snapshot.contacts, 1);
  const double pause = snapshot.time - touch_time_;
  if (touch == said_touch_ || (pause >= 0.0 && pause < kLeastPause)) return;
  said_touch_ = touch;
  touch_time_ = snapshot.time;
  tellSpokenName(*touch_);
}

void ForcePanel::setCompact(bool compact) {
  for (QWidget* part : std::initializer_list<QWidget*>{plot_, torque_, touch_})
    part->setVisible(!compact);
  setFixedWidth(compact ? kCompactWidth : kWidth);
}

void ForcePanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(style::kDark.line);
  painter.setBrush(style::kDark.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), style::kLargeCorner,
                          style::kLargeCorner);
}

}  // namespace ui
