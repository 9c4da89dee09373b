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
#include "haptics/omissions.h"
#include "haptics/solver/mass_metric.h"
#include "haptics/tool/point_shell.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// Accuracy of a tick. Studies vary these values; all other code uses the defaults.
struct Fineness {
  /// Distance that counts as contact, in voxels, above 0 and below 1. The rest gap is half of it.
  double epsilon = 0.05;
  /// Most motions in a millisecond that contacts shape or stop, at least 1. A tick has its share of
  /// them, and no less than one. A search of three times as many begins anew at the proxy.
  int sub_steps = 8;
};

/// Options of a scene, apart from volume and tool.
struct SceneOptions {
  FieldKind field = FieldKind::Trilinear;
  NormalKind normal = NormalKind::Central;
  Plan plan = {};  ///< work that may be left out
  Fineness fineness = {};
  /// If another thread sets it to true, makeScene() ends with Error::Kind::Cancelled. May be null.
  const std::atomic<bool>* cancel = nullptr;
  /// Of a scene that has come about by cuts, which the volume has: it has that scene's id. 0: the
  /// scene is a new one.
  std::uint64_t id = 0;
};

/// A structure built for a scene: its memory and its build time.
struct Structure {
  std::string name;
  std::size_t bytes = 0;
  double build_time = 0.0;  ///< s of wall-clock time; 0 if it was taken over from an earlier scene
};

/// Volume, tool, and the structures built from them. Immutable, but for the scene of a tool that
/// cuts, which only its servo thread has (scene/carved_scene.h). A new scene is built while the old
/// one is in use, and then replaces it. The isovalue is not part of the scene.
struct Scene {
  /// From 1, unique in the process, but for the same scene with what was cut in it.
  std::uint64_t id = 0;
  std::shared_ptr<const Volume> volume;
  Tool tool;
  ShellTree tree;  ///< over the tool's shell
  /// Shared by scenes of the same volume and kind.
  std::shared_ptr<const ScalarField> shared_field;
  const ScalarField& field;  ///< the same field: reads `volume`, has the pyramid over it
  MassMetric metric;         ///< mass metric of the tool
  Tolerances lengths;        ///< lengths that follow from the voxel
  NormalKind normal = NormalKind::Central;
  std::vector<Structure> structures = {};
  Plan plan = {};          ///< work that its ticks leave out
  PlanLines planned = {};  ///< the plan in words
  Fineness fineness = {};
  /// The field of this kind over the volume before any edit, taken over from scene to scene so that
  /// edits that are taken back build nothing; null: not known.
  std::shared_ptr<const ScalarField> scan_field = {};
};

/// The plan in words, with the reasons that this volume, tool and choice give it.
PlanLines linesOf(const Plan& plan, const SceneOptions& options, const Volume& volume,
                  const ShellTree& tree);

/// Builds a scene. It takes tens to hundreds of milliseconds, so do not call it on the GUI or servo
/// thread. The field of `previous` is reused if volume and kind are the same, and its scan_field if
/// the volume is the scan. If the volumes are neighbours (Derivation::neighbour), its bounds are
/// renewed only where the edit changed the voxels; a volume that is only cropped takes those of the
/// scan.
Expected<std::shared_ptr<const Scene>> makeScene(std::shared_ptr<const Volume> volume, Tool tool,
                                                 const SceneOptions& options = {},
                                                 const Scene* previous = nullptr);

}  // namespace haptics
