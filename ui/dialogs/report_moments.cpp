// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/report_moments.h"

#include <QDialogButtonBox>
#include <QFontMetrics>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/controls/time_words.h"
#include "ui/style/style.h"

namespace ui {

ReportMoments::ReportMoments(const QString& recording, const QList<ReportMoment>& moments,
                             QWidget* parent)
    : QDialog(parent), moments_(moments), list_(new QTableWidget) {
  setObjectName("reportMoments");
  setWindowTitle(tr("Moments of %1").arg(recording));
  list_->setObjectName("moments");
  list_->setAccessibleName(tr("Moments of the session"));
  list_->setToolTip(tr("A click or Enter shows the moment in the replay"));
  style::makeLines(*list_);
  list_->setColumnCount(2);
  list_->setHorizontalHeaderLabels({tr("Time"), tr("What happened")});
  list_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  list_->setRowCount(static_cast<int>(moments.size()));
  for (int row = 0; row < list_->rowCount(); ++row) {
    const auto add = [&](int column, const QString& words) {
      auto* item = new QTableWidgetItem(words);
      item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
      list_->setItem(row, column, item);
    };
    add(0, clockTime(moments[row].time, 1));
    add(1, moments[row].what);
    list_->item(row, 0)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  connect(list_, &QTableWidget::cellClicked, this, &ReportMoments::go);
  connect(list_, &QTableWidget::cellActivated, this, &ReportMoments::go);
  auto* none = new QLabel(tr("The tool came near no structure."));
  none->setVisible(moments.isEmpty());
  list_->setVisible(!moments.isEmpty());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  // Enter belongs to the selected row
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(none);
  column->addWidget(list_, 1);
  column->addWidget(buttons);
  const QFontMetrics letters(font());
  resize(letters.averageCharWidth() * 60, letters.lineSpacing() * 18);
}

void ReportMoments::go(int row) { emit momentWanted(moments_[row].time); }

}  // namespace ui
