// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/triangle_mesh.h"

namespace haptics {

/// The tool as the haptics know it: points on its surface, about their centroid.
///
/// The tool frame has its origin at the centroid of the points and the axes of the mesh.
struct PointShell {
  std::vector<Vec3> points;  ///< m, in the tool frame
  double radius = 0.0;       ///< m, of the farthest point
  /// m², mean inertia about the centroid, regularised; of a single point, whose extent is that of
  /// whatever it touches, the identity until a Scene takes the voxel for it.
  Mat3 inertia = Mat3::Identity();
  double spacing = 0.0;  ///< m, median distance to the nearest other point
};

/// A tool: what is drawn, and what is felt, in the same frame.
struct Tool {
  std::string name;
  TriangleMesh mesh;  ///< in the tool frame; empty for a tool that is only points
  PointShell shell;
};

/// Makes the shell of a set of points and centres it; inertia is regularised by 1e-6 r².
/// Refuses no point, a non-finite one, and one more than 10 m from the centroid.
Expected<PointShell> makeShell(std::vector<Vec3> points);

/// The greatest of its principal inertias, m²; of a symmetric matrix.
double largestInertia(const Mat3& inertia);

/// The mesh's vertices as the shell ([Chan 2011], 2.2), or with `point_count` > 0 that many
/// points spread evenly by area; deterministic.
Expected<Tool> makeTool(std::string name, TriangleMesh mesh, int point_count = 0);

}  // namespace haptics
