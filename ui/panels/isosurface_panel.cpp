// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/isosurface_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/controls/number_box.h"
#include "ui/style/style.h"

namespace ui {
namespace {

// the power of ten below a thousandth of the range
int magnitudeOf(const haptics::Volume& volume) {
  const double range = std::max(volume.greatest - volume.least, 1e-6);
  return static_cast<int>(std::floor(std::log10(range / 1000.0)));
}

// the least step above the background that is a surface
double grainOf(const haptics::Volume& volume) {
  return volume.type == haptics::ScalarType::Float32 ? std::pow(10.0, magnitudeOf(volume)) : 1.0;
}

// finer than a step of the slider, which must never be rounded back to where it was
int decimalsOf(const haptics::Volume& volume) { return std::clamp(1 - magnitudeOf(volume), 0, 9); }

/// What an arrow key adds, and what it adds with Shift.
struct Steps {
  double coarse, fine;
};
Steps stepsOf(const haptics::Volume& volume) {
  if (volume.unit == "HU") return {10.0, 1.0};
  const double fine = std::max(grainOf(volume), std::pow(10.0, magnitudeOf(volume)));
  return {std::max(fine, 10.0 * std::pow(10.0, magnitudeOf(volume))), fine};
}

}  // namespace

double allowedIsovalue(const haptics::Volume& volume, double isovalue) {
  const double scale = std::pow(10.0, decimalsOf(volume));
  const double lowest = std::ceil((volume.least + grainOf(volume)) * scale);
  const double highest = std::floor(volume.greatest * scale);
  if (!(lowest <= highest)) return volume.greatest;
  return std::clamp(std::round(isovalue * scale), lowest, highest) / scale;
}

IsosurfacePanel::IsosurfacePanel(QWidget* parent)
    : QWidget(parent),
      slider_(new HistogramSlider),
      typed_(new NumberBox),
      presets_(new QWidget),
      range_(new QLabel) {
  slider_->setObjectName("isovalueSlider");
  slider_->setAccessibleName(tr("Isovalue"));
  typed_->setObjectName("isovalueTyped");
  typed_->setAccessibleName(tr("Isovalue, typed"));
  typed_->setToolTip(tr("The intensity of the surface that is seen and felt"));
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
  style::setDim(*range_);
  style::setType(*range_, style::Type::Small);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(slider_, 1);
  column->addWidget(range_);
  column->addLayout(row);
  column->addWidget(presets_);
  setEnabled(false);

  connect(slider_, &QAbstractSlider::valueChanged, this,
          [this](int step) { choose(slider_->intensityAt(step)); });
  connect(slider_, &HistogramSlider::stepWanted, this, [this](int steps, bool fine) {
    if (!volume_) return;
    const Steps step = stepsOf(*volume_);
    choose(isovalue_ + steps * (fine ? step.fine : step.coarse));
  });
  connect(slider_, &HistogramSlider::intensityWanted, this, &IsosurfacePanel::choose);
  connect(typed_, &NumberBox::valueChanged, this, &IsosurfacePanel::choose);
}

void IsosurfacePanel::show(const Picture& picture, double isovalue) {
  volume_ = picture.volume;
  const haptics::Volume& volume = *volume_;
  const double range = volume.greatest - volume.least;
  const QSignalBlocker quiet_slider(slider_), quiet_typed(typed_);
  slider_->setHistogram(picture.histogram, QString::fromStdString(volume.unit));
  typed_->setDecimals(decimalsOf(volume));
  // wider than what is allowed, so that a refusal can be said instead of silently corrected
  typed_->setRange(volume.least - range - 1.0, volume.greatest);
  typed_->setSingleStep(stepsOf(volume).coarse);
  typed_->setFineStep(stepsOf(volume).fine);
  typed_->setSuffix(volume.unit.empty() ? QString() : " " + QString::fromStdString(volume.unit));
  range_->setText(tr("%L1 to %L2 %3")
                      .arg(volume.least, 0, 'g', 6)
                      .arg(volume.greatest, 0, 'g', 6)
                      .arg(QString::fromStdString(volume.unit)));
  presets_->setVisible(volume.unit == "HU");
  setEnabled(true);
  isovalue_ = isovalue;
  showValue(isovalue_);
}

void IsosurfacePanel::replace(const Picture& picture) {
  volume_ = picture.volume;
  slider_->setHistogram(picture.histogram, QString::fromStdString(volume_->unit));
  showValue(isovalue_);
}

void IsosurfacePanel::choose(double isovalue) {
  if (!volume_) return;
  const double possible = allowedIsovalue(*volume_, isovalue);
  if (isovalue <= volume_->least)
    emit refused(tr("The isovalue must lie above the volume's least value, %L1.")
                     .arg(volume_->least, 0, 'g', 6));
  else if (isovalue > volume_->greatest)
    emit refused(tr("Nothing in this volume is above %L1.").arg(volume_->greatest, 0, 'g', 6));
  showValue(possible);
  if (possible == isovalue_) return;
  isovalue_ = possible;
  emit isovalueChanged(possible);
}

void IsosurfacePanel::showValue(double isovalue) {
  const QSignalBlocker quiet_slider(slider_), quiet_typed(typed_);
  slider_->setIntensity(isovalue);
  typed_->setValue(isovalue);
}

}  // namespace ui
