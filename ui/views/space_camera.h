// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <QPointF>
#include <optional>
#include <vector>

class QWidget;
class vtkCamera;

namespace ui {

/// From where a box of these sizes is seen at first (unit, towards the viewer): from the front, a
/// little from the left and above; a slab more from its broad side.
Eigen::Vector3d firstDirection(const Eigen::Vector3d& sizes);

/// The camera of the 3-D view: how the mouse turns, shifts and zooms it, and where W is on the
/// screen, with and without perspective. Millimetres of W, and pixels of the widget.
class SpaceCamera {
 public:
  explicit SpaceCamera(const QWidget& view);

  vtkCamera* vtk() const;
  bool isParallel() const;

  QPointF projected(const Eigen::Vector3d& p_mm) const;
  Eigen::Matrix3d axes() const;  ///< columns: right, up, towards the viewer; in W
  double mmPerPixel(const Eigen::Vector3d& p_mm) const;
  /// The line of sight through a pixel: a place on it, and its unit direction away from the viewer.
  void sight(QPointF at, Eigen::Vector3d& from_mm, Eigen::Vector3d& along) const;
  /// The place under a pixel in the plane through `p_mm` that is parallel to the picture.
  Eigen::Vector3d placeBeside(QPointF at, const Eigen::Vector3d& p_mm) const;

  void rotate(QPointF by);
  void pan(QPointF by);
  /// Comes nearer by this factor; the place keeps its pixel.
  void zoom(double factor, const Eigen::Vector3d& at_mm);
  /// Shows what lies between these places from a direction (unit, towards the viewer), with another
  /// one up.
  void frame(std::vector<Eigen::Vector3d> outline_mm, const Eigen::Vector3d& from,
             const Eigen::Vector3d& up);
  /// Shows all that was framed last, in a view of another shape, unless the zoom is the
  /// user's. Whether it changed.
  bool refit();
  /// What is shown is the user's choice: refit() leaves it.
  void keep() { fit_.reset(); }
  /// Looks as another camera does.
  void take(const SpaceCamera& other);
  /// Looks at a place from a distance in a direction (unit, towards the viewer).
  void lookAt(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& from, const Eigen::Vector3d& up,
              double distance_mm, const Eigen::AlignedBox3d& box_mm);
  /// Switches the perspective; what is at the focal point keeps its size. `box_mm`: what must not
  /// lie behind the viewer.
  void setParallel(bool parallel, const Eigen::AlignedBox3d& box_mm);

 private:
  /// What frame() shows, and half the height [mm] that the view then has at the focal point.
  struct Fit {
    std::vector<Eigen::Vector3d> outline_mm;
    double half_mm = 0.0;
  };
  void fit(std::vector<Eigen::Vector3d> outline_mm, const Eigen::Matrix3d& axes);
  double half_mm() const;
  /// The distance at which perspective shows what parallel projection does.
  double distance() const;
  void set(const Eigen::Vector3d& eye_mm, const Eigen::Vector3d& focus_mm);

  const QWidget& view_;
  vtkSmartPointer<vtkCamera> camera_;
  std::optional<Fit> fit_;
};

}  // namespace ui
