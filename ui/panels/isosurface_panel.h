// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>

#include "ui/panels/histogram_slider.h"
#include "ui/props/colouring.h"

class QGridLayout;
class QToolButton;

namespace ui {

class NumberBox;
class SecondSurface;

/// The nearest isovalue that a volume can have: above its least intensity, not above its greatest,
/// and with no more decimals than the panel shows. Any thread.
double allowedIsovalue(const haptics::Volume& volume, double isovalue);

/// The isovalue: a slider on the histogram, a number field, and a chip for each tissue if the
/// intensities are Hounsfield units.
class IsosurfacePanel : public QWidget {
  Q_OBJECT
 public:
  explicit IsosurfacePanel(QWidget* parent = nullptr);

  /// Shows another volume, at an isovalue within its range; emits nothing.
  void show(const Picture& picture, double isovalue);
  /// Other voxels of the same scan; range and isovalue stay.
  void replace(const Picture& picture);
  /// As if the user had chosen it.
  void choose(double isovalue);
  /// Below them, while there is one.
  SecondSurface& second() { return *second_; }

 signals:
  void isovalueChanged(double isovalue);
  /// A sentence: the isovalue that the user entered is not possible.
  void refused(const QString& sentence);

 private:
  void showValue(double isovalue);
  void addChip(Tissue tissue, const QString& words, const char* name, QGridLayout& chips);

  HistogramSlider* slider_;
  NumberBox* typed_;
  QWidget* presets_;
  std::array<QToolButton*, kTissues.size()> chips_{};
  SecondSurface* second_;
  std::shared_ptr<const haptics::Volume> volume_;
  std::array<double, kTissues.size()> of_chips_{};  ///< isovalues
  double isovalue_ = 0.0;
};

}  // namespace ui
