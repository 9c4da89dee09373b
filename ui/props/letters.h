// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <array>

class vtkRenderer;
class vtkTextActor;

namespace ui {

/// The sides of the patient at the edges of a film's picture, on plates.
class Letters {
 public:
  explicit Letters(vtkRenderer* renderer);
  ~Letters();

  void setVisible(bool visible);
  /// `axes` of the picture, as edgeLettersOf() takes them; size in pixels.
  void show(const Eigen::Matrix3d& axes, int width, int height);

 private:
  std::array<vtkSmartPointer<vtkTextActor>, 4> actors_;  ///< left, right, upper, lower
};

}  // namespace ui
