// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/volume.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "haptics/core/parallel.h"
#include "haptics/core/voxel_memory.h"

namespace haptics {

const char* nameOf(ScalarType type) {
  switch (type) {
    case ScalarType::UInt8:
      return "uint8";
    case ScalarType::Int8:
      return "int8";
    case ScalarType::UInt16:
      return "uint16";
    case ScalarType::Int16:
      return "int16";
    case ScalarType::UInt32:
      return "uint32";
    case ScalarType::Int32:
      return "int32";
    case ScalarType::Float32:
      break;
  }
  return "float32";
}

std::size_t sizeOf(ScalarType type) {
  return visitVoxels(type, nullptr, [](auto* p) { return sizeof(*p); });
}

Expected<std::shared_ptr<void>> allocateVoxels(std::int64_t voxel_count, ScalarType type) {
  const auto size = static_cast<std::int64_t>(sizeOf(type));
  const std::int64_t most = std::numeric_limits<std::int64_t>::max() / size - 1024;
  if (voxel_count <= 0 || voxel_count > most)
    return tl::unexpected(Error{Error::Kind::Unsupported,
                                {"volume-memory", {std::to_string(voxel_count / 1'000'000 * size)}},
                                "too-large"});
  const auto bytes = static_cast<std::size_t>(voxel_count * size);
  // where files may not become so large, nor may a memory object: plain memory then, which cannot
  // be edited
  struct rlimit largest {};
  if (getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur < bytes) {
    void* plain = std::calloc(bytes + kVoxelPadding, 1);
    if (plain != nullptr) return std::shared_ptr<void>(plain, [](void* p) { std::free(p); });
  }
  const auto memory = VoxelMemory::allocate(bytes);
  if (!memory) return tl::unexpected(memory.error());
  return (*memory)->sharedView();
}

namespace {

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  std::int64_t non_finite = 0;
};

/// Extends a range by some voxels.
template <class T>
void extend(Range& range, const T* voxels, std::int64_t count) {
  if constexpr (std::is_floating_point_v<T>) {
    for (std::int64_t i = 0; i < count; ++i) {
      if (!std::isfinite(voxels[i])) {
        ++range.non_finite;
        continue;
      }
      range.least = std::min(range.least, double{voxels[i]});
      range.greatest = std::max(range.greatest, double{voxels[i]});
    }
  } else {
    T least = voxels[0], greatest = voxels[0];
    for (std::int64_t i = 1; i < count; ++i) {
      least = std::min(least, voxels[i]);
      greatest = std::max(greatest, voxels[i]);
    }
    range.least = std::min(range.least, static_cast<double>(least));
    range.greatest = std::max(range.greatest, static_cast<double>(greatest));
  }
}

constexpr std::int64_t kBlock = 1 << 20;  // voxels, which one thread takes at once

/// None where `goes_on` says to stop.
template <class T>
std::optional<Range> rangeOf(const T* voxels, std::int64_t count,
                             const std::function<bool(double)>& goes_on) {
  std::vector<Range> parts(static_cast<std::size_t>((count + kBlock - 1) / kBlock));
  std::atomic<bool> stopped{false};
  const auto caller = std::this_thread::get_id();
  inParallel(static_cast<std::int64_t>(parts.size()), [&](std::int64_t n) {
    const std::int64_t at = n * kBlock;
    if (goes_on && std::this_thread::get_id() == caller &&
        !goes_on(static_cast<double>(at) / static_cast<double>(count)))
      stopped = true;
    if (stopped) return;
    extend(parts[static_cast<std::size_t>(n)], voxels + at, std::min(kBlock, count - at));
  });
  if (stopped) return {};
  Range range;
  for (const Range& part : parts) {
    range.least = std::min(range.least, part.least);
    range.greatest = std::max(range.greatest, part.greatest);
    range.non_finite += part.non_finite;
  }
  return range;
}

/// Makes voxels that are no numbers background. Those of a file stay as they are in the file, so
/// its object is told where they are.
void replaceNonFinite(float* voxels, std::int64_t count, float background, VoxelMemory* memory) {
  const bool of_file = memory != nullptr && memory->isOfFile();
  std::vector<VoxelMemory::Floats> places;
  for (std::int64_t i = 0; i < count; ++i) {
    if (std::isfinite(voxels[i])) continue;
    voxels[i] = background;
    if (!of_file) continue;
    const auto at = static_cast<std::size_t>(i);
    if (!places.empty() && places.back().first + places.back().count == at)
      ++places.back().count;
    else
      places.push_back({at, 1});
  }
  if (of_file) memory->replaceInViews(std::move(places), background);
}

Error malformed(Message message, std::string reason) {
  return {Error::Kind::Malformed, std::move(message), std::move(reason)};
}

}  // namespace

Expected<Volume> makeVolume(const Grid& grid, ScalarType type, std::shared_ptr<void> voxels,
                            VolumeFacts facts, const std::function<bool(double)>& goes_on) {
  for (const std::int64_t n : grid.dims)
    if (n < 1) return tl::unexpected(malformed({"geometry-axis-empty", {}}, "bad-header"));
  if (!grid.spacing.allFinite() || grid.spacing.minCoeff() <= 0.0)
    return tl::unexpected(malformed({"geometry-not-finite", {}}, "bad-header"));
  if (!grid.origin.allFinite() || !grid.direction.allFinite())
    return tl::unexpected(malformed({"geometry-not-finite", {}}, "bad-header"));
  const Mat3 gram = grid.direction.transpose() * grid.direction;
  if ((gram - Mat3::Identity()).cwiseAbs().maxCoeff() > 1e-4)
    return tl::unexpected(malformed({"volume-axes-not-right-angled", {}}, "sheared"));

  Volume volume;
  volume.grid = grid;
  volume.type = type;
  const std::int64_t count = grid.voxelCount();
  const auto found = visitVoxels(type, static_cast<const void*>(voxels.get()),
                                 [&](const auto* v) { return rangeOf(v, count, goes_on); });
  if (!found)
    return tl::unexpected(Error{Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  const Range range = *found;
  if (range.non_finite == count)
    return tl::unexpected(malformed({"volume-no-finite-voxel", {}}, "no-pixels"));
  volume.least = range.least;
  volume.greatest = range.greatest;
  volume.replaced = range.non_finite;
  const std::shared_ptr<VoxelMemory> memory = VoxelMemory::of(voxels);
  if (range.non_finite > 0)
    replaceNonFinite(static_cast<float*>(voxels.get()), count, static_cast<float>(range.least),
                     memory.get());
  volume.memory = memory;
  volume.voxels = std::move(voxels);
  volume.unit = std::move(facts.unit);
  volume.modality = std::move(facts.modality);
  volume.orientation_known = facts.orientation_known;
  volume.padded = facts.padded;
  volume.beyond_bits = facts.beyond_bits;
  volume.resampled = facts.resampled;
  return volume;
}

VoxelBox joined(const VoxelBox& one, const VoxelBox& other) {
  if (isEmpty(one)) return other;
  if (isEmpty(other)) return one;
  VoxelBox both;
  for (std::size_t a = 0; a < 3; ++a) {
    both.first[a] = std::min(one.first[a], other.first[a]);
    both.end[a] = std::max(one.end[a], other.end[a]);
  }
  return both;
}

void add(const VoxelBox& box, std::vector<VoxelBox>& way) {
  if (isEmpty(box)) return;
  constexpr std::int64_t kLongest = 64;  // voxels
  const VoxelBox both = way.empty() ? box : joined(way.back(), box);
  bool is_long = way.empty();
  for (std::size_t a = 0; a < 3; ++a) is_long = is_long || both.end[a] - both.first[a] > kLongest;
  if (is_long)
    way.push_back(box);
  else
    way.back() = both;
}

}  // namespace haptics
