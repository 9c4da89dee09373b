// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/clearance.h"

#include <algorithm>
#include <limits>

namespace haptics {

/// Points on their way to be looked at together.
struct Clearance::Batch {
  lanes::Affine map;  // tool frame to index coordinates
  double reach = 0.0;
  int count = 0;
  int place[lanes::kLanes], leaf[lanes::kLanes];
  double x[lanes::kLanes], y[lanes::kLanes], z[lanes::kLanes];
};

Clearance::Clearance(const ShellTree& tree)
    : until_(static_cast<std::size_t>(tree.size()), 0.0),
      node_until_(tree.nodes.size(), 0.0),
      node_epoch_(tree.nodes.size(), 0),
      near_(static_cast<std::size_t>(tree.size())),
      found_in_(static_cast<std::size_t>(tree.size()), 0),
      patch_size_{(tree.size() + kPatches - 1) / kPatches},
      opened_(tree.nodes.size(), 0) {
  nearest_.fill(-1);
}

void Clearance::restart() HAPTICS_RT {
  for (int i = 0; i < patches_used_; ++i)
    nearest_[static_cast<std::size_t>(used_[static_cast<std::size_t>(i)])] = -1;
  patches_used_ = 0;
  found_ = 0;
  arm_ = 0.0;
  complete_ = goal_ = -1.0;
  cursor_ = 0;
  opened_count_ = 0;
  // a number of its own for each search; after 2^32 of them a stale mark could look fresh
  if (++search_ == 0) {
    std::fill(found_in_.begin(), found_in_.end(), 0);
    search_ = 1;
  }
}

void Clearance::forget() HAPTICS_RT {
  ++epoch_;
  translated_ = rotated_ = 0.0;
  restart();
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

Clearance::Verdict Clearance::collect(const Isosurface& solid, const ShellTree& tree,
                                      const Pose& X_WP, double reach, Budget& budget) HAPTICS_RT {
  Batch batch;
  batch.map = solid.field.affine(X_WP);
  while (complete_ < reach) {
    // a pass that was cut is finished first
    if (goal_ < 0.0) {
      goal_ = reach;
      cursor_ = 0;
      opened_count_ = 0;
    }
    batch.reach = goal_;
    const int end = static_cast<int>(tree.nodes.size());
    int n = cursor_;
    while (n < end) {
      const auto at = static_cast<std::size_t>(n);
      const ShellTree::Node& node = tree.nodes[at];
      const double spent = travelled(node.arm);
      const bool known = node_epoch_[at] == epoch_;
      if (known && node_until_[at] - spent >= goal_) {
        n = node.next;
        continue;
      }
      if (!budget.left()) {
        // what waits in the batch belongs to leaves before this one
        if (!look(solid, tree, batch, budget)) {
          restart();
          return Verdict::Inside;
        }
        cursor_ = n;
        return Verdict::Cut;
      }
      if (!node.leaf) {
        budget.spend(2);
        const MaxPyramid::Bound bound =
            solid.field.pyramid().bound(solid.field.indexOf(X_WP * node.centre), solid.ceiling());
        const double free = bound.lipschitz == 0.0 ? bound.radius - node.radius : 0.0;
        if (free >= goal_) {
          node_until_[at] = free + spent;
          node_epoch_[at] = epoch_;
          n = node.next;
          continue;
        }
        opened_[opened_count_++] = n++;
        node_until_[at] = -std::numeric_limits<double>::infinity();
        node_epoch_[at] = epoch_;
        continue;
      }
      if (!known)
        std::fill_n(until_.begin() + node.first, node.count,
                    -std::numeric_limits<double>::infinity());
      node_until_[at] = std::numeric_limits<double>::infinity();
      node_epoch_[at] = epoch_;
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const double left = until_[place] - travelled(tree.arm[place]);
        if (left >= goal_ || found_in_[place] == search_) {
          node_until_[at] = std::min(node_until_[at], left + spent);
          continue;
        }
        batch.place[batch.count] = i;
        batch.leaf[batch.count] = n;
        batch.x[batch.count] = tree.x[place];
        batch.y[batch.count] = tree.y[place];
        batch.z[batch.count] = tree.z[place];
        if (++batch.count == lanes::kLanes && !look(solid, tree, batch, budget)) {
          node_until_[at] = -std::numeric_limits<double>::infinity();
          restart();
          return Verdict::Inside;
        }
      }
      ++n;
    }
    cursor_ = end;
    if (!look(solid, tree, batch, budget)) {
      restart();
      return Verdict::Inside;
    }
    if (!close(tree, budget)) return Verdict::Cut;
    complete_ = goal_;
    goal_ = -1.0;
  }
  return Verdict::Legal;
}

}  // namespace haptics
