// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/stored_volumes.h"
#include "haptics/core/error.h"

namespace datasets {

/// Whether a file is named as a NIfTI file (.nii, .nii.gz) or begins as one, compressed or not.
bool looksLikeNifti(const Beginning& file);

/// Reads and checks the header of a NIfTI-1 or -2 file in one piece, whose world is RAS. Where both
/// a quaternion and a matrix place the voxels, their steps must be the same and their axes lie
/// within 20 degrees, or neither can be trusted ("ambiguous-orientation"). The matrix counts, or
/// the quaternion where the matrix is sheared by more than rounding, which is noted. Where neither
/// does, left and right are unknown. Refuses colours, vectors and complex numbers ("not-scalar"),
/// 64-bit integers ("unsupported-type"), and what the file cannot hold ("truncated").
haptics::Expected<StoredVolumes> describeNifti(const std::filesystem::path& path);

}  // namespace datasets
