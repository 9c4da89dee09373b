// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/readers/dicom_folder.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Decodes the slices of a sound series, one after the other, into one buffer, and applies each
/// slice's own slope and intercept. Integer slopes and intercepts keep the narrowest fitting
/// integer type, any other gives float32.
haptics::Expected<haptics::Volume> readSeries(const DicomSeries& series,
                                              const ReadProgress& progress);

}  // namespace datasets
