// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/friction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/proxy/tick.h"
#include "haptics/simulation/penetration.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::ConstrainedMotion;
using haptics::MassMetric;
using haptics::Mat3;
using haptics::MotionRow;
using haptics::Pose;
using haptics::Proxy;
using haptics::Scene;
using haptics::TickResult;
using haptics::Twist;
using haptics::Vec3;
using haptics::Vector6;
using made::at;
using millimetre::h;
using millimetre::unlimited;

struct Solved {
  ConstrainedMotion frictionless, held;
};
Solved solve(const Twist& free, const std::vector<MotionRow>& rows, const MassMetric& metric,
             const Mat3& R_WP, double mu) {
  Budget budget = unlimited();
  const ConstrainedMotion frictionless = haptics::constrainedMotion(free, rows, metric, R_WP);
  return {frictionless, haptics::withFriction(free, rows, metric, R_WP, mu, frictionless, budget)};
}

// three to twelve feet of a stool on a plane, pushed at its middle: it slips as one
TEST(Friction, SlipBeginsWhereThePullIsMuTimesThePush) {
  Random random{51};
  double worst = 0.0;
  for (int trial = 0; trial < 3000; ++trial) {
    SCOPED_TRACE(trial);
    const double mu = random.in(0.05, 1.2), load = std::exp(random.in(-12.0, -4.0));
    const Mat3 R = random.rotation().toRotationMatrix();
    const Vec3 n = R.col(2);
    const double side = random.in(2e-3, 20e-3);
    std::vector<MotionRow> rows;
    const int feet = trial % 4 == 0 ? 1 : 3 + trial % 10;
    for (int i = 0; i < feet; ++i) {
      const double turn = 2.0 * M_PI * (i + 0.3) / feet;
      const Vec3 r =
          feet == 1 ? Vec3::Zero() : Vec3{side * std::cos(turn), side * std::sin(turn), 0};
      rows.push_back({n, R * r, 0.0});
    }
    const MassMetric metric{0.5 * side * side * Mat3::Identity()};
    const double turn = random.in(0.0, 2.0 * M_PI);
    const Vec3 along = std::cos(turn) * R.col(0) + std::sin(turn) * R.col(1);
    const auto slip = [&](double pull) {
      const Twist free{load * (pull * along - n), Vec3::Zero()};
      const Solved s = solve(free, rows, metric, Mat3::Identity(), mu);
      EXPECT_GE(n.dot(s.held.twist.linear), -1e-9 * load);
      return s.held.twist.linear.dot(along) / load;
    };
    EXPECT_LT(std::abs(slip(0.99 * mu)), 1e-3 * mu);
    const double beyond = slip(1.5 * mu);
    EXPECT_NEAR(beyond, 0.5 * mu, 0.005 * mu);
    worst = std::max(worst, std::abs(beyond - 0.5 * mu) / mu);
  }
  std::cout << "sliding friction off by at most " << worst << " of mu\n";
}

// whatever the rows: none is violated, each reaction stays in its cone, and friction only takes
TEST(Friction, LeavesEveryRowItsRoomAndOnlyTakesEnergy) {
  Random random{52};
  int slowed = 0, stuck = 0, moved = 0, stopped = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    SCOPED_TRACE(trial);
    const Mat3 R_WP = random.rotation().toRotationMatrix();
    const Mat3 turn = random.rotation().toRotationMatrix();
    const MassMetric metric{
        turn * Vec3{random.in(1.0, 9.0), random.in(1.0, 9.0), random.in(1.0, 9.0)}.asDiagonal() *
        turn.transpose() * 1e-5};
    std::vector<MotionRow> rows;
    const int count = 1 + random.below(10);
    const Vec3 mean = random.direction();
    for (int i = 0; i < count; ++i)
      rows.push_back({(mean + random.in(0.0, 1.2) * random.direction()).normalized(),
                      random.box(5e-3), random.below(3) == 0 ? random.in(0.0, 1e-4) : 0.0});
    const Twist free{1e-3 * (random.box(1.0) - mean), 0.1 * random.box(1.0)};
    const double mu = random.in(0.05, 1.5);
    const Solved s = solve(free, rows, metric, R_WP, mu);
    if (s.frictionless.status != ConstrainedMotion::Status::Exact) continue;
    const Vector6 y_free = metric.whitened(free, R_WP), y = s.held.whitened;
    const double scale = y_free.norm();
    ASSERT_TRUE(y.allFinite());
    for (const MotionRow& row : rows) {
      const Vector6 a = metric.row(row.n_W, row.r_W, R_WP);
      EXPECT_GE(a.dot(y), -row.room - 1e-9 * scale * a.norm());
    }
    // the proxy comes no farther from the device than it was
    EXPECT_LE((y_free - y).norm(), scale * (1.0 + 1e-6));
    // and the reactions do no work on it but against friction: y · (y_free - y) >= 0
    EXPECT_GE(y.dot(y_free - y), -2e-6 * scale * scale);
    if (s.frictionless.active > 0) {
      slowed += (y - s.frictionless.whitened).norm() > 1e-3 * scale;
      stuck += y.norm() < 1e-3 * scale;
      stopped += y.isZero(0.0) && s.frictionless.whitened.norm() > 0.1 * scale;
      moved += y.norm() > 1e-2 * scale;
    }
  }
  std::cout << stopped << " of " << slowed << " stopped for want of sweeps\n";
  EXPECT_LT(stopped, slowed / 50);
  EXPECT_GT(slowed, 1000);
  EXPECT_GT(stuck, 200);
  EXPECT_GT(moved, 500);
}

TEST(Friction, OfAPointActsAtThePoint) {
  Random random{53};
  for (int trial = 0; trial < 500; ++trial) {
    const Mat3 I_P = Vec3{2e-5, 3e-5, 4e-5}.asDiagonal();
    const Mat3 R_WP = random.rotation().toRotationMatrix();
    const MassMetric metric{I_P};
    const MotionRow row{random.direction(), random.box(8e-3), 0.0};
    const Twist free{1e-3 * (random.box(0.7) - row.n_W), Vec3::Zero()};
    const Solved s = solve(free, {row}, metric, R_WP, 0.4);
    if (s.frictionless.active == 0) continue;
    // what the coupling with K = M feels of the surface: force and torque about the origin
    const Vec3 force = s.held.twist.linear - free.linear;
    const Vec3 torque = R_WP * I_P * R_WP.transpose() * (s.held.twist.angular - free.angular);
    EXPECT_LT((torque - row.r_W.cross(force)).norm(), 1e-9 * force.norm());
    const double push = force.dot(row.n_W);
    EXPECT_LE((force - push * row.n_W).norm(), 0.4 * push * (1.0 + 1e-5));
  }
}

TEST(Friction, OfNothingIsTheMotionWithoutItToTheBit) {
  Random random{54};
  const MassMetric metric{1e-5 * Mat3::Identity()};
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<MotionRow> rows;
    for (int i = 0; i < 5; ++i) rows.push_back({random.direction(), random.box(5e-3), 0.0});
    const Solved s =
        solve({random.box(1e-3), random.box(0.1)}, rows, metric, Mat3::Identity(), 0.0);
    EXPECT_EQ(s.held.whitened, s.frictionless.whitened);
    EXPECT_EQ(s.held.twist.angular, s.frictionless.twist.angular);
  }
}

/// A tool over a plane through the origin, driven tick by tick.
struct Bench {
  std::shared_ptr<const Scene> scene;
  double mu = 0.0;
  Proxy proxy;
  Bench(std::shared_ptr<const Scene> touched, double friction, const Pose& X_start)
      : scene{std::move(touched)}, mu{friction}, proxy{*scene, X_start} {}
  TickResult to(const Vec3& p) {
    Budget budget = Budget::counted(haptics::kTickWork);
    const haptics::VirtualCoupling coupling{.stiffness = 1000.0, .friction = mu};
    const TickResult result =
        haptics::tick(*scene, datasets::kSolidIso, coupling, at(p), proxy, budget, 1e-3);
    EXPECT_EQ(haptics::penetration(*scene, datasets::kSolidIso, proxy.X_WP), 0.0);
    return result;
  }
  Vec3 place() const { return proxy.X_WP.translation(); }
};

/// A half-space whose surface goes through the origin with this normal; white noise of so many
/// parts of the slope over one voxel.
std::shared_ptr<const Scene> halfSpace(const Vec3& n, double noise, haptics::Tool tool) {
  std::mt19937 engine{7};
  std::normal_distribution<double> grain{0.0, 4000.0 * noise};
  return made::scene(datasets::sampledFloat(datasets::centredGrid(50, h),
                                            [&](const Vec3& p) {
                                              return 1000.0 - 4e6 * n.dot(p) +
                                                     (noise > 0.0 ? grain(engine) : 0.0);
                                            }),
                     std::move(tool));
}

/// The ratio of pull along the surface to push at which the proxy begins to slip: the device goes
/// straight down by `depth`, then sideways.
double onset(Bench& bench, const Vec3& n, const Vec3& along, double depth) {
  for (int i = 0; i < 40; ++i) bench.to(1e-3 * n * (1.0 - i / 40.0) - depth * n * (i / 40.0));
  for (int i = 0; i < 40; ++i) bench.to(-depth * n);
  const Vec3 start = bench.place();
  for (int i = 0; i < 4000; ++i) {
    const double pull = 1e-3 * i * depth;
    bench.to(-depth * n + pull * along);
    const Vec3 apart = -depth * n + pull * along - bench.place();
    if ((bench.place() - start).dot(along) > 2e-3 * h) return apart.dot(along) / -apart.dot(n);
  }
  return 0.0;
}

TEST(Friction, OfTheProxyOnAPlaneBeginsToSlipWithinAHundredthOfMu) {
  Random random{55};
  double worst = 0.0;
  for (const double mu : {0.1, 0.3, 0.6, 1.0})
    for (const double depth : {1e-3, 4e-3})
      for (int k = 0; k < 6; ++k) {
        const Vec3 n = k < 2 ? Vec3::UnitZ() : random.direction();
        const Vec3 along = Eigen::AngleAxisd{random.in(0.0, 6.28), n} * n.unitOrthogonal();
        Bench bench{halfSpace(n, 0.0, made::point()), mu, at(12e-3 * n)};
        const double found = onset(bench, n, along, depth);
        EXPECT_NEAR(found, mu, 0.01 * mu);
        worst = std::max(worst, std::abs(found - mu) / mu);
      }
  std::cout << "slip begins within " << worst << " of mu\n";
}

// a hundredth of the slope over a voxel tilts the surface by about half a degree: its tangent
// adds to mu, or takes from it
TEST(Friction, OfTheProxyOnANoisyPlaneBeginsToSlipWithinItsTilt) {
  Random random{56};
  for (const double mu : {0.2, 0.5})
    for (int k = 0; k < 4; ++k) {
      const Vec3 n = random.direction();
      const Vec3 along = n.unitOrthogonal();
      Bench bench{halfSpace(n, 0.01, made::point()), mu, at(12e-3 * n)};
      EXPECT_NEAR(onset(bench, n, along, 2e-3), mu, 0.05);
    }
}

TEST(Friction, HoldsStillBelowMuAndSlidesBackAndForth) {
  const double mu = 0.4, depth = 2e-3;
  const Vec3 n = Vec3::UnitZ(), x = Vec3::UnitX();
  Bench bench{halfSpace(n, 0.0, made::point()), mu, at(12e-3 * n)};
  for (int i = 0; i < 60; ++i) bench.to((1e-3 - (1e-3 + depth) * std::min(1.0, i / 40.0)) * n);
  // pulled at nine tenths of mu, for half a second: to the bit
  for (int i = 0; i <= 50; ++i) bench.to(-depth * n + 0.9 * mu * depth * i / 50.0 * x);
  const Vec3 held = bench.place();
  for (int i = 0; i < 500; ++i) bench.to(-depth * n + 0.9 * mu * depth * x);
  EXPECT_EQ(bench.place(), held);

  // to and fro over ten times the reach of sticking; the hand's work is never given back
  double work = 0.0, slid = 0.0, before = 0.0;
  int still = 0, sliding = 0;
  Vec3 last = -depth * n + 0.9 * mu * depth * x;
  const double reach = 10.0 * mu * depth;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = -depth * n + reach * std::sin(2.0 * M_PI * i / 2000.0) * x;
    const Vec3 was = bench.place();
    const TickResult result = bench.to(p);
    work += -result.wrench_W.force.dot(p - last);
    last = p;
    const double step = (bench.place() - was).x();
    const Vec3 apart = p - bench.place();
    // friction is the whole of what the hand feels along the surface
    EXPECT_LE(std::abs(apart.x()), 1.01 * mu * -apart.z());
    if (std::abs(step) > 1e-3 * h) {
      EXPECT_NEAR(std::abs(apart.x()), mu * -apart.z(), 0.01 * mu * depth);
      EXPECT_GT(apart.x() * step, 0.0);
      slid += std::abs(step);
      ++sliding;
    } else {
      ++still;
    }
    before = std::max(before, std::abs(bench.place().x()));
  }
  EXPECT_GT(sliding, 2000);
  EXPECT_GT(still, 200);
  // what was put in is what friction took: mu times load times way
  EXPECT_NEAR(work, 1000.0 * mu * depth * slid, 0.05 * work);
  EXPECT_NEAR(before, reach - mu * depth, 0.02 * reach);
}

TEST(Friction, KeepsTheToolOutsideOnEverySurface) {
  Random random{57};
  const auto volume = datasets::solid(datasets::centredGrid(50, h), [](const Vec3& p) {
    return p.norm() - 15e-3 + 1e-3 * std::sin(p.x() * 900.0) * std::sin(p.y() * 700.0);
  });
  const auto scene = made::scene(volume, made::tool(datasets::ballPoints(200, 4e-3)));
  for (const double mu : {0.2, 0.8, 1.5}) {
    Bench bench{scene, mu, at(0, 0, 23e-3)};
    int touched = 0;
    for (int i = 0; i < 1500; ++i) {
      const double t = i * 1e-3;
      const double depth = std::min(1.0, t / 0.2) * 6e-3;
      const Vec3 p =
          (23e-3 - depth) * Vec3{std::sin(1.3 * t), std::sin(2.0 * t) * 0.4, std::cos(1.3 * t)};
      touched += bench.to(p).contacts > 0;
    }
    EXPECT_GT(touched, 1000);
  }
}

}  // namespace
