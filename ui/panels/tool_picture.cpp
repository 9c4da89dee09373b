// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/tool_picture.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPen>
#include <QPixmapCache>
#include <QPolygonF>
#include <QString>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace ui {
namespace {

constexpr double kLargestScale = 1.9;  // pixels of the widget to the millimetre
constexpr double kRim = 2.0;           // pixels of the widget
constexpr double kOutlineWidth = 0.9;
constexpr double kFade = 20.0;
constexpr std::size_t kMostTriangles = 300'000;  // drawn in about 0.1 s

/// Twice the area of a triangle on the picture, positive if it is seen from its outer side.
double areaSeen(const std::array<QPointF, 3>& t) {
  const QPointF u = t[1] - t[0], v = t[2] - t[0];
  return u.y() * v.x() - u.x() * v.y();
}

/// A closed line without the teeth of a rod that has few points around.
QPolygonF smoothed(const QPolygonF& line) {
  QPolygonF smooth;
  const qsizetype count = line.size();
  for (qsizetype k = 0; k < count; ++k)
    smooth << 0.25 * line[(k + count - 1) % count] + 0.5 * line[k] + 0.25 * line[(k + 1) % count];
  return smooth;
}

}  // namespace

ToolPicture::ToolPicture(const haptics::TriangleMesh& mesh) {
  static quint64 drawings = 0;
  number_ = ++drawings;
  for (const haptics::Vec3& v : mesh.vertices) points_.emplace_back(-1e3 * v.z(), 1e3 * v.x());
  bounds_ = QPolygonF(QList<QPointF>(points_.begin(), points_.end())).boundingRect();
  if (mesh.triangles.size() > kMostTriangles) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;  // of what is seen
  for (const auto& t : mesh.triangles) {
    const std::array<QPointF, 3> corners{points_[t[0]], points_[t[1]], points_[t[2]]};
    if (areaSeen(corners) <= 0.0) continue;
    for (std::size_t q = 0; q < 3; ++q) sides.emplace_back(t[q], t[(q + 1) % 3]);
  }
  std::ranges::sort(sides);
  // the border of all that is seen, in closed lines: it surrounds each place at least once
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b] : sides)
    if (!std::ranges::binary_search(sides, std::pair{b, a})) next.emplace(a, b);
  body_.setFillRule(Qt::WindingFill);
  while (!next.empty()) {
    QPolygonF line;
    for (auto side = next.begin(); side != next.end();) {
      line << points_[side->first];
      const std::uint32_t to = side->second;
      next.erase(side);
      side = next.find(to);
    }
    body_.addPolygon(smoothed(line));
    body_.closeSubpath();
  }
}

QPixmap ToolPicture::pixmap(QSize size, double ratio, const QColor& ink) const {
  const QString key = QString("tool picture %1 %2x%3 %4 %5")
                          .arg(number_)
                          .arg(size.width())
                          .arg(size.height())
                          .arg(ratio)
                          .arg(ink.rgba(), 8, 16);
  QPixmap picture;
  if (QPixmapCache::find(key, &picture)) return picture;
  picture = drawn(size, ratio, ink);
  QPixmapCache::insert(key, picture);
  return picture;
}

QPixmap ToolPicture::drawn(QSize size, double ratio, const QColor& ink) const {
  QPixmap picture(size * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  if (points_.empty()) return picture;
  const double width = size.width() - 2.0 * kRim, height = size.height() - 2.0 * kRim;
  const double scale = std::min(kLargestScale, height / std::max(1e-3, bounds_.height()));
  // a short tool stands in the middle, a long one ends at the right; what is seen of it is centred
  const double right = bounds_.right() + 0.5 * std::max(0.0, width / scale - bounds_.width());
  const double left = right - width / scale;
  double low = bounds_.bottom(), high = bounds_.top();
  for (const QPointF& p : points_)
    if (p.x() >= left) low = std::min(low, p.y()), high = std::max(high, p.y());

  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.save();
  painter.translate(size.width() - kRim, 0.5 * size.height());
  painter.scale(scale, scale);
  painter.translate(-right, -0.5 * (low + high));
  QColor flat = ink;
  flat.setAlphaF(0.35F * static_cast<float>(ink.alphaF()));
  // the line lies around the body: what is broad keeps its size, and what is slim is still seen
  painter.strokePath(
      body_, QPen(ink, 2.0 * kOutlineWidth / scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.fillPath(body_, flat);
  painter.restore();
  if (bounds_.width() * scale > width) {
    QLinearGradient fade(0.0, 0.0, kFade, 0.0);
    QColor none = ink, whole = ink;
    none.setAlpha(0);
    whole.setAlpha(255);
    fade.setColorAt(0.0, none);
    fade.setColorAt(1.0, whole);
    painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    painter.fillRect(QRectF(QPointF(), QSizeF(size)), fade);
  }
  return picture;
}

}  // namespace ui
