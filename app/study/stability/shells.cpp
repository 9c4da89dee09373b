// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>

#include "app/study/stability/failures.h"
#include "haptics/coupling/safety.h"
#include "haptics/solver/constrained_motion.h"

namespace study::stability {
namespace {

// from a pair to a paper's worst case many times over, all of them flat on the wall
void coplanar(Trials& found) {
  const auto volume =
      datasets::sampledFloat(cube(64), [](const Vec3& p) { return 1000.0 - 4e6 * p.z(); });
  for (const int count : {2, 100, 784, 7225}) {
    const auto points = count == 2
                            ? std::vector<Vec3>{{-0.02, 0, 0}, {0.02, 0, 0}}
                            : datasets::platePoints(int(std::lround(std::sqrt(count))), 0.04);
    const auto scene = sceneOf(volume, toolOf(points));
    const auto device = [](int n) { return at(-0.006 + 20e-6 * (n + 1), 0, -1e-3); };
    Trial& trial = found.brought(scene, 1000.0, at(-0.006, 0, 2e-3), device(-1), 30);
    const int ticks = found.tries > 1 ? 600 : 150;
    const Figures lag = trial.follow(ticks, device, [&](int n) {
      return std::abs(trial.place().x() - device(n).translation().x());
    });
    const Pose D = device(ticks - 1);
    const Vec3 rest = D.translation() + Vec3{0, 0, 1e-3 + scene->lengths.rest_gap};
    int took = 0;
    for (; (trial.place() - rest).norm() > 0.01 * h && took < 100; ++took) trial.step(D);
    trial.name = shortly(count) + " contacts";
    found.subject = "F7 " + trial.name + " in one plane";
    found.atMost("behind, most", 1e3 * lag.most, 0.02, "mm");
    found.atMost("ticks to rest", took, 5.0);
  }
}

// the proxy of very many points goes where that of few goes
void manyPoints(Trials& found) {
  const int few = 2000, many = found.tries > 1 ? 200'000 : 50'000;
  const auto device = [](int n) {
    return at({0.01 * std::sin(4e-3 * n), 0, 0.019}, turn(0.3 * std::sin(3e-3 * n), Vec3::UnitY()));
  };
  double coupling[2] = {};
  for (const bool is_many : {false, true}) {
    Trial& trial =
        found.trial(sphere(toolOf(datasets::rodPoints(is_many ? many : few, 0.06, 2e-3))),
                    kSolidIso, at(0, 0, 0.03));
    trial.judged = !is_many;
    trial.carry(at(0, 0, 0.03), at(0, 0, 0.019), 60);
    const auto apart = [&](int n) {
      if (is_many && n % 100 == 0) trial.illegal += !trial.isLegal();
      return (trial.place() - device(n).translation()).norm();
    };
    coupling[is_many] = trial.follow(400, device, apart).mean;
  }
  found.subject = "F6c " + shortly(many) + " points";
  found.atMost("coupling distance", 1e3 * coupling[1], 1.1e3 * coupling[0] + 0.2, "mm",
               "that of 2,000 points, a tenth and 0.2 mm");
  found.tell();
}

// voxels near the top of 32 bits, where a float cannot tell neighbours apart
void beyondFloat(Trials& found) {
  auto volume = datasets::filled(cube(48), haptics::ScalarType::UInt32, [](auto, auto, auto k) {
    return 4.0e9 - 100.0 * (double(k) - 24.0);
  });
  Trial& trial = found.brought(sceneOf(std::move(volume), ballTool(200, 3e-3)), 4.0e9,
                               at(-0.01, 0, 0.012), at(-0.01, 0, 2e-3), 40);
  const auto device = [](int n) { return at(1e-5 * n - 0.01, 0, 2e-3); };
  const Figures lag = trial.follow(found.tries > 1 ? 2000 : 1000, device, [&](int n) {
    return std::abs(trial.place().x() - device(n).translation().x());
  });
  // half a voxel above the grid's middle
  const double gap = trial.lowest(Vec3::UnitZ()) - 0.5 * h;
  found.atMost("behind, most", 1e3 * lag.most, 0.02, "mm");
  found.atMost("from the rest gap", 1e3 * std::abs(gap - trial.scene->lengths.rest_gap), 0.02,
               "mm");
  found.tellContact(found.subject);
}

void fewPoints(Trials& found) {
  // no point at all is refused, with a reason, where the tool is made
  found.subject = "no point";
  found.none("tools accepted", haptics::makeShell({}).has_value());
  std::vector<Vec3> points;
  for (const char* name : {"1 point", "2 points in line", "3 points in line"}) {
    points.push_back({0, 0, 5e-3 * double(points.size())});
    Trial& trial = found.trial(sphere(toolOf(points), 0.012, 3.0, 40), kSolidIso, at(0, 0, 0.03));
    trial.drag(Vec3::Zero(), 0.012, found.seed + 125, 20 * found.tries);
    found.tellContact(name);
  }
}

// a needle: about its own axis it turns a million times as easily as across
void needle(Trials& found) {
  // the inertia is regularised by 1e-6 r², so a line of points has the worst condition there is:
  // the metric's, over lengths and turns together, is made 1e12 by its unit of length
  const auto scene = sphere(toolOf(datasets::rodPoints(200, 0.12, 1e-7)));
  Eigen::Matrix<double, 6, 6> metric = Eigen::Matrix<double, 6, 6>::Identity();
  metric.bottomRightCorner<3, 3>() = scene->metric.inertia();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> values{metric};
  Trial& trial = found.trial(scene, kSolidIso, at(0, 0, 0.04));
  trial.drag(Vec3::Zero(), 0.025, found.seed + 141, 20 * found.tries);
  found.outcome.remarks.push_back(
      "The needle's mass metric has a condition of " +
      shortly(values.eigenvalues().maxCoeff() / values.eigenvalues().minCoeff()) + " in SI units.");
  found.tellContact(found.subject);
}

// the projection by itself, with a metric conditioned 1e12: optimal, by the conditions that make
// it so
void illConditioned(Trials& found) {
  Random random{found.seed + 142};
  const haptics::Mat3 I = haptics::Mat3::Identity();
  constexpr int kMostRows = 12;
  Series series{"most", {}};
  for (int k = 1; k <= kMostRows; ++k) series.points.push_back({double(k), 0.0});
  int inexact = 0;
  for (int n = 0; n < 200 * found.tries; ++n) {
    const haptics::Mat3 R = random.rotation().toRotationMatrix();
    const haptics::MassMetric metric{R * Vec3{1e-12, 1e-6 * random.in(0.1, 1.0), 1.0}.asDiagonal() *
                                     R.transpose()};
    double& worst = series.points[std::size_t(n % kMostRows)].y;
    std::vector<haptics::MotionRow> rows;
    for (int k = 0; k < 1 + n % kMostRows; ++k)
      rows.push_back({random.direction(), random.box(0.05), random.in(0.0, 1e-4)});
    const haptics::Twist free{random.box(1e-2), random.box(0.2)};
    const auto found_motion = haptics::constrainedMotion(free, rows, metric, I);
    inexact += found_motion.status != haptics::ConstrainedMotion::Status::Exact;
    // M (V - V_free) = sum of reactions, none of which pulls, and no row is broken
    haptics::Vector6 left = found_motion.whitened - metric.whitened(free, I);
    double scale = metric.whitened(free, I).norm();
    for (std::size_t k = 0; k < std::size_t(found_motion.active); ++k) {
      const haptics::MotionRow& row = rows[std::size_t(found_motion.bearing[k])];
      const haptics::Vector6 a = metric.row(row.n_W, row.r_W, I);
      left -= found_motion.reaction[k] * a;
      scale = std::max(scale, std::abs(found_motion.reaction[k]) * a.norm());
      worst = worse(worst, -found_motion.reaction[k] * a.norm() / scale);
    }
    worst = worse(worst, left.norm() / scale);
    for (const haptics::MotionRow& row : rows) {
      const haptics::Vector6 a = metric.row(row.n_W, row.r_W, I);
      worst = worse(worst, -(a.dot(found_motion.whitened) + row.room) / (a.norm() * scale));
    }
  }
  double worst = 0.0;
  for (const PlotPoint& each : series.points) worst = worse(worst, each.y);
  found.plot(found.subject + ": residual of the projection",
             "Largest violation of what makes a motion optimal, by the number of contacts",
             {"contacts"}, {"residual", Scale::Log}, {series});
  found.atMost("residual of the optimum's conditions", worst, 1e-9, "",
               "relative, in whitened coordinates; the projection may leave a row 1e-10 short");
  found.none("projections that were not exact", inexact);
}

void largeAndFar(Trials& found) {
  Trial& large = found.trial(sphere(ballTool(400, 0.1), 0.008, 3.0, 24), kSolidIso, at(0.15, 0, 0));
  large.drag(Vec3::Zero(), 0.13, found.seed + 123, 10 + 20 * found.tries);
  found.tellContact("tool eight times as wide as the volume");
  Vec3 settled[2];
  for (const int k : {0, 1}) {
    const Vec3 far = k * Vec3{10.0, -10.0, 10.0};
    haptics::Grid grid = cube(40, 3e-4);
    grid.origin += far;
    auto volume = datasets::sampledFloat(grid, [&](const Vec3& p) {
      return 1000.0 - 1e7 * std::clamp((p - far).norm() - 0.004, -1e-3, 1e-3);
    });
    const Pose from = at(far + Vec3{0, 0, 0.01}), D = at(far + Vec3{0, 0, 0.003});
    found.trials.clear();  // that at home is for comparison
    Trial& trial = found.trial(sceneOf(std::move(volume), ballTool(100, 1e-3)), 1000.0, from);
    trial.drag(far, 0.005, found.seed + 127, 10 * found.tries);
    trial.hold(from, 60);
    trial.carry(from, D, 40);
    trial.hold(D);
    settled[k] = trial.place() - far;
  }
  found.tellContact("origin at 10 m");
  found.atMost("from where it settles at home", 1e3 * (settled[1] - settled[0]).norm(), 3e-4, "mm",
               "a thousandth of a voxel");
}

// what the hand is asked for stays within the rating, with its direction, however far it pulls
void saturation(Trials& found) {
  const haptics::ForceLimits limits{3.3, 0.05, 0.0, 0.02};
  haptics::Safety safety{limits};
  Trial& trial = found.trial(sphere(ballTool(200, 3e-3)), kSolidIso, at(0, 0, 0.03));
  trial.coupling.stiffness = 20'000.0;
  double force = 0.0, torque = 0.0, least_turn = 1.0;
  for (int n = 0; n < 400; ++n) {
    const double down = n < 200 ? n : 400 - n;
    const Pose D = at({0.004, 0, 0.03 - 1e-4 * down}, turn(0.01 * down, Vec3::UnitX()));
    const haptics::Wrench asked = trial.step(D).wrench_W;
    safety.begin({.armed = true, .ready = true});
    const haptics::Wrench got = safety.pass(asked, trial.last.outside, 1e-3);
    force = std::max(force, got.force.norm());
    torque = std::max(torque, got.torque.norm());
    if (asked.force.norm() > 0.0)
      least_turn = -worse(-least_turn,
                          -got.force.dot(asked.force) / (got.force.norm() * asked.force.norm()));
  }
  found.atMost("force", force, limits.force * (1.0 + 1e-12), "N");
  found.atMost("torque", torque, limits.torque * (1.0 + 1e-12), "N m");
  found.atLeast("cosine to the wanted direction", least_turn, 1.0 - 1e-12);
  found.tellContact(found.subject);
}

}  // namespace

FailureGroup shells() {
  return {"Points: very many, few, large and far",
          {{"coplanar contacts", "F7 contacts in one plane", 1.0, 0.0, coplanar},
           {"very many points", "F6c", 3.0, 0.0, manyPoints},
           {"values beyond float", "F12 values that a float cannot hold", 0.5, 0.0, beyondFloat},
           {"few points", "few points", 0.0, 0.2, fewPoints},
           {"needle", "mass metric of a needle", 0.0, 0.3, needle},
           {"ill-conditioned metric", "mass metric conditioned 1e12", 0.0, 0.1, illConditioned},
           {"large and far", "large and far", 0.0, 0.5, largeAndFar},
           {"saturation", "saturation", 0.2, 0.0, saturation}}};
}

}  // namespace study::stability
