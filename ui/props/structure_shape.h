// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "haptics/core/volume.h"
#include "ui/props/structures.h"

namespace ui {

/// A structure as it is drawn in 3-D.
struct StructureShape {
  /// Smooth triangles with normals, in the frame L of pictures (ui/props/picture.h), mm; they face
  /// outwards in W. Null: the structure has no voxel.
  vtkSmartPointer<vtkPolyData> mesh = {};
  /// Some of its places, W, mm; the first is the nearest to its middle.
  std::vector<Eigen::Vector3d> places_mm = {};
};

/// For each of so many structures the box of its voxels; empty: it has none. Any thread.
std::vector<haptics::VoxelBox> boxesOf(const StructureMap& map, std::size_t structures);

/// Makes the shape of a structure from the voxels of its box. A wall of one voxel stays, with both
/// its sides; above some millions of voxels they are averaged, and it is drawn thicker or not at
/// all. Any thread. If `cancel` becomes true meanwhile, the result is empty.
StructureShape shapeOf(const StructureMap& map, std::uint8_t number, const haptics::VoxelBox& box,
                       std::int64_t most_triangles, const std::atomic<bool>& cancel);

}  // namespace ui
