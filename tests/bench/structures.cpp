// SPDX-License-Identifier: BSD-3-Clause

// palpate-structures [SCENE [SECONDS [REAL_SECONDS]]]: ticks with no structure and with twelve, in
// one process and in turn along the same hands: watched as the scan has them, and with walls of six
// solid ones and six that are not there. Then a hand slides in real time, and late ticks are
// counted with none and with twelve in turn, so many seconds each. Prints JSON. bunny has 512 x 512
// x 361 voxels.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "app/study/comparison/course.h"
#include "datasets/edits/walls.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampled_distances.h"
#include "haptics/scene/watch.h"
#include "haptics/session.h"
#include "haptics/simulation/closed_loop.h"
#include "tests/bench/ticks.h"

namespace {

using haptics::Vec3;
using Json = nlohmann::ordered_json;
constexpr double kStiffness = 1000.0, kReach = 0.030;  // N/m, m
constexpr int kRounds = 5;

double seconds(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  const auto at = std::min(values.size() - 1, static_cast<std::size_t>(q * double(values.size())));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at];
}

/// Twelve balls and rods around a place.
std::shared_ptr<haptics::Watch> structuresAbout(const Vec3& place, const haptics::Grid& scan) {
  datasets::Random random{71};
  auto watch = std::make_shared<haptics::Watch>();
  for (std::uint8_t n = 0; n < haptics::kMostWatched; ++n) {
    const Vec3 middle = place + random.in(2e-3, 15e-3) * random.direction();
    const Vec3 axis = random.direction();
    const double radius = random.in(1e-3, 4e-3), half = n % 2 == 0 ? 0.0 : 10e-3;
    haptics::Grid grid = scan;  // the scan's voxels about it
    const Vec3 at = scan.indexOf(middle).array().round();
    for (int a = 0; a < 3; ++a) {
      const double beyond = std::ceil((kReach + radius + half) / scan.spacing[a]) + 1.0;
      grid.dims[std::size_t(a)] = 2 * std::int64_t(beyond) + 1;
      grid.origin -= scan.direction.col(a) * scan.spacing[a] * beyond;
    }
    grid.origin += scan.worldOf(at) - scan.origin;
    watch->structures.push_back({n, datasets::distanceMap(grid, [&](const Vec3& p) {
                                   const double along =
                                       std::clamp(axis.dot(p - middle), -half, half);
                                   return (p - middle - along * axis).norm() - radius;
                                 })});
  }
  return watch;
}

struct Case {
  std::string name;
  std::shared_ptr<const haptics::Scene> scene;
  std::shared_ptr<const haptics::Watch> watch;
  std::vector<double> ticks = {};  ///< us, of all rounds, hands and ticks
};

/// What a servo loop at 1 kHz counts with none watched and with twelve, a second each in turn.
Json inRealTime(const haptics::ClosedLoop& loop, const haptics::Hand& hand,
                const std::shared_ptr<const haptics::Watch>& watch, double length) {
  haptics::Session session;
  session.chooseRate(loop.rate);
  session.set(loop.settings);
  session.adopt(loop.scene, hand.at(0.0));
  if (!session.open(haptics::HandKind::Slide)) return {{"failed", "the hand found no surface"}};
  haptics::Snapshot snapshot;
  const auto sleep = [&](double time) {
    std::this_thread::sleep_for(std::chrono::duration<double>(time));
    session.latest(snapshot);
    session.collectGarbage();
  };
  while (snapshot.contacts == 0) sleep(0.1);
  std::array<bench::Ticks, 2> counted;
  std::array<std::uint64_t, 2> near{};
  for (int second = 0; second < int(2.0 * length); ++second) {
    const bool twelve = second % 2 == 1;
    session.watch(twelve ? watch : nullptr);
    sleep(0.05);
    const bench::Ticks before = bench::ticksOf(snapshot);
    sleep(0.95);
    counted[twelve] += bench::ticksOf(snapshot) - before;
    near[twelve] += std::uint64_t(snapshot.near.size());
  }
  Json json{
      {"policy", snapshot.policy == haptics::SchedulingPolicy::RealTime ? "real time" : "other"}};
  json["none"] = bench::jsonOf(counted[0]);
  json["twelve"] = bench::jsonOf(counted[1]);
  json["watched"] = near;
  return json;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "bunny";
  const double length = argc > 2 ? std::atof(argv[2]) : 2.0;
  const double real = argc > 3 ? std::atof(argv[3]) : 10.0;
  if (!std::ranges::count(comparison::sceneNames(), name) || !(length > 0.0) || !(real > 0.0)) {
    std::fprintf(stderr,
                 "Usage: palpate-structures [bunny|engine|hole|bone [SECONDS [REAL_SECONDS]]]\n");
    return 2;
  }
  const comparison::Touched touched = comparison::makeScene(name);
  const auto scene = haptics::makeScene(touched.volume, comparison::toolOf(touched)).value();
  haptics::ClosedLoop loop;
  loop.scene = scene;
  loop.settings.isovalue = touched.isovalue;
  loop.settings.stiffness = kStiffness;
  std::vector<haptics::Hand> hands;
  for (const auto motion :
       {haptics::HandMotion::Tap, haptics::HandMotion::Slide, haptics::HandMotion::Wedge})
    if (auto hand =
            haptics::Hand::aimed(motion, *scene, touched.isovalue,
                                 haptics::Hand::reachFor(2e-3, kStiffness, loop.grip.stiffness), 1))
      hands.push_back(std::move(*hand));
  if (hands.empty()) return 1;
  const auto watch =
      structuresAbout(hands.back().at(0.5 * length).translation(), touched.volume->grid);
  Json json{{"scene", name},
            {"dims", touched.volume->grid.dims},
            {"points", scene->tool.shell.points.size()}};
  std::size_t map_bytes = 0;
  for (const auto& one : watch->structures) map_bytes += one.distances.bytes();

  std::vector<datasets::StructureWall> walls;
  for (const auto& one : watch->structures)
    walls.push_back({one.structure, one.structure % 2 == 0, one.distances});
  auto begun = std::chrono::steady_clock::now();
  const auto volume = datasets::walled(touched.volume, walls, touched.isovalue).value();
  const double wall_time = seconds(begun);
  begun = std::chrono::steady_clock::now();
  const auto walled =
      haptics::makeScene(volume, comparison::toolOf(touched), {}, scene.get()).value();
  const double scene_time = seconds(begun);
  begun = std::chrono::steady_clock::now();
  const auto again = datasets::walled(volume, walls, touched.isovalue + 50.0, volume).value();
  (void)haptics::makeScene(again, comparison::toolOf(touched), {}, walled.get()).value();
  json["maps_MB"] = double(map_bytes) * 1e-6;
  const datasets::Walled* made = datasets::walledOf(*volume);
  json["walls"] = {{"MB", made == nullptr ? 0.0 : double(made->bytes) * 1e-6},
                   {"made_ms", wall_time * 1e3},
                   {"scene_ms", scene_time * 1e3},
                   {"again_ms", seconds(begun) * 1e3}};

  std::vector<Case> cases{
      {"none", scene, nullptr}, {"twelve", scene, watch}, {"walls", walled, watch}};
  std::vector<double> ratios;  // of each tick, with twelve and with none: the same poses
  for (int round = 0; round < kRounds; ++round)
    for (const haptics::Hand& hand : hands) {
      std::vector<std::vector<double>> taken(cases.size());
      for (std::size_t n = 0; n < cases.size(); ++n) {
        // another one first in each round
        const std::size_t which = (n + std::size_t(round)) % cases.size();
        loop.scene = cases[which].scene;
        loop.watch = cases[which].watch;
        loop.grip.gyration = std::sqrt(loop.scene->tool.shell.inertia.trace() / 3.0);
        const auto done = loop.run(hand, std::int64_t(length * loop.rate.hz), [&](const auto& row) {
          taken[which].push_back(1e-3 * double(row.cpu_ns));
          return true;
        });
        if (!done) return 1;
      }
      for (std::size_t n = 0; n < cases.size(); ++n)
        cases[n].ticks.insert(cases[n].ticks.end(), taken[n].begin(), taken[n].end());
      for (std::size_t tick = 0; tick < taken[0].size(); ++tick)
        ratios.push_back(taken[1][tick] / taken[0][tick]);
    }
  for (const Case& one : cases)
    json["ticks"].push_back({{"with", one.name},
                             {"p50_us", quantile(one.ticks, 0.5)},
                             {"p99_us", quantile(one.ticks, 0.99)},
                             {"max_us", quantile(one.ticks, 1.0)}});
  json["ratio_of_a_tick"] = {{"p10", quantile(ratios, 0.1)},
                             {"p50", quantile(ratios, 0.5)},
                             {"p90", quantile(ratios, 0.9)}};
  loop.scene = scene;
  json["real_time"] = inRealTime(loop, hands.back(), watch, real);
  std::puts(json.dump(2).c_str());
  return 0;
}
