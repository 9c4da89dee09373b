// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

/// The trilinear field at sixteen places at a time, by whatever vectors the machine has (Highway,
/// chosen at run time). All arithmetic is in double, in the order of the scalar code in Cell, and
/// is never contracted: every target gives the same answer as the scalar code, to the bit.
namespace haptics::lanes {

inline constexpr int kLanes = 16;

/// One number for each lane.
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
};

/// What the lanes must know of a volume and its pyramid. Borrowed, not owned.
struct Lattice {
  const void* voxels = nullptr;
  ScalarType type = ScalarType::Int16;
  double dims[3] = {};                 ///< voxels along i, j, k
  const BlockBound* blocks = nullptr;  ///< finest level
  double block_counts[3] = {};
  double finest_radius = 0.0;  ///< m: how far a finest block's statement reaches
};

/// Where points are: u = A p + b, by rows.
struct Affine {
  double A[3][3] = {};
  double b[3] = {};
};
/// The places of `n` points, given by coordinate.
void place(const Affine& map, const double* px, const double* py, const double* pz, int n,
           Places& u) HAPTICS_RT;

/// What is known about the surroundings of each place.
struct Survey {
  Numbers value;            ///< F; of no meaning in an empty lane
  Numbers lipschitz;        ///< per metre, over `free`; of no meaning in an empty lane
  Numbers free;             ///< m the place may be left in any direction with F < ceiling: proven
  std::uint32_t edge = 0;   ///< lanes whose cell reaches beyond the grid: nothing is said of them
  std::uint32_t empty = 0;  ///< lanes in a finest block that is proven below the ceiling
  /// At how many of n places F was looked up: nobody asks in an empty block.
  int lookedUp(int n) const HAPTICS_RT { return n - std::popcount(empty & ((1U << n) - 1U)); }
};
void survey(const Lattice& lattice, const Places& u, int n, double ceiling,
            Survey& found) HAPTICS_RT;

/// Chords from `a` to `b` in index coordinates, to be looked at from the fraction `from` on.
struct Chords {
  Places a, b;
  Numbers from;
  Numbers level;
};
/// How far each chord is certainly below its level: the fraction at which the first cell begins
/// whose Bernstein hull reaches it (or that touches the grid's edge), or 2. Adds the cells looked
/// at to `cells`.
void clear(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
           std::int64_t& cells) HAPTICS_RT;

/// F, the exact gradient of its cell and, where asked for, central differences over one voxel, per
/// index step.
struct Slopes {
  Numbers value;
  Places exact, central;
  std::uint32_t edge = 0;  ///< lanes near the grid's edge: nothing is said of them
};
void slopes(const Lattice& lattice, const Places& u, int n, bool central, Slopes& found) HAPTICS_RT;

/// The vectors in use: "AVX3", "AVX2", "SSE4", …, "EMU128" for none.
const char* targetName();

}  // namespace haptics::lanes
