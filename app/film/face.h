// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/recording/recording.h"
#include "haptics/core/volume.h"

namespace app {

/// Whether a picture of the isosurface could show a person's face. If so, warn the user before the
/// picture leaves the program. True for HU if `isovalue` is below 200, where skin is drawn. True
/// for every isovalue in other units, since their scale is unknown. False if the volume is too
/// small for a face: two edges of at least 60 mm and a third of at least 20 mm are needed. The part
/// of the body is unknown. Do not call it for phantoms.
bool mayShowAFace(const haptics::Volume& volume, double isovalue);

/// The least isovalue of a recording, for mayShowAFace; infinity if it has none.
double leastIsovalue(const Recording& recording);

}  // namespace app
