// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/isosurface_panel.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace ui {

IsosurfacePanel::IsosurfacePanel(QWidget* parent)
    : QWidget(parent),
      slider_(new HistogramSlider),
      typed_(new QDoubleSpinBox),
      presets_(new QWidget),
      range_(new QLabel) {
  slider_->setObjectName("isovalueSlider");
  slider_->setAccessibleName(tr("Isovalue"));
  typed_->setObjectName("isovalueTyped");
  typed_->setAccessibleName(tr("Isovalue, typed"));
  typed_->setKeyboardTracking(false);
  presets_->setObjectName("presets");

  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Isovalue")));
  row->addWidget(typed_, 1);
  auto* buttons = new QHBoxLayout(presets_);
  buttons->setContentsMargins(0, 0, 0, 0);
  const auto preset = [&](const QString& label, const char* name, double isovalue) {
    auto* button = new QPushButton(label);
    button->setObjectName(name);
    button->setToolTip(tr("A starting point, not a threshold for diagnosis"));
    connect(button, &QPushButton::clicked, this, [this, isovalue] { choose(isovalue); });
    buttons->addWidget(button);
  };
  preset(tr("Bone %1 HU").arg(kBone_HU), "presetBone", kBone_HU);
  preset(tr("Skin %1 HU").arg(kSkin_HU), "presetSkin", kSkin_HU);
  presets_->hide();
  auto* column = new QVBoxLayout(this);
  column->addWidget(slider_, 1);
  column->addWidget(range_);
  column->addLayout(row);
  column->addWidget(presets_);
  setEnabled(false);

  connect(slider_, &QAbstractSlider::valueChanged, this,
          [this](int step) { choose(slider_->intensityAt(step)); });
  connect(typed_, &QDoubleSpinBox::valueChanged, this, &IsosurfacePanel::choose);
}

void IsosurfacePanel::show(const Picture& picture, double isovalue) {
  const haptics::Volume& volume = *picture.volume;
  least_ = volume.least;
  greatest_ = volume.greatest;
  const bool whole = volume.type != haptics::ScalarType::Float32;
  const double range = greatest_ - least_;
  grain_ = whole ? 1.0 : std::pow(10.0, std::floor(std::log10(std::max(range, 1e-6) / 1000.0)));
  const QSignalBlocker quiet_slider(slider_), quiet_typed(typed_);
  slider_->setHistogram(picture.histogram);
  typed_->setDecimals(std::clamp(whole ? 0 : 1 - static_cast<int>(std::log10(grain_)), 0, 9));
  // wider than what is allowed, so that a refusal can be said instead of silently corrected
  typed_->setRange(least_ - range - 1.0, greatest_);
  typed_->setSingleStep(std::max(grain_, range / 200.0));
  typed_->setSuffix(volume.unit.empty() ? QString() : " " + QString::fromStdString(volume.unit));
  range_->setText(tr("%1 to %2 %3")
                      .arg(least_, 0, 'g', 6)
                      .arg(greatest_, 0, 'g', 6)
                      .arg(QString::fromStdString(volume.unit)));
  presets_->setVisible(volume.unit == "HU");
  setEnabled(true);
  isovalue_ = allowed(isovalue);
  showValue(isovalue_);
}

double IsosurfacePanel::allowed(double isovalue) const {
  return std::clamp(isovalue, std::min(least_ + grain_, greatest_), greatest_);
}

void IsosurfacePanel::choose(double isovalue) {
  const double possible = allowed(isovalue);
  if (isovalue <= least_)
    emit refused(
        tr("The isovalue must lie above the volume's least value, %1.").arg(least_, 0, 'g', 6));
  else if (isovalue > greatest_)
    emit refused(tr("Nothing in this volume is above %1.").arg(greatest_, 0, 'g', 6));
  showValue(possible);
  if (possible == isovalue_) return;
  isovalue_ = possible;
  emit isovalueChanged(possible);
}

void IsosurfacePanel::showValue(double isovalue) {
  const QSignalBlocker quiet_slider(slider_), quiet_typed(typed_);
  if (!slider_->isSliderDown()) slider_->setValue(slider_->stepOf(isovalue));
  typed_->setValue(isovalue);
  slider_->update();
}

}  // namespace ui
