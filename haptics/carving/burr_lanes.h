// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/realtime.h"

/// What a burr leaves of a row of voxels, with the machine's vector instructions (Highway, chosen
/// at run time). In one order of the operations and without contraction, so every target gives the
/// same bits.
namespace haptics::lanes {

inline constexpr int kRowChunk = 64;  ///< voxels of a row at a time

/// A ball on its way past a row of voxels, along the grid's axes from where the way begins, and the
/// profile of the wall. `Real`: float, or double for voxels of more than its 24 bits.
template <class Real>
struct BallAtRow {
  Real x, y, z;     ///< m: the row's first voxel
  Real spacing[3];  ///< m
  bool cubes;       ///< all spacings are the same
  Real way[3];      ///< m
  Real per_way;     ///< 1/m2: one over the way squared, 0 if there is none
  Real radius;      ///< m
  Real bias;        ///< 1/m: voxels by which the ball is larger, for a voxel's side
  Real isovalue, slope, rise, straight, background, back;  ///< as of WallProfile
  bool whole;                                              ///< voxels are whole numbers
  Real per_value, at_wall, part_straight, part_rounded;    ///< as of PartOfVoxel
};

/// Some voxels of a row.
template <class Real>
struct RowOfVoxels {
  alignas(64) Real before[kRowChunk];  ///< their values
  alignas(64) Real after[kRowChunk];   ///< what is left of them
  alignas(64) Real part[kRowChunk];    ///< parts of a voxel that each lost
  int changed;                         ///< how many voxels changed
  std::uint64_t parts;                 ///< a bit for each voxel that lost a part
};

/// Lowers `count` voxels, at most kRowChunk. What lies behind them, up to a whole vector, must be
/// background.
void lower(const BallAtRow<float>& ball, int count, RowOfVoxels<float>& row) HAPTICS_RT;
void lower(const BallAtRow<double>& ball, int count, RowOfVoxels<double>& row) HAPTICS_RT;

}  // namespace haptics::lanes
