// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {
namespace {

QString wordsFor(haptics::ForceState state, haptics::ForceReason reason) {
  using haptics::ForceState;
  switch (state) {
    case ForceState::Off:
      return ForcePanel::tr("No force: nothing to touch, or no hand");
    case ForceState::Ready:
      return ForcePanel::tr("Force off");
    case ForceState::Ramping:
      return ForcePanel::tr("Force rising");
    case ForceState::On:
      return ForcePanel::tr("Force on");
    case ForceState::Fault:
      return ForcePanel::tr("Fault: force off");
    case ForceState::Armed:
      break;
  }
  return reason == haptics::ForceReason::Inside
             ? ForcePanel::tr("Surface moved: finding the outside")
             : ForcePanel::tr("Force withheld");
}

}  // namespace

ForcePanel::ForcePanel(QWidget* parent)
    : QWidget(parent),
      force_(new QLabel(tr("0.00 N"))),
      torque_(new QLabel(tr("0 mN·m"))),
      state_(new QLabel(tr("No device"))),
      plot_(new ForcePlot) {
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 2.0);
  large.setBold(true);
  force_->setFont(large);
  force_->setObjectName("forceNow");
  QFont medium = font();
  medium.setPointSizeF(medium.pointSizeF() * 1.3);
  torque_->setFont(medium);
  plot_->setObjectName("forcePlot");
  auto* figures = new QHBoxLayout;
  figures->addWidget(force_);
  figures->addStretch();
  figures->addWidget(torque_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(figures);
  column->addWidget(state_);
  column->addWidget(plot_, 1);
}

void ForcePanel::display(const haptics::Snapshot& snapshot) {
  force_->setText(tr("%1 N").arg(snapshot.felt_W.force.norm(), 0, 'f', 2));
  torque_->setText(tr("%1 mN·m").arg(snapshot.felt_W.torque.norm() * 1000.0, 0, 'f', 0));
  state_->setText(wordsFor(snapshot.force_state, snapshot.reason));
}

}  // namespace ui
