// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// What the axes of a file's world point at. Unknown is taken as it stands, without letters.
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

/// The one place where millimetres of a file become metres in patient LPS. Axes keep their
/// handedness and order. Refuses steps that are zero, not finite or beyond 1 m and origins
/// beyond 100 m ("bad-header"), and axes more than 0.005 degrees off their right angles
/// ("sheared"); smaller errors of rounding are removed.
haptics::Expected<haptics::Grid> gridOf(const FileGeometry& file);

}  // namespace datasets
