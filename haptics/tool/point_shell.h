// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/triangle_mesh.h"

namespace haptics {

/// The tool for collision: points on its surface, relative to their centroid.
///
/// The tool frame has its origin at the centroid of the points and the axes of the mesh.
struct PointShell {
  std::vector<Vec3> points;  ///< m, in the tool frame
  double radius = 0.0;       ///< m, distance of the farthest point from the origin
  /// m², mean inertia about the centroid, regularised. For a single point it is the identity, until
  /// a Scene replaces it by an inertia from the voxel's size.
  Mat3 inertia = Mat3::Identity();
  double spacing = 0.0;     ///< m, median distance to the nearest other point
  Vec3 tip = Vec3::Zero();  ///< m, in the tool frame: the middle of the points farthest along -z
  /// m, where the tool frame's origin was in the frame of what the tool was made of: the points
  /// that were given, or a mesh in its file.
  Vec3 origin = Vec3::Zero();
};

/// A tool: the mesh that is drawn and the shell that is felt, in the same frame.
struct Tool {
  std::string name;
  TriangleMesh mesh;  ///< in the tool frame; empty for a tool that is only points
  PointShell shell;
};

/// Makes the shell of a set of points and centres it; inertia is regularised by 1e-6 r².
/// Refuses no point, a non-finite one, and one more than 10 m from the centroid.
Expected<PointShell> makeShell(std::vector<Vec3> points);

/// The middle of the points that are farthest along -z; there must be one.
Vec3 tipOf(const std::vector<Vec3>& points);

/// The greatest principal inertia of a symmetric matrix, m².
double largestInertia(const Mat3& inertia);
/// m: radius of gyration of a ball that turns as easily as the tool does on average.
double gyrationOf(const PointShell& shell) HAPTICS_RT;

/// The mesh's vertices as the shell ([Chan 2011], 2.2), or with `point_count` > 0 that many
/// points spread evenly by area; deterministic.
Expected<Tool> makeTool(std::string name, TriangleMesh mesh, int point_count = 0);

}  // namespace haptics
