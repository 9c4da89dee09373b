// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <iostream>

#include "datasets/phantoms/shapes.h"
#include "tests/scenario/trial.h"

// A device held inside a solid of known form: where the proxy settles, and which way the hand is
// pushed. The proxy keeps the rest gap, 0.025 voxel, between its points and the surface, so the
// closed forms are those of surfaces that much further out.

namespace {

using haptics::Pose;
using haptics::Vec3;
using made::at;
using made::Random;
namespace shapes = datasets::shapes;

constexpr double h = 1e-3;  // m: the phantoms' voxel
constexpr double kGap = 0.025 * h;
constexpr double kBall = 3e-3;     // m, radius
constexpr int kBallPoints = 1000;  // 0.35 mm apart: the ball bulges 5 um between them

struct Settled {
  double worst = 0.0;        ///< m
  double worst_angle = 0.0;  ///< degrees between force and closed form
};

/// Holds the device at D, coming from `start`, and compares with the closed form.
void settle(const Stage& stage, const Pose& start, const Vec3& D, const Vec3& P, Settled& settled) {
  Trial trial{stage.scene, stage.isovalue, start};
  trial.carry(start, at(D), 40);
  trial.hold(at(D));
  EXPECT_EQ(trial.illegal, 0);
  settled.worst = std::max(settled.worst, (trial.place() - P).norm());
  const Vec3 force = trial.last.wrench_W.force;
  const Vec3 expected = P - D;
  EXPECT_GT(force.dot(expected), 0.0);
  const double angle = std::atan2(force.cross(expected).norm(), force.dot(expected)) * 180.0 / M_PI;
  settled.worst_angle = std::max(settled.worst_angle, angle);
}

void report(const char* what, const Settled& settled) {
  std::cout << what << ": at most " << settled.worst / h << " voxel, " << settled.worst_angle
            << " degrees\n";
}

TEST(Settled, OnAHalfSpaceStraightAboveTheDevice) {
  Random random{101};
  for (const double radius : {0.0, kBall}) {
    const Stage stage =
        stageOf("halfspace", radius > 0.0 ? ballTool(kBallPoints, radius) : made::point());
    // the lowest point of the ball's shell stands a little above the ball's own
    double reach = 0.0;
    for (const Vec3& p : stage.scene->tool.shell.points) reach = std::max(reach, -p.z());
    Settled settled;
    for (int n = 0; n < made::trials(30); ++n) {
      const Vec3 D{random.in(-0.015, 0.015), random.in(-0.015, 0.015),
                   reach - 4e-3 * random.in(0.1, 1)};
      Vec3 start = D;
      start.z() = 6e-3;
      settle(stage, at(start), D, {D.x(), D.y(), reach + kGap}, settled);
    }
    report(radius > 0.0 ? "half-space, ball" : "half-space, point", settled);
    // a ball of points turns to lie on a facet, up to its bulge of 0.005 voxel
    EXPECT_LE(settled.worst, 0.01 * h);
    EXPECT_LE(settled.worst_angle, 0.1);
  }
}

/// Devices at random inside, carried in from the side; the point settles nearest to the device.
void nearest(const char* name, const std::string& phantom, double radius, double bound,
             double bound_angle, const std::function<Vec3(Random&)>& device,
             const std::function<Vec3(const Vec3&, double)>& answer) {
  Random random{102};
  const Stage stage =
      stageOf(phantom, radius > 0.0 ? ballTool(kBallPoints, radius) : made::point());
  Settled settled;
  for (int n = 0; n < made::trials(40); ++n) {
    const Vec3 D = device(random);
    const Vec3 P = answer(D, radius + kGap);
    // from outside, up to 45 degrees aside
    const Vec3 out = (P - D).normalized();
    const Vec3 start = P + 3e-3 * out + 3e-3 * random.in(0.0, 1.0) * out.unitOrthogonal();
    settle(stage, at(start), D, P, settled);
  }
  report(name, settled);
  EXPECT_LE(settled.worst, bound);
  EXPECT_LE(settled.worst_angle, bound_angle);
}

TEST(Settled, OnASphereAlongTheRadius) {
  const double R = shapes::Sphere{}.radius;
  const auto device = [&](Random& random) {
    return Vec3{(R - random.in(1e-3, 5e-3)) * random.direction()};
  };
  const auto answer = [&](const Vec3& D, double r) { return Vec3{D.normalized() * (R + r)}; };
  nearest("sphere, point", "sphere", 0.0, 0.1 * h, 1.0, device, answer);
  nearest("sphere, ball", "sphere", kBall, 0.1 * h, 1.0, device, answer);
}

TEST(Settled, OnACylinderAlongTheRadius) {
  const double R = shapes::Cylinder{}.radius;
  const auto device = [&](Random& random) {
    const double angle = random.in(0.0, 2.0 * M_PI), depth = random.in(1e-3, 4e-3);
    return Vec3{random.in(-0.01, 0.01), (R - depth) * std::cos(angle),
                (R - depth) * std::sin(angle)};
  };
  const auto answer = [&](const Vec3& D, double r) {
    const Vec3 out = Vec3{0, D.y(), D.z()}.normalized();
    return Vec3{Vec3{D.x(), 0, 0} + (R + r) * out};
  };
  nearest("cylinder, point", "cylinder", 0.0, 0.1 * h, 1.0, device, answer);
  nearest("cylinder, ball", "cylinder", kBall, 0.1 * h, 1.0, device, answer);
}

TEST(Settled, InAWedgeAtItsEdge) {
  const shapes::Wedge wedge;
  for (const double radius : {0.0, kBall}) {
    const Stage stage =
        stageOf("wedge", radius > 0.0 ? ballTool(kBallPoints, radius) : made::point());
    Random random{103};
    Settled settled;
    for (int n = 0; n < made::trials(30); ++n) {
      const double y = random.in(-0.01, 0.01);
      const Vec3 P{0, y, wedge.bottom + (radius + kGap) / std::sin(wedge.half_angle)};
      // both walls press: D below P, within the cone of their normals
      const double depth = random.in(1e-3, 4e-3);
      const Vec3 D = P + Vec3{random.in(-0.4, 0.4) * depth, 0, -depth};
      settle(stage, at(P + Vec3{random.in(-1e-3, 1e-3), 0, 5e-3}), D, P, settled);
    }
    report(radius > 0.0 ? "wedge, ball" : "wedge, point", settled);
    EXPECT_LE(settled.worst, 0.1 * h);
    EXPECT_LE(settled.worst_angle, 1.0);
  }
}

TEST(Settled, InASlotOnItsFloorAtItsWallAndInItsCorner) {
  const shapes::Slot slot;
  for (const double radius : {0.0, kBall}) {
    const Stage stage =
        stageOf("slot", radius > 0.0 ? ballTool(kBallPoints, radius) : made::point());
    const double wall = slot.half_width - radius - kGap, floor = slot.floor + radius + kGap;
    Random random{104};
    Settled settled, cornered;
    for (int n = 0; n < made::trials(45); ++n) {
      const double y = random.in(-0.01, 0.01), x = random.in(-0.7, 0.7) * wall;
      const double deep = random.in(1e-3, 4e-3);
      Vec3 D, P;
      if (n % 3 == 0) {
        D = {x, y, floor - deep};
        P = {x, y, floor};
      } else if (n % 3 == 1) {
        D = {wall + deep, y, floor + 3e-3};
        P = {wall, y, floor + 3e-3};
      } else {
        D = {-wall - deep, y, floor - random.in(1e-3, 4e-3)};
        P = {-wall, y, floor};
      }
      settle(stage, at(0, y, floor + 4e-3), D, P, n % 3 == 2 ? cornered : settled);
    }
    report(radius > 0.0 ? "slot, ball" : "slot, point", settled);
    report("  in its corner", cornered);
    EXPECT_LE(settled.worst, 0.1 * h);
    EXPECT_LE(settled.worst_angle, 1.0);
    // a lone point is held short of the corner by central differences, which round it over a voxel
    // on either side: up to a third of a voxel, where 0.1 is wanted
    EXPECT_LE(cornered.worst, (radius > 0.0 ? 0.1 : 0.35) * h);
    EXPECT_LE(cornered.worst_angle, radius > 0.0 ? 1.0 : 6.0);
  }
}

}  // namespace
