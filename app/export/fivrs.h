// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

#include "app/export/export.h"
#include "app/export/hdf5_tables.h"
#include "haptics/core/error.h"

namespace app::exporting {

// What a burr did, once more in the groups and under the names of the drilling recordings of FIVRS,
// the volumetric drilling of AMBF (README.md). Times are in s since the recording began.

/// The force on the hand: a row for each step that is exported.
struct DrillForce {
  explicit DrillForce(hid_t file);
  void add(const haptics::Step& step);

  Table<double> wrench, time;
};

/// The burrs, the volume of a voxel, and the voxels that cuts removed, if the volume of one of the
/// scenes is at hand: of all steps between `from` and `to`, whatever the rate. Counts the voxels.
/// False if the file could not be written. Refusals: "cancelled", and those of reading.
haptics::Expected<bool> writeDrilling(hid_t file, Recording& recording,
                                      const ExportOptions& options, Exported& exported);

}  // namespace app::exporting
