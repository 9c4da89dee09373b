// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/readers/files/beginning.h"
#include "haptics/core/error.h"

namespace datasets {

enum class NrrdEncoding { Raw, Ascii, Hex, Gzip, Bzip2 };

/// The checked header, before teem parses it.
struct NrrdHeader {
  std::string type;                    ///< one of teem's own names: "short", "unsigned char", …
  int bytes_per_voxel = 0;             ///< in the file
  std::vector<std::int64_t> sizes;     ///< of the file's axes: three or four
  std::array<unsigned, 3> axes{};      ///< which of them are i, j, k
  std::array<std::int64_t, 3> dims{};  ///< of these axes: the sizes of one volume
  int volume_axis = -1;                ///< the axis that counts volumes; -1: none
  std::int64_t volumes = 1;
  NrrdEncoding encoding = NrrdEncoding::Raw;
  bool big_endian = false;
  std::int64_t header_bytes = 0;  ///< text and the empty line after it
  bool skip_stated = false;       ///< the header states how much to skip in each data file
  std::int64_t line_skip = 0;
  std::int64_t byte_skip = 0;                     ///< -1: the voxels are the last bytes of the file
  std::vector<std::filesystem::path> data_files;  ///< empty: the voxels follow the header
  std::string text;   ///< the header's lines without those that name data files or skip in them
  std::string skips;  ///< the lines that say what to skip

  std::int64_t voxelCount() const;  ///< of all volumes
  /// In each file: all have as many.
  std::int64_t voxelsPerFile() const;
};

/// Whether a file begins like an NRRD.
bool looksLikeNrrd(const Beginning& file);

/// Whether a file is a .seg.nrrd of 3D Slicer, by the segments that its header describes.
bool holdsSegments(const Beginning& file);

/// Reads the header's text and checks it against the files. The header must have three axes of
/// space, or a fourth that counts volumes, one value per voxel and a type that can be shown
/// ("not-scalar", "unsupported-type"). A number that places the voxels must be one as a whole
/// ("bad-header"). Each data file must be in the header's folder ("outside-folder"); several must
/// share the voxels as the format says ("bad-header"). The files must be large enough for the
/// voxels
/// ("truncated"), so that no broken header can make the reader allocate memory. A data file that is
/// longer than its voxels needs a stated skip ("bad-header").
haptics::Expected<NrrdHeader> readNrrdHeader(const std::filesystem::path& path);

}  // namespace datasets
