// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/edits/bits.h"
#include "datasets/edits/operators.h"
#include "haptics/core/volume.h"

namespace datasets {

/// The voxels of a box at or above an isovalue. None: cancelled.
std::optional<VoxelBits> solidOf(const haptics::Volume& volume, const haptics::VoxelBox& box,
                                 double isovalue, const EditProgress& progress);

/// The connected parts of a solid.
///
/// Two voxels are connected if they are neighbours along an axis, since the field between them
/// stays in the solid; or across a face of a cell, if the trilinear field connects them there: if
/// its saddle is in the solid. These are the pieces that a tool feels. A bridge that passes through
/// the body of a cell alone is none here.
class Pieces {
 public:
  /// None: cancelled. `saddles`: false leaves out connections across faces.
  static std::optional<Pieces> of(const haptics::Volume& volume, const VoxelBits& solid,
                                  double isovalue, bool saddles, const EditProgress& progress);

  std::uint32_t count() const { return static_cast<std::uint32_t>(voxels_.size()); }
  std::int64_t voxelsOf(std::uint32_t piece) const { return voxels_[piece]; }
  /// The piece with a voxel.
  std::optional<std::uint32_t> at(std::int64_t i, std::int64_t j, std::int64_t k) const;
  /// Sets the bits of the pieces for which `chosen` is true.
  void mark(const std::vector<bool>& chosen, VoxelBits& bits) const;

 private:
  struct Run {
    std::int32_t first, end;
  };
  std::array<std::int64_t, 3> dims_{};
  std::vector<Run> runs_;
  std::vector<std::uint32_t> piece_;     // of each run
  std::vector<std::size_t> row_begins_;  // of each row (j, k), and the end
  std::vector<std::int64_t> voxels_;
};

/// Lowers what is gone to the background, and its rim: voxels within two voxels of it that are
/// nearer to it than to what is kept. A voxel that shares a cell with what is kept stays, so the
/// kept surface at the isovalue does not move.
class PieceOperator final : public haptics::RowCutter {
 public:
  /// The rim of `gone` may reach into `box_of_rim`.
  PieceOperator(VoxelBits gone, VoxelBits kept, const haptics::VoxelBox& box_of_rim,
                double isovalue);
  void cutRow(std::int64_t j, std::int64_t k, haptics::RowCut& cut) const override;

 private:
  VoxelBits gone_, kept_;
};

}  // namespace datasets
