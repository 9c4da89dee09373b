// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/panels/force_words.h"

namespace ui {

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
  state_->setWordWrap(true);
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
  const QString why = sentenceFor(snapshot.force_state, snapshot.reason, snapshot.trouble);
  const QString state = tr("Force: %1").arg(nameOf(snapshot.force_state).toLower());
  state_->setText(why.isEmpty() ? state : tr("%1. %2").arg(state, why));
}

}  // namespace ui
