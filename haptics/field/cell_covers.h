// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"

namespace haptics {

/// A plane that covers the solid in one cell, in index coordinates: at every place u of the cell
/// with normal · u > height, F is below the ceiling.
struct CellCover {
  Vec3 normal = Vec3::Zero();  ///< unit vector, about along -grad F; zero for an empty cell
  double height = 0.0;         ///< -infinity for an empty cell, infinity for one without a cover
};

/// The covers of the cells near a tool's points. A cover belongs to a cell and not to a pose, so it
/// goes on serving while the tool slides along the surface. The pyramid's bounds hold for every
/// direction alike, so motion along the surface uses them up.
///
/// A cover is nowhere higher above the solid than kTightness, except where cells meet it askew.
/// Trilinear fields only.
class CellCovers {
 public:
  static constexpr double kTightness = 0.006;  ///< voxels

  /// For a tool that has so many points that covers pay; else it takes no memory.
  explicit CellCovers(bool used) : entries_(used ? kSets * kWays : 0) {}

  bool used() const HAPTICS_RT { return !entries_.empty(); }
  /// Discards all covers. Call it when the isovalue changed.
  void forget() HAPTICS_RT { ++epoch_; }

  /// The cover of the cell whose lowest corner is `at`, each index within 2^20 of 0. The reference
  /// is valid until the next call.
  const CellCover& at(const Isosurface& solid, const std::array<std::int64_t, 3>& at,
                      Budget& budget) HAPTICS_RT;

 private:
  static constexpr std::size_t kSets = 4096, kWays = 4;
  struct Entry {
    CellCover cover;
    std::int64_t key = 0;
    std::uint64_t epoch = 0;  ///< in which it was found; others are void
    std::uint64_t used = 0;   ///< number of the call that used it last
  };
  std::vector<Entry> entries_;
  std::uint64_t epoch_ = 1, calls_ = 0;
};

}  // namespace haptics
