// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/trial.h"

#include "app/study/reference/solid.h"

namespace study::stability {

bool isOutside(const haptics::Volume& volume, double isovalue,
               const std::vector<haptics::Vec3>& points, const haptics::Pose& X_WP) {
  const reference::Solid solid{volume, isovalue,
                               reference::choicesFor(volume.grid, reference::Variant::Literal)};
  return std::none_of(points.begin(), points.end(),
                      [&](const haptics::Vec3& p) { return solid.inside(X_WP * p); });
}

}  // namespace study::stability
