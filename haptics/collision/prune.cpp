// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/prune.h"

#include <algorithm>

#include "haptics/collision/motion.h"

namespace haptics {

bool standsInTheWay(const Isosurface& solid, const Vec3& c_W, const Vec3& r_W, const Twist& motion,
                    double epsilon) HAPTICS_RT {
  const PointPath path{c_W, r_W, motion};
  if (path.speed() <= 0.0) return false;
  return solid.inside(path.at(std::min(1.0, epsilon / path.speed())));
}

void prune(const Isosurface& solid, const PointShell& shell, const Pose& X_WP, const Twist& free,
           const Tolerances& lengths, Contacts& contacts, Budget& budget) HAPTICS_RT {
  for (std::size_t i = 0; i < contacts.size();) {
    Contact& contact = contacts[i];
    contact.r_W = X_WP.linear() * shell.points[static_cast<std::size_t>(contact.point)];
    const Vec3 moved = X_WP.translation() + contact.r_W - contact.met_W;
    budget.spend(solid.field.work());
    const bool near = moved.norm() <= lengths.rest_gap;
    budget.counts.samples += near;
    if (near && standsInTheWay(solid, X_WP.translation(), contact.r_W, free, lengths.epsilon)) {
      contact.gap = contact.met_gap + contact.n_W.dot(moved);
      ++i;
    } else {
      contacts.dropUnordered(i);
    }
  }
}

}  // namespace haptics
