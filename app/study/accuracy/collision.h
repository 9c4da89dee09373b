// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/arcs/arcs.h"
#include "app/study/report/outcome.h"

namespace study::accuracy {

/// A way to find where an arc first meets the surface.
struct Detector {
  std::string method, setting;
  arcs::Detect detect;
};
/// The search of a tick, and the paper's subdivision into pieces of f, half a voxel, and finer.
std::vector<Detector> detectors();

/// noise, slanted plate, upright plates, gyroid: volumes that are hard to shoot at.
const std::vector<std::string>& targetNames();

/// Random arcs of one point, the same for every detector, against a dense sampling in double:
/// which were missed or met late, and what an arc costs. The first detector is held to none.
Outcome collisions(const std::vector<Detector>& all, const std::string& target, long count,
                   unsigned seed);

}  // namespace study::accuracy
