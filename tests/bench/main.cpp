// SPDX-License-Identifier: BSD-3-Clause

// palpate-bench: literal, charitable, accept-inside and ours on the same hands in one process.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/bench/course.h"
#include "tests/bench/scenes.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  bool json = false, quick = false, counted = false;
  std::string scans, out;
  std::vector<std::string> only;
  double seconds = 3.0;
  int budget_us = 200;
};

Json jsonOf(const std::string& scene, const Summary& s) {
  Json hands = Json::array();
  for (const Part& part : s.parts)
    hands.push_back({{"hand", part.hand},
                     {"mean_us", part.mean_us},
                     {"coupling_mm", part.coupling_mm},
                     {"frozen", part.frozen},
                     {"contact", part.contact}});
  return {{"scene", scene},
          {"method", s.method},
          {"mean_us", s.mean_us},
          {"p50_us", s.p50_us},
          {"p99_us", s.p99_us},
          {"p999_us", s.p999_us},
          {"p9999_us", s.p9999_us},
          {"max_us", s.max_us},
          {"coupling_mm", s.coupling_mm},
          {"coupling_tap_slide_hook_mm", s.guided_mm},
          {"frozen", s.frozen},
          {"wall_passages", s.wall_passages},
          {"penetration_mm", s.penetration_mm},
          {"samples_per_tick", s.samples_per_tick},
          {"contacts_max", s.contacts_max},
          {"cut", s.cut},
          {"ticks", s.ticks},
          {"hands", hands}};
}

/// The baseline is honest only if it does the work that the paper describes, at a fitting speed.
Json baselineOf(const Case& scene, const Summary& literal) {
  const double per_point = literal.samples_per_tick / scene.points;
  Json json{{"scene", scene.name},
            {"literal_mean_us", literal.mean_us},
            {"samples_per_point", per_point}};
  std::string why;
  if (per_point < 1.3 || per_point > 2.0)
    why = "it takes " + Json(per_point).dump() + " samples a point, not 1.3 to 2";
  if (scene.literal_us) {
    json["expected_mean_us"] = *scene.literal_us;
    const double ratio = literal.mean_us / *scene.literal_us;
    if (ratio < 0.5 || ratio > 2.0)
      why += std::string{why.empty() ? "" : "; "} +
             "its mean is not within a factor of 2 of the expected one";
  }
  json["honest"] = why.empty();
  if (!why.empty()) json["why"] = why;
  return json;
}

int run(const Options& options) {
  std::vector<std::string> names = sceneNames();
#ifdef PALPATE_READERS
  if (!options.scans.empty()) names.insert(names.end(), scanNames().begin(), scanNames().end());
#endif
  const Limit limit{1000LL * options.budget_us, options.counted ? 25LL * options.budget_us : 0};
  Json results = Json::array(), ratios = Json::array(), baselines = Json::array(),
       long_ticks = Json::array();
  for (const std::string& name : names) {
    if (!options.only.empty() &&
        std::find(options.only.begin(), options.only.end(), name) == options.only.end())
      continue;
    Case scene;
#ifdef PALPATE_READERS
    if (name.rfind("scan-", 0) == 0) {
      auto read = readScan(name, options.scans);
      if (!read) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), read.error().what.c_str());
        continue;
      }
      scene = std::move(*read);
    } else
#endif
      scene = makeScene(name);
    auto built = haptics::makeScene(scene.volume, toolOf(scene));
    if (!built) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), built.error().what.c_str());
      return 4;
    }
    auto courses = coursesIn(**built, scene, options.seconds);
    if (!courses) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), courses.error().what.c_str());
      return 4;
    }
    auto methods = allMethods(scene, *built, limit);
    const std::vector<Track> tracks = follow(methods, *courses);
    const Judge judge{scene, (*built)->tool.shell};
    std::vector<Summary> summaries;
    for (const Track& track : tracks) {
      summaries.push_back(
          summaryOf(track, *courses, (*built)->tool.shell, judge, options.quick ? 20 : 5));
      const Summary& s = summaries.back();
      std::fprintf(
          stderr,
          "%-12s %-14s mean %7.1f p50 %6.1f p99 %7.1f p99.9 %8.1f max %9.1f us | coupling "
          "%6.2f (tap slide hook %6.2f) mm frozen %4.1f %% pen %.4f mm walls %d | contacts "
          "%d samples %.0f cut %.1f %%\n",
          name.c_str(), s.method.c_str(), s.mean_us, s.p50_us, s.p99_us, s.p999_us, s.max_us,
          s.coupling_mm, s.guided_mm, 100 * s.frozen, s.penetration_mm, s.wall_passages,
          s.contacts_max, s.samples_per_tick, 100 * s.cut);
      results.push_back(jsonOf(name, s));
    }
    for (const LongTick& tick : summaries.back().long_ticks) {
      std::fprintf(stderr, "  long: %s tick %zu %.0f us, work %lld, faults %ld, switches %ld\n",
                   tick.hand.c_str(), tick.tick, tick.us, static_cast<long long>(tick.work),
                   tick.faults, tick.switches);
      long_ticks.push_back({{"scene", name},
                            {"hand", tick.hand},
                            {"tick", tick.tick},
                            {"us", tick.us},
                            {"work", tick.work},
                            {"minor_faults", tick.faults},
                            {"switches", tick.switches}});
    }
    baselines.push_back(baselineOf(scene, summaries.front()));
    std::fprintf(stderr, "  baseline: %s\n", baselines.back().dump().c_str());
  }
  const Json report{{"results", results},
                    {"ratios", ratios},
                    {"baselines", baselines},
                    {"long_ticks", long_ticks}};
  if (options.json) std::printf("%s\n", report.dump(1).c_str());
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  CLI::App app{
      "Measures the literal, charitable and accept-inside readings of the paper, and "
      "Palpate's own tick, side by side."};
  app.add_flag("--json", options.json, "One JSON object on standard output");
  app.add_flag("--quick", options.quick, "Shorter hands, fewer checks");
  app.add_flag("--counted", options.counted,
               "Counted work in place of the clock, so that results repeat");
  app.add_option("--budget", options.budget_us, "Of a tick of ours [us]");
  app.add_option("--seconds", options.seconds, "Of each hand");
  app.add_option("--scans", options.scans, "Folder of real scans, to run those as well");
  app.add_option("--only", options.only, "These scenes alone");
  app.add_option("--out", options.out, "Write the JSON here");
  CLI11_PARSE(app, argc, argv);
  if (options.quick) options.seconds = 0.5;
  return bench::run(options);
}
