// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/near_line.h"

#include <QPainter>
#include <QWidget>

#include "ui/overlays/marks_style.h"

namespace ui {
namespace {

constexpr double kShortest = 6.0;  // pixels: of a shorter way the ends are one place
constexpr double kBeside = 6.0;    // pixels between the line and its label
constexpr int kWordPixels = 11;

}  // namespace

void NearLine::show(const std::optional<Way>& way) {
  const bool was = way_.has_value();
  way_ = way;
  if (was || way_) emit changed();
}

void NearLine::paint(QPainter& painter, const ViewGeometry& view) const {
  if (!way_ || view.isSlice()) return;
  const QPointF from = view.projected(way_->tip_mm), to = view.projected(way_->structure_mm);
  const QPointF by = to - from;
  if (!(QPointF::dotProduct(by, by) >= kShortest * kShortest)) return;
  painter.setRenderHint(QPainter::Antialiasing);
  drawLine(painter, QPolygonF(QList<QPointF>{from, to}), style::kMeasure, 1.5, true);
  QFont font = view.widget().font();
  font.setPixelSize(kWordPixels);
  painter.setFont(font);
  QRectF box{{}, labelSize(font, way_->words)};
  box.moveCenter(0.5 * (from + to) + QPointF(0.0, 0.5 * box.height() + kBeside));
  if (view.room().contains(box)) drawLabel(painter, box, way_->words);
}

}  // namespace ui
