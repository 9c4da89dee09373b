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

/// Extracts the stored bits of each word of one slice, with sign. Words that equal the padding stay
/// unchanged. Changed pixels are written to `room`.
Pixels settled(const Pixels& pixels, const DicomFile& file, std::vector<std::byte>& room);

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
