// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/slice.h"

#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>

#include <algorithm>

namespace ui {

PlaneAxes axesOf(Plane plane) {
  const Eigen::Vector3d left = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d back = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d head = Eigen::Vector3d::UnitZ();
  switch (plane) {
    case Plane::Axial:
      return {left, -back, head};
    case Plane::Coronal:
      return {left, head, back};
    case Plane::Sagittal:
      break;
  }
  return {back, head, left};
}

std::array<QString, 4> lettersOf(Plane plane) {
  switch (plane) {
    case Plane::Axial:
      return {"R", "L", "A", "P"};
    case Plane::Coronal:
      return {"R", "L", "S", "I"};
    case Plane::Sagittal:
      break;
  }
  return {"A", "P", "S", "I"};
}

Slice::Slice() : reslice_(vtkSmartPointer<vtkImageReslice>::New()) {
  reslice_->SetInterpolationModeToLinear();
  reslice_->SetOutputDimensionality(2);
  reslice_->SetOutputScalarType(VTK_FLOAT);
  reslice_->BorderOn();
}

Slice::~Slice() = default;

void Slice::show(const Picture& picture) {
  // the grid's frame has no direction of its own; where it lies in W is in the reslice axes,
  // which may mirror
  reslice_->SetInputData(picture.image);
  reslice_->SetBackgroundLevel(picture.volume->least);
  X_LW_mm_ = picture.X_WL_mm.inverse();
  shown_ = true;
}

QImage Slice::cut(Plane plane, const Eigen::Vector3d& centre_W_mm, QSize size, double mm_per_pixel,
                  const GreyWindow& grey) {
  const PlaneAxes axes = axesOf(plane);
  Eigen::Affine3d X_WS = Eigen::Affine3d::Identity();
  X_WS.linear() << axes.right, axes.up, axes.normal;
  X_WS.translation() = centre_W_mm;
  reslice_->SetResliceAxes(matrixOf(Eigen::Affine3d{X_LW_mm_ * X_WS}));
  const int w = size.width(), h = size.height();
  reslice_->SetOutputSpacing(mm_per_pixel, mm_per_pixel, 1.0);
  reslice_->SetOutputOrigin(-0.5 * (w - 1) * mm_per_pixel, -0.5 * (h - 1) * mm_per_pixel, 0.0);
  reslice_->SetOutputExtent(0, w - 1, 0, h - 1, 0, 0);
  reslice_->Update();

  const auto* in = static_cast<const float*>(reslice_->GetOutput()->GetScalarPointer());
  QImage image(size, QImage::Format_Grayscale8);
  const double width = std::max(grey.width, 1e-9);
  const auto scale = static_cast<float>(255.0 / width);
  const auto black = static_cast<float>(grey.level - 0.5 * width);
  for (int y = 0; y < h; ++y) {
    const float* row = in + static_cast<std::ptrdiff_t>(h - 1 - y) * w;  // VTK's rows go up
    uchar* out = image.scanLine(y);
    for (int x = 0; x < w; ++x)
      out[x] = static_cast<uchar>(std::clamp((row[x] - black) * scale, 0.0F, 255.0F));
  }
  return image;
}

}  // namespace ui
