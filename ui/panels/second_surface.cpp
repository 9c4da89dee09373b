// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/second_surface.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/controls/number_box.h"
#include "ui/props/view_look.h"

namespace ui {

SecondSurface::SecondSurface(QWidget* parent)
    : QWidget(parent), isovalue_(new NumberBox), opacity_(new NumberBox) {
  isovalue_->setObjectName("secondIsovalue");
  isovalue_->setAccessibleName(tr("Isovalue of the second surface"));
  isovalue_->setToolTip(tr("The intensity of the second surface, which is seen and not felt"));
  opacity_->setObjectName("secondOpacity");
  opacity_->setAccessibleName(tr("Opacity of the second surface"));
  opacity_->setToolTip(tr("How much of what lies behind it the second surface hides"));
  opacity_->setRange(100.0 * kLeastOpacity, 100.0);
  opacity_->setDecimals(0);
  opacity_->setSingleStep(5.0);
  opacity_->setFineStep(1.0);
  opacity_->setSuffix(tr(" %"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->addWidget(new QLabel(tr("Second surface")), 0, 0);
  grid->addWidget(new QLabel(tr("Opacity")), 0, 1);
  grid->addWidget(isovalue_, 1, 0);
  grid->addWidget(opacity_, 1, 1);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 2);
  hide();
  connect(isovalue_, &NumberBox::valueChanged, this, &SecondSurface::isovalueWanted);
  connect(opacity_, &NumberBox::valueChanged, this,
          [this](double percent) { emit opacityWanted(percent / 100.0); });
}

void SecondSurface::setLike(const NumberBox& isovalues) {
  const QSignalBlocker quiet(isovalue_);
  isovalue_->setDecimals(isovalues.decimals());
  isovalue_->setRange(isovalues.minimum(), isovalues.maximum());
  isovalue_->setSingleStep(isovalues.singleStep());
  isovalue_->setSuffix(isovalues.suffix());
}

void SecondSurface::show(std::optional<double> isovalue, double opacity) {
  const QSignalBlocker quiet_isovalue(isovalue_), quiet_opacity(opacity_);
  if (isovalue) isovalue_->setValue(*isovalue);
  opacity_->setValue(100.0 * opacity);
  setVisible(isovalue.has_value());
}

}  // namespace ui
