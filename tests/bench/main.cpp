// SPDX-License-Identifier: BSD-3-Clause

// palpate-bench: literal, charitable, accept-inside and ours on the same hands in one process.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>

#include "haptics/proxy/tick.h"
#include "tests/bench/report.h"
#include "tests/support/sentence.h"

namespace bench {
namespace {

struct Options {
  bool json = false, quick = false, counted = false, no_sweep = false, rates = false;
  std::string scans, out;
  std::vector<std::string> only;
  double seconds = 0.0;  ///< 0: 3, or less when quick
  int budget_us = 200;
  unsigned hands = 1;  ///< of each kind, at the rates
  haptics::NormalKind normal = haptics::NormalKind::Central;
};

double secondsSince(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

haptics::Expected<Touched> caseOf(const std::string& name, const Options& options) {
#ifdef PALPATE_READERS
  if (name.starts_with("scan-")) return readScan(name, options.scans);
#else
  static_cast<void>(options);
#endif
  return makeScene(name);
}

/// One part for each kind of hand: the mean of its hands.
std::vector<Part> byKind(const std::vector<Part>& parts, unsigned hands) {
  std::vector<Part> kinds;
  for (const Part& part : parts) {
    auto kind = std::ranges::find(kinds, part.hand, &Part::hand);
    if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {.hand = part.hand});
    kind->mean_us += part.mean_us / hands;
    kind->coupling_mm += part.coupling_mm / hands;
    kind->frozen += part.frozen / hands;
    kind->contact += part.contact / hands;
    kind->cut += part.cut / hands;
  }
  return kinds;
}

/// Ours alone along the same hands, at each rate of the servo and with its budget.
haptics::Expected<std::vector<Summary>> atEveryRate(const Touched& scene, const Options& options,
                                                    const Judge& judge) {
  const auto built = haptics::makeScene(scene.volume, toolOf(scene),
                                        {haptics::FieldKind::Trilinear, options.normal});
  if (!built) return tl::unexpected(built.error());
  const double seconds = options.seconds > 0.0 ? options.seconds : options.quick ? 0.3 : 3.0;
  std::vector<Summary> summaries;
  for (const haptics::ServoRate rate : haptics::kServoRates) {
    std::vector<Course> courses;
    for (unsigned seed = 1; seed <= options.hands; ++seed) {
      auto one = coursesIn(**built, scene, seconds, rate, seed);
      if (!one) return tl::unexpected(one.error());
      std::ranges::move(*one, std::back_inserter(courses));
    }
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(ours(*built, scene.isovalue,
                           {rate.budget_ns(), options.counted ? rate.budget_work() : 0, rate}));
    const Track track = std::move(follow(methods, courses).front());
    Summary summary =
        summaryOf(track, courses, (*built)->tool.shell, judge, options.quick ? 20 : 5);
    summary.method = "ours, " + std::to_string(rate.hz / 1000) + " kHz";
    summary.parts = byKind(summary.parts, options.hands);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

haptics::Expected<SceneReport> measured(const Touched& scene, const Options& options) {
  const Limit limit{1000LL * options.budget_us,
                    options.counted ? haptics::kTickWork * options.budget_us / 200 : 0};
  SceneReport report{scene.name, scene.tool, scene.points};
  report.literal_us = scene.literal_us;
  const auto begun = std::chrono::steady_clock::now();
  const auto built = haptics::makeScene(scene.volume, toolOf(scene),
                                        {haptics::FieldKind::Trilinear, options.normal});
  if (!built) return tl::unexpected(built.error());
  report.build_ms = 1e3 * secondsSince(begun);
  report.structures = (*built)->structures;
  report.voxel_mm = 1e3 * scene.volume->grid.spacing.minCoeff();
  report.rest_gap_mm = 1e3 * (*built)->lengths.rest_gap;

  const double seconds = options.seconds > 0.0 ? options.seconds : options.quick ? 0.3 : 3.0;
  const auto courses = coursesIn(**built, scene, seconds);
  if (!courses) return tl::unexpected(courses.error());
  auto methods = allMethods(scene, *built, limit);
  const std::vector<Track> tracks = follow(methods, *courses);
  const haptics::PointShell& shell = (*built)->tool.shell;
  const FreeBlocks blocks{*scene.volume, scene.isovalue};
  const Judge judge{scene, shell, blocks};
  for (const Track& track : tracks)
    report.summaries.push_back(summaryOf(track, *courses, shell, judge, options.quick ? 20 : 5));

  const HoldPlan holds = options.quick ? HoldPlan{4, 120, 4, 100} : HoldPlan{};
  const auto unhurried = ours(*built, scene.isovalue, {0, 1'000'000});
  report.holds = compareHolds(methods, *unhurried, holdsAlong(tracks.back(), *courses, holds.count),
                              shell, judge, holds);
  SlidePlan slide;
  if (options.quick) slide.length = 0.012;
  // a tooth is small: a small ball, slower
  if (scene.name == "scan-tooth") slide = {0.001, 0.005, 0.002, 0.008};
  report.feel = compareFeel(scene, **built, blocks, slide, limit);
  if (!options.rates) return report;
  auto rates = atEveryRate(scene, options, judge);
  if (!rates) return tl::unexpected(rates.error());
  report.rates = std::move(*rates);
  return report;
}

/// A line for each method, on standard error: what is known before the whole is done.
void tell(const SceneReport& report) {
  std::vector<Summary> lines = report.summaries;
  lines.insert(lines.end(), report.rates.begin(), report.rates.end());
  for (const Summary& s : lines)
    std::fprintf(
        stderr,
        "%-12s %-13s mean %6.1f p50 %6.1f p99 %7.1f p99.9 %8.1f max %9.1f us | coupling "
        "%6.2f mm, frozen %4.1f %%, deepest %.4f mm, walls %d | contacts %d, samples %.0f, "
        "work %.0f, cut %.1f %%\n",
        report.scene.c_str(), s.method.c_str(), s.mean_us, s.p50_us, s.p99_us, s.p999_us, s.max_us,
        s.coupling_mm, 100 * s.frozen, s.penetration_mm, s.wall_passages, s.contacts_max,
        s.counts.samples, s.counts.work, 100 * s.cut);
  for (const HoldSummary& h : report.holds)
    std::fprintf(stderr,
                 "  %-13s %d holds: residual @8 median %.4f mean %.3f (same start %.4f / "
                 "%.3f), @64 %.4f / %.3f mm; rest "
                 "p99 %.2g max %.2g um; slack %.4f mm (%.2f rest gaps) over %d legal\n",
                 h.method.c_str(), h.holds, h.residual_median_mm, h.residual_mean_mm,
                 h.same_start_median_mm, h.same_start_mean_mm, h.settled_median_mm,
                 h.settled_mean_mm, 1e3 * h.rest_p99_mm, 1e3 * h.rest_max_mm, h.slack_mm,
                 h.slack_mm / report.rest_gap_mm, h.legal);
  for (const FeelSummary& f : report.feel)
    std::fprintf(
        stderr,
        "  %-13s slow slide: fine %.4f N, largest step %.3f N/ms (lowered ball %.4f, ideal "
        "proxy %.3f), mean %.2f N\n",
        f.method.c_str(), f.fine_noise_N, f.largest_step_N, f.surface_step_N, f.ideal_step_N,
        f.mean_force_N);
  for (const LongTick& tick : report.summaries.back().long_ticks)
    std::fprintf(stderr, "  long tick: %s %zu, %.0f us, work %lld, %ld faults, %ld switches\n",
                 tick.hand.c_str(), tick.tick, tick.us, static_cast<long long>(tick.work),
                 tick.faults, tick.switches);
  if (const std::string why = whyNotHonest(report); !why.empty())
    std::fprintf(stderr, "  no ratio for %s: %s\n", report.scene.c_str(), why.c_str());
}

/// Adds what the sweep finds in this scene.
void swept(const Touched& scene, const Options& options, std::vector<SweepRow>& rows) {
  const SweepPlan plan = options.quick ? SweepPlan{{1'000, 100'000}, {200}, 200} : SweepPlan{};
  for (const SweepRow& r : sweep(scene, plan)) {
    std::fprintf(stderr,
                 "sweep %-6s %7d points %3d us: mean %6.1f p50 %6.1f p99 %6.1f max %6.1f us, "
                 "coupling %.3f lag %.3f mm, deepest %.4f mm, cut %.0f %%\n",
                 r.scene.c_str(), r.points, r.budget_us, r.mean_us, r.p50_us, r.p99_us, r.max_us,
                 r.coupling_mm, r.lag_mm, r.penetration_mm, 100 * r.cut);
    rows.push_back(r);
  }
}

int run(const Options& options) {
  std::vector<std::string> names = sceneNames();
  if (!options.scans.empty()) names.insert(names.end(), scanNames().begin(), scanNames().end());
  const auto wanted = [&](const std::string& name) {
    return options.only.empty() ||
           std::find(options.only.begin(), options.only.end(), name) != options.only.end();
  };
  const bool sweeps = !options.no_sweep && wanted("sweep");
  std::vector<SceneReport> reports;
  std::vector<SweepRow> rows;
  for (const std::string& name : names) {
    const bool slides = sweeps && name == "bunny";
    if (!wanted(name) && !slides) continue;
    const auto begun = std::chrono::steady_clock::now();
    const auto scene = caseOf(name, options);
    if (!scene) {
      std::fprintf(stderr, "%s is left out: %s\n", name.c_str(), sentence(scene.error()).c_str());
      continue;
    }
    const double made = secondsSince(begun);
    // while the volume is there: one of this size at a time
    if (slides) swept(*scene, options, rows);
    if (!wanted(name)) continue;
    auto report = measured(*scene, options);
    if (!report) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), sentence(report.error()).c_str());
      return 4;
    }
    tell(*report);
    std::fprintf(stderr, "  %.1f s, of which making the volume %.1f s\n", secondsSince(begun),
                 made);
    reports.push_back(std::move(*report));
  }
  if (sweeps) swept(plane(), options, rows);
  const Json json = jsonOf(reports, rows);
  if (options.json)
    std::printf("%s\n", json.dump(1).c_str());
  else
    std::printf("%s", tableOf(reports, rows).c_str());
  if (!options.out.empty()) {
    std::ofstream file{options.out};
    file << json.dump(1) << '\n';
    if (!file.flush()) {
      std::fprintf(stderr, "%s cannot be written.\n", options.out.c_str());
      return 4;
    }
  }
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  CLI::App app{
      "Leads the literal, charitable and accept-inside readings of the paper and "
      "Palpate's own tick along the same hands, and compares them."};
  app.add_flag("--json", options.json, "One JSON object on standard output, no table");
  app.add_flag("--quick", options.quick, "Shorter hands, fewer checks: under 40 s");
  app.add_flag("--counted", options.counted,
               "Counted work in place of the clock, so that all but the times repeat");
  app.add_flag("--no-sweep", options.no_sweep, "Leave out the sweep over points and budgets");
  auto* rates = app.add_flag("--rates", options.rates,
                             "Ours at 1, 2 and 4 kHz as well, each with its budget");
  app.add_option("--hands", options.hands, "Hands of each kind at the rates")
      ->needs(rates)
      ->check(CLI::Range(1, 1000));
  app.add_option("--budget", options.budget_us, "Of a tick of ours [us]")
      ->check(CLI::Range(1, 100000));
  const std::map<std::string, haptics::NormalKind> normals{
      {"central", haptics::NormalKind::Central},
      {"cell", haptics::NormalKind::Cell},
      {"spline", haptics::NormalKind::Spline}};
  app.add_option("--normal", options.normal, "Of ours: central, cell or spline")
      ->transform(CLI::CheckedTransformer(normals));
  app.add_option("--seconds", options.seconds, "Of each hand after its lead-in")
      ->check(CLI::Range(0.1, 1000.0));
#ifdef PALPATE_READERS
  app.add_option("--scans", options.scans, "Folder of real scans, to run those as well")
      ->check(CLI::ExistingDirectory);
#endif
  app.add_option("--only", options.only, "These scenes, scan-… or sweep, alone");
  app.add_option("--out", options.out, "Write the JSON here, too");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return bench::run(options);
}
