// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/readers/files/stored_volumes.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// An NRRD whose header has been parsed and checked, here and by teem.
struct ParsedNrrd {
  std::filesystem::path path;
  NrrdHeader header;
  StoredVolumes stored;
};
haptics::Expected<ParsedNrrd> parseNrrd(const std::filesystem::path& path);

/// Reads a part of one volume of an NRRD. Teem, the format's reference implementation, decodes a
/// volume that is whole and alone in its file. Other raw and gzip voxels are read in blocks. Raw
/// volumes of 1 GiB, or of half the free memory, are mapped. Other encodings and several data files
/// are decoded whole first. double becomes float32. Progress and Cancel work during decoding,
/// except for voxels in several files.
haptics::Expected<haptics::Volume> decodeNrrd(const ParsedNrrd& nrrd, int number, const Part& part,
                                              const ReadProgress& progress);

}  // namespace datasets
