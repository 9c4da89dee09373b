// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app::report {
namespace {

double seconds(std::int64_t ns) { return double(ns) * 1e-9; }

void takeLess(Moment& least, double value, double at) {
  if (value < least.value) least = {value, at};
}
void takeMore(Moment& most, double value, double at) {
  if (std::isnan(most.value) || value > most.value) most = {value, at};
}

bool isEncounter(const TickOf& tick) { return tick.touched || tick.nearest <= 0.0F; }

}  // namespace

bool Tally::Run::begins(std::int64_t time_ns, bool now_guarded) {
  const bool begins = !last_ns || time_ns - *last_ns >= kPause_ns || guarded != now_guarded;
  last_ns = time_ns;
  guarded = now_guarded;
  cut = cut && !begins;
  return begins;
}

Tally::Tally(std::vector<Structure> structures)
    : structures_{std::move(structures)},
      least_{haptics::Vec3::Constant(INFINITY)},
      most_{haptics::Vec3::Constant(-INFINITY)},
      push_seconds_(structures_.size()),
      encounter_(structures_.size()) {
  for (const Structure& structure : structures_) {
    FiguresOf& of = figures_.structures.emplace_back();
    of.nearest.value = of.nearest_of_tip.value = structure.told;
    of.within.resize(structure.margins.size());
  }
}

void Tally::add(const Tick& tick) {
  ++figures_.ticks;
  if (!first_) first_ = tick;
  // a tick lasts until the next one
  if (last_) {
    const std::int64_t ns = tick.time_ns - last_->time_ns;
    if (last_->known && ns <= kLongestTick_ns)
      weigh(*last_, seconds(ns));
    else
      figures_.unknown += seconds(ns);
  }
  if (tick.known) look(tick);
  follow(tick);
  last_ = tick;
}

/// Adds what lasts.
void Tally::weigh(const Tick& tick, double seconds) {
  if (tick.touches) {
    figures_.contact_time += seconds;
    force_seconds_ += tick.force * seconds;
  }
  if (tick.cuts) {
    figures_.cut_time += seconds;
    cut_force_seconds_ += tick.force * seconds;
  }
  for (std::size_t n = 0; n < structures_.size(); ++n) {
    const TickOf& now = tick.structures[n];
    FiguresOf& of = figures_.structures[n];
    for (std::size_t m = 0; m < of.within.size(); ++m)
      if (double(now.nearest) <= structures_[n].margins[m]) of.within[m] += seconds;
    if (now.touched) {
      of.touch_time += seconds;
      push_seconds_[n] += now.push * seconds;
    }
    if (isEncounter(now)) of.encounter_time += seconds;
  }
}

/// Takes the least and the largest, and counts.
void Tally::look(const Tick& tick) {
  const double at = seconds(tick.time_ns);
  takeMore(figures_.largest_force, tick.force, at);
  if (tick.touches && contact_.begins(tick.time_ns)) ++figures_.contacts;
  if (tick.cuts && stroke_.begins(tick.time_ns)) ++figures_.strokes;
  figures_.removed += tick.removed;
  for (std::size_t n = 0; n < structures_.size(); ++n) {
    const TickOf& now = tick.structures[n];
    FiguresOf& of = figures_.structures[n];
    // what is told as the greatest distance is that or more
    const auto told = float(structures_[n].told);
    if (now.nearest < told) takeLess(of.nearest, double(now.nearest), at);
    if (now.tip < told) takeLess(of.nearest_of_tip, double(now.tip), at);
    if (now.touched) takeMore(of.largest_push, now.push, at);
    if (!isEncounter(now)) continue;
    const bool kept = of.encounters.size() == std::size_t(of.encounter_count);
    if (encounter_[n].begins(tick.time_ns, now.guarded)) {
      ++of.encounter_count;
      of.injury_count += now.guarded;
      if (of.encounters.size() < FiguresOf::kMostEncounters)
        of.encounters.push_back({at, at, double(now.nearest), now.push, now.guarded, tick.cuts});
    } else if (kept) {
      Encounter& last = of.encounters.back();
      last.to = at;
      last.nearest = std::min(last.nearest, double(now.nearest));
      last.push = std::max(last.push, now.push);
      last.cut = last.cut || tick.cuts;
    }
    if (tick.cuts && !std::exchange(encounter_[n].cut, true)) of.burr_injury_count += now.guarded;
  }
}

/// Adds to the path, which ends where the tick before is not known, or had another scene.
void Tally::follow(const Tick& tick) {
  if (piece_ && (!tick.known || tick.scene != piece_->scene ||
                 tick.time_ns - last_->time_ns > kLongestTick_ns)) {
    endPiece(*last_);
    piece_.reset();
  }
  if (!tick.known) return;
  if (piece_ && tick.time_ns - piece_->time_ns < kPiece_ns) {
    piece_touches_ = piece_touches_ || tick.touches;
    return;
  }
  if (piece_) endPiece(tick);
  piece_ = tick;
  piece_touches_ = tick.touches;
  least_ = least_.cwiseMin(tick.tip_W);
  most_ = most_.cwiseMax(tick.tip_W);
}

void Tally::endPiece(const Tick& tick) {
  const double length = (tick.tip_W - piece_->tip_W).norm();
  const double lasted = seconds(tick.time_ns - piece_->time_ns);
  figures_.path += length;
  if (piece_->cuts) {
    cut_path_ += length;
    cut_path_time_ += lasted;
  }
  if (!piece_touches_ && length < kStill * lasted) figures_.idle += lasted;
  least_ = least_.cwiseMin(tick.tip_W);
  most_ = most_.cwiseMax(tick.tip_W);
}

Figures Tally::figures() const {
  Tally whole = *this;
  if (whole.piece_) whole.endPiece(*whole.last_);
  Figures& figures = whole.figures_;
  if (last_) figures.time = seconds(last_->time_ns - first_->time_ns);
  if (figures.path > 0.0)
    figures.economy = std::cbrt((whole.most_ - whole.least_).prod()) / figures.path;
  const double known = figures.time - figures.unknown;
  if (known > 0.0) figures.contact_share = figures.contact_time / known;
  if (figures.contact_time > 0.0) figures.mean_force = force_seconds_ / figures.contact_time;
  if (figures.cut_time > 0.0) figures.mean_cut_force = cut_force_seconds_ / figures.cut_time;
  if (whole.cut_path_time_ > 0.0) figures.mean_cut_speed = whole.cut_path_ / whole.cut_path_time_;
  for (std::size_t n = 0; n < structures_.size(); ++n)
    if (FiguresOf& of = figures.structures[n]; of.touch_time > 0.0)
      of.mean_push = push_seconds_[n] / of.touch_time;
  return figures;
}

}  // namespace app::report
