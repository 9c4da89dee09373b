// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/removal_shade.h"

#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/overlays/marks_style.h"
#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr std::int64_t kMostCells = 1'500'000;
constexpr int kCoarse = 2;  // pixels of the widget along a pixel of the body's picture
constexpr int kAlpha = 110, kBodyAlpha = 190;

QRgb premultiplied(double shade, int alpha) {
  const auto part = [&](int c) { return static_cast<int>(c * shade * alpha / 255.0); };
  return qRgba(part(style::kGoes.red()), part(style::kGoes.green()), part(style::kGoes.blue()),
               alpha);
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
        // a wider look makes the shading smooth
        Eigen::Vector3d out = Eigen::Vector3d::Zero();
        for (int a = -2; a <= 2; ++a)
          for (int b = -2; b <= 2; ++b)
            for (int c = -2; c <= 2; ++c)
              if (filled(I + a, J + b, K + c) > 0.0F) out -= Eigen::Vector3d(a, b, c);
        out = grid_.direction * out;
        surface_.push_back({(grid_.worldOf(index) * kMmPerM).cast<float>(),
                            out.norm() > 0.0 ? Eigen::Vector3f(out.normalized().cast<float>())
                                             : Eigen::Vector3f::Zero()});
      }
  filled_ = {};
}

void RemovalShade::show(std::shared_ptr<const MarkedVoxels> voxels) {
  voxels_ = std::move(voxels);
  body_ = {};
  emit changed();
}

void RemovalShade::paint(QPainter& painter, const ViewGeometry& view) const {
  if (!voxels_) return;
  const Projection camera = projectionOf(view);
  const QSize size = view.widget().size();
  if (view.isSlice()) {
    painter.drawImage(QRect({}, size), sliceOf(camera, size));
    return;
  }
  if (body_.isNull() || !(body_camera_ == camera)) {
    body_ = bodyOf(camera, size / kCoarse);
    body_camera_ = camera;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(0, 0, body_.width() * kCoarse, body_.height() * kCoarse), body_);
}

QImage RemovalShade::sliceOf(const Projection& camera, QSize size) const {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  const haptics::Grid& grid = voxels_->grid();
  const QRgb colour = premultiplied(1.0, kAlpha);
  const auto indexAt = [&](double x, double y) {
    const auto [u, v] = camera.acrossOf({x, y});
    return grid.indexOf((camera.eye + camera.axes.col(0) * u + camera.axes.col(1) * v) / kMmPerM);
  };
  for (int y = 0; y < size.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    const haptics::Vec3 first = indexAt(0.5, y + 0.5);
    const haptics::Vec3 step = indexAt(1.5, y + 0.5) - first;
    for (int x = 0; x < size.width(); ++x) {
      const haptics::Vec3 at = first + step * x;
      const std::array<std::int64_t, 3> n{std::llround(at.x()), std::llround(at.y()),
                                          std::llround(at.z())};
      const bool within = n[0] >= 0 && n[1] >= 0 && n[2] >= 0 && n[0] < grid.dims[0] &&
                          n[1] < grid.dims[1] && n[2] < grid.dims[2];
      line[x] = within && voxels_->has(n[0], n[1], n[2]) ? colour : 0;
    }
  }
  return image;
}

QImage RemovalShade::bodyOf(const Projection& camera, QSize size) const {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  std::vector<float> depth(static_cast<std::size_t>(size.width()) * size.height(),
                           std::numeric_limits<float>::infinity());
  const Eigen::Vector3d towards = camera.axes.col(2);
  for (const MarkedVoxels::Point& point : voxels_->surface()) {
    const Eigen::Vector3d p = point.p_W_mm.cast<double>();
    const double away = camera.depthOf(p);
    if (away <= 0.0 && !camera.parallel) continue;
    const QPointF at = camera.of(p) / kCoarse;
    const double across =
        0.62 * voxels_->cell_mm() * camera.scale / (camera.parallel ? 1.0 : away) / kCoarse;
    const int x0 = std::max(0, static_cast<int>(std::floor(at.x() - across)));
    const int x1 = std::min(size.width() - 1, static_cast<int>(std::floor(at.x() + across)));
    const int y0 = std::max(0, static_cast<int>(std::floor(at.y() - across)));
    const int y1 = std::min(size.height() - 1, static_cast<int>(std::floor(at.y() + across)));
    const double facing = std::abs(towards.dot(point.out_W.cast<double>()));
    const QRgb colour = premultiplied(0.35 + 0.65 * facing, kBodyAlpha);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        float& nearest = depth[static_cast<std::size_t>(y) * size.width() + x];
        if (static_cast<float>(away) >= nearest) continue;
        nearest = static_cast<float>(away);
        image.setPixel(x, y, colour);
      }
  }
  return image;
}

}  // namespace ui
