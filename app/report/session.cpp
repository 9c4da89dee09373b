// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/session.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/recording/felt_words.h"
#include "app/report/cut_structures.h"

namespace app::report {
namespace {

using haptics::Vec3;

/// m: more than what a recording rounds poses and distances by, and less than any other map gives.
constexpr float kSame = 1e-6F;

}  // namespace

Ticks::Ticks(const Recording& recording, const haptics::Watch& watch, const haptics::Volume& scan)
    : watch_{watch}, half_voxel_{0.5 * scan.grid.spacing.minCoeff()} {
  for (const RecordedScene& scene : recording.scenes())
    if (liesLike(scene.volume, scan))
      tools_.emplace(scene.id,
                     Tool{haptics::ShellTree{scene.tool.shell.points}, scene.tool.shell.tip});
}

haptics::Expected<void> Ticks::readGuards(const Recording& recording) {
  for (const RecordedEvent& event : recording.events()) {
    if (event.kind != kFeltEvent) continue;
    const auto felt = feltAsSaid(event.text, watch_);
    if (!felt) return tl::unexpected(felt.error());
    Guards guards{.from_ns = event.value ? std::numeric_limits<std::int64_t>::min() : event.time_ns,
                  .guarded = {}};
    for (const auto& watched : felt->structures)
      guards.guarded.push_back(watched.feel.kind == haptics::Feel::Kind::Guarded);
    guards_.push_back(std::move(guards));
  }
  return {};
}

std::vector<bool> Ticks::everGuarded() const {
  std::vector<bool> guarded(watch_.structures.size());
  for (const Guards& guards : guards_)
    for (std::size_t n = 0; n < guarded.size(); ++n) guarded[n] = guarded[n] || guards.guarded[n];
  return guarded;
}

Tick Ticks::of(const RecordedStep& recorded) {
  const haptics::Step& step = recorded.step;
  Tick tick{.time_ns = step.time_ns, .scene = step.scene, .force = step.sent_W.force.norm()};
  tick.structures = {};
  while (guard_ < guards_.size() && guards_[guard_].from_ns <= step.time_ns) ++guard_;
  for (std::size_t n = 0; n < watch_.structures.size(); ++n)
    tick.structures.push({.guarded = guard_ > 0 && guards_[guard_ - 1].guarded[n]});
  const auto tool = tools_.find(step.scene);
  tick.known = tool != tools_.end() && step.X_WP.matrix().allFinite() && std::isfinite(tick.force);
  if (!tick.known) return tick;
  tick.tip_W = step.X_WP * tool->second.tip;
  tick.touches = !step.contacts.empty();
  tick.cuts = (step.flags & haptics::StepFlags::kCut) != 0;
  tick.removed = step.removed;

  haptics::Nearnesses near;
  haptics::measure(watch_, tool->second.tree, tool->second.tip, step.X_WP, near);
  for (std::size_t n = 0; n < near.size(); ++n) {
    tick.structures[n].tip = near[n].tip;
    tick.structures[n].nearest = near[n].nearest;
    const auto* then =
        std::ranges::find(step.near, near[n].structure, &haptics::Nearness::structure);
    if (then == step.near.end()) continue;
    ++compared;
    differing += !(std::abs(then->tip - near[n].tip) <= kSame &&
                   std::abs(then->nearest - near[n].nearest) <= kSame);
  }
  for (const haptics::BearingContact& contact : step.contacts) {
    // what is touched lies half a voxel behind the surface
    const Vec3 p_W = step.X_WP.translation() + contact.r_W - half_voxel_ * contact.n_W;
    for (std::size_t n = 0; n < watch_.structures.size(); ++n)
      if (belongs(watch_.structures[n].distances, p_W)) {
        tick.structures[n].touched = true;
        if (std::isfinite(contact.push)) tick.structures[n].push += contact.push;
      }
  }
  return tick;
}

Curve::Curve(double begin, double end) : begin_{begin}, length_{std::max(end - begin, 1e-9)} {
  for (std::size_t n = 0; n < kParts; ++n)
    parts_[n].from = begin_ + length_ * double(n) / double(kParts);
}

void Curve::add(double time, double value) {
  const double at = std::clamp((time - begin_) / length_, 0.0, 1.0) * double(kParts);
  Part& part = parts_[std::min(std::size_t(at), kParts - 1)];
  if (!(value >= part.least.value)) part.least = {value, time};
  if (!(value <= part.most.value)) part.most = {value, time};
}

haptics::Expected<Session> sessionOf(Recording& recording, const haptics::Watch& watch,
                                     const std::shared_ptr<const haptics::Volume>& scan,
                                     const std::optional<VolumeHash>& hash,
                                     const std::vector<std::vector<double>>& margins,
                                     const std::function<bool(double)>& goes_on) {
  const std::size_t count = watch.structures.size();
  const Curve empty{recording.begin(), recording.end()};
  Session session{.guarded = {}, .force = empty, .nearest = std::vector<Curve>(count, empty)};
  for (const RecordedScene& scene : recording.scenes())
    if (liesLike(scene.volume, *scan) &&
        std::ranges::find(session.tools, scene.tool.name) == session.tools.end())
      session.tools.push_back(scene.tool.name);
  for (const haptics::ProxyStart& start : recording.starts()) session.rate = start.rate.hz;

  std::vector<Tally::Structure> structures;
  for (std::size_t n = 0; n < count; ++n)
    structures.push_back({margins[n], watch.structures[n].distances.told()});
  Tally tally{std::move(structures)};
  Ticks ticks{recording, watch, *scan};
  CutStructures cut{recording, watch, scan, hash};
  haptics::Expected<void> carved;
  if (auto read = ticks.readGuards(recording); !read) return tl::unexpected(read.error());
  session.guarded = ticks.everGuarded();
  const double span = std::max(recording.end() - recording.begin(), 1e-9);
  bool cancelled = false;
  std::int64_t until_told = 0;
  const auto read = recording.forEach(-INFINITY, INFINITY, [&](const RecordedStep& recorded) {
    const Tick tick = ticks.of(recorded);
    const double time = double(tick.time_ns) * 1e-9;
    if (--until_told < 0) {
      until_told = 1000;
      cancelled = !goes_on((time - recording.begin()) / span);
      if (cancelled) return false;
    }
    tally.add(tick);
    carved = cut.add(recorded.step);
    if (!carved) return false;
    if (!tick.known) return true;
    session.force.add(time, tick.force);
    for (std::size_t n = 0; n < count; ++n)
      session.nearest[n].add(time, double(tick.structures[n].nearest));
    return true;
  });
  if (!read) return tl::unexpected(read.error());
  if (cancelled)
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  if (!carved) return tl::unexpected(carved.error());
  session.figures = tally.figures();
  const std::vector<CutStructures::Taken> taken = cut.taken();
  for (std::size_t n = 0; n < count; ++n) {
    session.figures.structures[n].removed = taken[n].removed;
    session.figures.structures[n].exposed = taken[n].exposed;
  }
  session.compared = ticks.compared;
  session.differing = ticks.differing;
  return session;
}

}  // namespace app::report
