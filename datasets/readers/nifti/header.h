// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/readers/files/stored_volumes.h"
#include "haptics/core/error.h"

namespace datasets {

/// Whether a file is named as a NIfTI file (.nii, .nii.gz) or begins as one that is not compressed.
bool looksLikeNifti(const std::filesystem::path& path);

/// Reads and checks the header of a NIfTI-1 or -2 file in one piece, whose world is RAS. Where both
/// a quaternion and a matrix place the voxels, they must agree to 0.1 degrees and 0.01 voxels, or
/// neither can be trusted ("ambiguous-orientation"). Where neither does, left and right are
/// unknown. Refuses colours, vectors and complex numbers ("not-scalar"), 64-bit integers
/// ("unsupported-type"), and what the file cannot hold ("truncated").
haptics::Expected<StoredVolumes> describeNifti(const std::filesystem::path& path);

}  // namespace datasets
