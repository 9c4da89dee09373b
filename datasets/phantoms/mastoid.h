// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/structures.h"

namespace datasets {

/// A left temporal bone in a CT scanner, made of formulas: HU, 0.4 mm, without noise. Bone at 300.
/// README.md has its structures and where their sizes are from.
haptics::Expected<Phantom> mastoidPhantom(const std::atomic<bool>* cancel);

namespace mastoid {

/// HU at a place in W: what the phantom's voxels are sampled from.
double valueAt(const haptics::Vec3& p_W);

std::vector<PhantomStructure> structures();

}  // namespace mastoid
}  // namespace datasets
