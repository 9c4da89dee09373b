// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include "datasets/readers/files/refusal.h"
#include "haptics/core/parallel.h"

namespace datasets {
namespace {

using haptics::DistanceMap;
using haptics::Expected;
using haptics::Grid;
using haptics::Vec3;

/// The box of the structure's voxels.
haptics::VoxelBox boxOf(const LabelMap& labels, const std::array<bool, 256>& belongs) {
  const auto& dims = labels.grid().dims;
  std::vector<haptics::VoxelBox> of_slice(std::size_t(dims[2]), {dims, {}});
  haptics::inParallel(dims[2], [&](std::int64_t k) {
    haptics::VoxelBox& box = of_slice[std::size_t(k)];
    const std::uint8_t* code = labels.codes() + k * dims[0] * dims[1];
    for (std::int64_t j = 0; j < dims[1]; ++j)
      for (std::int64_t i = 0; i < dims[0]; ++i)
        if (belongs[*code++])
          for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t at = axis == 0 ? i : axis == 1 ? j : k;
            auto &first = box.first[std::size_t(axis)], &end = box.end[std::size_t(axis)];
            first = std::min(first, at);
            end = std::max(end, at + 1);
          }
  });
  haptics::VoxelBox box{dims, {}};
  for (const haptics::VoxelBox& one : of_slice)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.first[axis] = std::min(box.first[axis], one.first[axis]);
      box.end[axis] = std::max(box.end[axis], one.end[axis]);
    }
  return box;
}

/// The samples of a map while it is made.
class Work {
 public:
  Work(const Grid& grid, double most) : grid_{grid}, far_{float(most * most)} {
    const auto count = std::size_t(grid.voxelCount());
    inside_.reset(new (std::nothrow) std::uint8_t[count]{});
    squares_.reset(new (std::nothrow) float[count]);
  }
  bool hasRoom() const { return inside_ && squares_; }
  std::uint8_t* inside() { return inside_.get(); }

  /// Squared distances [m²] along an axis to the nearest midpoint between a sample that is inside
  /// and a neighbour on the axis that is not.
  void begin(int axis) {
    const double h = grid_.spacing[axis];
    eachLine(axis, [&](std::int64_t first, std::int64_t stride, std::int64_t count, Line& line) {
      const std::uint8_t* inside = inside_.get() + first;
      line.value.assign(std::size_t(count), far_);
      const auto sweep = [&](std::int64_t from, std::int64_t to, std::int64_t by) {
        double away = std::numeric_limits<double>::infinity();  // samples, from the last midpoint
        for (std::int64_t n = from; n != to; n += by) {
          away += 1.0;
          if (n != from && inside[n * stride] != inside[(n - by) * stride]) away = 0.5;
          float& value = line.value[std::size_t(n)];
          value = std::min(value, float(away * h * away * h));
        }
      };
      sweep(0, count, 1);
      sweep(count - 1, -1, -1);
      for (std::int64_t n = 0; n < count; ++n)
        squares_[first + n * stride] = line.value[std::size_t(n)];
    });
  }

  /// Adds the distance along another axis: the lower envelope of the parabolas over its samples.
  void add(int axis) {
    const double h2 = grid_.spacing[axis] * grid_.spacing[axis];
    eachLine(axis, [&](std::int64_t first, std::int64_t stride, std::int64_t count, Line& line) {
      line.value.resize(std::size_t(count));
      line.site.clear();
      line.from.clear();
      for (std::int64_t n = 0; n < count; ++n) {
        const float square = squares_[first + n * stride];
        line.value[std::size_t(n)] = square;
        if (square >= far_) continue;
        // in samples: where this parabola falls below that of the last site
        const double height = double(square) / h2 + double(n) * double(n);
        double from = -std::numeric_limits<double>::infinity();
        while (!line.site.empty()) {
          const std::int64_t last = line.site.back();
          from =
              (height - double(line.value[std::size_t(last)]) / h2 - double(last) * double(last)) /
              double(2 * (n - last));
          if (from > line.from.back()) break;
          line.site.pop_back();
          line.from.pop_back();
        }
        if (line.site.empty()) from = -std::numeric_limits<double>::infinity();
        line.site.push_back(n);
        line.from.push_back(from);
      }
      if (line.site.empty()) return;
      std::size_t at = 0;
      for (std::int64_t n = 0; n < count; ++n) {
        while (at + 1 < line.site.size() && line.from[at + 1] < double(n)) ++at;
        const double away = double(n - line.site[at]);
        squares_[first + n * stride] = std::min(
            far_, float(away * away * h2 + double(line.value[std::size_t(line.site[at])])));
      }
    });
  }

  /// Keeps the lesser of each sample of the map and the distance here, in its unit.
  void keep(std::int16_t* samples, double step) const {
    haptics::inParallel(grid_.dims[2], [&](std::int64_t k) {
      const std::int64_t slice = grid_.dims[0] * grid_.dims[1];
      for (std::int64_t n = k * slice; n < (k + 1) * slice; ++n)
        samples[n] = std::min(samples[n], std::int16_t(std::lround(std::sqrt(squares_[n]) / step)));
    });
  }

 private:
  struct Line {
    std::vector<float> value;
    std::vector<std::int64_t> site;
    std::vector<double> from;
  };

  /// Calls work(first sample, stride, count, scratch) for each line along the axis, on all cores:
  /// neighbours in memory one after another on one of them.
  template <class Each>
  void eachLine(int axis, const Each& each) {
    const std::array<std::int64_t, 3> stride{1, grid_.dims[0], grid_.dims[0] * grid_.dims[1]};
    const int quick = axis == 0 ? 1 : 0, slow = axis == 2 ? 1 : 2;
    haptics::inParallel(grid_.dims[std::size_t(slow)], [&](std::int64_t n) {
      Line line;
      for (std::int64_t m = 0; m < grid_.dims[std::size_t(quick)]; ++m)
        each(n * stride[std::size_t(slow)] + m * stride[std::size_t(quick)],
             stride[std::size_t(axis)], grid_.dims[std::size_t(axis)], line);
    });
  }

  const Grid& grid_;
  float far_;  // m²
  std::unique_ptr<std::uint8_t[]> inside_;
  std::unique_ptr<float[]> squares_;  // m²
};

// bytes of a sample while the map is made; two of them stay
constexpr std::size_t kBytes = kDistanceWork;
static_assert(kBytes == sizeof(float) + sizeof(std::int16_t) + 1);

/// Where the samples of a map lie among the voxels of the scan.
struct Samples {
  std::int64_t every = 0;  ///< voxels of a sample along an axis
  std::array<std::int64_t, 3> first, dims;
  std::int64_t count() const { return dims[0] * dims[1] * dims[2]; }
};

/// Those of a structure in this box: as many as the options allow.
Samples samplesOf(const Grid& scan, const haptics::VoxelBox& box, const DistanceOptions& options) {
  Samples samples;
  do {
    ++samples.every;
    for (int axis = 0; axis < 3; ++axis) {
      const auto of = std::size_t(axis);
      const std::int64_t every = samples.every;
      const double side = double(every) * scan.spacing[axis];
      const auto margin = std::int64_t(std::ceil(options.most / side)) + 1;
      samples.first[of] = box.first[of] - margin * every;
      samples.dims[of] = (box.end[of] - box.first[of] + every - 1) / every + 2 * margin;
    }
  } while (std::size_t(samples.count()) > options.most_bytes / kBytes);
  return samples;
}

}  // namespace

DistanceOptions distancesOf(std::size_t maps) {
  DistanceOptions options;
  const double each = 0.25 * freeMemory() / double(std::max<std::size_t>(maps, 1));
  options.most_bytes = std::min(options.most_bytes,
                                std::size_t(each * double(kBytes) / double(sizeof(std::int16_t))));
  return options;
}

std::int64_t distanceSamples(const Grid& scan, const haptics::VoxelBox& box,
                             const DistanceOptions& options) {
  return samplesOf(scan, box, options).count();
}

Expected<DistanceMap> distancesTo(const LabelMap& labels, std::uint8_t structure,
                                  const DistanceOptions& options,
                                  const std::function<bool(double)>& goes_on) {
  constexpr int kPasses = 10;
  const Grid& scan = labels.grid();
  std::array<bool, 256> belongs{};
  for (std::size_t code = 0; code < std::size_t(labels.codeCount()); ++code)
    belongs[code] = std::ranges::binary_search(labels.structuresOf(std::uint8_t(code)), structure);
  const haptics::VoxelBox box = boxOf(labels, belongs);

  DistanceMap map;
  map.most = options.most;
  map.step = options.most / std::numeric_limits<std::int16_t>::max();
  const Samples placed = samplesOf(scan, box, options);
  const std::int64_t every = placed.every;
  const auto& first = placed.first;
  map.grid.dims = placed.dims;
  map.grid.spacing = double(every) * scan.spacing;
  map.grid.direction = scan.direction;
  const double centre = 0.5 * double(every - 1);
  map.grid.origin = scan.worldOf(
      {double(first[0]) + centre, double(first[1]) + centre, double(first[2]) + centre});
  // a sample stands for all of its voxels, and is inside where one of them is: no nerve is too thin
  map.error = (every == 1 ? 0.55 : 1.0) * map.grid.spacing.maxCoeff();

  const auto count = map.grid.voxelCount();
  if (auto room = checkRoom(count, kBytes); !room) return tl::unexpected(room.error());
  Work work(map.grid, options.most);
  std::shared_ptr<std::int16_t[]> samples(new (std::nothrow) std::int16_t[std::size_t(count)]);
  if (!work.hasRoom() || !samples) return unsupported("too-large", {"labels-no-memory", {}});
  std::fill_n(samples.get(), count, std::numeric_limits<std::int16_t>::max());

  const auto& dims = map.grid.dims;
  haptics::inParallel(box.end[2] - box.first[2], [&](std::int64_t n) {
    // slices of one sample are one thread's: it writes them
    if (n % every != 0) return;
    for (std::int64_t k = box.first[2] + n; k < std::min(box.first[2] + n + every, box.end[2]); ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
        for (std::int64_t i = box.first[0]; i < box.end[0]; ++i)
          if (belongs[labels.codes()[(k * scan.dims[1] + j) * scan.dims[0] + i]])
            work.inside()[(((k - first[2]) / every) * dims[1] + (j - first[1]) / every) * dims[0] +
                          (i - first[0]) / every] = 1;
  });
  int passed = 0;
  const auto pass = [&] { return !goes_on || goes_on(double(++passed) / kPasses); };
  for (int axis = 0; axis < 3; ++axis) {
    work.begin(axis);
    if (!pass()) return cancelled();
    work.add((axis + 1) % 3);
    if (!pass()) return cancelled();
    work.add((axis + 2) % 3);
    if (!pass()) return cancelled();
    work.keep(samples.get(), map.step);
  }
  for (std::int64_t n = 0; n < count; ++n)
    if (work.inside()[n] != 0) samples[std::size_t(n)] = std::int16_t(-samples[std::size_t(n)]);
  map.samples = std::move(samples);
  haptics::boundSlopes(map);
  if (!pass()) return cancelled();
  return map;
}

}  // namespace datasets
