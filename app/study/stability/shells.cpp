// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>

#include "app/study/stability/failures.h"
#include "haptics/coupling/safety.h"
#include "haptics/solver/constrained_motion.h"

namespace study::stability {
namespace {

using haptics::ScalarType;

void tellContact(const std::string& name, const Trial& trial, Outcome& outcome) {
  outcome.cases.push_back(
      {name + "/ticks in contact", double(trial.contact), 1.0, "", Case::Sense::AtLeast});
  Watch watch;
  watch.add(trial);
  watch.tell(name, outcome);
}

// from a pair to a paper's worst case many times over, all of them flat on the wall
Outcome coplanar(int tries, std::uint64_t) {
  Outcome outcome;
  Watch watch;
  Plot plot{"Contacts in one plane",
            "How far a plate of so many points is behind at most as it slides at 20 mm/s",
            {"points", Scale::Log},
            {"behind [mm]", Scale::Log}};
  Series behind{"most", {}};
  const auto volume = std::make_shared<const haptics::Volume>(
      datasets::sampledFloat(cube(64), [](const Vec3& p) { return 1000.0 - 4e6 * p.z(); }));
  for (const int count : {2, 100, 784, 7225}) {
    const auto points = count == 2
                            ? std::vector<Vec3>{{-0.02, 0, 0}, {0.02, 0, 0}}
                            : datasets::platePoints(int(std::lround(std::sqrt(count))), 0.04);
    const auto scene = haptics::makeScene(volume, toolOf(points)).value();
    Trial trial{scene, 1000.0, at(-0.006, 0, 2e-3)};
    trial.carry(at(-0.006, 0, 2e-3), at(-0.006, 0, -1e-3), 30);
    double worst = 0.0;
    const int ticks = tries > 1 ? 600 : 150;
    for (int n = 1; n <= ticks; ++n) {
      const double x = -0.006 + 20e-6 * n;
      trial.step(at(x, 0, -1e-3));
      worst = std::max(worst, std::abs(trial.place().x() - x));
    }
    const Pose D = at(-0.006 + 20e-6 * ticks, 0, -1e-3);
    const Vec3 rest = D.translation() + Vec3{0, 0, 1e-3 + scene->lengths.rest_gap};
    int took = 0;
    while ((trial.place() - rest).norm() > 0.01 * h && took < 100) {
      trial.step(D);
      ++took;
    }
    const std::string name = "F7 " + shortly(count) + " contacts in one plane";
    outcome.cases.push_back({name + "/behind, most", 1e3 * worst, 0.02, "mm"});
    outcome.cases.push_back({name + "/ticks to rest", double(took), 5.0, ""});
    watch.add(trial);
    behind.points.push_back({double(count), 1e3 * worst});
  }
  watch.tell("F7 contacts in one plane", outcome);
  plot.series.push_back(std::move(behind));
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

// the proxy of very many points goes where that of few goes
Outcome manyPoints(int tries, std::uint64_t) {
  Outcome outcome;
  const int count = tries > 1 ? 200'000 : 50'000;
  double coupling[2] = {};
  Watch watch;
  for (const bool is_many : {false, true}) {
    const auto scene = sphere(toolOf(datasets::rodPoints(is_many ? count : 2000, 0.06, 2e-3)));
    Trial trial{scene, datasets::kSolidIso, at(0, 0, 0.03)};
    trial.judged = !is_many;
    trial.carry(at(0, 0, 0.03), at(0, 0, 0.019), 60);
    const int ticks = 400;
    for (int n = 0; n < ticks; ++n) {
      const Pose D = at({0.01 * std::sin(4e-3 * n), 0, 0.019},
                        Quat{Eigen::AngleAxisd{0.3 * std::sin(3e-3 * n), Vec3::UnitY()}});
      trial.step(D);
      coupling[is_many] += (trial.place() - D.translation()).norm() / ticks;
      if (is_many && n % 100 == 0) trial.illegal += !trial.isLegal();
    }
    watch.add(trial);
  }
  const std::string name = "F6c " + shortly(count) + " points";
  outcome.cases.push_back({name + "/coupling distance", 1e3 * coupling[1],
                           1.1e3 * coupling[0] + 0.2, "mm", Case::Sense::AtMost,
                           "that of 2,000 points, a tenth and 0.2 mm"});
  watch.tell(name, outcome);
  return outcome;
}

// voxels near the top of 32 bits, where a float cannot tell neighbours apart
Outcome beyondFloat(int tries, std::uint64_t) {
  Outcome outcome;
  const auto scene = sceneOf(
      datasets::filled(cube(48), ScalarType::UInt32,
                       [](auto, auto, auto k) { return 4.0e9 - 100.0 * (double(k) - 24.0); }),
      ball(200, 3e-3));
  // half a voxel above the grid's middle
  const double plane = 0.5 * h;
  Trial trial{scene, 4.0e9, at(-0.01, 0, 0.012)};
  trial.carry(at(-0.01, 0, 0.012), at(-0.01, 0, 2e-3), 40);
  double worst = 0.0;
  const int ticks = tries > 1 ? 2000 : 1000;
  for (int n = 0; n < ticks; ++n) {
    const double x = 1e-5 * n - 0.01;
    trial.step(at(x, 0, 2e-3));
    worst = std::max(worst, std::abs(trial.place().x() - x));
  }
  const std::string name = "F12 values that a float cannot hold";
  outcome.cases.push_back({name + "/behind, most", 1e3 * worst, 0.02, "mm"});
  outcome.cases.push_back(
      {name + "/from the rest gap",
       1e3 * std::abs(trial.lowest(Vec3::UnitZ()) - plane - scene->lengths.rest_gap), 0.02, "mm"});
  tellContact(name, trial, outcome);
  return outcome;
}

Outcome fewPoints(int tries, std::uint64_t seed) {
  Outcome outcome;
  const auto volume = std::make_shared<const haptics::Volume>(
      datasets::solid(cube(40), [](const Vec3& p) { return p.norm() - 0.012; }));
  // no point at all is refused, with a reason, where the tool is made
  outcome.cases.push_back({"no point/tools accepted", haptics::makeShell({}) ? 1.0 : 0.0, 0.0, ""});
  for (const auto& points :
       {std::vector<Vec3>{Vec3::Zero()}, std::vector<Vec3>{{0, 0, 0}, {0, 0, 5e-3}},
        std::vector<Vec3>{{0, 0, 0}, {0, 0, 5e-3}, {0, 0, 1e-2}}}) {
    Trial trial{haptics::makeScene(volume, toolOf(points)).value(), datasets::kSolidIso,
                at(0, 0, 0.03)};
    drag(trial, Vec3::Zero(), 0.012, unsigned(125 + seed), 20 * tries);
    tellContact(
        shortly(double(points.size())) + (points.size() == 1 ? " point" : " points in line"), trial,
        outcome);
  }
  return outcome;
}

// a needle: about its own axis it turns a million times as easily as across
Outcome needle(int tries, std::uint64_t seed) {
  Outcome outcome;
  // the inertia is regularised by 1e-6 r², so a line of points has the worst condition there is:
  // the metric's, over lengths and turns together, is made 1e12 by its unit of length
  const double length = 0.12;
  auto shell = haptics::makeShell(datasets::rodPoints(200, length, 1e-7)).value();
  const auto scene = sphere({"needle", {}, shell});
  Eigen::Matrix<double, 6, 6> metric = Eigen::Matrix<double, 6, 6>::Identity();
  metric.bottomRightCorner<3, 3>() = scene->metric.inertia();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> values{metric};
  Trial trial{scene, datasets::kSolidIso, at(0, 0, 0.04)};
  drag(trial, Vec3::Zero(), 0.025, unsigned(141 + seed), 20 * tries);
  const std::string name = "mass metric of a needle";
  outcome.remarks.push_back(
      "The needle's mass metric has a condition of " +
      shortly(values.eigenvalues().maxCoeff() / values.eigenvalues().minCoeff()) + " in SI units.");
  tellContact(name, trial, outcome);
  return outcome;
}

// the projection by itself, with a metric conditioned 1e12: optimal, by the conditions that make
// it so
Outcome illConditioned(int tries, std::uint64_t seed) {
  Outcome outcome;
  Random random{unsigned(142 + seed)};
  constexpr int kMostRows = 12;
  std::array<double, kMostRows> worst_of{};
  int inexact = 0;
  for (int n = 0; n < 200 * tries; ++n) {
    const Quat q = random.rotation();
    const haptics::Mat3 R = q.toRotationMatrix();
    const haptics::Mat3 inertia =
        R * Vec3{1e-12, 1e-6 * random.in(0.1, 1.0), 1.0}.asDiagonal() * R.transpose();
    const haptics::MassMetric metric{inertia};
    double& worst = worst_of[std::size_t(n % kMostRows)];
    std::vector<haptics::MotionRow> rows;
    for (int k = 0; k < 1 + n % kMostRows; ++k)
      rows.push_back({random.direction(), random.box(0.05), random.in(0.0, 1e-4)});
    const haptics::Twist free{random.box(1e-2), random.box(0.2)};
    const haptics::ConstrainedMotion found =
        haptics::constrainedMotion(free, rows, metric, haptics::Mat3::Identity());
    inexact += found.status != haptics::ConstrainedMotion::Status::Exact;
    // M (V - V_free) = sum of reactions, none of which pulls, and no row is broken
    haptics::Vector6 left = found.whitened - metric.whitened(free, haptics::Mat3::Identity());
    const double size = metric.whitened(free, haptics::Mat3::Identity()).norm();
    double scale = size;
    for (int k = 0; k < found.active; ++k) {
      const haptics::MotionRow& row = rows[std::size_t(found.bearing[std::size_t(k)])];
      const haptics::Vector6 a = metric.row(row.n_W, row.r_W, haptics::Mat3::Identity());
      left -= found.reaction[std::size_t(k)] * a;
      scale = std::max(scale, std::abs(found.reaction[std::size_t(k)]) * a.norm());
      worst = worse(worst, -found.reaction[std::size_t(k)] * a.norm() / scale);
    }
    worst = worse(worst, left.norm() / scale);
    for (const haptics::MotionRow& row : rows) {
      const haptics::Vector6 a = metric.row(row.n_W, row.r_W, haptics::Mat3::Identity());
      worst = worse(worst, -(a.dot(found.whitened) + row.room) / (a.norm() * scale));
    }
  }
  const std::string name = "mass metric conditioned 1e12";
  Plot plot{name + ": residual of the projection",
            "Largest violation of what makes a motion optimal, by the number of contacts",
            {"contacts"},
            {"residual", Scale::Log}};
  Series series{"most", {}};
  double worst = 0.0;
  for (int k = 0; k < kMostRows; ++k) {
    worst = worse(worst, worst_of[std::size_t(k)]);
    series.points.push_back({k + 1.0, worst_of[std::size_t(k)]});
  }
  plot.series.push_back(std::move(series));
  outcome.plots.push_back(std::move(plot));
  outcome.cases.push_back({name + "/residual of the optimum's conditions", worst, 1e-9, "",
                           Case::Sense::AtMost,
                           "relative, in whitened coordinates; the projection may leave a row "
                           "1e-10 short"});
  outcome.cases.push_back({name + "/projections that were not exact", double(inexact), 0.0, ""});
  return outcome;
}

Outcome largeAndFar(int tries, std::uint64_t seed) {
  Outcome outcome;
  {
    const auto scene = sceneOf(
        datasets::solid(cube(24), [](const Vec3& p) { return p.norm() - 0.008; }), ball(400, 0.1));
    Trial trial{scene, datasets::kSolidIso, at(0.15, 0, 0)};
    drag(trial, Vec3::Zero(), 0.13, unsigned(123 + seed), 10 + 20 * tries);
    tellContact("tool eight times as wide as the volume", trial, outcome);
  }
  Vec3 settled[2];
  for (const int k : {0, 1}) {
    const Vec3 far = k * Vec3{10.0, -10.0, 10.0};
    haptics::Grid grid = cube(40, 3e-4);
    grid.origin += far;
    const auto scene =
        sceneOf(datasets::sampledFloat(grid,
                                       [&](const Vec3& p) {
                                         return 1000.0 - 1e7 * std::clamp((p - far).norm() - 0.004,
                                                                          -1e-3, 1e-3);
                                       }),
                ball(100, 1e-3));
    const Pose from = at(far + Vec3{0, 0, 0.01}), D = at(far + Vec3{0, 0, 0.003});
    Trial trial{scene, 1000.0, from};
    drag(trial, far, 0.005, unsigned(127 + seed), 10 * tries);
    trial.hold(from, 60);
    trial.carry(from, D, 40);
    trial.hold(D);
    settled[k] = trial.place() - far;
    if (k == 1) tellContact("origin at 10 m", trial, outcome);
  }
  outcome.cases.push_back({"origin at 10 m/from where it settles at home",
                           1e3 * (settled[1] - settled[0]).norm(), 3e-4, "mm", Case::Sense::AtMost,
                           "a thousandth of a voxel"});
  return outcome;
}

// what the hand is asked for stays within the rating, with its direction, however far it pulls
Outcome saturation(int, std::uint64_t) {
  Outcome outcome;
  const auto scene = sphere(ball(200, 3e-3));
  const haptics::ForceLimits limits{3.3, 0.05, 0.0, 0.02};
  haptics::Safety safety{limits};
  Trial trial{scene, datasets::kSolidIso, at(0, 0, 0.03)};
  trial.coupling.stiffness = 20'000.0;
  double most = 0.0, torque = 0.0, least_turn = 1.0;
  Trace wanted{"wanted", 5}, sent{"sent", 5};
  for (int n = 0; n < 400; ++n) {
    const double down = n < 200 ? n : 400 - n;
    const Pose D =
        at({0.004, 0, 0.03 - 1e-4 * down}, Quat{Eigen::AngleAxisd{0.01 * down, Vec3::UnitX()}});
    const haptics::Wrench asked = trial.step(D).wrench_W;
    safety.begin({.armed = true, .ready = true});
    const haptics::Wrench got = safety.pass(asked, trial.last.outside, 1e-3);
    most = std::max(most, got.force.norm());
    torque = std::max(torque, got.torque.norm());
    if (asked.force.norm() > 0.0)
      least_turn = -worse(-least_turn,
                          -got.force.dot(asked.force) / (got.force.norm() * asked.force.norm()));
    wanted.add(n, asked.force.norm());
    sent.add(n, got.force.norm());
  }
  outcome.cases.push_back({"saturation/force", most, limits.force * (1.0 + 1e-12), "N"});
  outcome.cases.push_back({"saturation/torque", torque, limits.torque * (1.0 + 1e-12), "N m"});
  outcome.cases.push_back({"saturation/cosine to the wanted direction", least_turn, 1.0 - 1e-12, "",
                           Case::Sense::AtLeast});
  tellContact("saturation", trial, outcome);
  Plot plot = overTime(
      "Saturation", "Force wanted by 20,000 N/m and force sent to a device of 3.3 N", "force [N]");
  plot.y.scale = Scale::Log;
  plot.series = {wanted.series(), sent.series()};
  plot.bound = limits.force;
  plot.bound_name = "rating";
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

}  // namespace

std::vector<Job> shells(int tries) {
  const auto job = [&](std::string name, double cost, Outcome (*run)(int, std::uint64_t)) {
    return Job{"failures/" + std::move(name), "Points: very many, few, large and far", cost,
               [=](std::uint64_t seed) { return run(tries, seed); }};
  };
  return {job("coplanar contacts", 1.0, coplanar),
          job("very many points", 3.0, manyPoints),
          job("values beyond float", 0.5, beyondFloat),
          job("few points", 0.2 * tries, fewPoints),
          job("needle", 0.3 * tries, needle),
          job("ill-conditioned metric", 0.1 * tries, illConditioned),
          job("large and far", 0.5 * tries, largeAndFar),
          job("saturation", 0.2, saturation)};
}

}  // namespace study::stability
