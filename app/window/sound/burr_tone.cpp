// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sound/burr_tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "haptics/carving/burr.h"

namespace app {
namespace {

constexpr double kMostSpeed = 100'000.0;  // per minute
static_assert(haptics::kBurrTeeth * kMostSpeed / 60.0 < 0.5 * BurrTone::kRate);
constexpr double kHalfLoad = 2.0;  // N, at which a burr is half loaded
constexpr double kSlowing = 0.12;  // share of the speed that the greatest load takes
// of the full scale; together less than 1
constexpr double kIdle = 0.12, kWhine = 0.28, kRattle = 0.5;
constexpr double kRoughness = 0.5;  // share of the whine that comes and goes under load
constexpr double kUnrest = 8.0;     // of the slow noise, which is small
// of the partials, none higher than teeth pass
constexpr std::array<double, haptics::kBurrTeeth> kPartials{0.40, 0.20, 0.10, 0.07,
                                                            0.04, 0.03, 0.02, 0.14};

double loadOf(double force) {
  const double press = std::max(force, 0.0);
  return press / (press + kHalfLoad);
}

/// The share of the way to a new value that one sample goes.
double shareAt(double hertz) {
  return 1.0 - std::exp(-2.0 * std::numbers::pi * hertz / BurrTone::kRate);
}

/// The sum of the partials at this phase, by Clenshaw's recurrence.
double whineAt(double turns) {
  const double angle = 2.0 * std::numbers::pi * turns;
  const double twice = 2.0 * std::cos(angle);
  double last = 0.0, before = 0.0;
  for (std::size_t k = kPartials.size(); k-- > 0;) {
    const double now = kPartials[k] + twice * last - before;
    before = last;
    last = now;
  }
  return last * std::sin(angle);
}

}  // namespace

double BurrTone::pitchOf(const BurrRun& run) {
  return std::clamp(run.speed_rpm, 0.0, kMostSpeed) / 60.0 * (1.0 - kSlowing * loadOf(run.force));
}

double BurrTone::nextNoise() {
  random_ ^= random_ << 13;
  random_ ^= random_ >> 17;
  random_ ^= random_ << 5;
  return random_ / 2'147'483'648.0 - 1.0;
}

void BurrTone::fill(std::span<std::int16_t> samples, const BurrRun& run) {
  static const double kFollows = shareAt(10.0), kGrit = shareAt(4'000.0), kSlow = shareAt(60.0);
  if (run.turns && gain_ == 0.0) {
    frequency_ = pitchOf(run);
    load_ = loadOf(run.force);
  }
  const double pitch = run.turns ? pitchOf(run) : frequency_;
  const double load = run.turns ? loadOf(run.force) : load_;
  const double step = (run.turns ? 1.0 : -1.0) / kFade;
  for (std::int16_t& sample : samples) {
    gain_ = std::clamp(gain_ + step, 0.0, 1.0);
    frequency_ += kFollows * (pitch - frequency_);
    load_ += kFollows * (load - load_);
    phase_ += frequency_ / kRate;
    phase_ -= std::floor(phase_);
    const double noise = nextNoise();
    rattle_ += kGrit * (noise - rattle_);
    unrest_ += kSlow * (noise - unrest_);
    const double bite = std::clamp(0.5 + kUnrest * unrest_, 0.0, 1.0);
    const double whine =
        (kIdle + kWhine * load_) * (1.0 - kRoughness * load_ * (1.0 - bite)) * whineAt(phase_);
    const double rattle = kRattle * load_ * bite * rattle_;
    sample = static_cast<std::int16_t>(std::lround(32'767.0 * gain_ * (whine + rattle)));
  }
}

}  // namespace app
