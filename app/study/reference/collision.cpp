// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/collision.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "app/study/reference/motion.h"

namespace reference {
namespace {

/// Points of the shell on their way, (2): p(t) = c0 + v t + R(w t) r0.
class Sweep {
 public:
  Sweep(const haptics::PointShell& shell, const Pose& X_WP, const Twist& motion)
      : shell_{shell}, X_WP_{X_WP}, motion_{motion}, angle_{motion.angular.norm()} {
    if (angle_ > 0.0) axis_ = motion.angular / angle_;
  }

  Vec3 at(int point, double t) const {
    Vec3 r_W = X_WP_.linear() * shell_.points[point];
    if (angle_ > 0.0) r_W = Eigen::AngleAxisd{angle_ * t, axis_} * r_W;
    return X_WP_.translation() + motion_.linear * t + r_W;
  }
  /// m, at least the way the point travels in all
  double length(int point) const { return pathBound(motion_, shell_.points[point].norm()); }

 private:
  const haptics::PointShell& shell_;
  Pose X_WP_;
  Twist motion_;
  double angle_;
  Vec3 axis_ = Vec3::UnitX();
};

/// The next piece of a point's path to test: from `start` on.
struct Pending {
  double start = 0.0;
  int point = 0;
  std::int64_t piece = 0, pieces = 1;
  bool outside = false;  ///< at `start`; known for every piece but the first

  bool operator>(const Pending& other) const {
    return start != other.start ? start > other.start : point > other.point;
  }
};

}  // namespace

Contact contactOf(const Solid& solid, const haptics::PointShell& shell, const Pose& X_WP,
                  int point) {
  Contact contact;
  contact.point = point;
  contact.r_W = X_WP.linear() * shell.points[point];
  contact.position_W = X_WP.translation() + contact.r_W;
  contact.n_W = solid.normal(contact.position_W);
  contact.gap = solid.gap(contact.position_W);
  return contact;
}

std::vector<Contact> prune(const Solid& solid, const haptics::PointShell& shell,
                           const std::vector<Contact>& contacts, const Pose& X_WP,
                           const Twist& free) {
  const Choices& choices = solid.choices();
  const Sweep sweep{shell, X_WP, free};
  std::vector<Contact> kept;
  for (const Contact& contact : contacts) {
    // the time in which the point, or the whole tool at most, travels epsilon
    const double speed = choices.epsilon_motion == EpsilonMotion::EachPoint
                             ? (free.linear + free.angular.cross(contact.r_W)).norm()
                             : pathBound(free, shell.radius);
    const double t = speed > choices.epsilon ? choices.epsilon / speed : 1.0;
    if (solid.inside(sweep.at(contact.point, t))) kept.push_back(contact);
  }
  return kept;
}

FirstHit firstHit(const Solid& solid, const haptics::PointShell& shell, const Pose& X_WP,
                  const Twist& motion) {
  const Choices& choices = solid.choices();
  const bool accept_inside = choices.variant == Variant::AcceptInside;
  const Sweep sweep{shell, X_WP, motion};
  FirstHit hit;
  if (pathBound(motion, shell.radius) == 0.0) return hit;

  // every point's path, from its beginning
  std::vector<Pending> first;
  first.reserve(shell.points.size());
  for (int point = 0; point < static_cast<int>(shell.points.size()); ++point) {
    const double pieces = std::max(1.0, std::ceil(sweep.length(point) / choices.feature));
    first.push_back({.point = point, .pieces = static_cast<std::int64_t>(pieces)});
  }
  std::priority_queue<Pending, std::vector<Pending>, std::greater<>> queue{std::greater<>{},
                                                                           std::move(first)};

  // earliest piece first, until none can begin before the earliest hit
  while (!queue.empty() && queue.top().start < hit.t) {
    Pending next = queue.top();
    queue.pop();
    double t1 = next.start;
    double t2 = static_cast<double>(next.piece + 1) / static_cast<double>(next.pieces);
    const bool ends_outside = !solid.inside(sweep.at(next.point, t2));
    if (next.piece == 0 && !ends_outside) next.outside = !solid.inside(sweep.at(next.point, 0.0));

    if (ends_outside || !next.outside) {
      // nothing entered: the next piece of this point waits for its turn
      if (++next.piece == next.pieces) continue;
      next.start = t2;
      next.outside = ends_outside;
      queue.push(next);
      continue;
    }

    // bisection, until the way between the ends is shorter than epsilon
    while ((t2 - t1) * sweep.length(next.point) >= choices.epsilon) {
      const double middle = 0.5 * (t1 + t2);
      (solid.inside(sweep.at(next.point, middle)) ? t2 : t1) = middle;
    }
    const double t = accept_inside ? t2 : t1;
    if (!hit.met || t < hit.t) hit = {.met = true, .t = t, .point = next.point};
  }
  return hit;
}

std::vector<Contact> contactsAt(const Solid& solid, const haptics::PointShell& shell,
                                const Pose& X_WP, int met_point) {
  const double epsilon = solid.choices().epsilon;
  std::vector<Contact> contacts;
  for (int point = 0; point < static_cast<int>(shell.points.size()); ++point) {
    if (point != met_point && solid.farOutside(solid.value(X_WP * shell.points[point]), epsilon))
      continue;
    const Contact contact = contactOf(solid, shell, X_WP, point);
    if (contact.n_W.isZero()) continue;
    if (point == met_point || contact.gap <= epsilon) contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace reference
