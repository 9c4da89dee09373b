// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include "haptics/core/geometry.h"
#include "haptics/core/triangle_mesh.h"

class vtkActor;

namespace ui {

/// Draws the tool twice: solid at the pose of the proxy, and as a wireframe at the pose of the
/// device. Put the wireframe in a layer above the surface, so that it is visible inside the
/// surface.
class ToolProp {
 public:
  ToolProp();
  ~ToolProp();

  /// Shows a mesh, in the tool frame, metres. A mesh without triangles is shown as points.
  void show(const haptics::TriangleMesh& mesh);
  /// Shows the wireframe only where device and proxy differ by more than a little: 0.3 mm for some
  /// point of the tool.
  void showDeviceOnlyApart() { only_apart_ = true; }
  bool deviceShown() const;
  /// Sets the poses. Returns true if the tool has moved visibly.
  bool move(const haptics::Pose& X_WP, const haptics::Pose& X_WD);

  /// Its burr turns: the tool has a colour of its own. Returns true if that is new.
  bool setTurning(bool turning);

  vtkActor* proxy() const;
  vtkActor* device() const;

 private:
  void showDevice();

  vtkSmartPointer<vtkActor> proxy_;
  vtkSmartPointer<vtkActor> device_;
  bool shown_ = false;
  bool only_apart_ = false;
  bool turning_ = false;
  double radius_ = 0.0;  ///< m, of the tool about its origin
  haptics::Pose X_WP_ = haptics::Pose::Identity();
  haptics::Pose X_WD_ = haptics::Pose::Identity();
};

}  // namespace ui
