// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <QImage>
#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "ui/props/picture.h"
#include "ui/props/view_look.h"

class vtkImageReslice;

namespace ui {

enum class Plane { Axial, Coronal, Sagittal, Oblique };

/// Directions of a slice's picture in W (patient LPS), by the radiological convention: the
/// patient's right is on the left of axial and coronal pictures, the front on the left of sagittal.
struct PlaneAxes {
  Eigen::Vector3d right;   ///< towards the right edge of the picture
  Eigen::Vector3d up;      ///< towards its upper edge
  Eigen::Vector3d normal;  ///< direction of the wheel: towards S, P or L

  bool operator==(const PlaneAxes&) const = default;
};
/// An oblique plane begins as an axial one.
PlaneAxes axesOf(Plane plane);

/// The letters at the left, right, upper and lower edge.
std::array<QString, 4> lettersOf(const PlaneAxes& axes);

/// A grey value for an intensity: black at level - width/2 and below, white at level + width/2.
struct GreyWindow {
  double level = 0.0;
  double width = 1.0;
};

/// Cuts planar pictures out of a volume at a requested resolution, without copying the volume.
/// Voxels that a crop took away count as background.
class Slice {
 public:
  Slice();
  ~Slice();

  void show(const Picture& picture);
  /// Cuts these voxels of the same grid, which change from now on, as carve() says.
  void showLive(const haptics::Volume& voxels);
  void carve();
  /// The volume is this one now; its voxels are cut already.
  void renew(std::shared_ptr<const haptics::Volume> volume) { volume_ = std::move(volume); }
  bool empty() const { return volume_ == nullptr; }

  /// Cuts size.width() x size.height() pixels, each mm_per_pixel across, whose middle is
  /// centre_W_mm. Upper rows first.
  void cut(const PlaneAxes& axes, const Eigen::Vector3d& centre_W_mm, QSize size,
           double mm_per_pixel, const SliceLook& look);
  /// What was cut, in grey.
  QImage picture(const GreyWindow& grey) const;
  /// The intensity that a pixel of the cut shows; none outside the volume.
  std::optional<double> valueAt(QPoint pixel) const;
  /// Of squares of so many pixels, how many above and to the left of each corner show some of the
  /// body: rows of cells.width() + 1.
  std::vector<int> bodyBefore(int cell, QSize cells) const;

 private:
  struct Span {
    int first = 0, end = 0;
  };

  /// One layer of a slab: its values and, for each row, the pixels that lie in the volume.
  void cutLayer(const Eigen::Affine3d& X_LS, double mm_per_pixel);
  Span spanOf(const Eigen::Vector3d& first_V, const Eigen::Vector3d& step_V) const;
  /// The voxels at index coordinates, which are moved into the crop; trilinear or nearest.
  float kept(const Eigen::Vector3d& u) const;

  vtkSmartPointer<vtkImageReslice> reslice_;
  /// Voxels that change; null: none do. Of its own, since what is marked as changed is uploaded
  /// anew as a whole by whoever else has it.
  vtkSmartPointer<vtkImageData> live_;
  std::shared_ptr<const haptics::Volume> volume_;
  Eigen::Affine3d X_LW_mm_ = Eigen::Affine3d::Identity();
  Interpolation interpolation_ = Interpolation::Linear;
  QSize size_;
  std::vector<float> values_, layer_;
  std::vector<Span> spans_;             ///< of the layer
  std::vector<unsigned short> inside_;  ///< layers of the slab that have this pixel in the volume
};

}  // namespace ui
