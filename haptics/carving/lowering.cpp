// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/carving/lowering.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "haptics/carving/threshold.h"

namespace haptics {
namespace {

constexpr std::int64_t kSlab = 2;    // slices that one thread does at a time
constexpr std::int64_t kChunk = 32;  // voxels of a row that are looked at together

/// The greatest value of the type that is at most `ceiling`, to the nearest.
template <class T>
T valueAtMost(double ceiling) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(ceiling);
  } else {
    const double least = static_cast<double>(std::numeric_limits<T>::lowest());
    const double most = static_cast<double>(std::numeric_limits<T>::max());
    if (!(ceiling > least)) return std::numeric_limits<T>::lowest();
    if (!(ceiling < most)) return std::numeric_limits<T>::max();
    return static_cast<T>(std::floor(ceiling + 0.5));
  }
}

/// One slab's part: rows one after the other.
template <class T>
class RowLowering {
 public:
  RowLowering(const Volume& volume, const RowCutter& cutter, T* written, Lowered& lowered)
      : grid_{volume.grid},
        cutter_{cutter},
        values_{static_cast<const T*>(volume.voxels.get())},
        written_{written},
        lowered_{lowered},
        background_{valueAtMost<T>(volume.least)},
        isovalue_{cutter.isovalue},
        solid_from_{thresholdOf<T>(cutter.isovalue)} {
    cut_.ceiling.resize(static_cast<std::size_t>(grid_.dims[0]));
  }

  void row(std::int64_t j, std::int64_t k) {
    cut_.spans.clear();
    cutter_.cutRow(j, k, cut_);
    j_ = static_cast<std::int32_t>(j);
    k_ = static_cast<std::int32_t>(k);
    const std::int64_t at = (k * grid_.dims[1] + j) * grid_.dims[0];
    const T* values = values_ + at;
    T* written = written_ == nullptr ? nullptr : written_ + at;
    for (const RowCut::Span& span : cut_.spans)
      if (span.background)
        toBackground(values, written, span);
      else
        toCeiling(values, written, span);
    close();
  }

 private:
  void toBackground(const T* values, T* written, const RowCut::Span& span) {
    // counters as wide as the voxels, so that they are counted many at a time
    using Count =
        std::conditional_t<sizeof(T) == 1, std::uint8_t,
                           std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint32_t>>;
    const T solid_from = solid_from_.value_or(background_);
    for (std::int32_t i = span.first; i < span.end; i += kChunk) {
      const std::int32_t end = std::min<std::int32_t>(i + kChunk, span.end);
      Count higher = 0, solid = 0;
      for (std::int32_t n = i; n < end; ++n) {
        higher = static_cast<Count>(higher + (values[n] > background_));
        solid = static_cast<Count>(solid + (values[n] >= solid_from));
      }
      if (higher == 0) continue;
      std::int32_t a = i, b = end;
      while (!(values[a] > background_)) ++a;
      while (!(values[b - 1] > background_)) --b;
      if (solid_from_ && static_cast<double>(background_) < isovalue_) lowered_.solid += solid;
      if (written != nullptr) std::fill(written + a, written + b, background_);
      add(a, b);
    }
  }
  void toCeiling(const T* values, T* written, const RowCut::Span& span) {
    for (std::int32_t i = span.first; i < span.end; ++i) {
      const T before = values[i];
      const T most = valueAtMost<T>(cut_.ceiling[static_cast<std::size_t>(i)]);
      if (!(most < before)) continue;
      lowered_.solid +=
          static_cast<double>(before) >= isovalue_ && static_cast<double>(most) < isovalue_;
      if (written != nullptr) written[i] = most;
      add(i, i + 1);
    }
  }
  void add(std::int32_t first, std::int32_t end) {
    if (open_ && first - open_end_ < kChunk) {
      open_end_ = end;
      return;
    }
    close();
    open_ = true;
    open_first_ = first;
    open_end_ = end;
  }
  void close() {
    if (open_) lowered_.runs.push_back({open_first_, j_, k_, open_end_ - open_first_});
    open_ = false;
  }

  const Grid& grid_;
  const RowCutter& cutter_;
  const T* values_;
  T* written_;
  Lowered& lowered_;
  T background_;
  double isovalue_;
  std::optional<T> solid_from_;  // the least value that is solid
  RowCut cut_;
  bool open_ = false;
  std::int32_t open_first_ = 0, open_end_ = 0, j_ = 0, k_ = 0;
};

}  // namespace

std::optional<Lowered> lower(const Volume& volume, const RowCutter& cutter, void* written,
                             const EachPart& each) {
  const VoxelBox& box = cutter.box;
  const std::int64_t slices = std::max<std::int64_t>(0, box.end[2] - box.first[2]);
  const std::int64_t slabs = (slices + kSlab - 1) / kSlab;
  std::vector<Lowered> parts(static_cast<std::size_t>(slabs));
  const bool done = each(slabs, [&](std::int64_t n) {
    visitVoxels(volume.type, volume.voxels.get(), [&](const auto* typed) {
      using T = std::remove_cvref_t<decltype(*typed)>;
      RowLowering<T> rows{volume, cutter, static_cast<T*>(written),
                          parts[static_cast<std::size_t>(n)]};
      const std::int64_t first = box.first[2] + n * kSlab;
      for (std::int64_t k = first; k < std::min(first + kSlab, box.end[2]); ++k)
        for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) rows.row(j, k);
    });
  });
  if (!done) return {};
  Lowered all;
  std::size_t count = 0;
  for (const Lowered& part : parts) count += part.runs.size();
  all.runs.reserve(count);
  for (const Lowered& part : parts) {
    all.runs.insert(all.runs.end(), part.runs.begin(), part.runs.end());
    all.solid += part.solid;
  }
  return all;
}

}  // namespace haptics
