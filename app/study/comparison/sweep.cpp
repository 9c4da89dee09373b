// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "app/study/comparison/measures.h"
#include "haptics/proxy/tick.h"
#include "haptics/simulation/hand.h"

namespace comparison {
namespace {

/// A hand's path, and from which tick on it counts.
struct Way {
  std::vector<Pose> device;
  std::size_t from = 0;
};

Way cane(const Touched& bunny, int ticks) {
  // aimed with few points: the tool is the same, and aiming asks for every point many times
  const auto scene = haptics::makeScene(bunny.volume, toolOf(bunny, 1000)).value();
  const auto hand =
      haptics::Hand::aimed(haptics::HandMotion::Slide, *scene, bunny.isovalue, 0.008, 1).value();
  Way way{{}, 500};
  for (int n = 0; n < 500 + ticks; ++n) way.device.push_back(hand.at(1e-3 * n));
  return way;
}

Way plate(int ticks) {
  Way way{{}, 300};
  for (int n = 0; n < 300 + ticks; ++n) {
    Pose X = Pose::Identity();
    const double s = 1e-3 * std::max(0, n - 300);
    // down to 1 mm below the plane, then round and round at 50 mm/s
    X.translation() = Vec3{0.008 * std::sin(2.0 * std::numbers::pi * s),
                           0.008 * (1.0 - std::cos(2.0 * std::numbers::pi * s)),
                           0.005 - 0.006 * std::min(1.0, n / 250.0)};
    way.device.push_back(X);
  }
  return way;
}

struct Result {
  SweepRow row;
  double tangential_mm = 0.0;
};

Result led(const Touched& scene, const FreeBlocks& blocks,
           std::shared_ptr<const haptics::Scene> built, const Way& way, Limit limit) {
  const haptics::PointShell& shell = built->tool.shell;
  const Judge judge{scene, shell, blocks};
  const auto method = ours(std::move(built), scene.isovalue, limit);
  method->start(way.device.front());
  Result result;
  result.row.scene = scene.name;
  result.row.points = static_cast<int>(shell.points.size());
  std::vector<double> times, coupling, tangential;
  double cut = 0.0;
  for (std::size_t n = 0; n < way.device.size(); ++n) {
    const Tick tick = method->tick(way.device[n]);
    if (n < way.from) continue;
    times.push_back(1e-3 * double(tick.cpu_ns));
    cut += tick.cut;
    const double apart = 1e3 * massDistance(tick.X_WP, way.device[n], shell);
    if (apart > 1e-3) coupling.push_back(apart);
    tangential.push_back(1e3 *
                         (tick.X_WP.translation() - way.device[n].translation()).head<2>().norm());
    if (n % 100 == 0)
      result.row.penetration_mm = std::max(result.row.penetration_mm, 1e3 * judge.depth(tick.X_WP));
  }
  result.row.mean_us = mean(times);
  result.row.cut = cut / double(times.size());
  std::sort(times.begin(), times.end());
  result.row.p50_us = quantile(times, 0.5);
  result.row.p99_us = quantile(times, 0.99);
  result.row.max_us = quantile(times, 1.0);
  result.row.coupling_mm = mean(coupling);
  result.tangential_mm = mean(tangential);
  return result;
}

}  // namespace

std::vector<SweepRow> sweep(const Touched& scene, const SweepPlan& plan) {
  const bool flat = scene.tool == "plate";
  const FreeBlocks blocks{*scene.volume, scene.isovalue};
  const Way way = flat ? plate(plan.ticks) : cane(scene, plan.ticks);
  std::vector<SweepRow> rows;
  std::shared_ptr<const haptics::Scene> previous;
  for (const int count : plan.points) {
    const auto begun = std::chrono::steady_clock::now();
    const auto built =
        haptics::makeScene(scene.volume, flat ? plateTool(count, 0.020) : toolOf(scene, count), {},
                           previous.get())
            .value();
    const double build_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    previous = built;
    const double free_mm =
        flat ? 0.0 : led(scene, blocks, built, way, {0, 1'000'000'000}).row.coupling_mm;
    for (const int budget_us : plan.budgets_us) {
      Result result = led(scene, blocks, built, way,
                          {1000LL * budget_us, budget_us == 0 ? haptics::kTickWork : 0});
      result.row.budget_us = budget_us;
      result.row.build_ms = build_ms;
      result.row.lag_mm = flat ? result.tangential_mm : result.row.coupling_mm - free_mm;
      rows.push_back(result.row);
    }
  }
  return rows;
}

Touched plane() {
  Touched scene = phantomScene("halfspace");
  scene.name = "flat";
  scene.tool = "plate";
  return scene;
}

}  // namespace comparison
