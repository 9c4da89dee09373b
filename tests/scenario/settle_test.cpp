// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "app/study/accuracy/closed_forms.h"
#include "tests/scenario/trial.h"
#include "tests/support/millimetre.h"

// A device held inside a solid of known form: where the proxy settles, and which way the hand is
// pushed. The proxy keeps the rest gap, 0.025 voxel, between its points and the surface, so the
// closed forms are those of surfaces that much further out.

namespace {

using haptics::Vec3;
using made::at;
using millimetre::h;
using study::accuracy::AnalyticHold;

constexpr double kGap = 0.025 * h;
constexpr double kBall = 3e-3;     // m, radius
constexpr int kBallPoints = 1000;  // 0.35 mm apart: the ball bulges 5 um between them

/// How far from the closed form the worst of some holds is.
struct Settled {
  double position = 0.0;  ///< m
  double angle = 0.0;     ///< degrees between force and closed form
};

void settle(const Stage& stage, const AnalyticHold& hold, double radius, Settled& settled) {
  Trial trial{stage.scene, stage.isovalue, at(hold.start)};
  trial.carry(at(hold.start), at(hold.device), 40);
  trial.hold(at(hold.device));
  EXPECT_EQ(trial.illegal, 0);
  const Vec3 P = hold.answer(radius + kGap), expected = P - hold.device;
  settled.position = std::max(settled.position, (trial.place() - P).norm());
  const Vec3 force = trial.last.wrench_W.force;
  EXPECT_GT(force.dot(expected), 0.0);
  settled.angle = std::max(
      settled.angle, std::atan2(force.cross(expected).norm(), force.dot(expected)) * 180.0 / M_PI);
}

/// Bounds in voxels and degrees, for a ball and for a point.
struct Bounds {
  double position, angle;
};

void settleIn(const std::string& solid, const Bounds& bounds, const Bounds& cornered) {
  for (const double radius : {0.0, kBall}) {
    const Stage stage =
        stageOf(solid, radius > 0.0 ? ballTool(kBallPoints, radius) : made::point());
    double reach = radius;
    if (solid == "halfspace") {
      // the lowest point of the ball's shell stands a little above the ball's own
      reach = 0.0;
      for (const Vec3& p : stage.scene->tool.shell.points) reach = std::max(reach, -p.z());
    }
    Settled free, corner;
    for (const AnalyticHold& hold :
         study::accuracy::analyticHolds(solid, reach, made::trials(40), 101))
      settle(stage, hold, reach, hold.corner ? corner : free);
    std::cout << solid << (radius > 0.0 ? ", ball" : ", point") << ": at most " << free.position / h
              << " voxel, " << free.angle << " degrees; in a corner " << corner.position / h
              << " voxel, " << corner.angle << " degrees\n";
    EXPECT_LE(free.position, bounds.position * h);
    EXPECT_LE(free.angle, bounds.angle);
    const Bounds& in_corner = radius > 0.0 ? bounds : cornered;
    EXPECT_LE(corner.position, in_corner.position * h);
    EXPECT_LE(corner.angle, in_corner.angle);
  }
}

// a ball of points turns to lie on a facet, up to its bulge of 0.005 voxel
TEST(Settled, OnAHalfSpaceStraightAboveTheDevice) { settleIn("halfspace", {0.01, 0.1}, {}); }
TEST(Settled, OnASphereAlongTheRadius) { settleIn("sphere", {0.1, 1.0}, {}); }
TEST(Settled, OnACylinderAlongTheRadius) { settleIn("cylinder", {0.1, 1.0}, {}); }
TEST(Settled, InAWedgeAtItsEdge) { settleIn("wedge", {0.1, 1.0}, {}); }
// a lone point is held short of the corner by central differences, which round it over a voxel on
// either side: up to a third of a voxel, where 0.1 is wanted
TEST(Settled, InASlotOnItsFloorAtItsWallAndInItsCorner) {
  settleIn("slot", {0.1, 1.0}, {0.35, 6.0});
}

}  // namespace
