// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/readers/dicom/folder.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Decodes the slices of a series that makes a stack, on all cores, into one buffer, and applies
/// each slice's own slope and intercept. Integer slopes and intercepts keep the narrowest fitting
/// integer type, any other gives float32. A crooked stack is resampled where `geometry` says to
/// correct it, and refused with its reason else; of such a stack no part can be taken. Padding
/// becomes the least of all other values.
haptics::Expected<haptics::Volume> readSeries(const DicomSeries& series, Geometry geometry,
                                              const Part& part, const ReadProgress& progress);

/// Of the slice in the middle, whatever the verdict.
haptics::Expected<Thumbnail> thumbnailOf(const DicomSeries& series, int longest);

}  // namespace datasets
