// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Directions of the axes of a file's world. If Unknown, axes stay as stored and no letters are
/// shown.
enum class FileSpace {
  LeftPosteriorSuperior,
  RightAnteriorSuperior,
  LeftAnteriorSuperior,
  Unknown
};

/// Where a file says its voxels lie, in millimetres and in its own world.
struct FileGeometry {
  std::array<std::int64_t, 3> dims{};
  /// Column a is the step from one voxel to the next along axis a.
  haptics::Mat3 steps_mm = haptics::Mat3::Identity();
  haptics::Vec3 origin_mm = haptics::Vec3::Zero();  ///< centre of voxel (0, 0, 0)
  FileSpace space = FileSpace::LeftPosteriorSuperior;
};

/// How far two axes are off their right angle at most.
double shear_deg(const haptics::Mat3& steps);
/// Whether that is what rounding leaves, 0.1 degrees, as between slices of DICOM.
bool isSquareEnough(const haptics::Mat3& steps);

/// Converts a file's millimetres to metres in patient LPS; no other function does. Axes keep their
/// handedness and order. Refuses steps that are zero, not finite or beyond 1 m and origins beyond
/// 100 m ("bad-header"), and axes more than 0.1 degrees off their right angles ("sheared"). Axes
/// that are less off are turned into the nearest ones at right angles, of the same handedness.
haptics::Expected<haptics::Grid> gridOf(const FileGeometry& file);

}  // namespace datasets
