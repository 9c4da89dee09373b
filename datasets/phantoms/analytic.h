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

}  // namespace datasets
