// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/hand.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "haptics/scene/legal_pose.h"

namespace haptics {
namespace {

/// The isovalue as a person would write it.
Message plain(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return Message::numbers({text, end});
}

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kLeadIn = 0.5;  // s from outside the volume to the surface

/// A number in [0, 1) for each n of a seed: splitmix64.
double uniform(std::uint64_t seed, std::uint64_t n) HAPTICS_RT {
  std::uint64_t x = seed + (n + 1) * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  x ^= x >> 31;
  return double(x >> 11) * 0x1p-53;
}

double smooth(double x) HAPTICS_RT {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// The pose turned by an angle about an axis through its own origin.
Pose turned(const Pose& X, const Vec3& axis, double angle) HAPTICS_RT {
  Pose out = X;
  out.linear() = Eigen::AngleAxisd{angle, axis}.toRotationMatrix() * X.linear();
  return out;
}

/// The middle of the solid, seen on a coarse grid; none if nothing is inside.
std::optional<Vec3> middleOfSolid(const Scene& scene, double isovalue) {
  const Grid& grid = scene.volume->grid;
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  const VoxelBox& box = scene.field.bounds();
  std::array<std::int64_t, 3> stride;
  for (int axis = 0; axis < 3; ++axis)
    stride[axis] = std::max<std::int64_t>(1, (box.end[axis] - box.first[axis]) / 96);
  for (std::int64_t k = box.first[2]; k < box.end[2]; k += stride[2])
    for (std::int64_t j = box.first[1]; j < box.end[1]; j += stride[1])
      for (std::int64_t i = box.first[0]; i < box.end[0]; i += stride[0]) {
        const Vec3 u{double(i), double(j), double(k)};
        if (scene.field.value(u) < isovalue) continue;
        sum += u;
        ++count;
      }
  if (count == 0.0) return {};
  return grid.worldOf(sum / count);
}

/// How far along `way` the tool can be carried from X before a point of it is inside: by bounded
/// steps, so that nothing is jumped over; none if it meets nothing within `limit` [m].
std::optional<double> firstTouch(const Scene& scene, const Isosurface& solid, const Pose& X,
                                 const Vec3& way, double limit) {
  const ScalarField& field = scene.field;
  double travelled = 0.0;
  while (travelled < limit) {
    // the step that every point's bound allows, or a tenth of a voxel
    double step = limit;
    for (const Vec3& p : scene.tool.shell.points) {
      const Vec3 u = field.indexOf(X * p + travelled * way);
      const MaxPyramid::Bound bound = field.pyramid().bound(u, solid.ceiling());
      double free = bound.radius;
      if (bound.lipschitz > 0.0) {
        const double value = field.value(u);
        if (value >= solid.ceiling()) return travelled;
        free = std::min(bound.radius, (solid.ceiling() - value) / bound.lipschitz);
      }
      step = std::min(step, free);
      if (step < 0.1 * field.voxel()) step = 0.1 * field.voxel();
    }
    travelled += step;
  }
  return {};
}

/// How far the solid goes on from index coordinates u, within a cone about `way` [m], up to `most`.
double thickness(const Scene& scene, const Isosurface& solid, const Vec3& u, const Vec3& way,
                 double most) {
  const ScalarField& field = scene.field;
  const double h = field.voxel();
  const Vec3 side = way.unitOrthogonal(), other = way.cross(side);
  double least = most;
  for (const Vec3& lean : {Vec3{Vec3::Zero()}, side, Vec3{-side}, other, Vec3{-other}}) {
    const Vec3 step = field.indexStepOf((way + 0.6 * lean).normalized());
    // a grain of soft material at the touch itself does not count as the far side
    double d = 1.5 * h;
    while (d < least && field.value(u + step * d) >= solid.ceiling()) d += 0.5 * h;
    least = std::min(least, d);
  }
  return least;
}

/// A rotation whose -z axis points along `way`.
Mat3 tipAlong(const Vec3& way) {
  return Quat::FromTwoVectors(-Vec3::UnitZ(), way).toRotationMatrix();
}

struct Aim {
  Pose X_touch;
  Vec3 way;
  double approach = 0.0;
  double merit = -INFINITY;
};

}  // namespace

Pose Hand::at(double t) const HAPTICS_RT {
  if (times_.empty()) return scripted(t);
  const auto after = std::upper_bound(times_.begin(), times_.end(), t);
  if (after == times_.begin()) return poses_.front();
  if (after == times_.end()) return poses_.back();
  const auto i = static_cast<std::size_t>(after - times_.begin());
  const double share = (t - times_[i - 1]) / (times_[i] - times_[i - 1]);
  const Pose &a = poses_[i - 1], &b = poses_[i];
  return poseOf(a.translation() + share * (b.translation() - a.translation()),
                Quat{a.linear()}.slerp(share, Quat{b.linear()}));
}

Expected<Hand> Hand::along(std::vector<double> times, std::vector<Pose> poses) {
  if (times.empty() || times.size() != poses.size())
    return tl::unexpected(Error{Error::Kind::Malformed, {"hand-no-poses", {}}});
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || !poses[i].matrix().allFinite())
      return tl::unexpected(
          Error{Error::Kind::Malformed, {"hand-row-no-number", {std::to_string(i + 1)}}});
    if (i > 0 && times[i] <= times[i - 1])
      return tl::unexpected(
          Error{Error::Kind::Malformed, {"hand-time-not-increasing", {std::to_string(i + 1)}}});
  }
  Hand hand;
  hand.times_ = std::move(times);
  hand.poses_ = std::move(poses);
  return hand;
}

Expected<Hand> Hand::aimed(HandMotion motion, const Scene& scene, double isovalue, double reach,
                           std::uint64_t seed) {
  const Isosurface solid{scene.field, isovalue};
  const std::optional<Vec3> middle = middleOfSolid(scene, isovalue);
  if (!middle)
    return tl::unexpected(
        Error{Error::Kind::NotFound, {"hand-no-surface", {plain(isovalue)}}, "nothing-inside"});
  const Grid& grid = scene.volume->grid;
  const VoxelBox& box = scene.field.bounds();
  Vec3 first, last;  // voxels
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = double(box.first[axis]);
    last[axis] = double(box.end[axis] - 1);
  }
  const double diagonal = (last - first).cwiseProduct(grid.spacing).norm();

  // directions evenly over the sphere, turned by the seed
  constexpr int kDirections = 48;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double phase = kTurn * uniform(seed, 0);
  Aim best;
  for (int n = 0; n < kDirections; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
    const Vec3 way{r * std::cos(golden * n + phase), r * std::sin(golden * n + phase), z};
    // outside: so far back that the whole tool is beyond the voxels
    Pose X = Pose::Identity();
    X.linear() = tipAlong(way);
    const double back = diagonal + scene.tool.shell.radius + 4.0 * grid.spacing.maxCoeff();
    X.translation() = *middle - back * way;
    const std::optional<double> touch = firstTouch(scene, solid, X, way, 2.0 * back);
    if (!touch) continue;
    X.translation() += *touch * way;

    // what it touches: a surface that faces it, away from the cut faces
    double lowest = INFINITY;
    Vec3 u_touch = Vec3::Zero();
    for (const Vec3& p : scene.tool.shell.points) {
      const Vec3 u = scene.field.indexOf(X * p);
      const double below = solid.ceiling() - scene.field.value(u);
      if (below < lowest) {
        lowest = below;
        u_touch = u;
      }
    }
    const Vec3 gradient = scene.field.centralGradient(u_touch);
    const double facing = gradient.norm() > 0.0 ? gradient.dot(way) / gradient.norm() : -1.0;
    const double border =
        std::min((u_touch - first).minCoeff(), (last - u_touch).minCoeff());  // voxels inside
    // near, thick enough to press on, and rather from the front and above, as a person sits
    constexpr double kThick = 0.006;  // m
    static const Vec3 kFromTheFront{0.0, 0.8, -0.6};
    const double merit = std::min(facing, 0.95) - (border < 3.0 ? 1.0 : 0.0) +
                         thickness(scene, solid, u_touch, way, kThick) / kThick +
                         0.25 * way.dot(kFromTheFront) - 0.5 * *touch / back;
    if (merit > best.merit) best = {X, way, *touch, merit};
  }
  if (best.merit == -INFINITY)
    return tl::unexpected(
        Error{Error::Kind::NotFound, {"hand-no-surface", {plain(isovalue)}}, "nothing-inside"});
  Hand hand;
  hand.motion_ = motion;
  hand.X_WA_ = best.X_touch;
  hand.in_ = best.way;
  hand.side_ = best.way.unitOrthogonal();
  hand.other_ = best.way.cross(hand.side_);
  hand.reach_ = reach;
  // from just outside the volume, not from infinity
  const Vec3 u = grid.indexOf(best.X_touch.translation());
  const double within = (0.5 * (last - first) - (u - 0.5 * (first + last)).cwiseAbs())
                            .cwiseProduct(grid.spacing)
                            .minCoeff();
  hand.approach_ = std::min(
      best.approach, std::max(0.0, within) * std::sqrt(3.0) + scene.tool.shell.radius + 0.020);
  hand.seed_ = seed;
  return hand;
}

Expected<Hand> Hand::from(const Pose& X_WT, HandMotion motion, const Scene& scene, double isovalue,
                          double reach, std::uint64_t seed) {
  constexpr double kFarthest = 0.100;  // m
  const Isosurface solid{scene.field, isovalue};
  const Vec3 way = -X_WT.linear().col(2);
  const std::optional<double> touch = firstTouch(scene, solid, X_WT, way, kFarthest);
  if (!touch)
    return tl::unexpected(
        Error{Error::Kind::NotFound, {"hand-no-surface", {plain(isovalue)}}, "nothing-inside"});
  Hand hand;
  hand.motion_ = motion;
  hand.X_WA_ = X_WT;
  hand.X_WA_.translation() += *touch * way;
  hand.in_ = way;
  hand.side_ = way.unitOrthogonal();
  hand.other_ = way.cross(hand.side_);
  hand.reach_ = reach;
  hand.approach_ = *touch;
  hand.seed_ = seed;
  return hand;
}

Pose Hand::scripted(double t) const HAPTICS_RT {
  Pose X = X_WA_;
  if (t < kLeadIn) {
    X.translation() -= (1.0 - smooth(t / kLeadIn)) * approach_ * in_;
    return X;
  }
  const double s = t - kLeadIn;
  const double press = smooth(s / 0.2) * reach_;
  switch (motion_) {
    case HandMotion::Tap: {
      // two taps a second, from 10 mm above the surface
      const double depth = 0.5 * (1.0 - std::cos(kTurn * 2.0 * s));
      X.translation() += (depth * (reach_ + 0.010) - 0.010 * smooth(s / 0.1)) * in_;
      break;
    }
    case HandMotion::Slide:
      // a figure of eight, 24 mm by 12 mm, at some 40 mm/s
      X.translation() += press * in_ + 0.012 * std::sin(kTurn * 0.4 * s) * side_ +
                         0.006 * std::sin(kTurn * 0.8 * s) * other_;
      break;
    case HandMotion::Wedge:
      // deeper, working from side to side
      X.translation() += 1.5 * press * in_ + 0.004 * std::sin(kTurn * 1.5 * s) * side_ +
                         0.003 * std::sin(kTurn * 1.1 * s) * other_;
      X = turned(X, other_, 0.12 * std::sin(kTurn * 0.9 * s));
      break;
    case HandMotion::Pry:
      X.translation() += press * in_;
      X = turned(X, side_, 0.35 * std::sin(kTurn * 0.5 * s));
      break;
    case HandMotion::Hook: {
      // in, along the surface, and pulled back against whatever it caught
      const double along = 0.020 * std::sin(kTurn * 0.35 * s);
      X.translation() += press * (0.6 + 0.4 * std::cos(kTurn * 0.7 * s)) * in_ + along * side_;
      X = turned(X, in_, 0.4 * std::sin(kTurn * 0.35 * s));
      break;
    }
    case HandMotion::Jerk: {
      // a new target every 200 ms, reached in 20 ms: up to 50 mm and 1.5 rad, any way alike, from a
      // place a little beyond the surface
      const auto beat = static_cast<std::uint64_t>(s / 0.2);
      const double share = smooth((s - 0.2 * double(beat)) / 0.02);
      const auto target = [&](std::uint64_t n, Vec3& place, Vec3& turn) {
        if (n == 0) {
          place = turn = Vec3::Zero();
          return;
        }
        const std::uint64_t k = 16 * n;
        place =
            Vec3{uniform(seed_, k) - 0.5, uniform(seed_, k + 1) - 0.5, uniform(seed_, k + 2) - 0.5};
        turn = Vec3{uniform(seed_, k + 3) - 0.5, uniform(seed_, k + 4) - 0.5,
                    uniform(seed_, k + 5) - 0.5};
        place = 0.050 * place / std::max(0.5, place.norm());
        turn = 1.5 * turn / std::max(0.5, turn.norm());
      };
      Vec3 from, to, turn_from, turn_to;
      target(beat, from, turn_from);
      target(beat + 1, to, turn_to);
      const Vec3 place = from + share * (to - from),
                 turn = turn_from + share * (turn_to - turn_from);
      X.translation() += place.x() * side_ + place.y() * other_ + (place.z() + 0.7 * reach_) * in_;
      if (turn.norm() > 0.0) X = turned(X, turn.normalized(), turn.norm());
      break;
    }
    case HandMotion::Twist:
      X.translation() += press * in_;
      X = turned(X, in_, 0.8 * std::sin(kTurn * 0.5 * s));
      break;
    case HandMotion::Plunge:
      // straight in, 1 mm a second deeper
      X.translation() += (press + 0.001 * s) * in_;
      break;
    case HandMotion::Mill:
      // to and fro along a groove of 12 mm, that grows deeper by a millimetre in three strokes
      X.translation() += (press + 0.0005 * s) * in_ + 0.006 * std::sin(kTurn * 0.75 * s) * side_;
      break;
    case HandMotion::Hollow: {
      // in circles of up to 5 mm that grow and shrink, deeper all the while
      const double radius = 0.005 * std::sin(kTurn * 0.11 * s), turn = kTurn * 0.8 * s;
      X.translation() +=
          (press + 0.0005 * s) * in_ + radius * (std::cos(turn) * side_ + std::sin(turn) * other_);
      break;
    }
  }
  return X;
}

}  // namespace haptics
