// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "haptics/carving/lowering.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

namespace haptics {

/// What it takes to cut the voxels of some structures, whatever their values say: Volume::tissues.
/// Immutable.
class Tissues {
 public:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  /// Voxels that take so much energy [J/m3]; kNever: they may not be cut.
  struct Part {
    std::span<const VoxelRun> runs;
    double energy = kNever;
  };
  /// Part of a row: first <= i < end.
  struct Run {
    std::int32_t first = 0, end = 0;
    float energy = 0.0F;
    bool mayBeCut() const HAPTICS_RT { return energy < std::numeric_limits<float>::infinity(); }
  };

  /// Where parts overlap, what may not be cut may not be; else the last part counts. The runs lie
  /// in the grid.
  Tissues(const Grid& grid, std::span<const Part> parts);

  /// By i, apart.
  std::span<const Run> row(std::int64_t j, std::int64_t k) const HAPTICS_RT {
    const auto at = static_cast<std::size_t>(k * rows_ + j);
    return std::span{runs_}.subspan(begins_[at], begins_[at + 1] - begins_[at]);
  }
  /// Whether voxels of a box may not be cut: true also where some lie beside it, within a block.
  bool mayKeep(const VoxelBox& box) const HAPTICS_RT;

 private:
  std::int64_t rows_ = 0;            ///< of a slice
  std::vector<std::size_t> begins_;  ///< of each row in `runs_`, and their end
  std::vector<Run> runs_;
  static constexpr std::int64_t kBlock = 8;  ///< voxels
  std::array<std::int64_t, 3> blocks_{};     ///< their count along each axis
  std::vector<bool> kept_;                   ///< of each block: it has voxels that may not be cut
};

}  // namespace haptics
