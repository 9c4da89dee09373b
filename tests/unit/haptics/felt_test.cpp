// SPDX-License-Identifier: BSD-3-Clause
// Structures that are felt: tissue gives way and gives no energy, a guard keeps away and gives
// none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/coupling/passivity.h"
#include "haptics/proxy/felt.h"
#include "haptics/simulation/grip.h"
#include "tests/support/made.h"
#include "tests/support/made_distances.h"

namespace {

using datasets::Random;
using haptics::Feel;
using haptics::Felt;
using haptics::Pose;
using haptics::Vec3;
using haptics::Watch;
using haptics::Wrench;
using haptics::YieldingSpring;

constexpr double kPeriod = 1e-3;
constexpr double kRigid = std::numeric_limits<double>::infinity();

TEST(Tissue, GivesWayInSeriesWithTheCoupling) {
  for (const double c : {0.01, 0.3, 1.0, 40.0, kRigid}) {
    YieldingSpring spring;
    const Vec3 pull(0.3, -1.2, 2.0);
    Vec3 felt = Vec3::Zero();
    for (int tick = 0; tick < 200; ++tick) felt = spring.pass(pull, c, kPeriod);
    // k k_t / (k + k_t), of k
    const double share = std::isinf(c) ? 1.0 : c / (1.0 + c);
    EXPECT_LT((felt - share * pull).norm(), 1e-6) << c;
  }
}

TEST(Tissue, IsRigidToTheBit) {
  YieldingSpring spring;
  Random random{4};
  for (int tick = 0; tick < 100; ++tick) {
    const Vec3 pull = random.box(3.0);
    EXPECT_EQ(spring.pass(pull, kRigid, kPeriod), pull);
  }
}

/// What the hand is given on a way that ends where it begins, J: the spring of k [N/m] from the
/// origin, with another tissue from time to time. `sampled`: what holding a force for a tick gives
/// at most.
double givenOnAWay(Random& random, double k, double& sampled) {
  YieldingSpring spring;
  std::vector<Vec3> way{Vec3::Zero()};
  Vec3 aim = Vec3::Zero();
  for (int tick = 0; tick < 20'000; ++tick) {
    if (tick % 400 == 0) aim = random.box(4e-3);
    way.push_back(way.back() + 4e-6 * (aim - way.back()).normalized());
  }
  while (way.back().norm() > 4e-6) way.push_back(way.back() * (1.0 - 4e-6 / way.back().norm()));
  way.push_back(Vec3::Zero());
  double given = 0.0, c = kRigid;
  for (std::size_t tick = 0; tick + 1 < way.size(); ++tick) {
    if (tick % 150 == 0) {
      const double one = random.box(1.0).x();
      c = one > 0.4 ? kRigid : std::pow(10.0, 2.0 * one);
    }
    const Vec3 motion = way[tick + 1] - way[tick];
    given += spring.pass(-k * way[tick], c, kPeriod).dot(motion);
    sampled += 0.5 * k * motion.squaredNorm();
  }
  return given;
}

TEST(Tissue, GivesNoEnergyWhateverItBecomes) {
  Random random{6};
  double most = -kRigid;
  for (int n = 0; n < made::trials(60); ++n) {
    double sampled = 0.0;
    const double given = givenOnAWay(random, 1000.0, sampled);
    EXPECT_LE(given, sampled + 1e-9) << n;
    most = std::max(most, given);
  }
  EXPECT_LT(most, 1e-4);
  EXPECT_GT(most, -0.1);
}

// pressed where it is soft, and let out where it is hard
TEST(Tissue, GivesNoEnergyWhenItHardensUnderLoad) {
  constexpr double kStiffness = 1000.0, kStep = 2e-6;
  for (const double harder : {2.0, 50.0, kRigid}) {
    YieldingSpring spring;
    double given = 0.0;
    for (int round = 0; round < 5; ++round) {
      const auto go = [&](int from, int until, double c) {
        const int by = from < until ? 1 : -1;
        for (int n = from; n != until; n += by)
          given += spring.pass({kStiffness * kStep * n, 0.0, 0.0}, c, kPeriod).x() * -by * kStep;
      };
      go(0, 2000, 0.05);
      go(2000, 2000 + 100, harder);
      go(2100, 0, harder);
      EXPECT_LT(given, 1e-5) << harder << ", round " << round;
    }
    EXPECT_LT(given, -1e-4);  // it damps
  }
}

TEST(Tissue, NeverHoldsTheHandBack) {
  Random random{9};
  YieldingSpring spring;
  Vec3 pull = Vec3::Zero();
  for (int tick = 0; tick < 100'000; ++tick) {
    pull += random.box(0.05);
    if (tick % 977 == 0) pull = Vec3::Zero();
    const Vec3 felt = spring.pass(pull, tick % 300 < 100 ? kRigid : 0.2 + tick % 7, kPeriod);
    ASSERT_TRUE(felt.allFinite());
    if (pull.isZero()) {
      ASSERT_TRUE(felt.isZero());
    }
  }
  YieldingSpring along;
  for (int tick = 0; tick < 3000; ++tick) {
    const double size = 3.0 * std::sin(tick * 0.002) * std::sin(tick * 0.002);
    const double felt = along.pass({size, 0.0, 0.0}, tick % 500 < 250 ? 0.1 : kRigid, kPeriod).x();
    EXPECT_GE(felt, -1e-12);
    EXPECT_LE(felt, size);
  }
}

std::shared_ptr<const haptics::Scene> ballScene() {
  return made::scene(datasets::solid(datasets::centredGrid(32, 1e-3),
                                     [](const auto& p) { return p.norm() - 0.012; }),
                     made::tool(datasets::ballPoints(200, 2e-3)));
}

Watch guarded(double margin, double most) {
  Watch watch;
  watch.structures.push_back(
      {1,
       made::distanceMap(datasets::centredGrid(61, 1e-3),
                         [](const Vec3& p) { return (p - Vec3(3e-3, 0, 0)).norm() - 5e-3; }),
       {.kind = Feel::Kind::Guarded, .margin = margin, .most = most}});
  return watch;
}

TEST(Guard, RisesTowardsTheStructureAndNoHigher) {
  const auto scene = ballScene();
  const Watch watch = guarded(4e-3, 3.0);
  const Vec3 middle(3e-3, 0, 0);
  double before = 0.0;
  for (double away = 12e-3; away > 4e-3; away -= 1e-4) {
    const Pose X_WD = made::at(middle + away * Vec3(0.6, 0.0, 0.8));
    const Wrench force = haptics::guardAt(watch.structures[0], *scene, X_WD);
    const double distance = away - 5e-3 - 2e-3;  // of the tool's ball
    if (distance > 4.2e-3) {
      EXPECT_EQ(force.force.norm(), 0.0) << distance;
      continue;
    }
    EXPECT_GE(force.force.norm(), before - 0.2) << distance;
    EXPECT_LE(force.force.norm(), 3.0);
    before = force.force.norm();
    if (distance < 3e-3) {
      EXPECT_GT(force.force.normalized().dot(Vec3(0.6, 0.0, 0.8)), 0.95);
    }
  }
  EXPECT_GT(before, 1.5);  // of 3 N at most, less the slope that samples could have
}

TEST(Guard, GivesNoEnergyOverAClosedPath) {
  std::vector<Vec3> rod;
  for (int n = -20; n <= 20; ++n) rod.push_back(Vec3(0.0, 4e-4 * n, 1e-4 * (n % 3)));
  const auto scene = made::scene(datasets::solid(datasets::centredGrid(8, 1e-3),
                                                 [](const auto& p) { return p.norm() - 0.002; }),
                                 made::tool(rod));
  const Watch watch = guarded(5e-3, 10.0);
  Random random{12};
  double most = 0.0, felt = 0.0;
  for (int n = 0; n < made::trials(30); ++n) {
    // a loop of three waves through the margin, the structure and free space
    const Vec3 middle = Vec3(3e-3, 0, 0) + 9e-3 * random.box(1.0).normalized();
    const Vec3 a = random.box(4e-3), b = random.box(4e-3), c = random.box(0.5);
    const auto poseAt = [&](double turn) {
      return haptics::poseOf(
          middle + a * std::sin(turn) + b * (1.0 - std::cos(turn)),
          haptics::Quat{Eigen::AngleAxisd{c.norm() * std::sin(2.0 * turn + 1.0), c.normalized()}});
    };
    constexpr int kSteps = 4000;
    haptics::PassivityObserver observer;
    Wrench held;
    for (int tick = 0; tick <= kSteps; ++tick) {
      const Pose X = poseAt(2.0 * M_PI * tick / kSteps);
      if (tick > 0)
        observer.add(held, haptics::motionBetween(poseAt(2.0 * M_PI * (tick - 1) / kSteps), X));
      held = haptics::guardAt(watch.structures[0], *scene, X);
      felt = std::max(felt, held.force.norm());
    }
    most = std::max(most, std::abs(observer.energy()));
  }
  EXPECT_LT(most, 1e-3);  // J
  EXPECT_GT(felt, 4.0);
}

TEST(Guard, KeepsAHandFromANerveThatItsLimitAllows) {
  const auto scene = ballScene();
  const double radius = scene->tool.shell.radius;
  Random random{32};
  for (int n = 0; n < made::trials(20); ++n) {
    // a nerve, which the tool may slip around, and a plate, which it cannot
    const bool plate = n % 2 == 0;
    const auto toNerve = [plate](const Vec3& p) {
      return (plate ? std::abs(p.x()) : std::hypot(p.x(), p.z())) - 1e-3;
    };
    const double margin = random.in(2e-3, 6e-3);
    const Watch::Watched nerve{1,
                               made::distanceMap(datasets::centredGrid(61, 1e-3), toNerve),
                               {.kind = Feel::Kind::Guarded, .margin = margin, .most = 20.0}};
    const double turn = plate ? 0.0 : random.in(0.0, 2.0 * M_PI);
    const Vec3 away(std::cos(turn), 0.0, std::sin(turn));
    haptics::Grip grip;
    haptics::PassivityObserver observer;
    Wrench felt;
    double least = 1.0, pressed = 0.0;
    grip.X_WD = made::at(15e-3 * away);
    constexpr int kWay = 2000;  // ticks: towards the nerve, rest, and back
    for (int tick = 0; tick < 3 * kWay; ++tick) {
      const double share = std::clamp(1.0 - std::abs(tick - 1.5 * kWay) / kWay + 0.5, 0.0, 1.0);
      // as deep as pulls with 10 N where the guard holds that
      const Vec3 hand = (15e-3 - share * (15e-3 - radius + 10.5 / grip.stiffness)) * away;
      const Pose before = grip.X_WD;
      grip.advance(made::at(hand), felt, kPeriod);
      observer.add(felt, haptics::motionBetween(before, grip.X_WD));
      felt = haptics::guardAt(nerve, *scene, grip.X_WD);
      double near = 1.0;
      for (const Vec3& p : scene->tool.shell.points) near = std::min(near, toNerve(grip.X_WD * p));
      least = std::min(least, near);
      if (near > margin + 0.5e-3) {
        EXPECT_EQ(felt.force.norm(), 0.0) << near;
      }
      pressed = std::max(pressed, felt.force.norm());
    }
    EXPECT_GT(least, 0.0) << margin;
    EXPECT_GT(pressed, plate ? 10.0 : 3.0) << margin;
    EXPECT_LT(observer.energy(), 1e-3) << margin;
  }
}

// a tool that is wider than a nerve, held in it by a hand that rests
TEST(Guard, DoesNotShakeAHandThatRests) {
  const auto scene = ballScene();
  const Watch::Watched nerve{
      1,
      made::distanceMap(datasets::centredGrid(61, 1e-3),
                        [](const Vec3& p) { return std::hypot(p.x(), p.z()) - 1e-3; }),
      {.kind = Feel::Kind::Guarded, .margin = 2e-3, .most = 2.0}};
  Random random{31};
  double step = 0.0, felt = 0.0;
  for (int n = 0; n < made::trials(40); ++n) {
    const Pose X_WH = haptics::poseOf(random.box(1e-3), random.rotation());
    haptics::Grip grip;
    grip.X_WD = X_WH;
    Wrench before;
    for (int tick = 0; tick < 2000; ++tick) {
      const Wrench guard = haptics::guardAt(nerve, *scene, grip.X_WD);
      if (tick > 1000) {
        step = std::max(step, (guard.force - before.force).norm());
        felt = std::max(felt, guard.force.norm());
      }
      before = guard;
      grip.advance(X_WH, guard, kPeriod);
    }
  }
  EXPECT_LT(step, 0.02);
  EXPECT_GT(felt, 0.1);  // it is pushed from both sides
}

TEST(Felt, WithNothingChosenIsTheCouplingsToTheBit) {
  const auto scene = ballScene();
  Watch watch = guarded(4e-3, 3.0);
  watch.structures[0].feel = {};
  haptics::Proxy proxy{*scene, made::at(0, 0, 0.02)};
  Felt felt;
  Random random{3};
  for (int n = 0; n < 50; ++n) {
    const Wrench pulled{random.box(5.0), random.box(0.1)};
    const Wrench same =
        felt.shaped(watch, *scene, proxy, made::at(random.box(0.02)), 1000.0, pulled, kPeriod);
    EXPECT_EQ(same.force, pulled.force);
    EXPECT_EQ(same.torque, pulled.torque);
  }
}

// half of the force on what is soft, half on what is hard: their compliances are averaged
TEST(Felt, GivesWayByWhatTheToolBearsOn) {
  const auto scene = ballScene();
  Watch watch;
  watch.structures.push_back(
      {1,
       made::distanceMap(datasets::centredGrid(61, 1e-3), [](const Vec3& p) { return p.x(); }),
       {.kind = Feel::Kind::Softer, .stiffness = 500.0}});
  const Wrench pulled{{0.0, 0.0, 2.0}, Vec3::Zero()};
  const auto feltOn = [&](std::vector<double> places_x, const Vec3& normal = Vec3::UnitZ()) {
    haptics::Proxy proxy{*scene, made::at(0, 0, 0.014)};
    for (const double x : places_x)
      proxy.bearing.push({Vec3(x, 0.0, -2e-3), normal, 2.0 / double(places_x.size())});
    Felt felt;
    Wrench shaped;
    for (int tick = 0; tick < 300; ++tick)
      shaped = felt.shaped(watch, *scene, proxy, made::at(0, 0, 0.012), 1000.0, pulled, kPeriod);
    return shaped.force.z();
  };
  EXPECT_EQ(feltOn({5e-3}), 2.0);
  EXPECT_NEAR(feltOn({-5e-3}), 2.0 * 500.0 / 1500.0, 1e-6);
  // the voxel behind the surface is what is touched
  EXPECT_NEAR(feltOn({0.3e-3}, Vec3::UnitX()), 2.0 * 500.0 / 1500.0, 1e-6);
  EXPECT_EQ(feltOn({-0.3e-3}, -Vec3::UnitX()), 2.0);
  EXPECT_NEAR(feltOn({-5e-3, 5e-3}), 2.0 * 1000.0 / 2000.0, 1e-6);
}

}  // namespace
