// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/readers/files/stored_volumes.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// An NRRD whose header has been parsed and checked, by us and by teem.
struct ParsedNrrd {
  std::filesystem::path path;
  NrrdHeader header;
  StoredVolumes stored;
};
haptics::Expected<ParsedNrrd> parseNrrd(const std::filesystem::path& path);

/// Reads a part of one volume of an NRRD. A whole volume that is alone in its file is decoded by
/// teem, the format's reference implementation; raw and gzip voxels are else read block by block,
/// raw ones of a gibibyte mapped, and of the other encodings and of several data files the whole
/// is decoded first. double becomes float32. Progress and Cancel reach into the decoding, except
/// of voxels spread over several files.
haptics::Expected<haptics::Volume> decodeNrrd(const ParsedNrrd& nrrd, int number, const Part& part,
                                              const ReadProgress& progress);

}  // namespace datasets
