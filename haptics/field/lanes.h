// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

/// The trilinear field at sixteen places at a time (the spline: spline_lanes.h), with the machine's
/// vector instructions (Highway, chosen at run time). All arithmetic is in double, in the order of
/// the scalar code in Cell, without contraction. So every target gives the results of the scalar
/// code, to the bit.
namespace haptics::lanes {

inline constexpr int kLanes = 16;

/// A number for each lane.
struct alignas(64) Numbers {
  double lane[kLanes];
  double& operator[](int i) HAPTICS_RT { return lane[i]; }
  double operator[](int i) const HAPTICS_RT { return lane[i]; }
};

/// One place, or one vector, for each lane.
struct Places {
  Numbers x, y, z;
};

/// Greatest value and Lipschitz constant [per metre] of a finest block of the pyramid.
struct BlockBound {
  float greatest, lipschitz;
  bool operator==(const BlockBound&) const = default;
};

/// A volume and its pyramid, for the lanes. Borrowed, not owned.
struct Lattice {
  const void* voxels = nullptr;
  ScalarType type = ScalarType::Int16;
  double dims[3] = {};                 ///< voxels of the grid along i, j, k: the strides
  double first[3] = {}, end[3] = {};   ///< the box of voxels that exist: Volume::bounds()
  const BlockBound* blocks = nullptr;  ///< finest level
  double block_counts[3] = {};
  double finest_radius = 0.0;  ///< m: radius for which a finest block's bound holds
};

/// An affine map u = A p + b, by rows.
struct Affine {
  double A[3][3] = {};
  double b[3] = {};
};
/// The places of `n` points, given by coordinate.
void place(const Affine& map, const double* px, const double* py, const double* pz, int n,
           Places& u) HAPTICS_RT;

/// The field and its bounds at each place.
struct Survey {
  Numbers value;           ///< F; undefined in an empty lane
  Numbers lipschitz;       ///< per metre, over `free`; undefined in an empty lane
  Numbers free;            ///< m: radius within which F < ceiling is proven
  std::uint32_t edge = 0;  ///< lanes whose cell reaches beyond the box; their numbers are undefined
  std::uint32_t empty = 0;  ///< lanes in a finest block that is proven below the ceiling
  /// The number of the n places at which F was looked up: those that are not in an empty block.
  int lookedUp(int n) const HAPTICS_RT { return n - std::popcount(empty & ((1U << n) - 1U)); }
};
void survey(const Lattice& lattice, const Places& u, int n, double ceiling,
            Survey& found) HAPTICS_RT;

/// Chords from `a` to `b` in index coordinates, examined from the fraction `from` on.
struct Chords {
  Places a, b;
  Numbers from;
  Numbers level;
};
/// The fraction up to which each chord is proven below its level: where the first cell begins
/// whose Bernstein hull reaches the level (or that reaches beyond the box), or 2. Adds the number
/// of examined cells to `cells`.
void clear(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
           std::int64_t& cells) HAPTICS_RT;

/// F, the exact gradient of its cell and, where asked for, central differences over one voxel, per
/// index step.
struct Slopes {
  Numbers value;
  Places exact, central;
  std::uint32_t edge = 0;  ///< lanes near the box's faces; their numbers are undefined
};
void slopes(const Lattice& lattice, const Places& u, int n, bool central, Slopes& found) HAPTICS_RT;

/// The vector instructions in use: "AVX3", "AVX2", "SSE4", …; "EMU128" if there are none.
const char* targetName();

}  // namespace haptics::lanes
