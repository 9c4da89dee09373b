// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/collision/contact.h"
#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"
#include "haptics/field/isosurface.h"
#include "haptics/plan.h"
#include "haptics/solver/mass_metric.h"
#include "haptics/tool/point_shell.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// How finely a tick works. For studies, which show what other values come to; everybody else
/// takes these.
struct Fineness {
  /// Voxels, above 0 and below 1: how near counts as contact; what a contact keeps is half of it.
  double epsilon = 0.05;
  /// At least 1: motions in one tick that contacts shape or stop; three times as many where the
  /// proxy was held and stops short.
  int sub_steps = 8;
};

/// What the user may choose of a scene beside volume and tool.
struct SceneOptions {
  FieldKind field = FieldKind::Trilinear;
  NormalKind normal = NormalKind::Central;
  Plan plan = {};  ///< what may be left out
  Fineness fineness = {};
  /// True, from another thread, ends the making with Error::Kind::Cancelled; or none.
  const std::atomic<bool>* cancel = nullptr;
};

/// Something built for a scene: what it takes in memory, and took in time.
struct Structure {
  std::string name;
  std::size_t bytes = 0;
  double build_time = 0.0;  ///< s, by the clock on the wall; 0 where it was there already
};

/// What is touched, and with what: volume, tool, and what was built from them once. Immutable;
/// built beside the old one and handed over whole. The isovalue is not part of it.
struct Scene {
  std::uint64_t id = 0;  ///< unique in the process, from 1
  std::shared_ptr<const Volume> volume;
  Tool tool;
  ShellTree tree;                                   ///< over the tool's shell
  std::shared_ptr<const ScalarField> shared_field;  ///< scenes of one volume and kind share it
  const ScalarField& field;  ///< that field: reads `volume`, holds the pyramid over it
  MassMetric metric;         ///< of the tool
  Tolerances lengths;        ///< from the voxel
  NormalKind normal = NormalKind::Central;
  std::vector<Structure> structures = {};
  Plan plan = {};          ///< what its ticks leave out
  PlanLines planned = {};  ///< the same in words
  Fineness fineness = {};
};

/// The plan in words, with the reasons that this volume, tool and choice give it.
PlanLines linesOf(const Plan& plan, const SceneOptions& options, const Volume& volume,
                  const ShellTree& tree);

/// Builds a scene; takes tens to hundreds of milliseconds, so not on the GUI or servo thread. The
/// field of `previous` is taken over where volume and kind are the same.
Expected<std::shared_ptr<const Scene>> makeScene(std::shared_ptr<const Volume> volume, Tool tool,
                                                 const SceneOptions& options = {},
                                                 const Scene* previous = nullptr);

}  // namespace haptics
