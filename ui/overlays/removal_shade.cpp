// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/removal_shade.h"

#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "ui/overlays/marks_style.h"
#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr std::int64_t kMostCells = 1'500'000;
constexpr int kCoarse = 2;  // pixels of the widget along a pixel of the body's picture
constexpr int kFillAlpha = 100, kHatchAlpha = 190, kEdgeAlpha = 255;
constexpr int kHatch = 12, kHatchWidth = 4;  // pixels
constexpr uchar kBeside = 1, kWithin = 2;    // parts of a picture

QRgb premultiplied(int alpha) {
  return qPremultiply(qRgba(style::kGoes.red(), style::kGoes.green(), style::kGoes.blue(), alpha));
}

}  // namespace

MarkedVoxels::MarkedVoxels(const haptics::Grid& grid) : grid_(grid) {
  bits_.assign(static_cast<std::size_t>(grid.voxelCount() + 63) / 64, 0);
  while (grid.voxelCount() / (factor_ * factor_ * factor_) > kMostCells) ++factor_;
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    cells_[a] = (grid.dims[a] + factor_ - 1) / factor_;
    count *= static_cast<std::size_t>(cells_[a]);
  }
  filled_.assign(count, 0);
  cell_mm_ = static_cast<double>(factor_) * grid.spacing.maxCoeff() * kMmPerM;
}

void MarkedVoxels::add(std::int64_t i, std::int64_t j, std::int64_t k, std::int64_t count) {
  const std::int64_t row = (k * grid_.dims[1] + j) * grid_.dims[0];
  const std::int64_t cell_row = (k / factor_ * cells_[1] + j / factor_) * cells_[0];
  for (std::int64_t at = i; at < i + count; ++at) {
    const auto n = static_cast<std::size_t>(row + at);
    bits_[n >> 6] |= std::uint64_t{1} << (n & 63);
    ++filled_[static_cast<std::size_t>(cell_row + at / factor_)];
  }
}

void MarkedVoxels::finish() {
  const auto filled = [&](std::int64_t I, std::int64_t J, std::int64_t K) -> float {
    if (I < 0 || J < 0 || K < 0 || I >= cells_[0] || J >= cells_[1] || K >= cells_[2]) return 0.0F;
    return static_cast<float>(
        filled_[static_cast<std::size_t>((K * cells_[1] + J) * cells_[0] + I)]);
  };
  const double middle = 0.5 * static_cast<double>(factor_ - 1);
  for (std::int64_t K = 0; K < cells_[2]; ++K)
    for (std::int64_t J = 0; J < cells_[1]; ++J)
      for (std::int64_t I = 0; I < cells_[0]; ++I) {
        if (filled(I, J, K) == 0.0F) continue;
        const std::array<float, 6> beside{filled(I - 1, J, K), filled(I + 1, J, K),
                                          filled(I, J - 1, K), filled(I, J + 1, K),
                                          filled(I, J, K - 1), filled(I, J, K + 1)};
        if (std::ranges::none_of(beside, [](float f) { return f == 0.0F; })) continue;
        const haptics::Vec3 index{static_cast<double>(I * factor_) + middle,
                                  static_cast<double>(J * factor_) + middle,
                                  static_cast<double>(K * factor_) + middle};
        surface_.push_back((grid_.worldOf(index) * kMmPerM).cast<float>());
      }
  filled_ = {};
}

void RemovalShade::show(std::shared_ptr<const MarkedVoxels> voxels, Fate fate) {
  voxels_ = std::move(voxels);
  fate_ = fate;
  body_ = {};
  emit changed();
}

void RemovalShade::paint(QPainter& painter, const ViewGeometry& view) const {
  if (!voxels_) return;
  const Projection camera = projectionOf(view);
  const QSize size = view.widget().size();
  if (view.isSlice()) {
    painter.drawImage(QRect({}, size), shaded(sliceOf(camera, size)));
    return;
  }
  if (body_.isNull() || !(body_camera_ == camera)) {
    const QImage parts = bodyOf(camera, size / kCoarse);
    body_ = shaded(parts.scaled(parts.size() * kCoarse));
    body_camera_ = camera;
  }
  painter.drawImage(QPoint{}, body_);
}

QImage RemovalShade::shaded(const QImage& parts) const {
  const int width = parts.width(), height = parts.height();
  QImage image(parts.size(), QImage::Format_ARGB32_Premultiplied);
  const uchar hatched = fate_ == Fate::Goes ? kWithin : fate_ == Fate::Stays ? kBeside : uchar{255};
  // of all but a piece less, since it is much
  const int share = fate_ == Fate::Stays ? 2 : 1;
  const QRgb fill = premultiplied(kFillAlpha / share),
             hatch = premultiplied(kHatchAlpha * 2 / (1 + share)), edge = premultiplied(kEdgeAlpha);
  for (int y = 0; y < height; ++y) {
    auto* out = reinterpret_cast<QRgb*>(image.scanLine(y));
    const uchar* row = parts.constScanLine(y);
    const uchar* above = parts.constScanLine(std::max(0, y - 2));
    const uchar* below = parts.constScanLine(std::min(height - 1, y + 2));
    for (int x = 0; x < width; ++x) {
      const uchar part = row[x];
      const auto ends = [&](uchar beside) { return beside != kWithin; };
      out[x] = 0;
      if (part == kWithin &&
          (ends(row[std::max(0, x - 2)]) || ends(row[std::min(width - 1, x + 2)]) ||
           ends(above[x]) || ends(below[x])))
        out[x] = edge;
      else if (part == hatched)
        out[x] = (x + y) % kHatch < kHatchWidth ? hatch : fill;
      else if (part == kWithin && fate_ == Fate::Chosen)
        out[x] = fill;
    }
  }
  return image;
}

QImage RemovalShade::sliceOf(const Projection& camera, QSize size) const {
  QImage parts(size, QImage::Format_Grayscale8);
  const haptics::Grid& grid = voxels_->grid();
  const auto indexAt = [&](double x, double y) {
    const auto [u, v] = camera.acrossOf({x, y});
    return grid.indexOf((camera.eye + camera.axes.col(0) * u + camera.axes.col(1) * v) / kMmPerM);
  };
  for (int y = 0; y < size.height(); ++y) {
    uchar* line = parts.scanLine(y);
    const haptics::Vec3 first = indexAt(0.5, y + 0.5);
    const haptics::Vec3 step = indexAt(1.5, y + 0.5) - first;
    for (int x = 0; x < size.width(); ++x) {
      const haptics::Vec3 at = first + step * x;
      const std::array<std::int64_t, 3> n{std::llround(at.x()), std::llround(at.y()),
                                          std::llround(at.z())};
      const bool within = n[0] >= 0 && n[1] >= 0 && n[2] >= 0 && n[0] < grid.dims[0] &&
                          n[1] < grid.dims[1] && n[2] < grid.dims[2];
      line[x] = !within ? uchar{0} : voxels_->has(n[0], n[1], n[2]) ? kWithin : kBeside;
    }
  }
  return parts;
}

QImage RemovalShade::bodyOf(const Projection& camera, QSize size) const {
  QImage parts(size, QImage::Format_Grayscale8);
  parts.fill(0);
  const haptics::Grid& grid = voxels_->grid();
  if (fate_ == Fate::Stays) {
    const BoxCorners corners = cornersOf_mm(grid, {{}, grid.dims});
    QPainter painter(&parts);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(kBeside, kBeside, kBeside));
    constexpr std::size_t kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& face : kFaces) {
      QPolygonF outline;
      for (const std::size_t corner : face) outline << camera.of(corners[corner]) / kCoarse;
      painter.drawPolygon(outline);
    }
  }
  for (const Eigen::Vector3f& point : voxels_->surface()) {
    const Eigen::Vector3d p = point.cast<double>();
    const double away = camera.depthOf(p);
    if (away <= 0.0 && !camera.parallel) continue;
    const QPointF at = camera.of(p) / kCoarse;
    const double across =
        0.62 * voxels_->cell_mm() * camera.scale / (camera.parallel ? 1.0 : away) / kCoarse;
    const int x0 = std::max(0, static_cast<int>(std::floor(at.x() - across)));
    const int x1 = std::min(size.width() - 1, static_cast<int>(std::floor(at.x() + across)));
    const int y0 = std::max(0, static_cast<int>(std::floor(at.y() - across)));
    const int y1 = std::min(size.height() - 1, static_cast<int>(std::floor(at.y() + across)));
    for (int y = y0; y <= y1 && x0 <= x1; ++y)
      std::fill_n(parts.scanLine(y) + x0, x1 - x0 + 1, kWithin);
  }
  return parts;
}

}  // namespace ui
