// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <QImage>
#include <QString>
#include <array>

#include "ui/props/picture.h"

class vtkImageReslice;

namespace ui {

enum class Plane { Axial, Coronal, Sagittal };

/// Directions of a slice's picture in W (patient LPS), by the radiological convention: the
/// patient's right is on the left of axial and coronal pictures, the front on the left of sagittal.
struct PlaneAxes {
  Eigen::Vector3d right;   ///< towards the right edge of the picture
  Eigen::Vector3d up;      ///< towards its upper edge
  Eigen::Vector3d normal;  ///< direction of the wheel: towards S, P or L
};
PlaneAxes axesOf(Plane plane);

/// The letters at the left, right, upper and lower edge.
std::array<QString, 4> lettersOf(Plane plane);

/// A grey value for an intensity: black at level - width/2 and below, white at level + width/2.
struct GreyWindow {
  double level = 0.0;
  double width = 1.0;
};

/// Cuts planar pictures out of a volume at a requested resolution, without copying the volume.
class Slice {
 public:
  Slice();
  ~Slice();

  void show(const Picture& picture);
  bool empty() const { return !shown_; }

  /// A picture of size.width() x size.height() pixels, each mm_per_pixel across, whose centre
  /// is centre_W_mm.
  QImage cut(Plane plane, const Eigen::Vector3d& centre_W_mm, QSize size, double mm_per_pixel,
             const GreyWindow& grey);

 private:
  vtkSmartPointer<vtkImageReslice> reslice_;
  Eigen::Affine3d X_LW_mm_ = Eigen::Affine3d::Identity();
  bool shown_ = false;
};

}  // namespace ui
