// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Writes an NRRD (raw, attached, space left-posterior-superior, unit and modality as key/values):
/// geometry and voxels, nothing of the patient. Writes the file completely or not at all.
haptics::Expected<void> writeNrrd(const haptics::Volume& volume, const std::filesystem::path& out,
                                  const ReadProgress& progress = {});

/// The lines of a header that say where voxels lie in the patient (left-posterior-superior, mm);
/// `layered`: the voxels of several layers lie beside each other.
std::string nrrdSpaceOf(const haptics::Grid& grid, bool layered = false);

}  // namespace datasets
