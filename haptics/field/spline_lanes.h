// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/field/lanes.h"

/// The cubic B-spline field at sixteen places at a time, as haptics::lanes has the trilinear one:
/// in the order of the scalar code in SplineCell, so every target gives its results to the bit. The
/// voxels of a place are read in rows of four. `edge` are the lanes whose 4^3 voxels, or those of
/// the differences, reach beyond the box.
namespace haptics::lanes::spline {

void survey(const Lattice& lattice, const Places& u, int n, double ceiling,
            Survey& found) HAPTICS_RT;
/// As lanes::clear. A segment in a cell is cleared by F at its ends and a bound on how far F bends
/// up between them, or by the greatest of its voxels.
void clear(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
           std::int64_t& cells) HAPTICS_RT;
void slopes(const Lattice& lattice, const Places& u, int n, bool central, Slopes& found) HAPTICS_RT;

}  // namespace haptics::lanes::spline
