// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/scene.h"

#include <atomic>
#include <chrono>
#include <utility>

namespace haptics {
namespace {

bool isWithin(const VoxelBox& inner, const VoxelBox& outer) {
  for (std::size_t a = 0; a < 3; ++a)
    if (inner.first[a] < outer.first[a] || inner.end[a] > outer.end[a]) return false;
  return true;
}

/// The field over the scan that a volume was made from, if the previous scene knows it.
std::shared_ptr<const ScalarField> scanFieldOf(const Volume& scan, FieldKind kind,
                                               const Scene* previous) {
  if (previous == nullptr || previous->field.kind() != kind) return {};
  for (const auto& field : {previous->shared_field, previous->scan_field})
    if (field && &field->volume() == &scan) return field;
  return {};
}

/// The pyramid over a volume, renewed from the previous scene's where an edit changed it. `of_scan`
/// may be null.
MaxPyramid pyramidOf(const std::shared_ptr<const Volume>& volume, const SceneOptions& options,
                     const Scene* previous, const ScalarField* of_scan) {
  const Derivation* edit = previous != nullptr && previous->field.kind() == options.field
                               ? derivationBetween(volume, previous->volume)
                               : nullptr;
  // what a crop leaves out costs nothing to renew; what it gives back has to be looked at
  const bool narrower = edit != nullptr && isWithin(volume->bounds(), previous->volume->bounds());
  if (of_scan != nullptr && volume->voxels == of_scan->volume().voxels && !narrower)
    return {of_scan->pyramid(), *volume, {}, options.field, options.cancel};
  if (edit == nullptr) return MaxPyramid{*volume, options.field, options.cancel};
  return {previous->field.pyramid(), *volume, edit->changed, options.field, options.cancel};
}

std::uint64_t newSceneId() {
  static std::atomic<std::uint64_t> last_id{0};
  return ++last_id;
}

}  // namespace

Expected<std::shared_ptr<const Scene>> makeScene(std::shared_ptr<const Volume> volume, Tool tool,
                                                 const SceneOptions& options,
                                                 const Scene* previous) {
  if (!volume || !volume->voxels)
    return tl::unexpected(Error{Error::Kind::NotFound, {"scene-no-volume", {}}});
  if (tool.shell.points.empty())
    return tl::unexpected(Error{Error::Kind::Malformed, {"tool-no-points", {}}});
  using Clock = std::chrono::steady_clock;
  const auto secondsSince = [](Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
  };
  std::vector<Structure> structures;
  const Volume& scan = volume->derivation ? *volume->derivation->scan : *volume;
  std::shared_ptr<const ScalarField> scan_field = scanFieldOf(scan, options.field, previous);
  std::shared_ptr<const ScalarField> field;
  double build_time = 0.0;
  if (previous != nullptr && previous->volume == volume &&
      previous->field.kind() == options.field) {
    field = previous->shared_field;
  } else if (scan_field && &scan == volume.get()) {
    field = scan_field;
  } else {
    const Clock::time_point begun = Clock::now();
    field = std::make_shared<const ScalarField>(
        volume, options.field, pyramidOf(volume, options, previous, scan_field.get()));
    build_time = secondsSince(begun);
  }
  if (options.cancel != nullptr && *options.cancel)
    return tl::unexpected(Error{Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  if (&scan == volume.get()) scan_field = field;
  const Tolerances lengths{field->voxel(), options.fineness.epsilon};
  // a tool that is one point has no length of its own: the voxel's stands in
  if (tool.shell.radius == 0.0)
    tool.shell.inertia = field->voxel() * field->voxel() * Mat3::Identity();
  const MassMetric metric{tool.shell.inertia};
  structures.push_back({"pyramid", field->pyramid().bytes(), build_time});
  const Clock::time_point begun = Clock::now();
  ShellTree tree{tool.shell.points};
  structures.push_back({"shell_tree", tree.bytes(), secondsSince(begun)});
  Plan plan = options.plan;
  plan.free_space = plan.free_space && !plan.looksAgain();
  plan.central_differences = plan.central_differences && options.normal != NormalKind::Central;
  PlanLines planned = linesOf(plan, options, *volume, tree);
  return std::make_shared<const Scene>(
      Scene{options.id != 0 ? options.id : newSceneId(), std::move(volume), std::move(tool),
            std::move(tree), field, *field, metric, lengths, options.normal, std::move(structures),
            plan, std::move(planned), options.fineness, std::move(scan_field)});
}

}  // namespace haptics
