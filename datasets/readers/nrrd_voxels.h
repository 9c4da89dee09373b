// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/readers/volume_reader.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// What an NRRD's header says, checked, without its voxels.
struct NrrdDescription {
  haptics::Grid grid;
  haptics::VolumeFacts facts;
  bool spacing_stated = true;  ///< false: 1 mm is assumed
};

haptics::Expected<NrrdDescription> describeNrrd(const std::filesystem::path& path);

/// Decodes an NRRD through teem, the format's reference implementation. double becomes float32.
/// Progress and Cancel reach into the decoding, except of voxels spread over several files.
haptics::Expected<haptics::Volume> decodeNrrd(const std::filesystem::path& path,
                                              const ReadProgress& progress);

}  // namespace datasets
