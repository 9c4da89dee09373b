// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <array>

#include "haptics/core/geometry.h"
#include "haptics/core/triangle_mesh.h"

namespace ui {

/// The tool twice: the proxy solid, where the surface stops it, and the device as a wireframe,
/// where the hand is. The wireframe belongs in a layer above the surface, so that it is seen
/// inside it.
class ToolProp {
 public:
  static constexpr std::array<double, 3> kProxyColour{0.10, 0.65, 1.00};   ///< sky blue
  static constexpr std::array<double, 3> kDeviceColour{1.00, 0.35, 0.10};  ///< orange

  ToolProp();
  ~ToolProp();

  /// In the tool frame, metres. A mesh without triangles shows its vertices as points.
  void show(const haptics::TriangleMesh& mesh);
  /// True if the tool has moved visibly.
  bool move(const haptics::Pose& X_WP, const haptics::Pose& X_WD);

  vtkActor* proxy() const { return proxy_; }
  vtkActor* device() const { return device_; }

 private:
  vtkSmartPointer<vtkActor> proxy_;
  vtkSmartPointer<vtkActor> device_;
  haptics::Pose X_WP_ = haptics::Pose::Identity();
  haptics::Pose X_WD_ = haptics::Pose::Identity();
};

}  // namespace ui
