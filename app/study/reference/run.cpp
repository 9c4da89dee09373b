// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/run.h"

#include <cassert>
#include <cmath>

#include "app/study/reference/evaluator.h"
#include "app/study/reference/motion.h"

namespace reference {

std::vector<Record> run(const Scene& scene, std::span<const Pose> device_poses) {
  std::vector<Record> records;
  records.reserve(device_poses.size());
  State state;
  if (!device_poses.empty()) state.X_WP = device_poses.front();
  for (const Pose& X_WD : device_poses) {
    const std::int64_t before = scene.solid.samples();
    Record record;
    record.wrench = tick(scene, X_WD, state);
    record.samples = scene.solid.samples() - before;
    record.X_WP = state.X_WP;
    record.contacts = static_cast<int>(state.contacts.size());
    record.penetration =
        1e-3 * evaluator::penetration_mm(scene.solid.volume(), scene.solid.isovalue(),
                                         scene.shell.points, state.X_WP);
    records.push_back(record);
  }
  return records;
}

bool isFrozen(const Pose& X_before, const Pose& X_WP, const Pose& X_WD_before, const Pose& X_WD,
              const haptics::PointShell& shell) {
  const auto way = [&](const Pose& a, const Pose& b) {
    return pathBound(unconstrainedMotion(a, b), shell.radius);
  };
  const Twist left = unconstrainedMotion(X_WP, X_WD);
  const bool still = way(X_before, X_WP) < 1e-9;
  const bool behind = std::sqrt(massMetric(X_WP, shell.inertia).inner(left, left)) > 1e-4;
  const bool led = way(X_WD_before, X_WD) > 1e-9;
  return still && behind && led;
}

double frozenShare(std::span<const Record> records, std::span<const Pose> device_poses,
                   const haptics::PointShell& shell) {
  assert(records.size() == device_poses.size());
  int in_contact = 0, frozen = 0;
  for (std::size_t k = 0; k < records.size(); ++k) {
    in_contact += records[k].contacts > 0;
    if (k > 0 && records[k].contacts > 0)
      frozen += isFrozen(records[k - 1].X_WP, records[k].X_WP, device_poses[k - 1], device_poses[k],
                         shell);
  }
  return in_contact > 0 ? static_cast<double>(frozen) / in_contact : 0.0;
}

}  // namespace reference
