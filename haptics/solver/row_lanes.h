// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/realtime.h"

/// The rows of step 3, all at once, with the machine's vector instructions (Highway, chosen at run
/// time). All arithmetic is in double, in one order of the sums and without contraction, so every
/// target gives the same bits.
namespace haptics::row_lanes {

inline constexpr int kMostRows = 96;
inline constexpr int kWidest = 8;  ///< doubles in the widest vector

/// Rows a·y >= b, by coordinate. Made by whiten().
struct alignas(64) Rows {
  double a[6][kMostRows];
  double b[kMostRows];
  double size[kMostRows];  ///< of a row before it was normalised
  int count = 0;           ///< of rows, filled up to a multiple of kWidest
};

/// Of a contact's row, how its moment about the tool's origin becomes three coordinates: in the
/// tool's frame by R_WP^T, then by L^-1 (MassMetric::row()).
struct RowMap {
  double turn[3][3], shape[3][3];
};

/// Whitens and normalises `rows`, of which a[0..2] are the normals, a[3..5] the vectors to the
/// points, and b the rooms. A row without direction becomes one that every y meets (a = 0, b =
/// -infinity). Returns the greatest |b| of the others.
double whiten(const RowMap& map, Rows& rows) HAPTICS_RT;

/// The row with the least a·y - b of those below -tolerance, the first of equals, or -1. `b`
/// stands for the rows' own, so that rows may be left out by -infinity; it is aligned as theirs.
int mostViolated(const Rows& rows, const double* b, const double* y, double tolerance) HAPTICS_RT;

}  // namespace haptics::row_lanes
