// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ui/controls/figure.h"
#include "ui/controls/touched_words.h"
#include "ui/panels/force_words.h"
#include "ui/panels/tissue_bands.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kWidth = 248, kCompactWidth = 124;  // px
constexpr int kInside = 12, kFold = 20;

// what the tool is at, or why a force that is wanted is withheld
QString touchWords(const haptics::Snapshot& snapshot, const std::optional<TouchedValue>& touched) {
  if (snapshot.force_state == haptics::ForceState::Armed)
    return sentenceFor(snapshot.force_state, snapshot.reason, snapshot.trouble);
  if (snapshot.contacts == 0) return ForcePanel::tr("Nothing is touched");
  if (!touched) return ForcePanel::tr("Touching");
  const QString with_unit = touchedWords(touched->value, touched->unit);
  if (!touched->structure.isEmpty())
    return ForcePanel::tr("Touching %1, %2").arg(touched->structure, with_unit);
  const QString tissue =
      touched->unit == QLatin1String("HU") ? tissueAt(touched->value) : QString();
  return tissue.isEmpty() ? ForcePanel::tr("Touching %1").arg(with_unit)
                          : ForcePanel::tr("Touching %1, %2").arg(tissue, with_unit);
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
      unit_(new QLabel(tr("N"))),
      touch_(new Figure(tr("Touch"))),
      with_(new QLabel),
      line_(new Figure(tr("Force and touch"))),
      fold_(new QToolButton),
      plot_(new ForcePlot),
      near_(new NearnessLines) {
  setObjectName("forceCard");
  setPalette(style::paletteOf(style::kDark));
  setFixedWidth(kWidth);
  force_->setObjectName("forceNow");
  style::setType(*force_, style::Type::Force);
  // the unit stays where it is
  force_->setMinimumWidth(force_->fontMetrics().horizontalAdvance(QStringLiteral("0.00")) + 2);
  style::setDim(*unit_);
  torque_->setObjectName("torqueNow");
  torque_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  style::setDim(*torque_);
  torque_->setMinimumWidth(torque_->fontMetrics().horizontalAdvance(tr("%1 mN·m").arg(8888)) + 2);
  touch_->setObjectName("touchNow");
  touch_->setWordWrap(true);
  touch_->setTextFormat(Qt::PlainText);  // names of structures
  line_->setTextFormat(Qt::PlainText);
  style::setDim(*touch_);
  style::setType(*touch_, style::Type::Small);
  touch_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // always as high, so that the card stays as it is
  touch_->setFixedHeight(2 * touch_->fontMetrics().lineSpacing() + 2);
  with_->setObjectName("touchedWith");
  style::setDim(*with_);
  style::setType(*with_, style::Type::Small);
  line_->setObjectName("forceLine");
  line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  fold_->setObjectName("foldCard");
  fold_->setAutoRaise(true);
  fold_->setFocusPolicy(Qt::TabFocus);
  fold_->setFixedSize(kFold, kFold);
  connect(fold_, &QToolButton::clicked, this, [this] { emit foldWanted(!folded_); });
  plot_->setObjectName("forcePlot");
  auto* figures = new QHBoxLayout;
  figures->setSpacing(6);
  figures->addWidget(line_, 1);
  figures->addWidget(force_, 0, Qt::AlignBaseline);
  figures->addWidget(unit_, 0, Qt::AlignBaseline);
  figures->addStretch();
  figures->addWidget(torque_, 0, Qt::AlignBaseline);
  figures->addWidget(fold_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInside, 6, kInside, style::kGap);
  column->setSpacing(style::kStep);
  column->addLayout(figures);
  column->addWidget(near_);
  column->addWidget(plot_);
  column->addWidget(touch_);
  column->addWidget(with_);
  showParts();
  display({});
}

void ForcePanel::showNear(const std::vector<StructureNear>& near, const NearLimits& limits) {
  near_->show(near, limits);
  watches_ = !near.empty();
  showParts();
}

void ForcePanel::setHand(const QString& label) { with_->setText(label); }

void ForcePanel::display(const haptics::Snapshot& snapshot,
                         const std::optional<TouchedValue>& touched) {
  say(force_, QLocale().toString(snapshot.felt_W.force.norm(), 'f', 2));
  say(torque_, tr("%1 mN·m").arg(snapshot.felt_W.torque.norm() * 1000.0, 0, 'f', 0));
  const QString touch = touchWords(snapshot, touched);
  say(touch_, touch);
  say(line_, tr("%1 N · %2").arg(force_->text(), touch));
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
  if (compact == compact_) return;
  compact_ = compact;
  showParts();
}

void ForcePanel::setFolded(bool folded) {
  if (folded == folded_) return;
  folded_ = folded;
  showParts();
}

int ForcePanel::heightIf(bool folded) const {
  const QMargins inside = layout()->contentsMargins();
  int height = inside.top() + inside.bottom();
  // distances are told in one line, too
  const int near = watches_ ? layout()->spacing() + near_->sizeHint().height() : 0;
  if (folded && !compact_) return height + std::max(kFold, line_->sizeHint().height()) + near;
  height += force_->sizeHint().height();
  if (compact_) return height;
  height += near;
  for (const QWidget* part : std::initializer_list<QWidget*>{plot_, touch_, with_})
    height += layout()->spacing() + std::max(part->sizeHint().height(), part->minimumHeight());
  return height;
}

void ForcePanel::showParts() {
  const bool whole = !compact_ && !folded_;
  for (QWidget* part : std::initializer_list<QWidget*>{plot_, torque_, touch_, with_})
    part->setVisible(whole);
  near_->setVisible(!compact_ && watches_);
  for (QWidget* part : {force_, unit_}) part->setVisible(compact_ || !folded_);
  line_->setVisible(!compact_ && folded_);
  fold_->setVisible(!compact_);
  fold_->setArrowType(folded_ ? Qt::UpArrow : Qt::DownArrow);
  const QString tip = folded_ ? tr("Show force, torque and curve") : tr("Fold to one line");
  fold_->setToolTip(tip);
  fold_->setAccessibleName(tip);
  setFixedWidth(compact_ ? kCompactWidth : kWidth);
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
