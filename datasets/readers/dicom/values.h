// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "datasets/readers/dicom/folder.h"
#include "datasets/readers/files/part.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Pixels of one slice, as stored.
struct Pixels {
  haptics::ScalarType type;
  const void* first;
};

/// The type that holds the file's stored values.
haptics::ScalarType storedTypeOf(const DicomFile& file);

/// The voxel types to try for a series, in order: the header's bits may allow more than the voxels
/// use, so a 16-bit type comes before a 32-bit one, and the next is tried when a voxel does not
/// fit.
std::vector<haptics::ScalarType> voxelTypesFor(const DicomSeries& series);

/// Words of slices by their bits above the stored ones. These may extend the sign, or hold nothing.
struct UpperBits {
  std::int64_t extended = 0;  ///< negative values, with all of them set
  std::int64_t bare = 0;      ///< negative values, with none of them set
  std::int64_t other = 0;     ///< bits that are neither

  /// Words that say more than their stored bits do. Where the sign is extended, a word without it
  /// is a value beyond them: 2900 in 12 signed bits.
  std::int64_t beyond() const { return other + (extended > 0 ? bare : 0); }
  UpperBits& operator+=(const UpperBits& more) {
    extended += more.extended;
    bare += more.bare;
    other += more.other;
    return *this;
  }
};

/// Extracts the stored bits of each word of one slice, with sign, and adds what the bits above say
/// to `upper`. Words that equal the padding stay unchanged. Changed pixels are written to `room`.
Pixels settled(const Pixels& pixels, const DicomFile& file, std::vector<std::byte>& room,
               UpperBits& upper);

/// The chosen pixels of one slice, with its slope and intercept; false if a value does not fit an
/// integer type.
bool rescale(const Pixels& pixels, const DicomFile& file, const Window& window,
             haptics::ScalarType type, void* to);

/// The least rescaled value of a slice, without padding; infinity if all values are padding.
double leastOf(const Pixels& pixels, const DicomFile& file);

/// Sets the padding voxels of a slice to `air`, after the slice was rescaled. Returns their number.
std::int64_t makeAir(const DicomFile& file, haptics::ScalarType type, double air,
                     std::int64_t count, void* slice);

}  // namespace datasets
