// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/stored_volumes.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::ScalarType;

namespace {

constexpr double kMostInflation = 1032.0;        // times: the most that deflate can do
constexpr double kReading = 0.9;                 // of the progress; the rest is for the range
constexpr double kUnsaid_deg = 0.005;            // axes less off are not spoken of
constexpr std::int64_t kVoxelsAtOnce = 1 << 20;  // voxels between two looks at Cancel

struct Values {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

/// Calls f for the voxels from `begin` to `end`, block by block; false if cancelled.
template <class F>
bool inBlocks(std::int64_t count, const ReadProgress& progress, F&& f) {
  for (std::int64_t at = 0; at < count; at += kVoxelsAtOnce) {
    if (progress.isCancelled()) return false;
    f(at, std::min(at + kVoxelsAtOnce, count));
  }
  return true;
}

/// The narrowest type that holds every rescaled voxel, the stored one first.
ScalarType typeFor(ScalarType stored, double slope, double intercept, const Values& values) {
  if (stored == ScalarType::Float32 || std::nearbyint(slope) != slope ||
      std::nearbyint(intercept) != intercept)
    return ScalarType::Float32;
  const double one = slope * values.least + intercept, other = slope * values.greatest + intercept;
  const double low = std::min(one, other), high = std::max(one, other);
  std::vector<ScalarType> types{stored};
  if (haptics::sizeOf(stored) <= 2) {
    types.push_back(ScalarType::Int16);
    types.push_back(ScalarType::UInt16);
  }
  types.push_back(ScalarType::Int32);
  types.push_back(ScalarType::UInt32);
  for (const ScalarType type : types) {
    const bool holds = haptics::visitVoxels(type, nullptr, [&](const auto* v) {
      using T = std::remove_cvref_t<decltype(*v)>;
      return low >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
             high <= static_cast<double>(std::numeric_limits<T>::max());
    });
    if (holds) return type;
  }
  return ScalarType::Float32;
}

struct Rescaled {
  ScalarType type;
  std::shared_ptr<void> voxels;
};

Expected<Rescaled> rescaled(const StoredVolumes& stored, std::shared_ptr<void> voxels,
                            std::int64_t count, const ReadProgress& progress) {
  const ScalarType from = stored.voxels.layout.type;
  if (stored.slope == 1.0 && stored.intercept == 0.0) return Rescaled{from, std::move(voxels)};
  Values values;
  const bool seen = haptics::visitVoxels(from, voxels.get(), [&](const auto* v) {
    return inBlocks(count, progress, [&](std::int64_t begin, std::int64_t end) {
      const auto [least, greatest] = std::minmax_element(v + begin, v + end);
      values.least = std::min(values.least, static_cast<double>(*least));
      values.greatest = std::max(values.greatest, static_cast<double>(*greatest));
    });
  });
  if (!seen) return cancelled();
  const ScalarType to = typeFor(from, stored.slope, stored.intercept, values);
  std::shared_ptr<void> out = voxels;  // in place where the type stays
  if (to != from) {
    if (auto room = checkRoom(count, static_cast<std::int64_t>(haptics::sizeOf(to))); !room)
      return tl::unexpected(std::move(room.error()));
    auto more = haptics::allocateVoxels(count, to);
    if (!more) return tl::unexpected(std::move(more.error()));
    out = std::move(*more);
  }
  const bool done = haptics::visitVoxels(from, voxels.get(), [&](const auto* in) {
    return haptics::visitVoxels(to, out.get(), [&](const auto* kept) {
      auto* o = const_cast<std::remove_const_t<std::remove_pointer_t<decltype(kept)>>*>(kept);
      return inBlocks(count, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
          o[i] = static_cast<std::remove_reference_t<decltype(*o)>>(
              stored.slope * static_cast<double>(in[i]) + stored.intercept);
      });
    });
  });
  if (!done) return cancelled();
  return Rescaled{to, std::move(out)};
}

/// What is no number is replaced, and a page in which that happens is a copy in memory.
Expected<void> checkReplaced(const StoredVolumes& stored, const void* voxels, std::int64_t count,
                             const ReadProgress& progress) {
  if (stored.voxels.layout.type != ScalarType::Float32) return {};
  const auto* v = static_cast<const float*>(voxels);
  const std::int64_t page = sysconf(_SC_PAGESIZE) / std::int64_t{sizeof(float)};  // voxels
  std::int64_t pages = 0;
  const bool seen = inBlocks(count, progress, [&](std::int64_t begin, std::int64_t end) {
    progress.advanced(static_cast<double>(begin) / static_cast<double>(count));
    for (std::int64_t at = begin; at < end; at += page)
      if (!std::all_of(v + at, v + std::min(at + page, end),
                       [](float x) { return std::isfinite(x); }))
        pages += 2;  // the page may begin between two of the file
  });
  if (!seen) return cancelled();
  return checkRoom(pages * page, sizeof(float), {"advice-save-with-numbers", {}});
}

}  // namespace

Expected<void> place(StoredVolumes& stored, const FileGeometry& geometry) {
  auto grid = gridOf(geometry);
  if (!grid) return tl::unexpected(std::move(grid.error()));
  stored.grid = *grid;
  if (const double off_deg = shear_deg(geometry.steps_mm); off_deg > kUnsaid_deg)
    stored.notes.push_back({"geometry-squared", {brief(off_deg)}});
  return {};
}

Expected<void> checkStored(const StoredVoxels& voxels, const std::filesystem::path& header) {
  const VoxelLayout& layout = voxels.layout;
  std::int64_t room = std::numeric_limits<std::int64_t>::max() / 64;
  for (const std::int64_t size : layout.sizes) {
    if (size < 1) return malformed("bad-header", {"geometry-axis-empty", {}});
    if (size > std::min<std::int64_t>(room, std::numeric_limits<std::int32_t>::max()))
      return unsupported("too-large", {"header-too-many-voxels", {quoted(header)}});
    room /= size;
  }
  if (layout.sizes[3] > kMostVolumes)
    return unsupported("too-large", {"file-too-many-volumes",
                                     {quoted(header), std::to_string(layout.sizes[3]),
                                      std::to_string(kMostVolumes)}});
  std::error_code error;
  const auto length = static_cast<double>(std::filesystem::file_size(voxels.file, error));
  if (error) return notFound(voxels.file);
  const double stored = length - static_cast<double>(voxels.offset);
  const double needed = static_cast<double>(std::max<std::int64_t>(voxels.skip, 0)) +
                        static_cast<double>(layout.voxelCount() * layout.bytesPerVoxel());
  if (stored < 0.0 || (voxels.deflated ? kMostInflation * (stored + 1.0) : stored) < needed)
    return malformed("truncated", {"file-shorter-than-header", {quoted(voxels.file)}});
  return {};
}

Expected<haptics::Volume> finished(const StoredVolumes& stored, const Window& window,
                                   ScalarType type, std::shared_ptr<void> voxels,
                                   const ReadProgress& progress) {
  const auto goes_on = [&](double fraction) {
    progress.advanced(fraction);
    return !progress.isCancelled();
  };
  auto volume = haptics::makeVolume(gridOf(stored.grid, window), type, std::move(voxels),
                                    stored.facts, goes_on);
  if (progress.isCancelled()) return cancelled();
  progress.advanced(1.0);
  return volume;
}

Expected<haptics::Volume> readVolume(const StoredVolumes& stored, int number, const Part& part,
                                     const ReadProgress& progress) {
  const auto window = windowOf(part, stored.grid.dims);
  if (!window) return tl::unexpected(window.error());
  const std::int64_t count = window->count[0] * window->count[1] * window->count[2];
  const bool plain = stored.slope == 1.0 && stored.intercept == 0.0;
  if (plain && isMapped(stored.voxels, number, *window)) {
    auto voxels = mapVoxels(stored.voxels, number);
    if (!voxels) return tl::unexpected(std::move(voxels.error()));
    const ReadProgress looking = progress.part(0.0, 0.5);
    if (auto fits = checkReplaced(stored, voxels->get(), count, looking); !fits)
      return tl::unexpected(std::move(fits.error()));
    return finished(stored, *window, stored.voxels.layout.type, std::move(*voxels),
                    progress.part(0.5, 1.0));
  }
  auto voxels = readVoxels(stored.voxels, number, *window, progress.part(0.0, kReading));
  if (!voxels) return tl::unexpected(std::move(voxels.error()));
  auto ready = rescaled(stored, std::move(*voxels), count, progress);
  if (!ready) return tl::unexpected(std::move(ready.error()));
  return finished(stored, *window, ready->type, std::move(ready->voxels),
                  progress.part(kReading, 1.0));
}

}  // namespace datasets
