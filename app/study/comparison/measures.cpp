// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <set>

#include "app/study/reference/evaluator.h"
#include "app/study/reference/motion.h"
#include "app/study/reference/projection.h"

namespace comparison {

double massDistance(const Pose& X_WP, const Pose& X_WD, const haptics::PointShell& shell) {
  const reference::Twist left = reference::unconstrainedMotion(X_WP, X_WD);
  return std::sqrt(reference::massMetric(X_WP, shell.inertia).inner(left, left));
}

double wayBetween(const Pose& X_from, const Pose& X_to, const haptics::PointShell& shell) {
  return reference::pathBound(reference::unconstrainedMotion(X_from, X_to), shell.radius);
}

double mean(std::span<const double> values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return quantile(values, 0.5);
}

namespace {
constexpr std::int64_t kBlock = 8;  // cells
constexpr double kSamples = 25.0;   // of a path, in each voxel of its length
}  // namespace

FreeBlocks::FreeBlocks(const haptics::Volume& volume, double isovalue) : volume_{volume} {
  const auto& dims = volume.grid.dims;
  reach_ = double(kBlock) * volume.grid.spacing.minCoeff();
  for (int axis = 0; axis < 3; ++axis) blocks_[axis] = (dims[axis] + kBlock - 1) / kBlock;
  const auto at = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return static_cast<std::size_t>(i + blocks_[0] * (j + blocks_[1] * k));
  };
  std::vector<bool> holds(static_cast<std::size_t>(blocks_[0] * blocks_[1] * blocks_[2]), false);
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t k = 0; k < dims[2]; ++k)
      for (std::int64_t j = 0; j < dims[1]; ++j) {
        const auto* row = voxels + dims[0] * (j + dims[1] * k);
        for (std::int64_t b = 0; b < blocks_[0]; ++b) {
          const auto* last = row + std::min((b + 1) * kBlock, dims[0]);
          const auto greatest = *std::max_element(row + b * kBlock, last);
          if (double(greatest) >= isovalue) holds[at(b, j / kBlock, k / kBlock)] = true;
        }
      }
  });
  // a point within one block of an occupied one is not free; a cell's corners are covered by that
  occupied_.assign(holds.size(), false);
  for (std::int64_t k = 0; k < blocks_[2]; ++k)
    for (std::int64_t j = 0; j < blocks_[1]; ++j)
      for (std::int64_t i = 0; i < blocks_[0]; ++i) {
        if (!holds[at(i, j, k)]) continue;
        for (std::int64_t z = std::max<std::int64_t>(0, k - 2);
             z <= std::min(k + 2, blocks_[2] - 1); ++z)
          for (std::int64_t y = std::max<std::int64_t>(0, j - 2);
               y <= std::min(j + 2, blocks_[1] - 1); ++y)
            for (std::int64_t x = std::max<std::int64_t>(0, i - 2);
                 x <= std::min(i + 2, blocks_[0] - 1); ++x)
              occupied_[at(x, y, z)] = true;
      }
}

bool FreeBlocks::free(const Vec3& p_W, double reach) const {
  if (reach > reach_) return false;
  const Vec3 u = volume_.grid.indexOf(p_W);
  std::array<std::int64_t, 3> block;
  for (int axis = 0; axis < 3; ++axis) {
    // beyond the grid by a block and more there is nothing; nearer, the border's block decides
    const double size = double(volume_.grid.dims[axis]);
    if (u[axis] < -2.0 * kBlock || u[axis] > size + 2.0 * kBlock) return true;
    block[axis] = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(u[axis])) / kBlock,
                                           0, blocks_[axis] - 1);
  }
  return !occupied_[static_cast<std::size_t>(block[0] +
                                             blocks_[0] * (block[1] + blocks_[1] * block[2]))];
}

Judge::Judge(const Touched& scene, const haptics::PointShell& shell, const FreeBlocks& blocks)
    : scene_{scene},
      shell_{shell},
      blocks_{blocks},
      voxel_{scene.volume->grid.spacing.minCoeff()} {}

bool Judge::inside(const Vec3& p_W) const {
  return evaluator::fieldAt(*scene_.volume, p_W) >= scene_.isovalue;
}

double Judge::depth(const Pose& X_WP) const {
  double deepest_mm = 0.0;
  for (const Vec3& r_P : shell_.points) {
    const Vec3 p_W = X_WP * r_P;
    if (!blocks_.free(p_W, 0.0))
      deepest_mm =
          std::max(deepest_mm, evaluator::penetrationAt_mm(*scene_.volume, scene_.isovalue, p_W));
  }
  return 1e-3 * deepest_mm;
}

bool Judge::legal(const Pose& X_WP) const {
  return std::none_of(shell_.points.begin(), shell_.points.end(), [&](const Vec3& r_P) {
    const Vec3 p_W = X_WP * r_P;
    return !blocks_.free(p_W, 0.0) && inside(p_W);
  });
}

haptics::Twist Judge::wayOut(const Pose& X_WP, double margin) const {
  std::vector<reference::Row> rows;
  for (const Vec3& r_P : shell_.points) {
    const Vec3 r_W = X_WP.linear() * r_P, p_W = X_WP.translation() + r_W;
    if (blocks_.free(p_W, 0.0)) continue;
    const double excess = evaluator::fieldAt(*scene_.volume, p_W) - scene_.isovalue;
    if (excess < 0.0) continue;
    const Vec3 slopes = evaluator::slopesAt(*scene_.volume, p_W);
    const double slope = slopes.norm();
    if (slope > 0.0)
      rows.push_back(
          {-(scene_.volume->grid.direction * slopes) / slope, r_W, excess / slope + margin});
  }
  return reference::constrainedMotion({Vec3::Zero(), Vec3::Zero()}, rows,
                                      reference::massMetric(X_WP, shell_.inertia));
}

bool Judge::wayRound(const Vec3& from_W, const Vec3& to_W, double step) const {
  // the nearest to the goal first, over a lattice
  constexpr std::size_t kMost = 200'000;  // places: then it is taken for a wall
  using Place = std::array<int, 3>;
  const double longest = 2.0 * (to_W - from_W).norm() + 2.0 * voxel_;
  const auto at = [&](const Place& place) {
    return Vec3{from_W + step * Vec3{double(place[0]), double(place[1]), double(place[2])}};
  };
  // as closely as the path that met the wall: a coarse lattice must not step over a thin one
  const int samples = std::max(2, int(std::ceil(step / (voxel_ / kSamples))));
  const auto open = [&](const Vec3& a_W, const Vec3& b_W) {
    for (int n = 1; n <= samples; ++n)
      if (inside(a_W + double(n) / samples * (b_W - a_W))) return false;
    return true;
  };
  using Ranked = std::pair<double, Place>;
  std::priority_queue<Ranked, std::vector<Ranked>, std::greater<>> queue;
  std::set<Place> seen;
  queue.push({(to_W - from_W).norm(), {}});
  seen.insert({});
  while (!queue.empty() && seen.size() < kMost) {
    const auto [distance, place] = queue.top();
    queue.pop();
    const Vec3 here_W = at(place);
    if (distance <= step && open(here_W, to_W)) return true;
    for (int n = 0; n < 6; ++n) {
      Place next = place;
      next[n / 2] += n % 2 == 0 ? 1 : -1;
      const Vec3 there_W = at(next);
      const double left = (to_W - there_W).norm();
      if ((there_W - from_W).norm() + left > longest) continue;
      if (!seen.insert(next).second || !open(here_W, there_W)) continue;
      queue.push({left, next});
    }
  }
  return false;
}

int Judge::passages(const Pose& X_from, const Pose& X_to, bool may_go_round) const {
  const reference::Twist motion = reference::unconstrainedMotion(X_from, X_to);
  const double angle = motion.angular.norm();
  const Vec3 axis = angle > 0.0 ? Vec3{motion.angular / angle} : Vec3{Vec3::UnitX()};
  int count = 0;
  for (const Vec3& r_P : shell_.points) {
    const double length = reference::pathBound(motion, r_P.norm());
    if (length == 0.0) continue;
    const Vec3 r_W = X_from.linear() * r_P;
    const auto at = [&](double t) {
      return Vec3{X_from.translation() + t * motion.linear +
                  Eigen::AngleAxisd{t * angle, axis} * r_W};
    };
    const auto steps = static_cast<std::int64_t>(std::ceil(length / (voxel_ / kSamples)));
    // in pieces that one question to the blocks can answer
    const auto piece = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(0.9 * blocks_.reach() / (voxel_ / kSamples)));
    bool met = false;
    for (std::int64_t n = 0; n < steps && !met; n += piece) {
      const std::int64_t end = std::min(steps, n + piece);
      if (blocks_.free(at(double(n) / double(steps)), blocks_.reach())) continue;
      for (std::int64_t m = std::max<std::int64_t>(1, n); m < end && !met; ++m)
        met = inside(at(double(m) / double(steps)));
    }
    if (!met || inside(at(0.0)) || inside(at(1.0))) continue;
    if (!may_go_round) {
      ++count;
      continue;
    }
    // along a wall the way between the ends is known no better than this
    double deepest = 0.0;
    for (int n = 1; n < 200; ++n) {
      const Vec3 p_W = at(n / 200.0);
      const double excess = evaluator::fieldAt(*scene_.volume, p_W) - scene_.isovalue;
      if (excess >= 0.0)
        deepest = std::max(deepest, excess / evaluator::slopeAt(*scene_.volume, p_W));
    }
    if (deepest < 0.01 * voxel_) continue;
    // a coarse lattice finds most ways, finer ones those through slits
    const auto round = [&](double step) { return wayRound(at(0.0), at(1.0), step * voxel_); };
    if (!round(0.25) && !round(0.05) && !round(0.02)) ++count;
  }
  return count;
}

}  // namespace comparison
