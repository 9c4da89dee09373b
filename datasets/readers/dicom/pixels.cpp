// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/pixels.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "datasets/readers/dicom/codestream.h"
#include "datasets/readers/dicom/decoder.h"
#include "datasets/readers/dicom/frames.h"
#include "datasets/readers/dicom/straighten.h"
#include "datasets/readers/dicom/values.h"
#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/parallel.h"
#include "datasets/readers/files/part.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/thumbnail.h"

namespace datasets {

using haptics::Expected;
using haptics::ScalarType;

namespace {

/// What a reading takes of a series.
struct Taken {
  const DicomSeries& series;
  std::vector<std::size_t> slices;  ///< indices of the series' files, in the order of the stack
  Window window;

  std::int64_t pixelCount() const { return window.count[0] * window.count[1]; }
  void* sliceAt(std::size_t place, ScalarType type, void* voxels) const {
    return static_cast<char*>(voxels) + static_cast<std::int64_t>(place) * pixelCount() *
                                            static_cast<std::int64_t>(haptics::sizeOf(type));
  }
};

Expected<Taken> takenOf(const DicomSeries& series, const Part& part) {
  const std::vector<std::size_t>& order = series.stack->order;
  const SlicePlane& any = series.files.front().plane;
  const auto window =
      windowOf(part, {any.columns, any.rows, static_cast<std::int64_t>(order.size())});
  if (!window) return tl::unexpected(window.error());
  Taken taken{series, {}, *window};
  for (std::int64_t k = 0; k < window->count[2]; ++k)
    taken.slices.push_back(order[static_cast<std::size_t>(window->first[2] + k * window->step)]);
  return taken;
}

/// The slices that lie in one file.
struct FileTask {
  std::vector<std::size_t> places;  ///< in Taken::slices
};

std::vector<FileTask> tasksOf(const Taken& taken) {
  std::vector<FileTask> tasks;
  std::map<std::filesystem::path, std::size_t> by_path;
  for (std::size_t k = 0; k < taken.slices.size(); ++k) {
    const auto [it, is_new] =
        by_path.try_emplace(taken.series.files[taken.slices[k]].path, tasks.size());
    if (is_new) tasks.emplace_back();
    tasks[it->second].places.push_back(k);
  }
  return tasks;
}

/// What the frames under way take while they are read.
std::int64_t decodedBytes(const Taken& taken) {
  std::int64_t most = 0;
  for (const std::size_t n : taken.slices) {
    const DicomFile& file = taken.series.files[n];
    const int frames = codingOf(file.syntax) ? 1 : file.frame_count;
    most =
        std::max(most, file.plane.columns * file.plane.rows * frames * (file.bits_allocated / 8));
  }
  return most * static_cast<std::int64_t>(workersFor(tasksOf(taken).size()));
}

enum class Outcome { Done, DoesNotFit };

bool isPadded(const DicomSeries& series) {
  return std::ranges::any_of(series.files,
                             [](const DicomFile& f) { return f.padding.has_value(); });
}

/// `air` becomes the least value that is no padding, where there is padding: of whole slices, also
/// where only a part of them is taken.
Expected<Outcome> decodeAll(const Taken& taken, ScalarType type, void* voxels, double& air,
                            UpperBits& upper, const ReadProgress& progress) {
  const bool padded = isPadded(taken.series);
  air = std::numeric_limits<double>::infinity();
  const std::vector<FileTask> tasks = tasksOf(taken);
  Decoders decoders = decodersFor(taken.series.files);
  std::mutex mutex;
  std::optional<haptics::Error> failed;
  std::size_t failed_at = tasks.size();
  std::atomic<bool> fits = true;
  const auto decodeOne = [&](std::size_t n) {
    const CLocale numbers_with_points;
    std::unique_ptr<FileFrames> frames;
    std::vector<std::byte> room;
    UpperBits of_file;
    for (const std::size_t place : tasks[n].places) {
      const DicomFile& file = taken.series.files[taken.slices[place]];
      if (!frames) frames = framesOf(file, decoders);
      const auto words = frames->pixelsOf(file, progress);
      if (!words) {
        const std::scoped_lock lock(mutex);
        if (n < failed_at) failed = words.error();
        failed_at = std::min(n, failed_at);
        return false;
      }
      const Pixels pixels = settled(*words, file, room, of_file);
      if (padded) {
        const double least = leastOf(pixels, file);
        const std::scoped_lock lock(mutex);
        air = std::min(air, least);
      }
      if (!rescale(pixels, file, taken.window, type, taken.sliceAt(place, type, voxels)))
        fits = false;
    }
    const std::scoped_lock lock(mutex);
    upper += of_file;
    return fits.load();
  };
  const bool done = onAllCores(tasks.size(), progress, decodeOne);
  if (failed) return tl::unexpected(*failed);
  if (!fits) return Outcome::DoesNotFit;
  if (!done) return cancelled();
  return Outcome::Done;
}

/// Makes air of what the slices pad their pixels with. How many.
std::int64_t padWithAir(const Taken& taken, ScalarType type, double air, void* voxels) {
  // where all is padding nothing is known to be air
  if (!isPadded(taken.series) || !std::isfinite(air)) return 0;
  std::int64_t count = 0;
  for (std::size_t place = 0; place < taken.slices.size(); ++place)
    count += makeAir(taken.series.files[taken.slices[place]], type, air, taken.pixelCount(),
                     taken.sliceAt(place, type, voxels));
  return count;
}

}  // namespace

Expected<haptics::Volume> readSeries(const DicomSeries& series, Geometry geometry, const Part& part,
                                     const ReadProgress& progress) {
  if (!series.stack) return tl::unexpected(series.stack.error());
  const Stack& stack = *series.stack;
  if (stack.crooked && geometry == Geometry::AsStored) return tl::unexpected(stack.crooked->why);
  if (series.question && geometry == Geometry::AsStored) return tl::unexpected(*series.question);
  if (stack.crooked && !part.isWhole())
    return unsupported("too-large", {"dicom-resampled-whole-only", {}});
  const auto whole = gridOf(stack.geometry);
  if (!whole) return tl::unexpected(whole.error());
  const auto taken = takenOf(series, part);
  if (!taken) return tl::unexpected(taken.error());
  const haptics::Grid grid = stack.crooked ? *whole : gridOf(*whole, taken->window);
  const std::int64_t stored = taken->pixelCount() * static_cast<std::int64_t>(taken->slices.size());
  const double decoded = stack.crooked ? 0.8 : 1.0;  // of the progress

  for (const ScalarType type : voxelTypesFor(series)) {
    const std::int64_t voxel_count = stored + (stack.crooked ? grid.voxelCount() : 0);
    const auto room = checkRoom(
        voxel_count * static_cast<std::int64_t>(haptics::sizeOf(type)) + decodedBytes(*taken), 1);
    if (!room) return tl::unexpected(room.error());
    auto voxels = haptics::allocateVoxels(stored, type);
    if (!voxels) return tl::unexpected(std::move(voxels.error()));
    double air = 0.0;
    UpperBits upper;
    const auto outcome =
        decodeAll(*taken, type, voxels->get(), air, upper, progress.part(0.0, decoded));
    if (!outcome) return tl::unexpected(outcome.error());
    if (*outcome == Outcome::DoesNotFit) continue;
    const std::int64_t padded = padWithAir(*taken, type, air, voxels->get());
    if (stack.crooked) {
      auto box = haptics::allocateVoxels(grid.voxelCount(), type);
      if (!box) return tl::unexpected(std::move(box.error()));
      if (!straighten(stack, type, voxels->get(), box->get(), progress.part(decoded, 1.0)))
        return cancelled();
      voxels = std::move(box);
    }
    const bool hounsfield = std::ranges::all_of(series.files, &DicomFile::hounsfield);
    return haptics::makeVolume(grid, type, std::move(*voxels),
                               {.unit = hounsfield ? "HU" : "",
                                .modality = series.files.front().modality,
                                .orientation_known = true,
                                .padded = padded,
                                .beyond_bits = upper.beyond(),
                                .resampled = stack.crooked.has_value()},
                               [&](double) { return !progress.isCancelled(); });
  }
  return unsupported("bad-header", {"dicom-rescaled-range", {}});
}

Expected<Thumbnail> thumbnailOf(const DicomSeries& series, int longest) {
  const CLocale numbers_with_points;
  const DicomFile& file = middleSliceOf(series);
  if (file.fault) return tl::unexpected(*file.fault);
  if (const auto room = checkRoom(file.plane.columns * file.plane.rows, 4); !room)
    return tl::unexpected(room.error());
  Decoders decoders = decodersFor({&file, 1});
  const std::unique_ptr<FileFrames> frames = framesOf(file, decoders);
  const auto words = frames->pixelsOf(file, {});
  if (!words) return tl::unexpected(words.error());
  std::vector<std::byte> room;
  UpperBits upper;
  const Pixels pixels = settled(*words, file, room, upper);
  return thumbnailOf({.type = pixels.type,
                      .pixels = pixels.first,
                      .columns = file.plane.columns,
                      .rows = file.plane.rows,
                      .column_step = file.plane.column_step_mm,
                      .row_step = file.plane.row_step_mm,
                      .direction = file.placed ? directionOf(file.plane) : std::nullopt,
                      .padding = file.padding,
                      .inverted = file.inverted},
                     longest);
}

}  // namespace datasets
