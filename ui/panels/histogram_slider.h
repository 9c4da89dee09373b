// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractSlider>

#include "ui/props/picture.h"

namespace ui {

/// A slider on a histogram, moved by drag, wheel and arrow keys. The solid side of the value is
/// bright. Counts are logarithmic, because air has most of the voxels.
class HistogramSlider : public QAbstractSlider {
  Q_OBJECT
 public:
  static constexpr int kSteps = 4096;

  explicit HistogramSlider(QWidget* parent = nullptr);

  void setHistogram(const Histogram& histogram);
  const Histogram& histogram() const { return histogram_; }
  double intensityAt(int step) const;
  int stepOf(double intensity) const;
  QSize sizeHint() const override { return {260, 88}; }
  QSize minimumSizeHint() const override { return {160, 72}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void follow(double x);
  Histogram histogram_;
  double tallest_ = 1.0;  ///< greatest logarithm of the counts
};

}  // namespace ui
