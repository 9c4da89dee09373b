// SPDX-License-Identifier: BSD-3-Clause

// palpate-bench: literal, charitable, accept-inside and ours on the same hands in one process.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "app/build_info/build_info.h"
#include "app/study/comparison/course.h"
#include "app/study/comparison/feel.h"
#include "app/study/comparison/holds.h"
#include "app/study/comparison/sweep.h"
#include "haptics/proxy/tick.h"
#include "tests/support/sentence.h"

namespace {

using namespace comparison;  // its words are what is reported here
using Json = nlohmann::ordered_json;

struct Options {
  bool json = false, quick = false, counted = false, no_sweep = false, rates = false;
  std::string scans;
  std::vector<std::string> only;
  double seconds = 0.0;  ///< 0: 3, or less when quick
  unsigned hands = 1;    ///< of each kind, at the rates
  haptics::NormalKind normal = haptics::NormalKind::Central;

  double handSeconds() const { return seconds > 0.0 ? seconds : quick ? 0.3 : 3.0; }
  std::size_t judgedPose() const { return quick ? 20 : 5; }
};

/// Everything measured in one scene, literal first and ours last.
struct SceneReport {
  std::string scene;
  double samples_per_point = 0.0;  ///< of literal
  std::vector<Summary> summaries;
  std::vector<Summary> rates = {};  ///< ours alone at each rate of the servo; may be empty
  std::vector<HoldSummary> holds = {};
  std::vector<FeelSummary> feel = {};  ///< empty: no even stretch was found
};

/// Whether literal is the fair rival that a ratio needs: its search does not look more often than
/// the paper's.
bool isHonest(const SceneReport& report) {
  return report.samples_per_point >= 1.3 && report.samples_per_point <= 2.0;
}

double over(double a, double b) { return b > 0.0 ? a / b : 0.0; }

/// The method's entry of a list that may be empty.
template <class T>
const T* entry(const std::vector<T>& list, const std::string& method) {
  const auto found = std::ranges::find(list, method, &T::method);
  return found == list.end() ? nullptr : &*found;
}

Json resultOf(const SceneReport& report, const Summary& s) {
  Json json{{"scene", report.scene},
            {"method", s.method},
            {"mean_us", s.mean_us},
            {"p50_us", s.p50_us},
            {"p99_us", s.p99_us},
            {"p999_us", s.p999_us},
            {"max_us", s.max_us},
            {"p999_work", s.p999_work},
            {"coupling_mm", s.coupling_mm},
            {"coupling_tap_slide_hook_mm", s.guided_mm},
            {"frozen", s.frozen},
            {"truly_stuck", s.truly_stuck},
            {"contact_slack_mm", mean(s.sorted(&Part::slack_mm))},
            {"wall_passages", s.wall_passages},
            {"penetration_mm", s.penetration_mm},
            {"samples_per_tick", s.counts.samples},
            {"work_per_tick", s.counts.work},
            {"contacts_max", s.contacts_max},
            {"cut", s.cut},
            {"ticks", s.ticks}};
  if (const FeelSummary* feel = entry(report.feel, s.method))
    json.update(Json{{"fine_noise_N", feel->fine_noise_N},
                     {"force_step_N", feel->largest_step_N},
                     {"surface_step_N", feel->surface_step_N},
                     {"ideal_step_N", feel->ideal_step_N},
                     {"slide_force_N", feel->mean_force_N},
                     {"surface_fine_mm", feel->surface_fine_mm}});
  if (const HoldSummary* hold = entry(report.holds, s.method))
    json.update(Json{{"residual_mm_median", hold->residual_median_mm},
                     {"residual_mm_mean", hold->residual_mean_mm},
                     {"same_start_mm_median", hold->same_start_median_mm},
                     {"same_start_mm_mean", hold->same_start_mean_mm},
                     {"settled_mm_median", hold->settled_median_mm},
                     {"settled_mm_mean", hold->settled_mean_mm},
                     {"rest_mm_p99", hold->rest_p99_mm},
                     {"rest_mm_max", hold->rest_max_mm},
                     {"slack_mm", hold->legal > 0 ? Json(hold->slack_mm) : Json()}});
  for (const Part& part : s.parts)
    json["hands"].push_back({{"hand", part.hand},
                             {"mean_us", part.mean_us},
                             {"coupling_mm", part.coupling_mm},
                             {"frozen", part.frozen},
                             {"truly_stuck", part.truly_stuck},
                             {"contact", part.contact},
                             {"cut", part.cut}});
  return json;
}

Json jsonOf(const std::vector<SceneReport>& reports, const std::vector<SweepRow>& sweep) {
  Json json{{"machine", app::machineHere()},
            {"results", Json::array()},
            {"rates", Json::array()},
            {"ratios", Json::array()},
            {"sweep", Json::array()}};
  for (const SceneReport& report : reports) {
    for (const Summary& summary : report.summaries)
      json["results"].push_back(resultOf(report, summary));
    for (const Summary& summary : report.rates) json["rates"].push_back(resultOf(report, summary));
    const Summary &literal = report.summaries.front(), &own = report.summaries.back();
    const auto ratio = [&](double a, double b) {
      return isHonest(report) ? Json(over(a, b)) : Json();
    };
    json["ratios"].push_back({{"scene", report.scene},
                              {"mean", ratio(literal.mean_us, own.mean_us)},
                              {"p999", ratio(literal.p999_us, own.p999_us)},
                              {"max", ratio(literal.max_us, own.max_us)},
                              {"coupling", ratio(literal.coupling_mm, own.coupling_mm)},
                              {"literal_samples_per_point", report.samples_per_point}});
  }
  for (const SweepRow& r : sweep)
    json["sweep"].push_back({{"scene", r.scene},
                             {"points", r.points},
                             {"budget_us", r.budget_us},
                             {"build_ms", r.build_ms},
                             {"mean_us", r.mean_us},
                             {"p50_us", r.p50_us},
                             {"p99_us", r.p99_us},
                             {"max_us", r.max_us},
                             {"coupling_mm", r.coupling_mm},
                             {"lag_mm", r.lag_mm},
                             {"penetration_mm", r.penetration_mm},
                             {"cut", r.cut}});
  return json;
}

/// A row for each method, as soon as its scene is done.
void tell(const SceneReport& report, std::FILE* to) {
  std::vector<Summary> rows = report.summaries;
  rows.insert(rows.end(), report.rates.begin(), report.rates.end());
  for (const Summary& s : rows) {
    std::fprintf(to,
                 "| %s | %s | %.1f | %.0f | %.0f | %.0f | %.2f | %.1f %% | %.4f | %d | %.1f %% |",
                 report.scene.c_str(), s.method.c_str(), s.mean_us, s.p99_us, s.p999_us, s.max_us,
                 s.coupling_mm, 100 * s.frozen, s.penetration_mm, s.wall_passages, 100 * s.cut);
    const HoldSummary* hold = entry(report.holds, s.method);
    const FeelSummary* feel = entry(report.feel, s.method);
    if (hold) std::fprintf(to, " %.4f / %.3f", hold->residual_median_mm, hold->residual_mean_mm);
    std::fprintf(to, " |");
    if (feel) std::fprintf(to, " %.4f | %.3f", feel->fine_noise_N, feel->largest_step_N);
    std::fprintf(to, feel ? " |\n" : " | |\n");
  }
  std::fflush(to);
}

/// Adds what the sweep finds in this scene.
void swept(const Touched& scene, const Options& options, std::vector<SweepRow>& rows) {
  const SweepPlan plan = options.quick ? SweepPlan{{1'000, 100'000}, {200}, 200} : SweepPlan{};
  std::ranges::move(sweep(scene, plan), std::back_inserter(rows));
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
    kind->truly_stuck += part.truly_stuck / hands;
    kind->contact += part.contact / hands;
    kind->cut += part.cut / hands;
  }
  return kinds;
}

/// Ours alone along the same hands, at each rate of the servo and with its budget.
haptics::Expected<std::vector<Summary>> atEveryRate(
    const std::shared_ptr<const haptics::Scene>& built, const Touched& scene,
    const Options& options, const Judge& judge) {
  std::vector<Summary> summaries;
  for (const haptics::ServoRate rate : haptics::kServoRates) {
    const auto courses = coursesIn(*built, scene, options.handSeconds(), rate, 1, options.hands);
    if (!courses) return tl::unexpected(courses.error());
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(ours(built, scene.isovalue,
                           {rate.budget_ns(), options.counted ? rate.budget_work() : 0, rate}));
    const Track track = std::move(follow(methods, *courses).front());
    Summary summary = summaryOf(track, *courses, built->tool.shell, judge, options.judgedPose(),
                                built->lengths.rest_gap);
    summary.method = "ours, " + std::to_string(rate.hz / 1000) + " kHz";
    summary.parts = byKind(summary.parts, options.hands);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

haptics::Expected<SceneReport> measured(const Touched& scene, const Options& options) {
  const Limit limit{.work = options.counted ? haptics::kTickWork : 0};
  const auto built = haptics::makeScene(scene.volume, toolOf(scene),
                                        {haptics::FieldKind::Trilinear, options.normal});
  if (!built) return tl::unexpected(built.error());
  const auto courses = coursesIn(**built, scene, options.handSeconds());
  if (!courses) return tl::unexpected(courses.error());
  auto methods = allMethods(scene, *built, limit);
  const std::vector<Track> tracks = follow(methods, *courses);
  const haptics::PointShell& shell = (*built)->tool.shell;
  const FreeBlocks blocks{*scene.volume, scene.isovalue};
  const Judge judge{scene, shell, blocks};
  SceneReport report;
  report.scene = scene.name;
  for (const Track& track : tracks)
    report.summaries.push_back(
        summaryOf(track, *courses, shell, judge, options.judgedPose(), (*built)->lengths.rest_gap));
  report.samples_per_point = report.summaries.front().counts.samples / scene.points;

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
  auto rates = atEveryRate(*built, scene, options, judge);
  if (!rates) return tl::unexpected(rates.error());
  report.rates = std::move(*rates);
  return report;
}

int run(const Options& options) {
  std::vector<std::string> names = sceneNames();
  if (!options.scans.empty()) names.insert(names.end(), scanNames().begin(), scanNames().end());
  const auto wanted = [&](const std::string& name) {
    return options.only.empty() ||
           std::find(options.only.begin(), options.only.end(), name) != options.only.end();
  };
  std::FILE* table = options.json ? stderr : stdout;
  std::fprintf(
      table,
      "| scene | method | mean | p99 | p99.9 | longest us | coupling mm | frozen | deepest "
      "mm | walls | cut | residual median / mean mm | fine N | step N |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const bool sweeps = !options.no_sweep && wanted("sweep");
  std::vector<SceneReport> reports;
  std::vector<SweepRow> rows;
  for (const std::string& name : names) {
    const bool slides = sweeps && name == "bunny";
    if (!wanted(name) && !slides) continue;
    const auto scene = caseOf(name, options);
    if (!scene) {
      std::fprintf(stderr, "%s is left out: %s\n", name.c_str(), sentence(scene.error()).c_str());
      continue;
    }
    // while the volume is there: one of this size at a time
    if (slides) swept(*scene, options, rows);
    if (!wanted(name)) continue;
    auto report = measured(*scene, options);
    if (!report) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), sentence(report.error()).c_str());
      return 4;
    }
    tell(*report, table);
    reports.push_back(std::move(*report));
  }
  if (sweeps) {
    swept(plane(), options, rows);
    std::fprintf(
        table,
        "\n| sweep | points | budget us | mean | p99 | longest us | coupling mm | lag mm | "
        "cut |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const SweepRow& r : rows)
      std::fprintf(table, "| %s | %d | %d | %.0f | %.0f | %.0f | %.3f | %.3f | %.0f %% |\n",
                   r.scene.c_str(), r.points, r.budget_us, r.mean_us, r.p99_us, r.max_us,
                   r.coupling_mm, r.lag_mm, 100 * r.cut);
  }
  if (options.json) std::printf("%s\n", jsonOf(reports, rows).dump(1).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{
      "Leads the literal, charitable and accept-inside readings of the paper and "
      "Palpate's own tick along the same hands, and compares them."};
  app.add_flag("--json", options.json,
               "One JSON object on standard output, the table on the other");
  app.add_flag("--quick", options.quick, "Shorter hands, fewer checks: under 40 s");
  app.add_flag("--counted", options.counted,
               "Counted work in place of the clock, so that all but the times repeat");
  app.add_flag("--no-sweep", options.no_sweep, "Leave out the sweep over points and budgets");
  auto* rates = app.add_flag("--rates", options.rates,
                             "Ours at 1, 2 and 4 kHz as well, each with its budget");
  app.add_option("--hands", options.hands, "Hands of each kind at the rates")
      ->needs(rates)
      ->check(CLI::Range(1, 1000));
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
  CLI11_PARSE(app, argc, argv);
  return run(options);
}
