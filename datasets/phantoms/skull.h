// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/phantoms/phantoms.h"

namespace datasets {

/// A head in a CT scanner, made of formulas: HU, 1 mm, noise of 16 HU. Bone at 300, skin at -300.
///
/// To touch: a cranial vault of two cortical tables with spongy bone between, sutures, a burr hole
/// on the patient's left, orbits with floors one to two voxels thin, nose, sinuses, cheek arches,
/// ear canals, mastoid air cells, a jaw, teeth (a lower left molar is missing). It resembles a
/// head; it is not anatomically exact.
haptics::Expected<Phantom> skullPhantom(const std::atomic<bool>* cancel);

}  // namespace datasets
