// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/touched_surface.h"

#include <algorithm>
#include <utility>

#include "haptics/core/budget.h"

namespace app {
namespace {

constexpr double kMeetTolerance = 1e-6;        // of the segment
constexpr std::int64_t kMeetWork = 2'000'000;  // some 20 ms

}  // namespace

double valueBehind(const haptics::ScalarField& field, haptics::Vec3 p_W) {
  const haptics::Vec3 rise_W = field.sample(field.indexOf(p_W)).gradient_W;
  if (rise_W.norm() > 0.0) p_W += 0.5 * field.voxel() * rise_W.normalized();
  haptics::Vec3 u = field.indexOf(p_W);
  const haptics::VoxelBox& box = field.bounds();
  for (std::size_t axis = 0; axis < 3; ++axis)
    u(Eigen::Index(axis)) =
        std::clamp(u(Eigen::Index(axis)), double(box.first[axis]), double(box.end[axis] - 1));
  return field.value(u);
}

ui::TouchedSurface touchedSurfaceOf(std::shared_ptr<const haptics::Scene> scene) {
  ui::TouchedSurface touched;
  touched.value = [scene](const haptics::Vec3& p_W) {
    return scene->field.value(scene->field.indexOf(p_W));
  };
  touched.behind = [scene](const haptics::Vec3& p_W) { return valueBehind(scene->field, p_W); };
  touched.firstMet = [scene](const haptics::Vec3& from_W, const haptics::Vec3& to_W,
                             double isovalue) -> std::optional<ui::SurfacePlace> {
    haptics::Budget budget = haptics::Budget::counted(kMeetWork);
    const haptics::ScalarField& field = scene->field;
    const double at = field.firstReach(field.indexOf(from_W), field.indexOf(to_W), isovalue,
                                       kMeetTolerance, budget);
    if (at > 1.0 || budget.cut()) return {};
    const haptics::Vec3 p_W = from_W + at * (to_W - from_W);
    const haptics::Vec3 rise = field.sample(field.indexOf(p_W)).gradient_W;
    const haptics::Vec3 back = (from_W - to_W).normalized();
    return ui::SurfacePlace{p_W, rise.norm() > 0.0 ? haptics::Vec3{-rise.normalized()} : back};
  };
  return touched;
}

}  // namespace app
