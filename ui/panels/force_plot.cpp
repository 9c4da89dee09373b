// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/force_plot.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr std::size_t kCapacity = 10'000;  // ten seconds of 1 kHz
constexpr int kPauseMs = 50;               // between two paints

// the least of 1, 2, 5, 10, … that is not below `value`
double roundScale(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * decade) return step * decade;
  return 10.0 * decade;
}

}  // namespace

ForcePlot::ForcePlot(QWidget* parent) : QWidget(parent) {
  offerSpoken();
  ring_.resize(kCapacity);
  setAccessibleName(tr("Force over time"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&pause_, &QTimer::timeout, this, [this] {
    if (waits_) drawAnew();
  });
}

void ForcePlot::append(std::span<const haptics::ForceSample> points) {
  if (points.empty()) return;
  if (points.front().time < newest_) clear();  // a new session's clock starts again
  for (const haptics::ForceSample& point : points) {
    ring_[next_] = point;
    next_ = (next_ + 1) % kCapacity;
    full_ = full_ || next_ == 0;
    level(point);
  }
  newest_ = points.back().time;
  // where all that was painted was level and it stays so, the same would be painted again
  const bool changes = level_->since > painted_ - kSeconds;
  // under another tab it counts as visible, and to update it would compose the window for nothing
  if (!changes || visibleRegion().isEmpty()) return;
  if (pause_.isActive())
    waits_ = true;
  else
    drawAnew();
}

void ForcePlot::drawAnew() {
  waits_ = false;
  drawn_ = {};
  update();
  pause_.start();
}

void ForcePlot::level(const haptics::ForceSample& point) {
  const Level alone{point.time, point.force, point.force, point.torque, point.torque};
  if (!level_) level_ = alone;
  level_->least_force = std::min(level_->least_force, point.force);
  level_->greatest_force = std::max(level_->greatest_force, point.force);
  level_->least_torque = std::min(level_->least_torque, point.torque);
  level_->greatest_torque = std::max(level_->greatest_torque, point.torque);
  const double half_pixel = 0.5 / std::max(1, area().height());
  if (level_->greatest_force - level_->least_force > half_pixel * force_top_ ||
      level_->greatest_torque - level_->least_torque > half_pixel * torque_top_)
    level_ = alone;
}

void ForcePlot::clear() {
  next_ = 0;
  full_ = false;
  newest_ = painted_ = 0.0;
  level_.reset();
  drawn_ = {};
  update();
}

std::vector<ForcePlot::Column> ForcePlot::columns(int count, double from, double to) const {
  std::vector<Column> columns(static_cast<std::size_t>(std::max(1, count)),
                              Column{0.0F, 0.0F, 0.0F, 0.0F, false});
  const std::size_t size = full_ ? kCapacity : next_;
  for (std::size_t i = 0; i < size; ++i) {
    const haptics::ForceSample& p = ring_[i];
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
  const qreal scale = devicePixelRatioF();
  if (drawn_.isNull() || drawn_.size() != size() * scale) draw();
  QPainter(this).drawPixmap(0, 0, drawn_);
}

void ForcePlot::draw() {
  ++drawings_;
  drawn_ = QPixmap(size() * devicePixelRatioF());
  drawn_.setDevicePixelRatio(devicePixelRatioF());
  drawn_.fill(style::kDark.panel);
  QPainter painter(&drawn_);
  const QRect area = this->area();
  painted_ = newest_;
  const double to = std::max(newest_, kSeconds), from = to - kSeconds;
  const std::vector<Column> pixels = columns(area.width(), from, to);
  greatest_force_ = greatest_torque_ = 0.0F;
  for (const Column& c : pixels) {
    greatest_force_ = std::max(greatest_force_, c.greatest_force);
    greatest_torque_ = std::max(greatest_torque_, c.greatest_torque);
  }
  force_top_ = roundScale(std::max(1.0F, greatest_force_));
  torque_top_ = roundScale(std::max(0.01F, greatest_torque_));

  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0, Qt::DotLine));
  for (int line = 0; line <= 2; ++line) {
    const int y = area.bottom() - area.height() * line / 2;
    painter.drawLine(area.left(), y, area.right(), y);
  }
  const QColor &force = style::kDark.force, &torque = style::kDark.torque;
  const auto trace = [&](const QColor& colour, double top, float Column::*least,
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
  trace(torque, torque_top_, &Column::least_torque, &Column::greatest_torque);
  trace(force, force_top_, &Column::least_force, &Column::greatest_force);

  painter.setFont(style::font(style::Type::Small));
  const QString force_words = tr("force to %L1 N").arg(force_top_);
  const QString torque_words = tr("torque to %L1 mN·m").arg(torque_top_ * 1000.0);
  const QFontMetrics metrics = painter.fontMetrics();
  const bool beside = metrics.horizontalAdvance(force_words + "  " + torque_words) <= width();
  painter.setPen(force);
  painter.drawText(rect(), Qt::AlignLeft | Qt::AlignTop, force_words);
  painter.setPen(torque);
  painter.drawText(rect().adjusted(0, beside ? 0 : metrics.lineSpacing(), 0, 0),
                   Qt::AlignRight | Qt::AlignTop, torque_words);
}

}  // namespace ui
