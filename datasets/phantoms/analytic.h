// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "datasets/phantoms/phantoms.h"

namespace datasets {

// Each samples one solid of shapes.h, with its default sizes, on a grid centred on W's origin.
haptics::Expected<Phantom> spherePhantom(const std::atomic<bool>* cancel);     ///< 64^3, 1 mm
haptics::Expected<Phantom> halfSpacePhantom(const std::atomic<bool>* cancel);  ///< 64^3, 1 mm
haptics::Expected<Phantom> torusPhantom(const std::atomic<bool>* cancel);   ///< 72 x 72 x 40, 1 mm
haptics::Expected<Phantom> gyroidPhantom(const std::atomic<bool>* cancel);  ///< 96^3, 1 mm
haptics::Expected<Phantom> cylinderPhantom(const std::atomic<bool>* cancel);  ///< 64^3, 1 mm
haptics::Expected<Phantom> wedgePhantom(
    const std::atomic<bool>* cancel);  ///< 65^3, 1 mm: its edge lies on voxel centres
haptics::Expected<Phantom> slotPhantom(
    const std::atomic<bool>* cancel);  ///< 65^3, 1 mm: its edges lie on voxel centres
haptics::Expected<Phantom> holePhantom(
    const std::atomic<bool>* cancel);  ///< 256^3 uint8, 0.3 mm: walls on voxel centres
haptics::Expected<Phantom> markerPhantom(const std::atomic<bool>* cancel);  ///< 65^3, 1 mm, CT

// Rebuilds of the paper's scenes; sizes, types, spacings and noise are those of its Table 1.
haptics::Expected<Phantom> bunnyPhantom(
    const std::atomic<bool>* cancel);  ///< 512 x 512 x 361, 0.34 x 0.34 x 0.5 mm
haptics::Expected<Phantom> enginePhantom(
    const std::atomic<bool>* cancel);  ///< 256 x 256 x 110 uint8, 0.6 mm
haptics::Expected<Phantom> bonePhantom(
    const std::atomic<bool>* cancel);  ///< 768 x 768 x 70, 0.15 x 0.15 x 0.5 mm

}  // namespace datasets
