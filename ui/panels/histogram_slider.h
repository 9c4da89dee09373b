// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractSlider>

#include "ui/props/picture.h"

namespace ui {

/// A slider that stands on a histogram: drag, wheel, arrow keys. What it selects is the solid
/// side, drawn bright. Counts are drawn by their logarithm, or air would hide all else.
class HistogramSlider : public QAbstractSlider {
  Q_OBJECT
 public:
  static constexpr int kSteps = 4096;

  explicit HistogramSlider(QWidget* parent = nullptr);

  void setHistogram(const Histogram& histogram);
  double intensityAt(int step) const;
  int stepOf(double intensity) const;
  QSize sizeHint() const override { return {260, 110}; }
  QSize minimumSizeHint() const override { return {160, 80}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void follow(double x);
  Histogram histogram_;
  double tallest_ = 1.0;  ///< of the logarithms
};

}  // namespace ui
