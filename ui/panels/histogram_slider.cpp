// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/histogram_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {

HistogramSlider::HistogramSlider(QWidget* parent) : QAbstractSlider(parent) {
  setOrientation(Qt::Horizontal);
  setRange(0, kSteps);
  setSingleStep(8);
  setPageStep(kSteps / 16);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
}

void HistogramSlider::setHistogram(const Histogram& histogram) {
  histogram_ = histogram;
  tallest_ = 1.0;
  for (const double count : histogram_.counts) tallest_ = std::max(tallest_, std::log1p(count));
  update();
}

double HistogramSlider::intensityAt(int step) const {
  return histogram_.least + (histogram_.greatest - histogram_.least) * step / kSteps;
}

int HistogramSlider::stepOf(double intensity) const {
  const double width = histogram_.greatest - histogram_.least;
  if (!(width > 0.0)) return 0;
  return std::clamp(qRound((intensity - histogram_.least) / width * kSteps), 0, kSteps);
}

void HistogramSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const style::Colours& c = style::colours();
  painter.fillRect(rect(), c.control);
  const double mark = (width() - 1) * static_cast<double>(value()) / kSteps;
  const auto bins = static_cast<int>(histogram_.counts.size());
  for (int x = 0; x < width() && bins > 0; ++x) {
    const auto bin = static_cast<std::size_t>(std::min(bins - 1, x * bins / width()));
    const double tall = std::log1p(histogram_.counts[bin]) / tallest_ * (height() - 4);
    painter.fillRect(QRectF{x + 0.0, height() - tall, 1.0, tall}, x >= mark ? c.solid : c.empty);
  }
  painter.setPen(QPen(c.accent, 2.0));
  painter.drawLine(QPointF{mark, 0.0}, QPointF{mark, height() + 0.0});
  if (!hasFocus()) return;
  painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
}

void HistogramSlider::follow(double x) {
  setSliderPosition(std::clamp(qRound(x / std::max(1, width() - 1) * kSteps), 0, kSteps));
}

void HistogramSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setSliderDown(true);
  follow(event->position().x());
}

void HistogramSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) follow(event->position().x());
}

void HistogramSlider::mouseReleaseEvent(QMouseEvent*) { setSliderDown(false); }

}  // namespace ui
