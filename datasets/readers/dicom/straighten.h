// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/scan.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Resamples the slices of a crooked stack onto its box: in each slice between its four nearest
/// pixels, and between the two nearest slices, linearly, in the stored type. What no slice covers
/// becomes the least value of them all. `slices` holds them in the stack's order, `box` has the
/// dims of its geometry. False if cancelled.
bool straighten(const Stack& stack, haptics::ScalarType type, const void* slices, void* box,
                const ReadProgress& progress);

}  // namespace datasets
