// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench/report.h"

#include <algorithm>

#include "app/build_info/build_info.h"
#include "app/study/page/text.h"

namespace bench {
namespace {

using study::text;

bool isScan(const SceneReport& report) { return report.scene.starts_with("scan-"); }

double over(double a, double b) { return b > 0.0 ? a / b : 0.0; }

/// The method's entry of a list that may be empty.
template <class T>
const T* entry(const std::vector<T>& list, const std::string& method) {
  for (const T& one : list)
    if (one.method == method) return &one;
  return nullptr;
}

Json resultOf(const SceneReport& report, const Summary& s) {
  Json json{
      {"scene", report.scene},        {"method", s.method}, {"mean_us", s.mean_us},
      {"p50_us", s.p50_us},           {"p99_us", s.p99_us}, {"p999_us", s.p999_us},
      {"p9999_us", s.p9999_us},       {"max_us", s.max_us}, {"p999_work", s.p999_work},
      {"coupling_mm", s.coupling_mm}, {"frozen", s.frozen}, {"wall_passages", s.wall_passages}};
  const FeelSummary* feel = entry(report.feel, s.method);
  const HoldSummary* hold = entry(report.holds, s.method);
  const auto number = [](bool known, double value) { return known ? Json(value) : Json(); };
  json["fine_noise_N"] = number(feel, feel ? feel->fine_noise_N : 0.0);
  json["residual_mm_median"] = number(hold, hold ? hold->residual_median_mm : 0.0);
  json["residual_mm_mean"] = number(hold, hold ? hold->residual_mean_mm : 0.0);
  json["penetration_mm"] = s.penetration_mm;
  json["samples_per_tick"] = s.counts.samples;
  json["work_per_tick"] = s.counts.work;
  json["contacts_max"] = s.contacts_max;
  json["coupling_tap_slide_hook_mm"] = s.guided_mm;
  json["cut"] = s.cut;
  json["ticks"] = s.ticks;
  if (feel) {
    json["force_step_N"] = feel->largest_step_N;
    json["surface_step_N"] = feel->surface_step_N;
    json["ideal_step_N"] = feel->ideal_step_N;
    json["slide_force_N"] = feel->mean_force_N;
    json["surface_fine_mm"] = feel->surface_fine_mm;
  }
  if (hold) {
    json["holds"] = hold->holds;
    json["same_start_mm_median"] = hold->same_start_median_mm;
    json["same_start_mm_mean"] = hold->same_start_mean_mm;
    json["settled_mm_median"] = hold->settled_median_mm;
    json["settled_mm_mean"] = hold->settled_mean_mm;
    json["rest_mm_p99"] = hold->rest_p99_mm;
    json["rest_mm_max"] = hold->rest_max_mm;
    json["slack_mm"] = hold->legal > 0 ? Json(hold->slack_mm) : Json();
  }
  json["hands"] = Json::array();
  for (const Part& part : s.parts)
    json["hands"].push_back({{"hand", part.hand},
                             {"mean_us", part.mean_us},
                             {"coupling_mm", part.coupling_mm},
                             {"frozen", part.frozen},
                             {"contact", part.contact},
                             {"cut", part.cut}});
  return json;
}

Json ratioOf(const SceneReport& report) {
  const Summary &literal = report.summaries.front(), &own = report.summaries.back();
  Json json{{"scene", report.scene}};
  const std::string why = whyNotHonest(report);
  const auto ratio = [&](double a, double b) { return why.empty() ? Json(over(a, b)) : Json(); };
  json["mean"] = ratio(literal.mean_us, own.mean_us);
  json["p999"] = ratio(literal.p999_us, own.p999_us);
  json["max"] = ratio(literal.max_us, own.max_us);
  json["coupling"] = ratio(literal.coupling_mm, own.coupling_mm);
  if (!why.empty()) json["why"] = why;
  return json;
}

/// One row of the table: what, what must be, what is wanted, what was reached.
std::string row(const std::string& what, const std::string& must, const std::string& want,
                const std::string& reached) {
  return "| " + what + " | " + must + " | " + want + " | " + reached + " |\n";
}

/// One value for each scene, "bunny 1.5, engine 3.1".
template <class Value>
std::string each(const std::vector<SceneReport>& reports, bool scans, Value value) {
  std::string all;
  for (const SceneReport& report : reports) {
    if (isScan(report) != scans) continue;
    const std::string one = value(report);
    if (one.empty()) continue;
    all += (all.empty() ? "" : ", ") + report.scene.substr(scans ? 5 : 0) + " " + one;
  }
  return all.empty() ? "not run" : all;
}

}  // namespace

std::string whyNotHonest(const SceneReport& report) {
  const Summary& literal = report.summaries.front();
  const double per_point = literal.counts.samples / report.points;
  std::string why;
  if (per_point < 1.3 || per_point > 2.0)
    why = text("literal takes %.2f samples a point, not 1.3 to 2", per_point);
  if (report.literal_us &&
      (literal.mean_us < 0.5 * *report.literal_us || literal.mean_us > 2.0 * *report.literal_us))
    why += text("%sits mean of %.0f us is not within a factor of 2 of %.0f us",
                why.empty() ? "" : "; ", literal.mean_us, *report.literal_us);
  return why;
}

Json jsonOf(const std::vector<SceneReport>& reports, const std::vector<SweepRow>& sweep) {
  Json json{{"machine", app::machineHere()}, {"results", Json::array()}, {"rates", Json::array()},
            {"ratios", Json::array()},       {"scenes", Json::array()},  {"sweep", Json::array()},
            {"long_ticks", Json::array()}};
  for (const SceneReport& report : reports) {
    for (const Summary& summary : report.summaries)
      json["results"].push_back(resultOf(report, summary));
    for (const Summary& summary : report.rates) json["rates"].push_back(resultOf(report, summary));
    if (!isScan(report)) json["ratios"].push_back(ratioOf(report));
    const Summary& literal = report.summaries.front();
    Json scene{{"scene", report.scene},
               {"tool", report.tool},
               {"points", report.points},
               {"voxel_mm", report.voxel_mm},
               {"rest_gap_mm", report.rest_gap_mm},
               {"build_ms", report.build_ms},
               {"literal_samples_per_point", literal.counts.samples / report.points}};
    scene["structures"] = Json::array();
    for (const haptics::Structure& structure : report.structures)
      scene["structures"].push_back({{"name", structure.name},
                                     {"bytes", structure.bytes},
                                     {"build_ms", 1e3 * structure.build_time}});
    if (report.literal_us) scene["literal_expected_us"] = *report.literal_us;
    const std::string why = whyNotHonest(report);
    scene["baseline_honest"] = why.empty();
    if (!why.empty()) scene["why"] = why;
    json["scenes"].push_back(scene);
    for (const LongTick& tick : report.summaries.back().long_ticks)
      json["long_ticks"].push_back({{"scene", report.scene},
                                    {"hand", tick.hand},
                                    {"tick", tick.tick},
                                    {"us", tick.us},
                                    {"work", tick.work},
                                    {"minor_faults", tick.faults},
                                    {"switches", tick.switches}});
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

std::string tableOf(const std::vector<SceneReport>& reports, const std::vector<SweepRow>& sweep) {
  const auto own = [](const SceneReport& r) -> const Summary& { return r.summaries.back(); };
  const auto literal = [](const SceneReport& r) -> const Summary& { return r.summaries.front(); };
  const auto ratio = [&](const SceneReport& r, double a, double b) {
    return whyNotHonest(r).empty() ? text("%.2f", over(a, b)) : "none (" + whyNotHonest(r) + ")";
  };
  const auto hold = [&](const SceneReport& r, auto&& line) {
    return r.holds.empty() ? std::string{} : line(r.holds.back(), r.holds.front());
  };
  std::string table = "| figure | must | want | reached |\n|---|---|---|---|\n";
  double deepest = 0.0;
  int passages = 0;
  for (const SceneReport& report : reports) {
    deepest = std::max(deepest, own(report).penetration_mm);
    passages += own(report).wall_passages;
  }
  table += row("penetration of any judged pose [mm]", "0", "0", text("%g", deepest));
  table += row("shell points through walls", "0", "0", text("%d", passages));
  table += row("mean tick, literal / ours", "1.5, 3, 3, 1.5", "3, 8, 8, 3",
               each(reports, false, [&](const SceneReport& r) {
                 return ratio(r, literal(r).mean_us, own(r).mean_us);
               }));
  table += row("coupling distance, ours / literal", "0.85", "",
               each(reports, false, [&](const SceneReport& r) {
                 return text("%.2f", over(own(r).coupling_mm, literal(r).coupling_mm));
               }));
  table +=
      row("p99.9 tick, literal / ours", "20", "60", each(reports, false, [&](const SceneReport& r) {
            return ratio(r, literal(r).p999_us, own(r).p999_us);
          }));
  table +=
      row("longest tick, literal / ours", "", "", each(reports, false, [&](const SceneReport& r) {
            return ratio(r, literal(r).max_us, own(r).max_us);
          }));
  table += row("p99.99 and longest tick of ours [us]", "400 at p99.99", "300",
               each(reports, false, [&](const SceneReport& r) {
                 return text("%.0f and %.0f", own(r).p9999_us, own(r).max_us);
               }));
  table +=
      row("residual after 8 ticks, median / mean [mm] (literal's mean)", "0.01 / half of literal",
          "0.002 / a fifth", each(reports, false, [&](const SceneReport& r) {
            return hold(r, [](const HoldSummary& o, const HoldSummary& l) {
              return text("%.4f / %.3f (%.3f)", o.residual_median_mm, o.residual_mean_mm,
                          l.residual_mean_mm);
            });
          }));
  table += row("the same against the same start alone", "", "",
               each(reports, false, [&](const SceneReport& r) {
                 return hold(r, [](const HoldSummary& o, const HoldSummary& l) {
                   return text("%.4f / %.3f (%.3f)", o.same_start_median_mm, o.same_start_mean_mm,
                               l.same_start_mean_mm);
                 });
               }));
  table += row("way at rest after 200 ticks, 99 % / all [um]", "1", "bit-still",
               each(reports, false, [&](const SceneReport& r) {
                 return hold(r, [](const HoldSummary& o, const HoldSummary&) {
                   return text("%.3g / %.3g", 1e3 * o.rest_p99_mm, 1e3 * o.rest_max_mm);
                 });
               }));
  table += row("scans: local slack / rest gap", "1.2", "0.6",
               each(reports, true, [&](const SceneReport& r) {
                 return hold(r, [&](const HoldSummary& o, const HoldSummary&) {
                   return text("%.2f", over(o.slack_mm, r.rest_gap_mm));
                 });
               }));
  table += row("scans: frozen, of contact ticks (bunny; all; thin bone) [%]", "5, 20, 30",
               "2, 10, 15", each(reports, true, [&](const SceneReport& r) {
                 return text("%.1f", 100.0 * own(r).frozen);
               }));
  for (const bool scans : {true, false})
    table += row(std::string{scans ? "scans" : "scenes"} +
                     ": coupling on tap, slide, hook, ours / literal and ours / accept-inside",
                 "0.8, 1.05", "0.5, 0.9", each(reports, scans, [&](const SceneReport& r) {
                   return text("%.2f and %.2f", over(own(r).guided_mm, literal(r).guided_mm),
                               over(own(r).guided_mm, r.summaries[2].guided_mm));
                 }));
  for (const bool scans : {true, false})
    table += row(
        std::string{scans ? "scans" : "scenes"} +
            ": fine force noise [N] and largest step [N/ms] in a slow slide (the surface's "
            "own noise; the steps of a lowered ball and of an ideal proxy)",
        "0.02 head, 0.005 smooth, 0.035 bunny; 0.15", "half; 0.05",
        each(reports, scans, [&](const SceneReport& r) {
          if (r.feel.empty()) return std::string{};
          const FeelSummary& feel = r.feel.back();
          return text("%.4f and %.3f (%.4f; %.3f and %.3f)", feel.fine_noise_N, feel.largest_step_N,
                      feel.surface_fine_mm, feel.surface_step_N, feel.ideal_step_N);
        }));
  table +=
      row("mean tick on the scans [us] (head bone)", "100", "50",
          each(reports, true, [&](const SceneReport& r) { return text("%.0f", own(r).mean_us); }));
  for (const SweepRow& r : sweep) {
    if (r.budget_us != 200) continue;
    table += row(text("%s, %d points, 200 us", r.scene.c_str(), r.points),
                 r.points <= 10'000 ? "keeps up" : "", "10^5 at 250 us; 10^6 without starving",
                 text("mean %.0f, p99 %.0f, longest %.0f us; lag %.3f mm; cut %.0f %%", r.mean_us,
                      r.p99_us, r.max_us, r.lag_mm, 100.0 * r.cut));
  }
  return table;
}

}  // namespace bench
