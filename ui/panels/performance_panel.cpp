// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/performance_panel.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
namespace {

QLabel* sentence(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  // to be copied into a mail, also without a mouse
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->hide();
  return label;
}

void say(QLabel* label, const QString& text) {
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

}  // namespace

PerformancePanel::PerformancePanel(QWidget* parent)
    : QWidget(parent),
      measure_(new QPushButton),
      progress_(new QProgressBar),
      headline_(sentence("performanceHeadline")),
      details_(sentence("performanceDetails")),
      plot_(new LoadPlot),
      suggestion_(sentence("performanceSuggestion")),
      left_out_title_(new QLabel(tr("Left out"))),
      left_out_(sentence("leftOut")) {
  measure_->setObjectName("measure");
  progress_->setObjectName("measureProgress");
  progress_->setRange(0, 1000);
  progress_->setAccessibleName(tr("How far the measurement is"));
  plot_->setObjectName("loadPlot");
  plot_->hide();
  QFont bold = font();
  bold.setBold(true);
  headline_->setFont(bold);
  left_out_title_->setFont(bold);
  left_out_title_->hide();
  left_out_->setTextFormat(Qt::RichText);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(measure_);
  column->addWidget(progress_);
  column->addWidget(headline_);
  column->addWidget(suggestion_);
  column->addWidget(plot_);
  column->addWidget(details_);
  column->addWidget(left_out_title_);
  column->addWidget(left_out_);

  setFocusProxy(measure_);
  connect(measure_, &QPushButton::clicked, this, [this] {
    if (measuring_)
      emit cancelWanted();
    else
      emit measureWanted();
  });
  end();
}

void PerformancePanel::end() {
  measuring_ = false;
  measure_->setText(tr("&Measure this machine"));
  measure_->setToolTip(
      tr("Ten seconds with the present volume, tool and stiffness: how long a tick takes, and how "
         "many points this machine carries"));
  measure_->setEnabled(ready_);
  progress_->hide();
}

void PerformancePanel::setReady(bool ready) {
  ready_ = ready;
  measure_->setEnabled(ready_ || measuring_);
}

void PerformancePanel::showMeasuring() {
  measuring_ = true;
  measure_->setText(tr("Cancel"));
  measure_->setToolTip(tr("Ends the measurement without a result"));
  progress_->setValue(0);
  progress_->show();
}

void PerformancePanel::showProgress(double fraction) {
  progress_->setValue(qRound(fraction * 1000.0));
}

void PerformancePanel::show(const Performance& performance) {
  end();
  say(headline_, headlineOf(performance));
  say(suggestion_, suggestionOf(performance));
  say(details_, detailsOf(performance));
  plot_->show(performance.present, performance.tried, performance.budget);
  plot_->show();
}

void PerformancePanel::showNothing(const QString& why) {
  end();
  say(headline_, {});
  say(suggestion_, {});
  say(details_, why);
  plot_->hide();
}

void PerformancePanel::showLeftOut(const QList<LeftOut>& left_out) {
  QString lines;
  for (const LeftOut& line : left_out)
    lines += tr("<p><b>%1</b>: %2</p>").arg(line.what.toHtmlEscaped(), line.why.toHtmlEscaped());
  left_out_title_->setVisible(!left_out.isEmpty());
  say(left_out_, lines);
}

}  // namespace ui
