// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractSlider>

#include "ui/controls/spoken.h"
#include "ui/props/picture.h"

namespace ui {

/// A slider on a histogram. The solid side of the value is bright. Counts are logarithmic, because
/// air has most of the voxels. Below it stand an axis in the volume's unit and, for HU, bands of
/// tissues. Drag, Page Up and Down, Home and End move it; for arrow keys and wheel it asks the
/// owner.
class HistogramSlider : public QAbstractSlider, public Spoken {
  Q_OBJECT
 public:
  static constexpr int kSteps = 4096;

  explicit HistogramSlider(QWidget* parent = nullptr);

  /// `unit`: as the volume has it; may be empty.
  void setHistogram(const Histogram& histogram, const QString& unit);
  const Histogram& histogram() const { return histogram_; }
  /// Shows and says this value, which may be finer than a step of the slider.
  void setIntensity(double intensity);
  double intensity() const { return intensity_; }
  double intensityAt(int step) const;
  int stepOf(double intensity) const;
  QSize sizeHint() const override { return {260, 116}; }
  QSize minimumSizeHint() const override { return {160, 100}; }

  QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
  QString spokenName() const override;
  QString spokenValue() const override;
  std::optional<SpokenNumber> spokenNumber() const override;
  void takeSpoken(double intensity) override { emit intensityWanted(intensity); }

 signals:
  /// An arrow key or the wheel; `fine` while Shift is held.
  void stepWanted(int steps, bool fine);
  /// A screen reader set this intensity.
  void intensityWanted(double intensity);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void follow(double x);
  double xOf(double intensity) const;
  int axisHeight() const;
  void drawAxis(QPainter& painter) const;

  Histogram histogram_;
  QString unit_;
  double intensity_ = 0.0;
  int wheel_ = 0;         ///< eighths of a degree that are no step yet
  double tallest_ = 1.0;  ///< greatest logarithm of the counts
};

}  // namespace ui
