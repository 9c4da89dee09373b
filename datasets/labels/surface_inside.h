// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "datasets/labels/label_map.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Which way the x and y axes of a surface point: to the patient's left and back, or right and
/// front.
enum class SurfaceSpace { Lps, Ras };

/// Of "lps" or "ras", in any case; none of anything else.
std::optional<SurfaceSpace> surfaceSpaceNamed(std::string_view name);

/// Whether a file is named as a surface: .stl, .obj or .ply.
bool isSurfaceFile(const std::filesystem::path& path);

/// Adds what lies within a closed surface, in millimetres, as a structure with the name of the
/// file: the voxels from whose centre any ray crosses it an odd number of times. `space` counts
/// where the file does not state one, as 3D Slicer's do ("SPACE=LPS"). Refuses what readToolMesh()
/// refuses; and by name: no space or two ("surface-space"), and a surface with an open edge
/// ("surface-open").
haptics::Expected<void> addSurface(LabelMap& map, const std::filesystem::path& path,
                                   std::optional<SurfaceSpace> space, const ReadProgress& progress);

}  // namespace datasets
