// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/volume.h"
#include "haptics/recording/recording.h"

namespace app {

/// Whether a picture of the isosurface could be a person's face, of which the user is to be warned
/// before it leaves the program. Of HU: below 200, where skin is drawn. Of any other unit: always,
/// because skin is bright here and dark there. Never of a volume in which no face has room: two
/// edges of 60 mm and a third of 20. Says nothing of where in a body the scan was taken, which no
/// volume tells; of a phantom nobody need ask.
bool mayShowAFace(const haptics::Volume& volume, double isovalue);

/// The least isovalue of a recording, for mayShowAFace; infinity where it has none.
double leastIsovalue(const haptics::Recording& recording);

}  // namespace app
