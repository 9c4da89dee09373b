// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/slice.h"

#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/props/orientation.h"

namespace ui {
namespace {

constexpr int kMostLayers = 64;  // of a slab

}  // namespace

PlaneAxes axesOf(Plane plane) {
  const Eigen::Vector3d left = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d back = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d head = Eigen::Vector3d::UnitZ();
  switch (plane) {
    case Plane::Axial:
    case Plane::Oblique:
      return {left, -back, head};
    case Plane::Coronal:
      return {left, head, back};
    case Plane::Sagittal:
      break;
  }
  return {back, head, left};
}

std::array<QString, 4> lettersOf(const PlaneAxes& axes) {
  return {lettersTowards(-axes.right), lettersTowards(axes.right), lettersTowards(axes.up),
          lettersTowards(-axes.up)};
}

Slice::Slice() : reslice_(vtkSmartPointer<vtkImageReslice>::New()) {
  reslice_->SetOutputDimensionality(2);
  reslice_->SetOutputScalarType(VTK_FLOAT);
  reslice_->BorderOn();
}

Slice::~Slice() = default;

void Slice::show(const Picture& picture) {
  // the grid's frame has no direction of its own; where it lies in W is in the reslice axes,
  // which may mirror
  live_ = nullptr;
  reslice_->SetInputData(picture.image);
  reslice_->SetBackgroundLevel(picture.volume->least);
  volume_ = picture.volume;
  X_LW_mm_ = picture.X_WL_mm.inverse();
}

void Slice::showLive(const haptics::Volume& voxels) {
  live_ = imageOf(voxels);
  reslice_->SetInputData(live_);
}

void Slice::carve() {
  if (live_ != nullptr) live_->Modified();
}

Slice::Span Slice::spanOf(const Eigen::Vector3d& first_V, const Eigen::Vector3d& step_V) const {
  const haptics::VoxelBox box = volume_->bounds();
  double from = 0.0, to = size_.width() - 1.0;
  for (int a = 0; a < 3; ++a) {
    const double low = static_cast<double>(box.first[a]) - 0.5 - first_V[a];
    const double high = static_cast<double>(box.end[a]) - 0.5 - first_V[a];
    if (std::abs(step_V[a]) < 1e-12) {
      if (low > 0.0 || high < 0.0) return {};
      continue;
    }
    from = std::max(from, std::min(low / step_V[a], high / step_V[a]));
    to = std::min(to, std::max(low / step_V[a], high / step_V[a]));
  }
  if (from > to) return {};
  return {static_cast<int>(std::ceil(from)), static_cast<int>(std::floor(to)) + 1};
}

float Slice::kept(const Eigen::Vector3d& u) const {
  const bool nearest = interpolation_ == Interpolation::Nearest;
  return static_cast<float>(
      fieldAt(*volume_, nearest ? Eigen::Vector3d{(u.array() + 0.5).floor()} : u));
}

void Slice::cutLayer(const Eigen::Affine3d& X_LS, double mm_per_pixel) {
  const int w = size_.width(), h = size_.height();
  reslice_->SetResliceAxes(matrixOf(X_LS));
  reslice_->SetOutputSpacing(mm_per_pixel, mm_per_pixel, 1.0);
  reslice_->SetOutputOrigin(-0.5 * (w - 1) * mm_per_pixel, -0.5 * (h - 1) * mm_per_pixel, 0.0);
  reslice_->SetOutputExtent(0, w - 1, 0, h - 1, 0, 0);
  reslice_->Update();
  const auto* in = static_cast<const float*>(reslice_->GetOutput()->GetScalarPointer());

  const haptics::Grid& grid = volume_->grid;
  const haptics::VoxelBox box = volume_->bounds();
  const Eigen::Vector3d per_mm = (grid.spacing * kMmPerM).cwiseInverse();
  const Eigen::Vector3d step = per_mm.cwiseProduct(X_LS.linear().col(0)) * mm_per_pixel;
  const auto background = static_cast<float>(volume_->least);
  layer_.resize(values_.size());
  for (int y = 0; y < h; ++y) {
    const std::ptrdiff_t row = h - 1 - y;  // VTK's rows go up
    const Eigen::Vector3d at =
        X_LS * Eigen::Vector3d{-0.5 * (w - 1) * mm_per_pixel,
                               (static_cast<double>(row) - 0.5 * (h - 1)) * mm_per_pixel, 0.0};
    const Eigen::Vector3d first = per_mm.cwiseProduct(at);
    float* out = layer_.data() + static_cast<std::ptrdiff_t>(y) * w;
    const Span span = spans_[static_cast<std::size_t>(y)] = spanOf(first, step);
    std::fill(out, out + w, background);
    if (span.first < span.end)
      std::copy(in + row * w + span.first, in + row * w + span.end, out + span.first);
    if (!volume_->crop) continue;
    // a crop's outermost half voxel would be mixed with what was taken away
    for (int x = span.first; x < span.end; ++x) {
      const Eigen::Vector3d u = first + step * x;
      bool rim = false;
      for (int a = 0; a < 3; ++a)
        rim = rim || u[a] < static_cast<double>(box.first[a]) ||
              u[a] > static_cast<double>(box.end[a] - 1);
      if (rim) out[x] = kept(u);
    }
  }
}

void Slice::cut(const PlaneAxes& axes, const Eigen::Vector3d& centre_W_mm, QSize size,
                double mm_per_pixel, const SliceLook& look) {
  size_ = size;
  interpolation_ = look.interpolation;
  if (look.interpolation == Interpolation::Linear)
    reslice_->SetInterpolationModeToLinear();
  else
    reslice_->SetInterpolationModeToNearestNeighbor();
  values_.resize(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()));
  inside_.assign(values_.size(), 0);
  spans_.resize(static_cast<std::size_t>(size.height()));

  int layers = 1;
  double between_mm = 0.0;
  if (look.slab != SlabKind::None) {
    const double voxel_mm = volume_->grid.spacing.minCoeff() * kMmPerM;
    layers =
        std::clamp(static_cast<int>(std::ceil(look.thickness_mm / voxel_mm)) + 1, 2, kMostLayers);
    between_mm = look.thickness_mm / (layers - 1);
  }
  for (int n = 0; n < layers; ++n) {
    Eigen::Affine3d X_WS = Eigen::Affine3d::Identity();
    X_WS.linear() << axes.right, axes.up, axes.normal;
    X_WS.translation() = centre_W_mm + axes.normal * ((n - 0.5 * (layers - 1)) * between_mm);
    cutLayer(X_LW_mm_ * X_WS, mm_per_pixel);
    if (n == 0) values_ = layer_;
    for (int y = 0; y < size.height(); ++y) {
      const Span span = spans_[static_cast<std::size_t>(y)];
      const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width());
      for (std::size_t i = row + span.first; i < row + span.end; ++i) {
        // what lies outside the volume takes no part
        if (inside_[i]++ == 0)
          values_[i] = layer_[i];
        else if (look.slab == SlabKind::Maximum)
          values_[i] = std::max(values_[i], layer_[i]);
        else if (look.slab == SlabKind::Minimum)
          values_[i] = std::min(values_[i], layer_[i]);
        else
          values_[i] += layer_[i];
      }
    }
  }
  if (look.slab == SlabKind::Mean)
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (inside_[i] > 1) values_[i] /= static_cast<float>(inside_[i]);
}

QImage Slice::picture(const GreyWindow& grey) const {
  QImage image(size_, QImage::Format_Grayscale8);
  const double width = std::max(grey.width, 1e-9);
  const auto scale = static_cast<float>(255.0 / width);
  const auto black = static_cast<float>(grey.level - 0.5 * width);
  const float* in = values_.data();
  const unsigned short* inside = inside_.data();
  for (int y = 0; y < size_.height(); ++y) {
    uchar* out = image.scanLine(y);
    for (int x = 0; x < size_.width(); ++x, ++in)
      out[x] = *inside++ == 0 ? 0  // black in every window
                              : static_cast<uchar>(std::clamp((*in - black) * scale, 0.0F, 255.0F));
  }
  return image;
}

std::vector<int> Slice::bodyBefore(int cell, QSize cells) const {
  const int w = cells.width() + 1;
  std::vector<int> sums(static_cast<std::size_t>(w) * static_cast<std::size_t>(cells.height() + 1));
  const double least = bodyFrom(*volume_);
  for (int y = 0; y < size_.height() && y / cell < cells.height(); ++y)
    for (int x = 0; x < size_.width() && x / cell < cells.width(); ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width()) +
                            static_cast<std::size_t>(x);
      if (inside_[i] != 0 && values_[i] >= least)
        sums[static_cast<std::size_t>((y / cell + 1) * w + x / cell + 1)] = 1;
    }
  for (int y = 1; y <= cells.height(); ++y)
    for (int x = 1; x < w; ++x) {
      const auto i = static_cast<std::size_t>(y * w + x);
      const auto up = static_cast<std::size_t>(w);
      sums[i] += sums[i - 1] + sums[i - up] - sums[i - up - 1];
    }
  return sums;
}

std::optional<double> Slice::valueAt(QPoint pixel) const {
  if (!QRect({0, 0}, size_).contains(pixel)) return {};
  const std::size_t i =
      static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(size_.width()) +
      static_cast<std::size_t>(pixel.x());
  if (inside_[i] == 0) return {};
  return values_[i];
}

}  // namespace ui
