// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "haptics/core/volume.h"

namespace cohort {

/// A slice through a place of a volume, drawn without a display.
struct SlicePicture {
  std::string plane;   ///< axial, coronal, sagittal
  std::string bitmap;  ///< a BMP file
};

/// The letters at the left, right, upper and lower edge of this plane's picture.
const std::array<const char*, 4>& lettersOf(const std::string& plane);

/// The three slices through a place [m, W], 256 pixels a side, each as large as the volume: grey
/// from air to bone where the unit is HU, else over the whole range; the isosurface in red, the
/// place as a cross. Axial: seen from the feet, the patient's right at the left.
std::array<SlicePicture, 3> slicesThrough(const haptics::Volume& volume, double isovalue,
                                          const haptics::Vec3& place_W);

}  // namespace cohort
