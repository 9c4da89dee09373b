// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/histogram_slider.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/panels/tissue_bands.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kBandHeight = 4;
constexpr double kRoom = 8.0;  // pixels between two words of the axis

/// 1, 2 or 5 times a power of ten, so that about four of them fit.
double tickOf(double range) {
  const double rough = range / 4.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= rough) return times * power;
  return 10.0 * power;
}

}  // namespace

HistogramSlider::HistogramSlider(QWidget* parent) : QAbstractSlider(parent) {
  offerSpoken();
  setOrientation(Qt::Horizontal);
  setRange(0, kSteps);
  setPageStep(kSteps / 16);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setToolTip(tr("Drag, or press the arrow keys; with Shift in small steps"));
}

void HistogramSlider::setIntensity(double intensity) {
  const bool other = intensity != intensity_;
  intensity_ = intensity;
  // while it is dragged it stays under the mouse
  if (!isSliderDown()) setValue(stepOf(intensity));
  if (other) tellSpokenNumber(*this);
  update();
}

QString HistogramSlider::spokenName() const {
  return unit_.isEmpty() ? accessibleName() : tr("%1 in %2").arg(accessibleName(), unit_);
}

QString HistogramSlider::spokenValue() const {
  QString number = QLocale().toString(intensity_, 'g', 6);
  return unit_.isEmpty() ? number : number + ' ' + unit_;
}

std::optional<SpokenNumber> HistogramSlider::spokenNumber() const {
  return SpokenNumber{.now = intensity_,
                      .least = histogram_.least,
                      .most = histogram_.greatest,
                      .step = (histogram_.greatest - histogram_.least) / kSteps};
}

void HistogramSlider::setHistogram(const Histogram& histogram, const QString& unit) {
  histogram_ = histogram;
  unit_ = unit;
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
  const auto bins = static_cast<int>(histogram_.counts.size());
  if (bins == 0) {
    painter.setPen(c.dim);
    painter.drawText(rect(), Qt::AlignCenter, tr("No scan yet"));
    return;
  }
  const double mark = (width() - 1) * static_cast<double>(value()) / kSteps;
  const int foot = height() - axisHeight();
  for (int x = 0; x < width(); ++x) {
    const auto bin = static_cast<std::size_t>(std::min(bins - 1, x * bins / width()));
    const double tall = std::log1p(histogram_.counts[bin]) / tallest_ * (foot - 4);
    painter.fillRect(QRectF{x + 0.0, foot - tall, 1.0, tall}, x >= mark ? c.solid : c.empty);
  }
  drawAxis(painter);
  painter.setPen(QPen(c.accent, 2.0));
  painter.drawLine(QPointF{mark, 0.0}, QPointF{mark, foot + 0.0});
  if (!hasFocus()) return;
  painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
}

double HistogramSlider::xOf(double intensity) const {
  const double width_of = histogram_.greatest - histogram_.least;
  const double share = width_of > 0.0 ? (intensity - histogram_.least) / width_of : 0.0;
  return std::clamp(share, 0.0, 1.0) * (width() - 1);
}

int HistogramSlider::axisHeight() const {
  const int line = fontMetrics().height();
  return unit_ == QLatin1String("HU") ? 2 * line + kBandHeight + 4 : line + 4;
}

void HistogramSlider::drawAxis(QPainter& painter) const {
  const double range = histogram_.greatest - histogram_.least;
  if (!(range > 0.0)) return;
  const int line = fontMetrics().height();
  double top = height() - axisHeight() + 2.0;
  painter.setPen(style::colours().dim);
  // words from left to right, as far as they have room
  const auto place = [&](double middle, const QString& word, double& free_from) {
    const double wide = fontMetrics().horizontalAdvance(word);
    const double left = std::clamp(middle - wide / 2.0, 0.0, std::max(0.0, width() - wide));
    if (left < free_from) return;
    painter.drawText(QRectF{left, top, wide + 1.0, line + 0.0}, Qt::AlignLeft, word);
    free_from = left + wide + kRoom;
  };
  if (unit_ == QLatin1String("HU")) {
    double free_from = 0.0;
    for (const TissueBand& band : kTissueBands) {
      if (band.to <= histogram_.least || band.from >= histogram_.greatest) continue;
      const double from = xOf(band.from), to = xOf(band.to);
      painter.fillRect(QRectF{from, top - 2.0, std::max(1.0, to - from), kBandHeight + 0.0},
                       style::colours().dim);
    }
    top += kBandHeight;
    for (const TissueBand& band : kTissueBands)
      if (band.to > histogram_.least && band.from < histogram_.greatest)
        place(0.5 * (xOf(band.from) + xOf(band.to)), nameOf(band), free_from);
    top += line;
  }
  const double tick = tickOf(range);
  const auto numberOf = [&](double value) {
    QLocale ungrouped = locale();  // a comma could be a decimal mark
    ungrouped.setNumberOptions(QLocale::OmitGroupSeparator);
    return ungrouped.toString(value, 'g', 6).replace('-', QChar(0x2212));
  };
  double free_from = 0.0;
  for (double at = std::ceil(histogram_.least / tick) * tick; at <= histogram_.greatest;
       at += tick) {
    const double value = std::abs(at) < 1e-9 * tick ? 0.0 : at;
    painter.drawLine(QPointF{xOf(value), top - 2.0}, QPointF{xOf(value), top + 1.0});
    place(xOf(value), numberOf(value), free_from);
  }
}

void HistogramSlider::keyPressEvent(QKeyEvent* event) {
  const bool fine = event->modifiers().testFlag(Qt::ShiftModifier);
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
    case Qt::Key_Minus:
      return emit stepWanted(-1, fine);
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Plus:
      return emit stepWanted(1, fine);
    default:
      QAbstractSlider::keyPressEvent(event);
  }
}

void HistogramSlider::wheelEvent(QWheelEvent* event) {
  // some platforms turn the wheel sideways while a key is held
  wheel_ += event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  const int steps = wheel_ / QWheelEvent::DefaultDeltasPerStep;
  wheel_ -= steps * QWheelEvent::DefaultDeltasPerStep;
  if (steps != 0) emit stepWanted(steps, event->modifiers().testFlag(Qt::ShiftModifier));
  event->accept();
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
