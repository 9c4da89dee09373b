// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/isosurface_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/controls/number_box.h"
#include "ui/panels/second_surface.h"
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
      second_(new SecondSurface) {
  slider_->setObjectName("isovalueSlider");
  slider_->setAccessibleName(tr("Isovalue"));
  typed_->setObjectName("isovalueTyped");
  typed_->setAccessibleName(tr("Isovalue, typed"));
  presets_->setObjectName("presets");

  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Isovalue")));
  row->addWidget(typed_, 1);
  auto* chips = new QGridLayout(presets_);
  chips->setContentsMargins(0, 0, 0, 0);
  chips->setSpacing(style::kStep);
  addChip(Tissue::Bone, tr("Bone"), "presetBone", *chips);
  addChip(Tissue::Skin, tr("Skin"), "presetSkin", *chips);
  addChip(Tissue::Airway, tr("Airway"), "presetAirway", *chips);
  addChip(Tissue::Vessels, tr("Vessels"), "presetVessels", *chips);
  addChip(Tissue::Teeth, tr("Teeth"), "presetTeeth", *chips);
  presets_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(slider_, 1);
  column->addLayout(row);
  column->addWidget(presets_);
  column->addWidget(second_);
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

void IsosurfacePanel::addChip(Tissue tissue, const QString& words, const char* name,
                              QGridLayout& chips) {
  constexpr int kInRow = 3;
  const auto n = static_cast<std::size_t>(std::ranges::find(kTissues, tissue) - kTissues.begin());
  auto* chip = chips_[n] = new QToolButton;
  chip->setObjectName(name);
  chip->setText(words);
  chip->setCheckable(true);
  chip->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(chip, &QToolButton::clicked, this, [this, n] {
    choose(of_chips_[n]);
    showValue(isovalue_);  // a click does not take the mark away
  });
  chips.addWidget(chip, static_cast<int>(n) / kInRow, static_cast<int>(n) % kInRow);
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
  const QString unit = QString::fromStdString(volume.unit);
  typed_->setSuffix(unit.isEmpty() ? QString() : ' ' + unit);
  second_->setLike(*typed_);
  typed_->setToolTip(tr("The intensity of the surface that is seen and felt, from %L1 to %L2 %3")
                         .arg(volume.least, 0, 'g', 6)
                         .arg(volume.greatest, 0, 'g', 6)
                         .arg(unit)
                         .trimmed());
  for (std::size_t n = 0; n < kTissues.size(); ++n) {
    of_chips_[n] = isovalueOf(kTissues[n], picture);
    chips_[n]->setToolTip(
        tr("%L1 %2: a starting point, not a threshold for diagnosis").arg(of_chips_[n]).arg(unit));
  }
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
  for (std::size_t n = 0; n < chips_.size(); ++n) chips_[n]->setChecked(isovalue == of_chips_[n]);
}

}  // namespace ui
