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
           double epsilon, Contacts& contacts, Budget& budget) HAPTICS_RT {
  for (std::size_t i = 0; i < contacts.size();) {
    Contact& contact = contacts[i];
    contact.r_W = X_WP.linear() * shell.points[static_cast<std::size_t>(contact.point)];
    budget.spend(2);
    bool holds = standsInTheWay(solid, X_WP.translation(), contact.r_W, free, epsilon);
    if (holds) {
      const Vec3 u = solid.field.indexOf(X_WP.translation() + contact.r_W);
      const Cell cell = solid.field.cellAround(u);
      const Vec3 gradient = solid.field.worldGradient(cell.gradient(u));
      const double slope = gradient.norm();
      holds = slope > 0.0;
      if (holds) {
        contact.n_W = -gradient / slope;
        contact.gap = (solid.ceiling() - cell.value(u)) / slope;
      }
    }
    if (holds)
      ++i;
    else
      contacts.dropUnordered(i);
  }
}

}  // namespace haptics
