// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/collision/motion.h"

namespace haptics {
namespace {

constexpr std::int64_t kCarryWork = 3;   // of a look at a node's box; a unit more for each cell
constexpr double kLargest = 2.0;         // voxels: radius of a node that may be carried
constexpr std::int64_t kMostCells = 27;  // that it may reach
constexpr int kCrowd = 4096;     // points looked at or carried in a search, from which on nodes are
constexpr double kAlike = 0.25;  // of the band: how much nearer than its one point a node may be

/// The outermost point of the box's along `down` (tool frame), as `nearest`; whether none of the
/// box can be farther along it by more than `alike` [m].
bool standsFor(const ShellTree& tree, const ShellTree::Box& box, const Vec3& down, double alike,
               int& nearest) HAPTICS_RT {
  const double steep = down.norm();
  double most = -std::numeric_limits<double>::infinity(), depth = most;
  for (const int place : box.outermost) {
    const auto p = static_cast<std::size_t>(place);
    const double deep = down.dot(Vec3{tree.x[p], tree.y[p], tree.z[p]});
    // of points that are equally deep, the one farthest from the tool's origin
    const double measure = deep + 1e-6 * steep * tree.arm[p];
    if (measure <= most) continue;
    most = measure;
    depth = deep;
    nearest = place;
  }
  const double deepest = down.dot(box.centre) + (down.transpose() * box.half).cwiseAbs().sum();
  return deepest - depth <= alike * steep;
}

}  // namespace

/// The tool at a pose, and at the end of a motion if there is one, in index coordinates.
struct Clearance::Ride {
  Ride(const Isosurface& solid, const Pose& X, double near_by) HAPTICS_RT
      : X_WP{X},
        steps{1.0 / solid.field.voxel()},
        band{near_by},
        largest{kLargest * solid.field.voxel()} {
    at(solid, X, 0);
  }
  Ride(const Isosurface& solid, const Pose& X, const Twist& motion, double near_by) HAPTICS_RT
      : Ride{solid, X, near_by} {
    at(solid, haptics::moved(X, motion, 1.0), 1);
    ends = 2;
    angle = motion.angular.norm();
  }
  void at(const Isosurface& solid, const Pose& X, std::size_t end) HAPTICS_RT {
    const Vec3 origin = solid.field.indexOf(X.translation());
    for (int k = 0; k < 3; ++k) A[end].col(k) = solid.field.indexStepOf(X.linear().col(k));
    b[end] = origin;
  }

  const Pose& X_WP;
  std::array<Mat3, 2> A;  ///< tool frame to index coordinates
  std::array<Vec3, 2> b;
  std::size_t ends = 1;
  double angle = 0.0;  ///< rad, of the motion
  double steps;        ///< greatest index steps per metre
  double band;         ///< m: points nearer than this make rows
  double largest;      ///< m: radius of a node that may be carried
};

/// Points on their way to be looked at together.
struct Clearance::Batch {
  lanes::Affine map;  // tool frame to index coordinates
  double reach = 0.0;
  int count = 0;
  int place[lanes::kLanes], leaf[lanes::kLanes];
  double x[lanes::kLanes], y[lanes::kLanes], z[lanes::kLanes];
};

Clearance::Clearance(const ShellTree& tree, double band)
    : until_(static_cast<std::size_t>(tree.size()), 0.0),
      node_until_(tree.nodes.size(), 0.0),
      node_epoch_(tree.nodes.size(), 0),
      near_(static_cast<std::size_t>(tree.size())),
      found_in_(static_cast<std::size_t>(tree.size()), 0),
      patch_size_{(tree.size() + kPatches - 1) / kPatches},
      opened_(tree.nodes.size(), 0),
      covers_{band > 0.0 && !tree.boxes.empty()},
      carried_in_(tree.boxes.size(), 0),
      carried_(tree.boxes.size(), 0),
      band_{band} {
  nearest_.fill(-1);
}

void Clearance::restart() HAPTICS_RT {
  for (int i = 0; i < patches_used_; ++i)
    nearest_[static_cast<std::size_t>(used_[static_cast<std::size_t>(i)])] = -1;
  patches_used_ = 0;
  found_ = 0;
  arm_ = 0.0;
  complete_ = goal_ = -1.0;
  cursor_.set(0);
  opened_count_ = carried_count_ = aimed_ = 0;
  if (crowd_ > 0) crowded_ = crowd_ > kCrowd;
  crowd_ = 0;
  // a number of its own for each search; after 2^32 of them a stale mark could look fresh
  if (++search_ == 0) {
    std::fill(found_in_.begin(), found_in_.end(), 0);
    std::fill(carried_in_.begin(), carried_in_.end(), 0);
    search_ = 1;
  }
}

void Clearance::forget() HAPTICS_RT {
  covers_.forget();
  ++epoch_;
  translated_ = rotated_ = 0.0;
  restart();
  crowded_ = false;
}

void Clearance::moved(double translation, double rotation) HAPTICS_RT {
  // sums so long that a nanometre of them could be lost are begun anew
  constexpr double kLongest = 1e3;
  translated_ += translation;
  rotated_ += rotation;
  if (translated_ > kLongest || rotated_ > kLongest) forget();
  restart();
}

void Clearance::note(const NearPoint& point) HAPTICS_RT {
  const auto patch = static_cast<std::size_t>(point.place / patch_size_);
  const int at = static_cast<int>(found_);
  if (nearest_[patch] < 0) {
    used_[static_cast<std::size_t>(patches_used_++)] = static_cast<int>(patch);
    nearest_[patch] = at;
  } else if (point.free < near_[static_cast<std::size_t>(nearest_[patch])].free) {
    nearest_[patch] = at;
  }
  near_[found_++] = point;
}

/// Looks at the points of the batch and empties it; false if one is inside.
bool Clearance::look(const Isosurface& solid, const ShellTree& tree, Batch& batch,
                     Budget& budget) HAPTICS_RT {
  const int n = batch.count;
  batch.count = 0;
  if (n == 0) return true;
  crowd_ += n;
  budget.spend(n * solid.field.lanesWork().value);
  lanes::Places u;
  lanes::place(batch.map, batch.x, batch.y, batch.z, n, u);
  lanes::Survey found;
  solid.survey(u, n, found);
  budget.counts.samples += found.lookedUp(n);
  for (int l = 0; l < n; ++l) {
    const auto place = static_cast<std::size_t>(batch.place[l]);
    const double free = found.free[l], arm = tree.arm[place];
    if (found.value[l] >= solid.ceiling()) {
      // of the leaves on their way nothing is known
      for (int k = 0; k < n; ++k)
        node_until_[static_cast<std::size_t>(batch.leaf[k])] =
            -std::numeric_limits<double>::infinity();
      return false;
    }
    until_[place] = free + travelled(arm);
    const auto leaf = static_cast<std::size_t>(batch.leaf[l]);
    node_until_[leaf] = std::min(node_until_[leaf], free + travelled(tree.nodes[leaf].arm));
    if (free >= batch.reach) continue;
    note({batch.place[l], found.value[l], free, found.empty >> l & 1 ? 0.0 : found.lipschitz[l]});
    found_in_[place] = search_;
    arm_ = std::max(arm_, arm);
  }
  return true;
}

/// What the children of the opened nodes have become, from below; false if cut.
bool Clearance::close(const ShellTree& tree, Budget& budget) HAPTICS_RT {
  while (opened_count_ > 0) {
    if (opened_count_ % 64 == 0 && !budget.left()) return false;
    const auto n = static_cast<std::size_t>(opened_[--opened_count_]);
    const std::size_t left = n + 1;
    const auto right = static_cast<std::size_t>(tree.nodes[left].next);
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t child : {left, right})
      least = std::min(least, node_until_[child] - travelled(tree.nodes[child].arm));
    node_until_[n] = least + travelled(tree.nodes[n].arm);
  }
  return true;
}

bool Clearance::carries(const ShellTree& tree, std::size_t place) const HAPTICS_RT {
  if (!covers_.used()) return false;
  const auto at = static_cast<int>(place);
  for (int n = 0; n < static_cast<int>(tree.nodes.size());) {
    const ShellTree::Node& node = tree.nodes[static_cast<std::size_t>(n)];
    if (at >= node.first + node.count) {
      n = node.next;
      continue;
    }
    if (carried_in_[static_cast<std::size_t>(n)] == search_) return true;
    if (node.leaf) return false;
    ++n;
  }
  return false;
}

/// Whether the node is carried at the pose and along the motion. `nearest` gets the place of the
/// point that stands for it, or -1 if none of its points is within the band.
bool Clearance::carried(const Isosurface& solid, const ShellTree& tree, int n, const Ride& ride,
                        int& nearest, Budget& budget) HAPTICS_RT {
  const auto at = static_cast<std::size_t>(n);
  const ShellTree::Node& node = tree.nodes[at];
  const ShellTree::Box& box = tree.boxes[at];
  budget.spend(kCarryWork);
  // where the box is, at the pose and at the end of the motion
  std::array<Vec3, 2> u;
  std::array<Mat3, 2> half;
  // paths between the two stay this near to their chords
  const double bulge = sagitta(node.arm, ride.angle) * ride.steps;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t end = 0; end < ride.ends; ++end) {
    u[end] = ride.A[end] * box.centre + ride.b[end];
    half[end] = ride.A[end] * box.half;
    const Vec3 reach = half[end].cwiseAbs().rowwise().sum() + Vec3::Constant(bulge);
    low = low.cwiseMin(u[end] - reach);
    high = high.cwiseMax(u[end] + reach);
  }
  constexpr double kFarthest = 1e6;  // voxels
  if (!(low.minCoeff() > -kFarthest) || !(high.maxCoeff() < kFarthest)) return false;
  std::array<std::int64_t, 3> first, last;
  std::int64_t cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<std::int64_t>(std::floor(low[static_cast<int>(axis)]));
    last[axis] = static_cast<std::int64_t>(std::floor(high[static_cast<int>(axis)]));
    cells *= last[axis] - first[axis] + 1;
  }
  if (cells > kMostCells) return false;
  budget.spend(cells);

  // the plane of the box, and between which distances along its normal all of it lies
  Vec3 flat = half[0].col(0).cross(half[0].col(1));
  const double area = flat.norm();
  flat = area > 0.0 ? Vec3{flat / area} : Vec3::Zero();
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (std::size_t end = 0; end < ride.ends; ++end) {
    const double middle = flat.dot(u[end]);
    const double reach = (flat.transpose() * half[end]).cwiseAbs().sum() + bulge;
    from = std::min(from, middle - reach);
    to = std::max(to, middle + reach);
  }
  const double cell_reach = 0.5 * flat.cwiseAbs().sum() + 1e-9;

  // the least room above a cover, and that cover's normal
  double least = std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::Zero();
  std::array<std::int64_t, 3> cell;
  for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2])
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1])
      for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) {
        const Vec3 corner{double(cell[0]), double(cell[1]), double(cell[2])};
        const double middle = flat.dot(corner + Vec3::Constant(0.5));
        if (middle - cell_reach > to || middle + cell_reach < from) continue;
        const CellCover& cover = covers_.at(solid, cell, budget);
        if (cover.height == -std::numeric_limits<double>::infinity()) continue;
        // How low the box gets along the normal in this cell: its plane leaves only the rest of
        // the normal to the cell.
        const double along = cover.normal.dot(flat);
        const Vec3 rest = cover.normal - along * flat;
        const Vec3 corner_low = low.cwiseMax(corner);
        const Vec3 corner_high = high.cwiseMin(corner + Vec3::Ones());
        double room = along * (along > 0.0 ? from : to) +
                      rest.cwiseProduct(corner_low).cwiseMin(rest.cwiseProduct(corner_high)).sum() -
                      cover.height;
        if (!(room > 0.0)) {
          // anywhere
          double lowest = std::numeric_limits<double>::infinity();
          for (std::size_t end = 0; end < ride.ends; ++end)
            lowest = std::min(lowest, cover.normal.dot(u[end]) - bulge -
                                          (cover.normal.transpose() * half[end]).cwiseAbs().sum());
          room = lowest - cover.height;
          if (!(room > 0.0)) return false;
        }
        if (room >= least) continue;
        least = room;
        normal = cover.normal;
      }
  const double gap = least / ride.steps;
  nearest = -1;
  return gap > ride.band ||
         standsFor(tree, box, -(ride.A[0].transpose() * normal), kAlike * ride.band, nearest);
}

/// From the cursor to end_: finds the points with less than goal_ of clearance.
Clearance::Verdict Clearance::walk(const Isosurface& solid, const ShellTree& tree, const Ride& ride,
                                   Budget& budget) HAPTICS_RT {
  Batch batch;
  batch.map = solid.field.affine(ride.X_WP);
  batch.reach = goal_;
  const auto add = [&](int place, int leaf) HAPTICS_RT {
    const auto p = static_cast<std::size_t>(place);
    batch.place[batch.count] = place;
    batch.leaf[batch.count] = leaf;
    batch.x[batch.count] = tree.x[p];
    batch.y[batch.count] = tree.y[p];
    batch.z[batch.count] = tree.z[p];
    return ++batch.count < lanes::kLanes || look(solid, tree, batch, budget);
  };
  bool inside = false;
  const auto hasRoom = [&](std::size_t n) HAPTICS_RT {
    return node_epoch_[n] == epoch_ && node_until_[n] - travelled(tree.nodes[n].arm) >= goal_;
  };
  const auto pass = [&](std::size_t n) HAPTICS_RT {
    while (n < end_ && hasRoom(n)) n = static_cast<std::size_t>(tree.nodes[n].next);
    return n;
  };
  const auto visit = [&](std::size_t at) HAPTICS_RT -> std::size_t {
    const ShellTree::Node& node = tree.nodes[at];
    const auto n = static_cast<int>(at);
    const auto next = static_cast<std::size_t>(node.next);
    const double spent = travelled(node.arm);
    const bool known = node_epoch_[at] == epoch_;
    node_epoch_[at] = epoch_;
    if (!node.leaf) {
      budget.spend(2);
      const MaxPyramid::Bound bound = solid.field.pyramid().bound(
          solid.field.indexOf(ride.X_WP * node.centre), solid.ceiling());
      const double free = bound.lipschitz == 0.0 ? bound.radius - node.radius : 0.0;
      if (free >= goal_) {
        node_until_[at] = free + spent;
        return next;
      }
      static_assert(ShellTree::kLeastBox > ShellTree::kLeaf, "a leaf is never carried");
      if (covers_.used() && (crowded_ || crowd_ > kCrowd) && n != open_ &&
          node.count >= ShellTree::kLeastBox && node.radius < ride.largest) {
        int nearest = -1;
        const bool already = carried_in_[at] == search_;
        if (already || carried(solid, tree, n, ride, nearest, budget)) {
          if (!already) {
            carried_in_[at] = search_;
            carried_[carried_count_++] = n;
            crowd_ += node.count;
          }
          // free here; a step aside might not be
          node_until_[at] = spent;
          inside = nearest >= 0 && !holds(static_cast<std::size_t>(nearest)) && !add(nearest, n);
          return inside ? end_ : next;
        }
      }
      opened_[opened_count_++] = n;
      node_until_[at] = -std::numeric_limits<double>::infinity();
      return at + 1;
    }
    if (!known)
      std::fill_n(until_.begin() + node.first, node.count,
                  -std::numeric_limits<double>::infinity());
    node_until_[at] = std::numeric_limits<double>::infinity();
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const double left = until_[place] - travelled(tree.arm[place]);
      if (left >= goal_ || found_in_[place] == search_) {
        node_until_[at] = std::min(node_until_[at], left + spent);
        continue;
      }
      if (!add(i, n)) {
        node_until_[at] = -std::numeric_limits<double>::infinity();
        inside = true;
        return end_;
      }
    }
    return at + 1;
  };
  const bool whole = cursor_.through(end_, budget, pass, visit);
  // what waits in the batch belongs to leaves before the cursor
  if (inside || !look(solid, tree, batch, budget)) {
    restart();
    return Verdict::Inside;
  }
  return whole && close(tree, budget) ? Verdict::Legal : Verdict::Cut;
}

Clearance::Verdict Clearance::collect(const Isosurface& solid, const ShellTree& tree,
                                      const Pose& X_WP, double reach, Budget& budget) HAPTICS_RT {
  const Ride ride{solid, X_WP, band_};
  while (complete_ < reach) {
    // a pass that was cut is finished first
    if (goal_ < 0.0) {
      goal_ = reach;
      cursor_.set(0);
      open_ = -1;
      end_ = tree.nodes.size();
      opened_count_ = 0;
    }
    const Verdict verdict = walk(solid, tree, ride, budget);
    if (verdict != Verdict::Legal) return verdict;
    complete_ = goal_;
    goal_ = -1.0;
  }
  return Verdict::Legal;
}

Clearance::Verdict Clearance::carry(const Isosurface& solid, const ShellTree& tree,
                                    const Pose& X_WP, const Twist& motion,
                                    Budget& budget) HAPTICS_RT {
  const Ride ride{solid, X_WP, band_}, along{solid, X_WP, motion, band_};
  while (aimed_ < carried_count_) {
    if (goal_ < 0.0) {
      const int n = carried_[aimed_];
      const auto at = static_cast<std::size_t>(n);
      if (carried_in_[at] != search_) {
        ++aimed_;
        continue;
      }
      if (!budget.left()) return Verdict::Cut;
      int nearest = -1;
      if (carried(solid, tree, n, along, nearest, budget)) {
        ++aimed_;
        continue;
      }
      // its parts may be
      carried_in_[at] = 0;
      goal_ = complete_;
      open_ = n;
      cursor_.set(at);
      end_ = static_cast<std::size_t>(tree.nodes[at].next);
      opened_count_ = 0;
      node_until_[at] = -std::numeric_limits<double>::infinity();
    }
    const Verdict verdict = walk(solid, tree, ride, budget);
    if (verdict != Verdict::Legal) return verdict;
    goal_ = -1.0;
    ++aimed_;
  }
  return Verdict::Legal;
}

}  // namespace haptics
