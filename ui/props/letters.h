// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <array>

class vtkBillboardTextActor3D;
class vtkRenderer;

namespace ui {

/// L R A P S I about the volume in the 3-D view; they always face the viewer.
class Letters {
 public:
  explicit Letters(vtkRenderer* renderer);
  ~Letters();

  /// Places the letters around a box in W, mm.
  void place(const Eigen::AlignedBox3d& box_mm);
  void setVisible(bool visible) { visible_ = visible; }
  /// Shows the letters beside the volume, and hides those in front of it or behind it.
  void face(const Eigen::Vector3d& view_direction);
  /// Position of a letter in W, mm.
  Eigen::Vector3d positionOf(char letter) const;

 private:
  std::array<vtkSmartPointer<vtkBillboardTextActor3D>, 6> actors_;
  bool visible_ = false;
};

}  // namespace ui
