// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/collision.h"

#include <cmath>

#include "app/study/accuracy/work_precision.h"
#include "app/study/reference/collision.h"
#include "haptics/core/budget.h"

namespace study::accuracy {
namespace {

/// [Chan 2011], 2.3, with pieces of `feature` [m].
arcs::Detect pieces(double feature) {
  return [feature](const arcs::Target& target, double s, const arcs::Arc& arc) {
    reference::Choices choices =
        reference::choicesFor(target.volume->grid, reference::Variant::Literal);
    choices.feature = feature;
    choices.epsilon = feature / 10.0;
    const reference::Solid solid{*target.volume, s, choices};
    haptics::PointShell shell;
    shell.points = {arc.r};
    shell.radius = arc.r.norm();
    const reference::FirstHit hit = reference::firstHit(solid, shell, arc.X, arc.motion);
    arcs::Crossing crossing{hit.t, hit.met};
    crossing.counts.samples = solid.samples();
    return crossing;
  };
}

arcs::Target targetOf(const std::string& name, unsigned seed) {
  datasets::Random random{seed};
  if (name == "noise") return arcs::noise(seed);
  if (name == "slanted plate") return arcs::slantedPlate(random);
  if (name == "upright plates") return arcs::uprightPlates();
  return arcs::gyroid();
}

}  // namespace

std::vector<Detector> detectors() {
  std::vector<Detector> all{{"ours", "as a tick", arcs::detected}};
  for (const double parts : {1.0, 2.0, 4.0, 8.0, 32.0})
    all.push_back(
        {"literal", "pieces of " + shortly(0.5 / parts) + " voxel", pieces(0.5 * arcs::h / parts)});
  return all;
}

const std::vector<std::string>& targetNames() {
  static const std::vector<std::string> kNames{"noise", "slanted plate", "upright plates",
                                               "gyroid"};
  return kNames;
}

Outcome collisions(const std::vector<Detector>& all, const std::string& name, long count,
                   unsigned seed) {
  const arcs::Target target = targetOf(name, seed);
  Outcome outcome;
  WorkPrecision work{"Arcs in " + name + ": wrong answers",
                     "Share of the arcs that meet the surface which were missed or met later than "
                     "1e-3 voxel, against the time of an arc.",
                     "CPU of an arc [us]", "wrong of the arcs that meet [%]"};
  Table table{
      "Arcs",
      {"target", "method", "setting", "arcs", "meet", "missed", "late", "latest [voxel]", "early"},
      {}};
  for (const Detector& detector : all) {
    datasets::Random random{seed};
    // look-ups alone: an arc is no tick
    WorkPoint point{
        detector.method, detector.setting, {}, {}, comparison::MeanCounts{0.0, NAN, NAN, NAN}};
    double samples = 0.0;
    const arcs::Detect timed = [&](const arcs::Target& at, double s, const arcs::Arc& arc) {
      const std::int64_t begun = haptics::Budget::threadTime();
      const arcs::Crossing crossing = detector.detect(at, s, arc);
      point.cost.push_back(1e-3 * double(haptics::Budget::threadTime() - begun));
      samples += double(crossing.counts.samples);
      return crossing;
    };
    const arcs::Tally tally = arcs::shootPoints(target, count, random, timed);
    point.counts->samples = samples / double(tally.arcs);
    const long meet = tally.met + tally.missed;
    point.error = {100.0 * double(tally.missed + tally.late) / double(std::max(1L, meet))};
    table.rows.push_back({name, detector.method, detector.setting, shortly(double(tally.arcs)),
                          shortly(double(meet)), shortly(double(tally.missed)),
                          shortly(double(tally.late)), shortly(tally.latest),
                          shortly(double(tally.early))});
    work.points.push_back(std::move(point));
    if (&detector != &all.front()) continue;
    const auto none = [&](const char* what, double value, const char* note) {
      outcome.cases.push_back(
          {"arcs in " + name + ": " + what, value, 0.0, "arcs", Case::Sense::AtMost, note});
    };
    none("missed", double(tally.missed), "Inside somewhere on the way, and not stopped.");
    none("late", double(tally.late),
         "Stopped more than 1e-3 voxel of path beyond the surface, and not at it.");
    none("early", double(tally.early),
         "Stopped where F is below what sagitta, root and guard amount to.");
    outcome.cases.push_back({"arcs in " + name + ": that meet the surface", double(meet), 1.0,
                             "arcs", Case::Sense::AtLeast,
                             "Else the two above would say nothing."});
  }
  addTo(outcome, work);
  outcome.tables.push_back(std::move(table));
  return outcome;
}

}  // namespace study::accuracy
