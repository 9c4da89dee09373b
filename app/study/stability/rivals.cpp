// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/rivals.h"

#include <cmath>

#include "app/study/reference/evaluator.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "haptics/coupling/passivity.h"

namespace study::stability {
namespace {

using comparison::Method;
using haptics::HandMotion;

/// A force or torque, shortened to its rating where it is larger.
Vec3 within(const Vec3& wanted, double most) {
  const double size = wanted.norm();
  return size > most ? Vec3{wanted * (most / size)} : wanted;
}

/// m: rms of a path less its mean over 10 ms on either side.
double shakingOf(const std::vector<Vec3>& path, double period) {
  const auto reach = static_cast<std::size_t>(std::lround(0.01 / period));
  std::vector<Vec3> sums{Vec3::Zero()};
  for (const Vec3& p : path) sums.push_back(sums.back() + (p - path.front()));
  double squares = 0.0, count = 0.0;
  for (std::size_t n = reach; n + reach < path.size(); ++n) {
    const Vec3 mean = (sums[n + reach + 1] - sums[n - reach]) / double(2 * reach + 1);
    squares += (path[n] - path.front() - mean).squaredNorm();
    ++count;
  }
  return std::sqrt(squares / std::max(1.0, count));
}

}  // namespace

RivalRun runRival(Method& method, const haptics::DeviceModel& device, const haptics::Hand& hand,
                  const comparison::Touched& touched, const haptics::PointShell& shell,
                  haptics::ServoRate rate, double stiffness, std::int64_t ticks) {
  RivalRun run;
  haptics::Linkage link = device.linkage;
  haptics::Grip grip = device.heldBy({}, std::sqrt(shell.inertia.trace() / 3.0));
  grip.X_WD = link.handleAt(hand.at(0.0));
  method.start(link.read(grip.X_WD));
  EnergyBalance balance{stiffness, grip, rate.period()};
  haptics::PassivityObserver observer;
  haptics::Wrench held;
  std::vector<Vec3> path;
  for (std::int64_t n = 0; n < ticks; ++n) {
    const Pose X_before = grip.X_WD;
    if (n > 0) grip.advance(link.handleAt(hand.at(double(n) * rate.period())), held, rate.period());
    const haptics::Twist motion = haptics::motionBetween(X_before, grip.X_WD);
    observer.add(held, motion);
    balance.add(observer.energy(), held, motion, haptics::Vector6::Zero());
    const comparison::Tick tick = method.tick(link.read(grip.X_WD));
    const haptics::Wrench sent{within(tick.force, device.rating.force),
                               within(tick.torque, device.rating.torque)};
    if (n > 0) run.force_step = worse(run.force_step, (sent.force - held.force).norm());
    held = link.carry(sent, grip.X_WD);
    run.contact += tick.contacts > 0;
    if (tick.contacts > 0) path.push_back(grip.X_WD.translation());
    if (n % 10 == 0)
      run.penetration =
          worse(run.penetration, 1e-3 * evaluator::penetration_mm(*touched.volume, touched.isovalue,
                                                                  shell.points, tick.X_WP));
  }
  run.given = balance.most_given;
  run.beyond_damping = balance.most_left;
  run.shaking = shakingOf(path, rate.period());
  return run;
}

namespace {

/// One scene, all methods at each stiffness and rate along each hand.
Outcome rivalsOn(const std::string& name, bool full, std::uint64_t seed) {
  static constexpr std::pair<const char*, HandMotion> kMotions[] = {{"tap", HandMotion::Tap},
                                                                    {"wedge", HandMotion::Wedge},
                                                                    {"pry", HandMotion::Pry},
                                                                    {"hook", HandMotion::Hook}};
  Findings found;
  const comparison::Touched touched = comparison::phantomScene(name);
  const auto scene = haptics::makeScene(touched.volume, toolOf(touched)).value();
  const haptics::PointShell& shell = scene->tool.shell;
  const haptics::DeviceModel device = haptics::findDeviceModel("lambda.7").value();
  const double seconds = full ? 3.0 : 0.8;
  // sums of what cancels are zero but for rounding
  const auto mJ = [](double energy) { return std::abs(energy) < 1e-12 ? 0.0 : 1e3 * energy; };
  for (const double K : full ? std::vector{1000.0, 2000.0, 5000.0} : std::vector{1000.0, 5000.0})
    for (const haptics::ServoRate rate : haptics::kServoRates) {
      if (!full && rate.hz == 2000) continue;
      rivals::PenaltySettings settings;
      settings.sub_steps = std::max(1, settings.sub_steps * 1000 / rate.hz);
      std::vector<std::unique_ptr<Method>> methods;
      methods.push_back(comparison::penalty(touched, shell, settings, rate, K));
      methods.push_back(comparison::godObject(touched, shell, {}, K));
      methods.push_back(
          comparison::ours(scene, touched.isovalue, {0, rate.budget_work(), rate}, K));
      for (const auto& [kind, motion] : kMotions) {
        if (!full && motion != HandMotion::Tap && motion != HandMotion::Wedge) continue;
        const auto aimed = haptics::Hand::aimed(
            motion, *scene, touched.isovalue,
            haptics::Hand::reachFor(1e-3, K, haptics::HumanHand{}.stiffness), 1 + seed);
        if (!aimed) continue;
        const haptics::Hand hand =
            waiting(*aimed, placeOf(touched, 1 + seed), 0.0, 0.5 + seconds, rate.period());
        const std::int64_t ticks = std::lround((0.5 + seconds) / rate.period());
        for (const auto& method : methods) {
          const RivalRun run = runRival(*method, device, hand, touched, shell, rate, K, ticks);
          found.row("Rivals at the same stiffness, hand and rate",
                    {{"scene", name},
                     {"hand", kind},
                     {"K [N/m]", shortly(K)},
                     {"rate", rateOf(rate.period())},
                     {"method", method->name()},
                     {"handle shakes, rms [um]", shortly(1e6 * run.shaking)},
                     {"force step, largest [N]", shortly(run.force_step)},
                     {"energy given, most [mJ]", shortly(mJ(run.given))},
                     {"beyond what damping takes [mJ]", shortly(mJ(run.beyond_damping))},
                     {"deepest [mm]", shortly(1e3 * run.penetration)},
                     {"contact [ms]", shortly(1e3 * rate.period() * run.contact)}});
        }
      }
    }
  found.outcome.remarks.push_back(
      "Rivals and ours without ramp, guard and delay, each force in time, within the rating of a "
      "lambda.7 in a hand: what the method itself does. The penalty method integrates four times a "
      "millisecond at every rate. A handle shakes by the rms of its place less its mean over 20 "
      "ms, "
      "in ticks of contact, the arrivals of taps among them.");
  return std::move(found.outcome);
}

}  // namespace

std::vector<Job> rivalJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  std::vector<Job> jobs;
  for (const char* name : {"demo", "slot", "sphere"})
    if (full || name == std::string{"demo"})
      jobs.push_back({std::string{"rivals/"} + name, "Rivals", full ? 120.0 : 8.0,
                      [=](std::uint64_t seed) { return rivalsOn(name, full, seed); }});
  return jobs;
}

}  // namespace study::stability
