// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/touched_surface.h"

#include <utility>

#include "haptics/core/budget.h"

namespace app {
namespace {

constexpr double kMeetTolerance = 1e-6;        // of the segment
constexpr std::int64_t kMeetWork = 2'000'000;  // some 20 ms

}  // namespace

ui::TouchedSurface touchedSurfaceOf(std::shared_ptr<const haptics::Scene> scene) {
  ui::TouchedSurface touched;
  touched.value = [scene](const haptics::Vec3& p_W) {
    return scene->field.value(scene->field.indexOf(p_W));
  };
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
