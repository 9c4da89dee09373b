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

/// Whether teem, the format's reference implementation, decodes the voxels: of encodings other than
/// raw and gzip.
bool needsTeem(const NrrdHeader& header);

/// Reads a part of one volume of an NRRD. What needsTeem() is decoded whole first. Raw volumes of
/// 1 GiB, or of half the free memory, are mapped unless they lie in several files. double becomes
/// float32. Progress and Cancel work during decoding, except for gzip voxels in one piece.
haptics::Expected<haptics::Volume> decodeNrrd(const ParsedNrrd& nrrd, int number, const Part& part,
                                              const ReadProgress& progress);

}  // namespace datasets
