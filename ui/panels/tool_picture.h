// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QPainterPath>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <vector>

#include "haptics/core/triangle_mesh.h"

namespace ui {

/// A tool as a small line drawing: the silhouette of its mesh, seen along y, with its tip to the
/// right. A tool longer than the picture fades out at the left. A mesh of more than 300,000
/// triangles has no picture.
class ToolPicture {
 public:
  ToolPicture() = default;
  explicit ToolPicture(const haptics::TriangleMesh& mesh);

  /// `size` in the widget's pixels, `ratio` of them to the screen's. Kept in QPixmapCache.
  QPixmap pixmap(QSize size, double ratio, const QColor& ink) const;

 private:
  QPixmap drawn(QSize size, double ratio, const QColor& ink) const;

  quint64 number_ = 0;  ///< of this drawing, for the cache
  // mm; x to the tip, y down
  QPainterPath body_;
  std::vector<QPointF> points_;
  QRectF bounds_;
};

}  // namespace ui
