// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "ui/panels/histogram_slider.h"

class QLabel;

namespace ui {

class NumberBox;

/// The nearest isovalue that a volume can have: above its least intensity, not above its greatest,
/// and with no more decimals than the panel shows. Any thread.
double allowedIsovalue(const haptics::Volume& volume, double isovalue);

/// The isovalue: a slider on the histogram, a number field, and presets if the intensities are
/// Hounsfield units.
class IsosurfacePanel : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kBone_HU = 300.0;
  static constexpr double kSkin_HU = -300.0;

  explicit IsosurfacePanel(QWidget* parent = nullptr);

  /// Shows another volume, at an isovalue within its range; emits nothing.
  void show(const Picture& picture, double isovalue);
  /// Other voxels of the same scan; range and isovalue stay.
  void replace(const Picture& picture);
  /// As if the user had chosen it.
  void choose(double isovalue);

 signals:
  void isovalueChanged(double isovalue);
  /// A sentence: the isovalue that the user entered is not possible.
  void refused(const QString& sentence);

 private:
  void showValue(double isovalue);

  HistogramSlider* slider_;
  NumberBox* typed_;
  QWidget* presets_;
  QLabel* range_;
  std::shared_ptr<const haptics::Volume> volume_;
  double isovalue_ = 0.0;
};

}  // namespace ui
