// SPDX-License-Identifier: BSD-3-Clause

// palpate-stages: what each stage of a tick costs, by google-benchmark. Look at whole ticks in
// palpate-bench; this is to see where their time goes.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "app/study/comparison/scenes.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/collision/sweep.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/tick.h"
#include "haptics/simulation/hand.h"
#include "haptics/solver/constrained_motion.h"

namespace {

using haptics::Pose;
using haptics::Vec3;

constexpr std::int64_t kNoLimit = 1'000'000'000;

/// The bunny, its cane with `points` points, and the poses of a slide in contact, with the proxy's.
struct Touch {
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
  std::vector<Pose> device, proxy;
};

const Touch& touch(int points) {
  static const comparison::Touched bunny = comparison::makeScene("bunny");
  static std::vector<std::pair<int, Touch>> made;
  for (const auto& [count, known] : made)
    if (count == points) return known;
  Touch t;
  t.isovalue = bunny.isovalue;
  const auto aimed = haptics::makeScene(bunny.volume, comparison::toolOf(bunny, 1000), {},
                                        made.empty() ? nullptr : made.front().second.scene.get())
                         .value();
  const auto hand =
      haptics::Hand::aimed(haptics::HandMotion::Slide, *aimed, t.isovalue, 0.004, 1).value();
  t.scene =
      haptics::makeScene(bunny.volume, comparison::toolOf(bunny, points), {}, aimed.get()).value();
  haptics::Proxy proxy{*t.scene, hand.at(0.0)};
  for (int n = 0; n < 1500; ++n) {
    haptics::Budget budget = haptics::Budget::counted(kNoLimit);
    haptics::tick(*t.scene, t.isovalue, {}, hand.at(1e-3 * n), proxy, budget, 1e-3);
    if (n < 800) continue;
    t.device.push_back(hand.at(1e-3 * n));
    t.proxy.push_back(proxy.X_WP);
  }
  return made.emplace_back(points, std::move(t)).second;
}

/// Index coordinates of the tool's points at a pose.
std::vector<Vec3> placesOf(const Touch& t) {
  std::vector<Vec3> places;
  for (const Vec3& p : t.scene->tool.shell.points)
    places.push_back(t.scene->field.indexOf(t.proxy.front() * p));
  return places;
}

void Sample(benchmark::State& state) {
  const Touch& t = touch(403);
  const std::vector<Vec3> places = placesOf(t);
  for (auto _ : state)
    for (const Vec3& u : places) benchmark::DoNotOptimize(t.scene->field.value(u));
  state.SetItemsProcessed(state.iterations() * std::int64_t(places.size()));
}
BENCHMARK(Sample)->Unit(benchmark::kMicrosecond);

template <Vec3 (haptics::ScalarField::*gradient)(const Vec3&) const noexcept>
void Gradient(benchmark::State& state) {
  const Touch& t = touch(403);
  const std::vector<Vec3> places = placesOf(t);
  for (auto _ : state)
    for (const Vec3& u : places) benchmark::DoNotOptimize((t.scene->field.*gradient)(u));
  state.SetItemsProcessed(state.iterations() * std::int64_t(places.size()));
}
BENCHMARK(Gradient<&haptics::ScalarField::centralGradient>)
    ->Name("Gradient/central")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(Gradient<&haptics::ScalarField::splineGradient>)
    ->Name("Gradient/spline")
    ->Unit(benchmark::kMicrosecond);

void PyramidQuery(benchmark::State& state) {
  const Touch& t = touch(403);
  const std::vector<Vec3> places = placesOf(t);
  for (auto _ : state)
    for (const Vec3& u : places)
      benchmark::DoNotOptimize(t.scene->field.pyramid().bound(u, t.isovalue));
  state.SetItemsProcessed(state.iterations() * std::int64_t(places.size()));
}
BENCHMARK(PyramidQuery)->Unit(benchmark::kMicrosecond);

/// One leaf of the shell's tree after the other: sixteen points placed, sampled and bounded.
void Leaf(benchmark::State& state) {
  const Touch& t = touch(403);
  const haptics::Isosurface solid{t.scene->field, t.isovalue};
  const haptics::ShellTree& tree = t.scene->tree;
  const haptics::lanes::Affine map = t.scene->field.affine(t.proxy.front());
  for (auto _ : state)
    for (int first = 0; first + haptics::lanes::kLanes <= tree.size();
         first += haptics::lanes::kLanes) {
      haptics::lanes::Places u;
      haptics::lanes::place(map, &tree.x[std::size_t(first)], &tree.y[std::size_t(first)],
                            &tree.z[std::size_t(first)], haptics::lanes::kLanes, u);
      haptics::lanes::Survey found;
      solid.survey(u, haptics::lanes::kLanes, found);
      benchmark::DoNotOptimize(found);
    }
  state.SetItemsProcessed(state.iterations() *
                          (tree.size() / haptics::lanes::kLanes * haptics::lanes::kLanes));
}
BENCHMARK(Leaf)->Unit(benchmark::kMicrosecond);

/// All near points, with nothing known from an earlier tick.
void Collect(benchmark::State& state) {
  const Touch& t = touch(static_cast<int>(state.range(0)));
  const haptics::Isosurface solid{t.scene->field, t.isovalue};
  haptics::Clearance clearance{t.scene->tree};
  for (auto _ : state) {
    clearance.forget();
    haptics::Budget budget = haptics::Budget::counted(kNoLimit);
    benchmark::DoNotOptimize(
        clearance.collect(solid, t.scene->tree, t.proxy.front(), t.scene->lengths.band, budget));
  }
  state.counters["near"] = double(clearance.size());
}
BENCHMARK(Collect)->RangeMultiplier(10)->Range(1000, 100'000)->Unit(benchmark::kMicrosecond);

/// The same from tick to tick: what is proven is spent by motion, not looked at again.
void CollectAgain(benchmark::State& state) {
  const Touch& t = touch(static_cast<int>(state.range(0)));
  const haptics::Isosurface solid{t.scene->field, t.isovalue};
  haptics::Clearance clearance{t.scene->tree};
  std::size_t n = 0;
  for (auto _ : state) {
    const Pose& X = t.proxy[n % t.proxy.size()];
    n = (n + 1) % t.proxy.size();
    if (n == 1)
      clearance.forget();
    else
      clearance.moved(0.00005, 0.0005);
    haptics::Budget budget = haptics::Budget::counted(kNoLimit);
    benchmark::DoNotOptimize(
        clearance.collect(solid, t.scene->tree, X, t.scene->lengths.band, budget));
  }
}
BENCHMARK(CollectAgain)->RangeMultiplier(10)->Range(1000, 100'000)->Unit(benchmark::kMicrosecond);

/// Half a voxel along the surface and into it.
void FirstHit(benchmark::State& state) {
  const Touch& t = touch(static_cast<int>(state.range(0)));
  const haptics::Isosurface solid{t.scene->field, t.isovalue};
  const Pose& X = t.proxy.front();
  const Vec3 towards = (t.device.front().translation() - X.translation()).normalized();
  const haptics::Twist motion{0.5 * t.scene->field.voxel() * towards, Vec3{0.0, 0.0, 0.002}};
  const double length = motion.linear.norm() + motion.angular.norm() * t.scene->tool.shell.radius;
  haptics::Clearance near{t.scene->tree};
  haptics::Budget unlimited = haptics::Budget::counted(kNoLimit);
  near.collect(solid, t.scene->tree, X, length, unlimited);
  haptics::Sweep sweep{t.scene->tool.shell.points.size()};
  for (auto _ : state) {
    haptics::Budget budget = haptics::Budget::counted(kNoLimit);
    sweep.begin(t.scene->field, near, X, motion, t.scene->lengths);
    sweep.advance(solid, t.scene->tree, near, t.scene->lengths, budget);
    benchmark::DoNotOptimize(sweep.impact(solid, t.scene->tree, t.scene->lengths, budget));
  }
  state.counters["near"] = double(near.size());
}
BENCHMARK(FirstHit)->RangeMultiplier(10)->Range(1000, 100'000)->Unit(benchmark::kMicrosecond);

/// Budget: 4 us at 60 rows, of a tick's 200.
void Projection(benchmark::State& state) {
  std::mt19937 random{5};
  std::normal_distribution<double> normal;
  const auto triple = [&] { return Vec3{normal(random), normal(random), normal(random)}; };
  std::vector<haptics::MotionRow> rows;
  for (int n = 0; n < state.range(0); ++n) {
    Vec3 n_W = triple().normalized();
    // a cone of normals about one direction, so that a motion is left
    n_W = (n_W + 1.2 * Vec3::UnitZ()).normalized();
    rows.push_back({n_W, 0.02 * triple(), 1e-5 * std::abs(normal(random))});
  }
  const haptics::MassMetric metric{haptics::Mat3::Identity() * 1e-4};
  const haptics::Twist free{{0.0003, 0.0001, -0.001}, {0.01, 0.005, 0.0}};
  for (auto _ : state)
    benchmark::DoNotOptimize(
        haptics::constrainedMotion(free, rows, metric, haptics::Mat3::Identity()));
}
BENCHMARK(Projection)->Arg(1)->Arg(6)->Arg(12)->Arg(40)->Arg(60)->Unit(benchmark::kMicrosecond);

/// A tick of the slide, with the live budget.
void WholeTick(benchmark::State& state) {
  const Touch& t = touch(static_cast<int>(state.range(0)));
  auto proxy = std::make_unique<haptics::Proxy>(*t.scene, t.proxy.front());
  // there and back, so that the device never jumps
  std::size_t n = 0;
  bool ahead = true;
  for (auto _ : state) {
    haptics::Budget budget = haptics::Budget::timed(200'000);
    benchmark::DoNotOptimize(
        haptics::tick(*t.scene, t.isovalue, {}, t.device[n], *proxy, budget, 1e-3));
    if (n + 1 == t.device.size()) ahead = false;
    if (n == 0) ahead = true;
    n = ahead ? n + 1 : n - 1;
  }
}
BENCHMARK(WholeTick)
    ->Arg(403)
    ->RangeMultiplier(10)
    ->Range(1000, 100'000)
    ->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
