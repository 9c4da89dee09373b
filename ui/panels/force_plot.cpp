// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_plot.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {

constexpr std::size_t kCapacity = 10'000;  // ten seconds of 1 kHz

// the least of 1, 2, 5, 10, … that is not below `value`
double roundScale(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * decade) return step * decade;
  return 10.0 * decade;
}

}  // namespace

ForcePlot::ForcePlot(QWidget* parent) : QWidget(parent) {
  ring_.resize(kCapacity);
  setAccessibleName(tr("Force over time"));
}

void ForcePlot::append(std::span<const ForcePoint> points) {
  if (points.empty()) return;
  if (points.front().time < newest_) clear();  // a new session's clock starts again
  for (const ForcePoint& point : points) {
    ring_[next_] = point;
    next_ = (next_ + 1) % kCapacity;
    full_ = full_ || next_ == 0;
  }
  newest_ = points.back().time;
  if (isVisible()) update();
}

void ForcePlot::clear() {
  next_ = 0;
  full_ = false;
  newest_ = 0.0;
  update();
}

std::vector<ForcePlot::Column> ForcePlot::columns(int count, double from, double to) const {
  std::vector<Column> columns(static_cast<std::size_t>(std::max(1, count)),
                              Column{0.0F, 0.0F, 0.0F, 0.0F, false});
  const std::size_t size = full_ ? kCapacity : next_;
  for (std::size_t i = 0; i < size; ++i) {
    const ForcePoint& p = ring_[i];
    if (p.time < from) continue;
    const auto x = static_cast<std::size_t>(
        std::clamp((p.time - from) / (to - from) * count, 0.0, count - 1.0));
    Column& c = columns[x];
    if (!c.any) c = {p.force, p.force, p.torque, p.torque, true};
    c.least_force = std::min(c.least_force, p.force);
    c.greatest_force = std::max(c.greatest_force, p.force);
    c.least_torque = std::min(c.least_torque, p.torque);
    c.greatest_torque = std::max(c.greatest_torque, p.torque);
  }
  return columns;
}

void ForcePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QRect area = rect().adjusted(4, 16, -4, -4);
  const double to = std::max(newest_, kSeconds), from = to - kSeconds;
  const std::vector<Column> pixels = columns(area.width(), from, to);
  greatest_force_ = greatest_torque_ = 0.0F;
  for (const Column& c : pixels) {
    greatest_force_ = std::max(greatest_force_, c.greatest_force);
    greatest_torque_ = std::max(greatest_torque_, c.greatest_torque);
  }
  const double force_top = roundScale(std::max(1.0F, greatest_force_));
  const double torque_top = roundScale(std::max(0.01F, greatest_torque_));

  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0, Qt::DotLine));
  for (int line = 0; line <= 4; ++line) {
    const int y = area.bottom() - area.height() * line / 4;
    painter.drawLine(area.left(), y, area.right(), y);
  }
  const QColor force(230, 90, 30), torque(80, 130, 220);
  const auto draw = [&](const QColor& colour, double top, float Column::*least,
                        float Column::*greatest) {
    painter.setPen(colour);
    double last_y = -1.0;
    for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
      const Column& c = pixels[static_cast<std::size_t>(i)];
      if (!c.any) continue;
      double high = area.bottom() - c.*greatest / top * area.height();
      double low = area.bottom() - c.*least / top * area.height();
      // join to the pixel before
      if (last_y >= 0.0) {
        high = std::min(high, last_y);
        low = std::max(low, last_y);
      }
      painter.drawLine(QPointF{area.left() + i + 0.5, high}, QPointF{area.left() + i + 0.5, low});
      last_y = area.bottom() - c.*greatest / top * area.height();
    }
  };
  draw(torque, torque_top, &Column::least_torque, &Column::greatest_torque);
  draw(force, force_top, &Column::least_force, &Column::greatest_force);

  QFont font = painter.font();
  font.setPointSizeF(8.0);
  painter.setFont(font);
  painter.setPen(force);
  painter.drawText(rect().adjusted(4, 1, -4, 0), Qt::AlignLeft | Qt::AlignTop,
                   tr("Force, to %1 N").arg(force_top));
  painter.setPen(torque);
  painter.drawText(rect().adjusted(4, 1, -4, 0), Qt::AlignRight | Qt::AlignTop,
                   tr("Torque, to %1 mN·m").arg(torque_top * 1000.0));
}

}  // namespace ui
