// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPolygonF>
#include <vector>

#include "haptics/core/triangle_mesh.h"
#include "ui/props/slice.h"

namespace ui {

/// The lines in which a mesh at a pose meets a plane through `origin_W_mm`, in mm from it along the
/// axes' right and up. A line that closes ends where it begins.
std::vector<QPolygonF> sectionOf(const haptics::TriangleMesh& mesh, const haptics::Pose& X_WM,
                                 const PlaneAxes& axes, const Eigen::Vector3d& origin_W_mm);

/// The tip of a tool, in the tool frame [m]: its end along -z.
haptics::Vec3 tipOf(const haptics::TriangleMesh& mesh);

}  // namespace ui
