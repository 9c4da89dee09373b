// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/plan/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/measurement/quantile.h"
#include "app/study/plan/left_out_work.h"
#include "haptics/proxy/cutting.h"
#include "haptics/proxy/tick.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/simulation/grip.h"
#include "resources/messages/messages.h"

namespace study::plan {
namespace {

using haptics::Budget;

std::unique_ptr<haptics::Cutting> cuttingOf(const haptics::Scene& scene) {
  haptics::CutLaw law;
  law.burr = haptics::ballAtTip(scene.tool.shell, 2e-3);
  return std::make_unique<haptics::Cutting>(haptics::CarvedScene::of(scene).value(), law);
}

/// One of the two, on its way.
struct Side {
  Side(const haptics::Scene& in, const Course& course, const haptics::Pose& X_start,
       Burr of = Burr::None)
      : burr{of},
        cutting{of == Burr::None ? nullptr : cuttingOf(in)},
        scene{cutting ? *cutting->scene() : in},
        proxy{scene, X_start},
        left_out{scene.plan, scene.tree} {
    proxy.second_look = &left_out;
    grip.gyration = std::sqrt(in.tool.shell.inertia.trace() / 3.0);
    grip.X_WD = course.hand.at(course.begin);
  }

  void step(const Course& course, int n) {
    constexpr double kPeriod = 1e-3;  // s
    if (n > 0) grip.advance(course.hand.at(course.begin + n * kPeriod), felt, kPeriod);
    Budget budget = Budget::counted(std::numeric_limits<std::int64_t>::max());
    const std::int64_t begun = Budget::threadTime();
    const haptics::TickResult result =
        haptics::tick(scene, course.isovalue, course.coupling, grip.X_WD, proxy, budget, kPeriod);
    haptics::Wrench drag;
    if (cutting)
      drag = cutting->go(burr == Burr::Held, proxy, grip.X_WD, course.isovalue, kPeriod, budget);
    spent += Budget::threadTime() - begun;
    work += budget.spent();
    felt = {result.wrench_W.force + drag.force, result.wrench_W.torque + drag.torque};
    contact_ticks += result.contacts > 0 ? 1 : 0;
  }

  Burr burr;
  std::unique_ptr<haptics::Cutting> cutting;
  const haptics::Scene& scene;
  haptics::Proxy proxy;
  LeftOutWork left_out;
  haptics::Grip grip;
  haptics::Wrench felt;
  std::int64_t spent = 0;  ///< ns
  std::int64_t work = 0;
  int contact_ticks = 0;
};

/// What it costs to read the clock twice [ns]: the same in every measurement.
double clockCost() {
  std::vector<std::int64_t> costs;
  for (int n = 0; n < 1001; ++n) {
    const std::int64_t begun = Budget::threadTime();
    costs.push_back(Budget::threadTime() - begun);
  }
  std::nth_element(costs.begin(), costs.begin() + 500, costs.end());
  return double(costs[500]);
}

double quantileOf(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return measurement::quantile(values, q);
}

std::shared_ptr<const haptics::Scene> rebuilt(const haptics::Scene& scene,
                                              const haptics::Plan& plan) {
  return haptics::makeScene(scene.volume, scene.tool,
                            {scene.field.kind(), scene.normal, plan, scene.fineness}, &scene)
      .value();
}

const std::vector<std::string> kHead{"scene and hand", "left out",
                                     "because",        "mean tick [us]",
                                     "if not [us]",    "time saved [%], median (p10 to p90)",
                                     "work a tick",    "if not",
                                     "pose apart [m]", "force apart [N]"};
// ticks in contact: fewer would prove nothing. A jerk is at the surface for one or two at a time
constexpr double kEnough = 10.0;
const char* const kCaption = "What is left out, what that saves, and what it changes";

/// One comparison as cases and a row.
void report(const Course& course, const std::string& what, const std::string& why,
            const Comparison& found, Outcome& outcome) {
  const std::string name = course.name + ": " + what;
  const std::string note = "largest of " + std::to_string(found.ticks) + " ticks, of which " +
                           std::to_string(found.contact_ticks) + " in contact";
  // nothing compared is no proof
  const double unknown = found.ticks > 0 ? 0.0 : INFINITY;
  const auto add = [&](const char* measure, double value, const char* unit) {
    outcome.cases.push_back(
        {name + ": " + measure, value + unknown, 0.0, unit, Case::Sense::AtMost, note});
  };
  add("pose", found.pose, "m");
  add("force", found.force, "N");
  add("torque", found.torque, "N·m");
  if (found.ticks == 0) return;
  std::vector<double> saved;
  for (std::size_t n = 0; n < found.first_us.size(); ++n)
    saved.push_back(100.0 * (1.0 - found.first_us[n] / found.second_us[n]));
  outcome.tables.front().rows.push_back(
      {course.name, what, why, shortly(quantileOf(found.first_us, 0.5)),
       shortly(quantileOf(found.second_us, 0.5)),
       shortly(quantileOf(saved, 0.5)) + " (" + shortly(quantileOf(saved, 0.1)) + " to " +
           shortly(quantileOf(saved, 0.9)) + ")",
       shortly(found.first_work), shortly(found.second_work), shortly(found.pose),
       shortly(found.force)});
}

}  // namespace

Comparison compared(const Course& course, const haptics::Scene& first, const haptics::Scene& second,
                    int runs, Burr burr) {
  Comparison found;
  const auto start = haptics::legalPoseNear(first, course.isovalue, course.hand.at(course.begin));
  if (!start) return found;
  const double radius = first.tool.shell.radius, clock = clockCost();
  for (int run = 0; run < runs; ++run) {
    Side a{first, course, *start}, b{second, course, *start, burr};
    for (int n = 0; n < course.ticks; ++n) {
      // in turn, so that neither always finds the caches warm
      Side& earlier = n % 2 == 0 ? a : b;
      Side& later = n % 2 == 0 ? b : a;
      earlier.step(course, n);
      later.step(course, n);
      const haptics::Pose &X = a.proxy.X_WP, &Y = b.proxy.X_WP;
      found.pose = worse(found.pose, (X.translation() - Y.translation()).norm() +
                                         radius * (X.linear() - Y.linear()).norm());
      found.force = worse(found.force, (a.felt.force - b.felt.force).norm());
      found.torque = worse(found.torque, (a.felt.torque - b.felt.torque).norm());
    }
    const auto mean_us = [&](const Side& side) {
      return std::max(0.0, double(side.spent) / course.ticks - clock) * 1e-3;
    };
    found.first_us.push_back(mean_us(a));
    found.second_us.push_back(mean_us(b));
    found.ticks = course.ticks;
    found.contact_ticks = a.contact_ticks;
    found.first_work = double(a.work) / course.ticks;
    found.second_work = double(b.work) / course.ticks;
  }
  return found;
}

std::optional<std::int64_t> workOf(const Course& course, Burr burr,
                                   const std::function<void()>& begin) {
  const haptics::Scene& scene = *course.scene;
  const auto start = haptics::legalPoseNear(scene, course.isovalue, course.hand.at(course.begin));
  if (!start) return {};
  Side side{scene, course, *start, burr};
  begin();
  for (int n = 0; n < course.ticks; ++n) side.step(course, n);
  return side.work;
}

std::shared_ptr<const haptics::Scene> without(const haptics::Scene& scene,
                                              bool haptics::Plan::*omission) {
  haptics::Plan plan = scene.plan;
  plan.*omission = false;
  return rebuilt(scene, plan);
}

std::shared_ptr<const haptics::Scene> withEverything(const haptics::Scene& scene) {
  haptics::Plan plan;
  for (const haptics::PlanLine& line : scene.planned) plan.*line.omission = false;
  return rebuilt(scene, plan);
}

Outcome examined(const Course& course, int runs) {
  Outcome outcome;
  outcome.tables = {{kCaption, kHead, {}}};
  for (const haptics::PlanLine& line : course.scene->planned) {
    if (!line.left_out) {
      std::vector<std::string> row(kHead.size());
      row[0] = course.name;
      row[1] = "not left out here: " + resources::sentence(line.what);
      row[2] = resources::sentence(line.why);
      outcome.tables.front().rows.push_back(row);
      continue;
    }
    report(course, resources::sentence(line.what), resources::sentence(line.why),
           compared(course, *course.scene, *without(*course.scene, line.omission), runs), outcome);
  }
  const Comparison all = compared(course, *course.scene, *withEverything(*course.scene), runs);
  report(course, "all of these", "each of them", all, outcome);
  if (course.touches)
    outcome.cases.push_back({course.name + ": ticks in contact", double(all.contact_ticks), kEnough,
                             "", Case::Sense::AtLeast,
                             "a hand that touches nothing would prove nothing"});
  if (all.ticks == 0) return outcome;
  const auto points = double(course.scene->tree.size());
  const auto series = [&](const char* name, const std::vector<double>& us) {
    return Series{
        name, {{points, quantileOf(us, 0.5), quantileOf(us, 0.1), quantileOf(us, 0.9)}}, false};
  };
  outcome.plots.push_back(
      {"Mean tick by points of the tool",
       "Time of a tick against the number of points, as planned and with nothing left out; one "
       "mark "
       "for each scene. Bars: p10 to p90 of the runs.",
       {"points of the tool", Scale::Log},
       {"mean tick [us]", Scale::Log},
       {series("as planned", all.first_us), series("nothing left out", all.second_us)}});
  return outcome;
}

Outcome uncut(const Course& course, int runs, Burr burr) {
  Outcome outcome;
  const Comparison found = compared(course, *course.scene, *course.scene, runs, burr);
  const double unknown = found.ticks > 0 ? 0.0 : INFINITY;
  const auto none = [&](const char* measure, double value, const char* unit) {
    outcome.cases.push_back({course.name + ": a burr that is not held: " + measure, value + unknown,
                             0.0, unit, Case::Sense::AtMost,
                             "largest of " + std::to_string(found.ticks) + " ticks"});
  };
  none("pose apart", found.pose, "m");
  none("force apart", found.force, "N");
  none("torque apart", found.torque, "N·m");
  none("work of a tick, more", std::abs(found.second_work - found.first_work), "units");
  if (course.touches)
    outcome.cases.push_back({course.name + ": a burr that is not held: ticks in contact",
                             double(found.contact_ticks), kEnough, "", Case::Sense::AtLeast,
                             "a hand that touches nothing would prove nothing"});
  if (found.ticks == 0) return outcome;
  std::vector<double> more;
  for (std::size_t n = 0; n < found.first_us.size(); ++n)
    more.push_back(100.0 * (found.second_us[n] / found.first_us[n] - 1.0));
  outcome.tables.push_back(
      {"A tool that could cut and does not, against one without a burr",
       {"scene and hand", "mean tick without [us]", "with [us]", "more [%], median (p10 to p90)",
        "work a tick without", "with", "pose apart [m]", "force apart [N]"},
       {{course.name, shortly(quantileOf(found.first_us, 0.5)),
         shortly(quantileOf(found.second_us, 0.5)),
         shortly(quantileOf(more, 0.5)) + " (" + shortly(quantileOf(more, 0.1)) + " to " +
             shortly(quantileOf(more, 0.9)) + ")",
         shortly(found.first_work), shortly(found.second_work), shortly(found.pose),
         shortly(found.force)}}});
  return outcome;
}

}  // namespace study::plan
