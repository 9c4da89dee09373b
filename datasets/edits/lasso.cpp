// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "datasets/edits/operators.h"
#include "haptics/carving/wall.h"

namespace datasets {
namespace {

constexpr std::int64_t kBlock = 8;   // voxels: the side of the blocks that know their edges
constexpr std::int64_t kRoot = 128;  // voxels: of the blocks with which the search begins

/// The wall over one edge of the outline, in index coordinates: a strip along the view, or the
/// sector between two rays from the eye.
struct WallPart {
  haptics::Vec3 at = haptics::Vec3::Zero();  // eye, or the edge's first corner
  haptics::Vec3 one =
      haptics::Vec3::Zero();  // the ray through the first corner; for a strip unused
  haptics::Vec3 two =
      haptics::Vec3::Zero();  // the ray through the second corner; of a strip the edge
  haptics::Vec3 dual_one = haptics::Vec3::Zero(), dual_two = haptics::Vec3::Zero();
  haptics::Vec3 normal = haptics::Vec3::Zero();  // unit
  std::array<double, 2> from{}, until{};         // the edge in the picture
};

double squaredToRay(const haptics::Vec3& q, const haptics::Vec3& ray) {
  return (q - std::max(0.0, q.dot(ray)) * ray).squaredNorm();
}

/// A lasso: what lies within the cone or prism over its outline, and between two depths.
class LassoOperator final : public haptics::RowCutter {
 public:
  LassoOperator(const haptics::Volume& volume, const LassoCut& cut);
  /// Finds for each block whether it is inside or outside, or which edges come near. False:
  /// cancelled.
  bool classify(const EditProgress& progress);
  void cutRow(std::int64_t j, std::int64_t k, haptics::RowCut& cut) const override;

 private:
  static constexpr std::uint32_t kInside = 0xffffffff, kOutside = 0xfffffffe;
  /// Edges that come near a block: a part of `edges`.
  struct NearEdges {
    std::uint32_t first, count;
    haptics::Vec3 middle;  // of the block
    bool inside;           // whether that is
    double inward;         // its distance to the wall, positive inside
  };
  struct Found {
    std::vector<std::pair<std::size_t, std::uint32_t>> blocks;  // block, kInside or one of `lists`
    std::vector<NearEdges> lists;
    std::vector<std::uint32_t> edges;
  };

  double squaredDistance(const WallPart& part, const haptics::Vec3& u) const;
  /// In the picture: x, y and the depth.
  haptics::Vec3 pictureOf(const haptics::Vec3& u) const;
  bool isInside(const haptics::Vec3& u) const;
  bool isInside(const haptics::Vec3& u, const NearEdges& near) const;
  void divide(const std::array<std::int64_t, 3>& first, std::int64_t side,
              std::span<const std::uint32_t> near, Found& found) const;
  std::size_t blockAt(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return static_cast<std::size_t>((k * blocks_[1] + j) * blocks_[0] + i);
  }
  /// Distance to the wall at a voxel near it, positive inside.
  double inward(const haptics::Vec3& u, std::uint32_t list) const;

  haptics::WallProfile wall_;
  bool parallel_, inside_;
  haptics::Grid grid_;
  haptics::Mat3 A_CV_;  // from index coordinates to the camera
  haptics::Vec3 b_C_;
  std::vector<std::array<double, 2>> outline_;
  std::vector<WallPart> parts_;
  // depth in voxels behind the beginning of the cut and before its end: linear in index coordinates
  haptics::Vec3 depth_V_ = haptics::Vec3::Zero();
  double depth_from_ = 0.0, depth_until_ = 0.0;
  std::array<std::int64_t, 3> blocks_{};
  std::vector<std::uint32_t> state_;  // of each block: kInside, kOutside or one of lists_
  std::vector<NearEdges> lists_;
  std::vector<std::uint32_t> edges_;
};

LassoOperator::LassoOperator(const haptics::Volume& volume, const LassoCut& cut)
    : wall_{volume.least, volume.greatest, cut.isovalue},
      parallel_{cut.parallel},
      inside_{cut.inside},
      grid_{volume.grid},
      A_CV_{cut.X_WC.linear().transpose() * grid_.direction * grid_.spacing.asDiagonal()},
      b_C_{cut.X_WC.linear().transpose() * (grid_.origin - cut.X_WC.translation())} {
  box = volume.bounds();
  // a corner that is drawn twice makes no edge
  for (const auto& corner : cut.outline)
    if (outline_.empty() || corner != outline_.back()) outline_.push_back(corner);
  while (outline_.size() > 1 && outline_.front() == outline_.back()) outline_.pop_back();

  const auto indexStep = [&](const haptics::Vec3& d_W) -> haptics::Vec3 {
    return (grid_.direction.transpose() * d_W).cwiseQuotient(grid_.spacing);
  };
  const haptics::Mat3 R_WC = cut.X_WC.linear();
  const haptics::Vec3 eye = grid_.indexOf(cut.X_WC.translation());
  const haptics::Vec3 view = indexStep(-R_WC.col(2)).normalized();
  for (std::size_t n = 0; n < outline_.size(); ++n) {
    const auto& a = outline_[n];
    const auto& b = outline_[(n + 1) % outline_.size()];
    WallPart part;
    part.from = a;
    part.until = b;
    if (parallel_) {
      part.at = eye + indexStep(R_WC * haptics::Vec3{a[0], a[1], 0.0});
      part.two = indexStep(R_WC * haptics::Vec3{b[0] - a[0], b[1] - a[1], 0.0});
      part.one = view;
    } else {
      part.at = eye;
      part.one = indexStep(R_WC * haptics::Vec3{a[0], a[1], -1.0}).normalized();
      part.two = indexStep(R_WC * haptics::Vec3{b[0], b[1], -1.0}).normalized();
    }
    const haptics::Vec3 normal = part.one.cross(part.two);
    if (!(normal.norm() > 0.0)) continue;  // its rays are one
    part.normal = normal.normalized();
    // p = at + s one + t two + ... : s = dual_one p, t = dual_two p
    part.dual_one = part.two.cross(normal) / normal.squaredNorm();
    part.dual_two = normal.cross(part.one) / normal.squaredNorm();
    parts_.push_back(part);
  }

  const haptics::Vec3 depth =
      -grid_.spacing.cwiseProduct(grid_.direction.transpose() * R_WC.col(2));
  depth_V_ = depth.normalized();
  const double at_eye = -depth_V_.dot(eye);
  // the apex of a cone has nothing behind it
  const double from = parallel_ ? cut.from : std::max(0.0, cut.from);
  depth_from_ = at_eye - from / depth.norm();
  depth_until_ = at_eye - cut.until / depth.norm();

  for (std::size_t a = 0; a < 3; ++a) blocks_[a] = (grid_.dims[a] + kBlock - 1) / kBlock;
  state_.assign(static_cast<std::size_t>(blocks_[0] * blocks_[1] * blocks_[2]), kOutside);
}

double LassoOperator::squaredDistance(const WallPart& part, const haptics::Vec3& u) const {
  const haptics::Vec3 q = u - part.at;
  const double s = part.dual_one.dot(q), t = part.dual_two.dot(q);
  const double off = part.normal.dot(q);
  if (parallel_) {
    if (t >= 0.0 && t <= 1.0) return off * off;
    const haptics::Vec3 to = q - (t < 0.0 ? haptics::Vec3{haptics::Vec3::Zero()} : part.two);
    return (to - to.dot(part.one) * part.one).squaredNorm();
  }
  if (s >= 0.0 && t >= 0.0) return off * off;
  return std::min(squaredToRay(q, part.one), squaredToRay(q, part.two));
}

haptics::Vec3 LassoOperator::pictureOf(const haptics::Vec3& u) const {
  const haptics::Vec3 p_C = A_CV_ * u + b_C_;
  const double depth = -p_C.z();
  if (parallel_ || !(depth > 0.0)) return {p_C.x(), p_C.y(), depth};
  return {p_C.x() / depth, p_C.y() / depth, depth};
}

bool LassoOperator::isInside(const haptics::Vec3& u) const {
  const haptics::Vec3 at = pictureOf(u);
  if (!parallel_ && !(at.z() > 0.0)) return false;
  const double x = at.x(), y = at.y();
  // even and odd: a loop within a loop is outside
  bool inside = false;
  for (std::size_t n = 0, before = outline_.size() - 1; n < outline_.size(); before = n++) {
    const auto& a = outline_[before];
    const auto& b = outline_[n];
    if ((a[1] > y) == (b[1] > y)) continue;
    if (x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])) inside = !inside;
  }
  return inside;
}

bool LassoOperator::isInside(const haptics::Vec3& u, const NearEdges& near) const {
  // from the middle of its block: each edge that is crossed in between comes near the block
  const haptics::Vec3 p = pictureOf(near.middle), q = pictureOf(u);
  if (!parallel_ && !(p.z() > 0.0 && q.z() > 0.0)) return isInside(u);
  const auto side = [](double ax, double ay, double bx, double by, double x, double y) {
    return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
  };
  const double squared = (q - p).head<2>().squaredNorm();
  bool inside = near.inside;
  for (std::uint32_t n = near.first; n < near.first + near.count; ++n) {
    const WallPart& part = parts_[edges_[n]];
    const double ax = part.from[0], ay = part.from[1], bx = part.until[0], by = part.until[1];
    const double of_from = side(p.x(), p.y(), q.x(), q.y(), ax, ay);
    const double of_until = side(p.x(), p.y(), q.x(), q.y(), bx, by);
    const double of_middle = side(ax, ay, bx, by, p.x(), p.y());
    const double of_here = side(ax, ay, bx, by, q.x(), q.y());
    // a middle on an edge, or a place in line with one: rounding would decide
    constexpr double kDoubt = 1e-9;
    const double least =
        std::min({std::abs(of_from), std::abs(of_until), std::abs(of_middle), std::abs(of_here)});
    if (least <= kDoubt * (squared + (bx - ax) * (bx - ax) + (by - ay) * (by - ay)))
      return isInside(u);
    if ((of_from > 0.0) != (of_until > 0.0) && (of_middle > 0.0) != (of_here > 0.0))
      inside = !inside;
  }
  return inside;
}

void LassoOperator::divide(const std::array<std::int64_t, 3>& first, std::int64_t side,
                           std::span<const std::uint32_t> near, Found& found) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (first[a] >= box.end[a] || first[a] + side <= box.first[a]) return;
  const double half = 0.5 * static_cast<double>(side - 1);
  const haptics::Vec3 middle{static_cast<double>(first[0]) + half,
                             static_cast<double>(first[1]) + half,
                             static_cast<double>(first[2]) + half};
  // blocks beyond the depth limits stay as they are
  const double ball = half * std::sqrt(3.0);
  const double away = ball + std::max(haptics::WallProfile::kReach, wall_.back());
  const double deep = depth_V_.dot(middle);
  if (deep + depth_from_ < -away || deep + depth_until_ > away) return;

  std::vector<std::uint32_t> here;
  double nearest = away * away;
  for (const std::uint32_t n : near) {
    const double squared = squaredDistance(parts_[n], middle);
    if (!(squared < away * away)) continue;
    here.push_back(n);
    nearest = std::min(nearest, squared);
  }
  if (here.empty() || side == kBlock) {
    if (here.empty() && !isInside(middle)) return;
    std::uint32_t state = kInside;
    if (!here.empty()) {
      state = static_cast<std::uint32_t>(found.lists.size());
      const bool inside = isInside(middle);
      const double distance = std::sqrt(nearest);
      found.lists.push_back({static_cast<std::uint32_t>(found.edges.size()),
                             static_cast<std::uint32_t>(here.size()), middle, inside,
                             inside ? distance : -distance});
      found.edges.insert(found.edges.end(), here.begin(), here.end());
    }
    const std::int64_t n = side / kBlock;
    for (std::int64_t k = first[2] / kBlock; k < std::min(first[2] / kBlock + n, blocks_[2]); ++k)
      for (std::int64_t j = first[1] / kBlock; j < std::min(first[1] / kBlock + n, blocks_[1]); ++j)
        for (std::int64_t i = first[0] / kBlock; i < std::min(first[0] / kBlock + n, blocks_[0]);
             ++i)
          found.blocks.push_back({blockAt(i, j, k), state});
    return;
  }
  for (int octant = 0; octant < 8; ++octant)
    divide({first[0] + (octant & 1) * side / 2, first[1] + (octant >> 1 & 1) * side / 2,
            first[2] + (octant >> 2) * side / 2},
           side / 2, here, found);
}

bool LassoOperator::classify(const EditProgress& progress) {
  std::array<std::int64_t, 3> roots{};
  for (std::size_t a = 0; a < 3; ++a) roots[a] = (grid_.dims[a] + kRoot - 1) / kRoot;
  std::vector<std::uint32_t> all(parts_.size());
  for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<std::uint32_t>(n);
  std::vector<Found> found(static_cast<std::size_t>(roots[0] * roots[1] * roots[2]));
  const bool done = progress.each(static_cast<std::int64_t>(found.size()), [&](std::int64_t n) {
    divide(
        {n % roots[0] * kRoot, n / roots[0] % roots[1] * kRoot, n / (roots[0] * roots[1]) * kRoot},
        kRoot, all, found[static_cast<std::size_t>(n)]);
  });
  if (!done) return false;
  for (const Found& part : found) {
    const auto list = static_cast<std::uint32_t>(lists_.size());
    const auto edge = static_cast<std::uint32_t>(edges_.size());
    for (const auto& [block, state] : part.blocks)
      state_[block] = state == kInside ? kInside : state + list;
    for (const NearEdges& near : part.lists) {
      lists_.push_back(near);
      lists_.back().first += edge;
    }
    edges_.insert(edges_.end(), part.edges.begin(), part.edges.end());
  }
  return true;
}

double LassoOperator::inward(const haptics::Vec3& u, std::uint32_t list) const {
  const NearEdges& near = lists_[list];
  // what is farther from the wall than this is as good as infinitely far
  const double far = std::max(haptics::WallProfile::kReach, wall_.back());
  const double margin = std::abs(near.inward) - far;
  if (margin > 0.0 && (u - near.middle).squaredNorm() < margin * margin)
    return near.inside ? far : -far;
  double least = far * far;
  for (std::uint32_t n = near.first; n < near.first + near.count; ++n) {
    const WallPart& part = parts_[edges_[n]];
    // the plane of a part is never farther than the part
    const double off = part.normal.dot(u - part.at);
    if (off * off < least) least = std::min(least, squaredDistance(part, u));
  }
  const double distance = std::sqrt(least);
  return isInside(u, near) ? distance : -distance;
}

void LassoOperator::cutRow(std::int64_t j, std::int64_t k, haptics::RowCut& cut) const {
  const auto y = static_cast<double>(j), z = static_cast<double>(k);
  const double row_depth = depth_V_.y() * y + depth_V_.z() * z;
  const auto depthWithin = [&](std::int64_t i) {
    const double depth = row_depth + depth_V_.x() * static_cast<double>(i);
    return std::min(depth + depth_from_, -(depth + depth_until_));
  };
  const auto add = [&](std::int64_t first, std::int64_t end, bool background) {
    const auto from = static_cast<std::int32_t>(first), until = static_cast<std::int32_t>(end);
    if (!cut.spans.empty() && cut.spans.back().end == from &&
        cut.spans.back().background == background)
      cut.spans.back().end = until;
    else
      cut.spans.push_back({from, until, background});
  };
  for (std::int64_t b = box.first[0] / kBlock; b * kBlock < box.end[0]; ++b) {
    const std::int64_t first = std::max(b * kBlock, box.first[0]);
    const std::int64_t end = std::min((b + 1) * kBlock, box.end[0]);
    const std::uint32_t state = state_[blockAt(b, j / kBlock, k / kBlock)];
    const bool uniform = state == kInside || state == kOutside;
    if (uniform && (state == kInside) != inside_) continue;
    // depth is a least of linear functions: over the block least at its ends
    const double within = std::min(depthWithin(first), depthWithin(end - 1));
    if (uniform && within >= wall_.back()) {
      add(first, end, true);
      continue;
    }
    for (std::int64_t i = first; i < end; ++i) {
      double taken = depthWithin(i);
      if (!uniform && taken > -haptics::WallProfile::kReach) {
        const double inward_here = inward({static_cast<double>(i), y, z}, state);
        taken = std::min(taken, inside_ ? inward_here : -inward_here);
      }
      if (taken <= -haptics::WallProfile::kReach) continue;
      const bool background = taken >= wall_.back();
      if (!background) cut.ceiling[static_cast<std::size_t>(i)] = wall_.ceiling(-taken);
      add(i, i + 1, background);
    }
  }
}

}  // namespace

MadeOperator lassoOperator(const haptics::Volume& volume, const LassoCut& cut,
                           const EditWatch& watch) {
  auto made = std::make_unique<LassoOperator>(volume, cut);
  if (!made->classify({watch, 0.0, 0.6})) return tl::unexpected(editCancelled());
  return made;
}

}  // namespace datasets
