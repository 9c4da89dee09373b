// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "datasets/labels/label_map.h"
#include "haptics/structures/distance_map.h"

namespace datasets {

/// How far and how finely distances to a structure are known.
struct DistanceOptions {
  double most = 0.030;  ///< m, beyond which a distance is "more than that"; above 0
  /// Bytes that the work may take, some seven for a sample. Of a structure that takes more there is
  /// a sample for every second voxel along each axis only, or for every third, …
  std::size_t most_bytes = std::size_t{768} << 20;
};

/// Options for so many maps that all of them together take at most a quarter of the free memory,
/// and each no more than the default.
DistanceOptions distancesOf(std::size_t maps);

/// The samples of the map of a structure whose voxels lie in this box of the scan: two bytes each,
/// and kDistanceWork while the map is made.
std::int64_t distanceSamples(const haptics::Grid& scan, const haptics::VoxelBox& box,
                             const DistanceOptions& options = {});
inline constexpr std::int64_t kDistanceWork = 7;  ///< bytes

/// The distances to a structure of the map, by its number; it must have voxels. Refuses
/// ("too-large") what the free memory does not hold. `goes_on` gets the fraction that is done; if
/// it returns false, the result is Error::Kind::Cancelled. Any thread; on all cores. Source of the
/// method: Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions (2012); here to
/// the midpoints between voxels.
haptics::Expected<haptics::DistanceMap> distancesTo(
    const LabelMap& labels, std::uint8_t structure, const DistanceOptions& options = {},
    const std::function<bool(double)>& goes_on = {});

}  // namespace datasets
