// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "haptics/collision/contact.h"
#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"
#include "haptics/field/isosurface.h"
#include "haptics/solver/mass_metric.h"
#include "haptics/tool/point_shell.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// What is touched, and with what: volume, tool, and what was built from them once. Immutable;
/// built beside the old one and handed over whole. The isovalue is not part of it.
struct Scene {
  std::uint64_t id = 0;  ///< unique in the process, from 1
  std::shared_ptr<const Volume> volume;
  Tool tool;
  ShellTree tree;      ///< over the tool's shell
  ScalarField field;   ///< reads `volume`; holds the pyramid over it
  MassMetric metric;   ///< of the tool
  Tolerances lengths;  ///< from the voxel
};

/// Builds a scene; takes tens to hundreds of milliseconds, so not on the GUI or servo thread.
Expected<std::shared_ptr<const Scene>> makeScene(std::shared_ptr<const Volume> volume, Tool tool);

/// The pose itself if every shell point is outside, else a legal pose near it, at most 50 mm
/// away; none if there is none to be found.
std::optional<Pose> legalPoseNear(const Scene& scene, double isovalue, const Pose& X_WT);

}  // namespace haptics
