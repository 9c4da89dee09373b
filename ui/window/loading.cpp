// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/loading.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "ui/window/start_page.h"

namespace ui {
namespace {

constexpr int kSteps = 1000;
constexpr int kWidth = 180;  // px

}  // namespace

Loading::Loading(StartPage& start) : start_(start), what_(new QLabel), progress_(new QProgressBar) {
  auto* cancel = new QToolButton;
  cancel->setObjectName("cancelLoading");
  cancel->setText(tr("Cancel"));
  cancel->setToolTip(tr("Cancels the loading or the computation"));
  connect(cancel, &QToolButton::clicked, this, &Loading::cancelWanted);
  connect(&start_, &StartPage::cancelWanted, this, &Loading::cancelWanted);
  progress_->setRange(0, kSteps);
  progress_->setMaximumWidth(kWidth);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(what_);
  row->addWidget(progress_);
  row->addWidget(cancel);
  hide();
}

void Loading::begin(const QString& what) {
  if (!start_.isHidden()) return start_.setLoading(what);
  // the same again leaves the bar as it is: a new range paints the window at once
  if (isVisible() && what_->text() == what) return;
  what_->setText(what);
  progress_->setRange(0, 0);  // busy, until a fraction is known
  show();
}

void Loading::advance(double fraction) {
  if (!start_.isHidden()) return start_.setProgress(fraction);
  progress_->setRange(0, kSteps);
  progress_->setValue(qRound(fraction * kSteps));
}

void Loading::end() {
  start_.setLoading({});
  hide();
  if (!behind_.isEmpty()) begin(behind_);
}

void Loading::setBehind(const QString& what) {
  const bool seen = isHidden() || what_->text() == behind_;
  behind_ = what;
  if (seen) end();
}

void Loading::advanceBehind(double fraction) {
  if (what_->text() == behind_) advance(fraction);
}

}  // namespace ui
