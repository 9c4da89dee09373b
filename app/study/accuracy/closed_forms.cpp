// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/closed_forms.h"

#include <cmath>
#include <numbers>

#include "app/study/accuracy/contenders.h"
#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/measures.h"
#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/shapes.h"
#include "haptics/proxy/tick.h"

namespace study::accuracy {
namespace {

using comparison::Limit;
using datasets::Random;

constexpr double kStiffness = 1000.0;   // N/m, of every method
constexpr double kBall = 3e-3;          // m, radius
constexpr int kBallPoints = 1000;       // 0.35 mm apart: the ball bulges 5 um between them
constexpr int kCarry = 40, kHold = 60;  // ticks

/// From outside, up to 45 degrees aside.
Vec3 aside(const Vec3& D, const Vec3& P, Random& random) {
  const Vec3 out = (P - D).normalized();
  return P + 3e-3 * out + 3e-3 * random.in(0.0, 1.0) * out.unitOrthogonal();
}

AnalyticHold onHalfSpace(double radius, Random& random) {
  const Vec3 D{random.in(-0.015, 0.015), random.in(-0.015, 0.015),
               radius - 4e-3 * random.in(0.1, 1)};
  return {{D.x(), D.y(), 6e-3}, D, {D.x(), D.y(), 0.0}, Vec3::UnitZ()};
}

AnalyticHold onSphere(double radius, Random& random) {
  const double R = datasets::shapes::Sphere{}.radius;
  const Vec3 D = (R - random.in(1e-3, 5e-3)) * random.direction(), out = D.normalized();
  return {aside(D, (R + radius) * out, random), D, R * out, out};
}

AnalyticHold onCylinder(double radius, Random& random) {
  const double R = datasets::shapes::Cylinder{}.radius;
  const double angle = random.in(0.0, 2.0 * std::numbers::pi), depth = random.in(1e-3, 4e-3);
  const Vec3 out{0.0, std::cos(angle), std::sin(angle)};
  const Vec3 axis{random.in(-0.01, 0.01), 0.0, 0.0};
  const Vec3 D = axis + (R - depth) * out;
  return {aside(D, axis + (R + radius) * out, random), D, axis + R * out, out};
}

/// Both walls press: the device below the edge, within the cone of their normals.
AnalyticHold inWedge(double radius, Random& random) {
  const datasets::shapes::Wedge wedge;
  const Vec3 base{0.0, random.in(-0.01, 0.01), wedge.bottom};
  const Vec3 along = Vec3::UnitZ() / std::sin(wedge.half_angle);
  const Vec3 P = base + radius * along;
  const double depth = random.in(1e-3, 4e-3);
  return {P + Vec3{random.in(-1e-3, 1e-3), 0, 5e-3},
          P + Vec3{random.in(-0.4, 0.4) * depth, 0, -depth}, base, along};
}

/// On the floor, at the wall, or in the corner of both.
AnalyticHold inSlot(double radius, int which, Random& random) {
  const datasets::shapes::Slot slot;
  const double wall = slot.half_width - radius, floor = slot.floor + radius;
  const double y = random.in(-0.01, 0.01), x = random.in(-0.7, 0.7) * wall,
               deep = random.in(1e-3, 4e-3);
  const Vec3 start{0.0, y, floor + 4e-3};
  switch (which) {
    case 0:
      return {start, {x, y, floor - deep}, {x, y, slot.floor}, Vec3::UnitZ()};
    case 1:
      return {start,
              {wall + deep, y, floor + 3e-3},
              {slot.half_width, y, floor + 3e-3},
              -Vec3::UnitX()};
    default:
      return {start,
              {-wall - deep, y, floor - random.in(1e-3, 4e-3)},
              {-slot.half_width, y, slot.floor},
              Vec3::UnitX() + Vec3::UnitZ(),
              true};
  }
}

Contenders contendersOn(const comparison::Touched& scene, const haptics::Tool& tool,
                        const OursMade& judged) {
  Contenders all;
  for (const Reading& reading : kReadings)
    for (const double fineness : {2.0, 10.0, 50.0}) {
      reference::Choices choices = reference::choicesFor(scene.volume->grid, reading.variant);
      choices.epsilon = choices.feature / fineness;
      all.add(reading.name, "epsilon f/" + shortly(fineness),
              comparison::rival(scene, tool.shell, choices));
    }
  for (const Kind& kind : kKinds) {
    const auto built = haptics::makeScene(scene.volume, tool, {kind.field, kind.normal}).value();
    // a tenth of the tick's work, all of it, and as much as it likes
    for (const std::int64_t work :
         {haptics::kTickWork / 10, haptics::kTickWork, 50 * haptics::kTickWork})
      all.add(kind.name, "work " + shortly(double(work)),
              judged && &kind == kKinds && work == haptics::kTickWork
                  ? judged(built, scene.isovalue)
                  : comparison::ours(built, scene.isovalue, Limit{0, work}));
  }
  return all;
}

/// Diagrams of what some contenders did.
struct Diagrams {
  WorkPrecision position, angle;
  explicit Diagrams(const std::string& what)
      : position{what + ": position",
                 "Distance of the settled proxy from the closed form, against time.",
                 "mean CPU of a tick [us]", "error of position [um]"},
        angle{what + ": direction of the force",
              "Angle between the force and the closed form's, against time.",
              "mean CPU of a tick [us]", "error of direction [degrees]"} {}
  void addTo(Outcome& outcome) const {
    accuracy::addTo(outcome, position);
    accuracy::addTo(outcome, angle);
  }
};

/// Leads all through the holds as often as asked, run by run; what the first run came to.
std::vector<HeldErrors> ledThrough(Contenders& all, const std::vector<AnalyticHold>& holds,
                                   double radius, int runs, Diagrams& diagrams) {
  std::vector<HeldErrors> first;
  for (int run = 0; run < runs; ++run)
    for (std::size_t m = 0; m < all.methods.size(); ++m) {
      HeldErrors errors = heldErrors(*all.methods[m], holds, radius);
      if (run == 0) {
        const auto& [method, setting] = all.names[m];
        diagrams.position.points.push_back(
            {method, setting, {}, errors.position_um, errors.counts});
        diagrams.angle.points.push_back({method, setting, {}, errors.angle_deg, errors.counts});
      }
      for (WorkPrecision* work : {&diagrams.position, &diagrams.angle}) {
        WorkPoint& point = work->points[m];
        point.cost.insert(point.cost.end(), errors.tick_us.begin(), errors.tick_us.end());
        point.runs.push_back(comparison::mean(errors.tick_us));
      }
      if (run == 0) first.push_back(std::move(errors));
    }
  return first;
}

/// The cases on ours.
void judge(Outcome& outcome, const std::string& what, const HeldErrors& errors,
           const std::vector<AnalyticHold>& holds, bool ball, const comparison::Touched& scene,
           const haptics::PointShell& shell) {
  const double voxel_um = 1e6 * scene.volume->grid.spacing.minCoeff();
  const auto worst = [&](const std::vector<double>& values, bool corner) {
    double most = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n)
      if (holds[n].corner == corner) most = worse(most, values[n]);
    return most;
  };
  const auto claim = [&](const std::string& which, double value, double bound, const char* unit,
                         const std::string& note) {
    outcome.cases.push_back({what + ": " + which, value, bound, unit, Case::Sense::AtMost, note});
  };
  for (const bool corner : {false, true}) {
    if (std::ranges::none_of(holds, [&](const auto& hold) { return hold.corner == corner; }))
      continue;
    // a lone point is held short of a corner by central differences, which round it
    const bool rounded = corner && !ball;
    const double voxels = rounded ? 0.35 : 0.1;
    const std::string where = corner ? ", in its corner" : "";
    const std::string why =
        rounded ? "Central differences round a corner over a voxel on either side: a lone "
                  "point is held a third of a voxel short of it."
                : "The worst of the holds.";
    claim("position of ours" + where, worst(errors.position_um, corner), voxels * voxel_um, "um",
          why);
    claim("direction of our force" + where, worst(errors.angle_deg, corner), rounded ? 6.0 : 1.0,
          "degrees", why);
    claim("size of our force" + where, worst(errors.magnitude, corner), voxels * voxel_um / 400.0,
          "", "Relative; the bound on position over the least depth of the device, 0.4 mm. " + why);
  }
  double off = 0.0;
  for (const double newton : errors.own_force) off = worse(off, newton);
  claim("our force and the poses of its tick", off, 1e-9, "N",
        "In every tick on the way, so that a force that lags is seen.");
  double deepest = 0.0;
  for (const Pose& X_WP : errors.settled)
    deepest = std::max(
        deepest, evaluator::penetration_mm(*scene.volume, scene.isovalue, shell.points, X_WP));
  claim("penetration of ours", deepest, 0.0, "mm", "Settled, in double.");
}

}  // namespace

const std::vector<std::string>& analyticSolids() {
  static const std::vector<std::string> kNames{"halfspace", "sphere", "cylinder", "wedge", "slot"};
  return kNames;
}

std::vector<AnalyticHold> analyticHolds(const std::string& solid, double radius, int count,
                                        unsigned seed) {
  Random random{seed};
  std::vector<AnalyticHold> holds;
  for (int n = 0; n < count; ++n)
    holds.push_back(solid == "halfspace"  ? onHalfSpace(radius, random)
                    : solid == "sphere"   ? onSphere(radius, random)
                    : solid == "cylinder" ? onCylinder(radius, random)
                    : solid == "wedge"    ? inWedge(radius, random)
                                          : inSlot(radius, n % 3, random));
  return holds;
}

HeldErrors heldErrors(comparison::Method& method, const std::vector<AnalyticHold>& holds,
                      double radius) {
  HeldErrors errors;
  const std::size_t ticks = holds.size() * (kCarry + kHold);
  for (const AnalyticHold& hold : holds) {
    method.start(haptics::poseOf(hold.start, haptics::Quat::Identity()));
    comparison::Tick last;
    for (int n = 1; n <= kCarry + kHold; ++n) {
      const double share = std::min(1.0, double(n) / kCarry);
      const Pose X_WD = haptics::poseOf(hold.start + share * (hold.device - hold.start),
                                        haptics::Quat::Identity());
      last = method.tick(X_WD);
      errors.tick_us.push_back(1e-3 * double(last.cpu_ns));
      errors.counts.add(last, ticks);
      const Vec3 own = kStiffness * (last.X_WP.translation() - X_WD.translation());
      errors.own_force.push_back((last.force - own).norm());
    }
    errors.settled.push_back(last.X_WP);
    const Vec3 P = hold.answer(radius), force = kStiffness * (P - hold.device);
    errors.position_um.push_back(1e6 * (last.X_WP.translation() - P).norm());
    errors.angle_deg.push_back(std::atan2(last.force.cross(force).norm(), last.force.dot(force)) *
                               180.0 / std::numbers::pi);
    errors.magnitude.push_back(std::abs(last.force.norm() / force.norm() - 1.0));
  }
  return errors;
}

Outcome closedForms(const std::string& solid, const HeldEffort& effort, unsigned seed,
                    const OursMade& ours) {
  Outcome outcome;
  for (const bool ball : {false, true}) {
    datasets::Phantom phantom = datasets::makePhantom(solid).value();
    const comparison::Touched scene{
        solid, std::make_shared<const haptics::Volume>(std::move(phantom.volume)), phantom.isovalue,
        "", 0};
    const haptics::Tool tool =
        ball ? comparison::ballTool(kBallPoints, kBall) : comparison::toolOf({Vec3::Zero()});
    double radius = ball ? kBall : 0.0;
    if (ball && solid == "halfspace") {
      // the lowest point of the ball's shell stands a little above the ball's own
      radius = 0.0;
      for (const Vec3& p : tool.shell.points) radius = std::max(radius, -p.z());
    }
    const std::vector<AnalyticHold> holds = analyticHolds(solid, radius, effort.holds, seed);
    const std::string what = std::string{ball ? "Ball" : "Point"} + " held in the " + solid;
    Contenders all = contendersOn(scene, tool, ours);
    Diagrams diagrams{what};
    const auto errors = ledThrough(all, holds, radius, effort.runs, diagrams);
    const auto judged = std::ranges::find_if(all.names, [](const auto& name) {
      return name.method == "ours" && name.setting == kCounted;
    });
    judge(outcome, what, errors[static_cast<std::size_t>(judged - all.names.begin())], holds, ball,
          scene, tool.shell);
    diagrams.addTo(outcome);
    if (!effort.every_fineness) continue;
    const auto built = haptics::makeScene(scene.volume, tool).value();
    Contenders finer = withFineness(*built, scene.isovalue, {});
    Diagrams swept{what + ", epsilon and sub-steps of ours"};
    ledThrough(finer, holds, radius, effort.runs, swept);
    swept.addTo(outcome);
  }
  return outcome;
}

}  // namespace study::accuracy
