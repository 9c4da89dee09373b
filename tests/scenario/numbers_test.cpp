// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/scenario/trial.h"
#include "tests/support/millimetre.h"

// Voxels of every type, more of them than 32 bits count, and scenes from a tenth of a millimetre to
// two metres: the same answers.

namespace {

using datasets::Random;
using haptics::Grid;
using haptics::Pose;
using haptics::Quat;
using haptics::ScalarType;
using haptics::Vec3;
using made::at;
using millimetre::h;

TEST(Numbers, EveryTypeOfVoxelIsFeltAtTheSamePlace) {
  struct Row {
    ScalarType type;
    double low, high;  // of the ramp, five voxels wide
  };
  const double ball = 3e-3, radius = 0.012;
  for (const auto& [type, low, high] :
       {Row{ScalarType::UInt8, 0, 255}, Row{ScalarType::Int8, -128, 127},
        Row{ScalarType::UInt16, 0, 65535}, Row{ScalarType::Int16, -32768, 32767},
        Row{ScalarType::UInt32, 0, 4294967295.0},
        Row{ScalarType::Int32, -2147483648.0, 2147483647.0}, Row{ScalarType::Float32, -1e-3, 3e-3},
        Row{ScalarType::Float32, -3e30, 5e30}}) {
    SCOPED_TRACE(haptics::nameOf(type));
    const double middle = 0.5 * (low + high), slope = (high - low) / 5.0;
    const Grid grid = datasets::centredGrid(40, h);
    const auto scene = made::scene(
        datasets::filled(grid, type,
                         [&, low = low, high = high](auto i, auto j, auto k) {
                           const Vec3 p = grid.worldOf(Vec3{double(i), double(j), double(k)});
                           return std::clamp(middle + slope * (radius - p.norm()) / h, low, high);
                         }),
        ballTool(300, ball));
    const auto device = [&](int n) {
      const double a = 1e-3 * n, b = 0.7e-3 * n;
      return at(0.013 * Vec3{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    };
    Trial trial{scene, middle, at(0, 0, 0.02)};
    trial.carry(at(0, 0, 0.02), device(0), 40);
    double worst = 0.0, worst_angle = 0.0;
    for (int n = 0; n < 1500; ++n) {
      trial.step(device(n));
      const Vec3 out = device(n).translation().normalized();
      worst = std::max(worst, (trial.place() - (radius + ball) * out).norm());
      const Vec3 force = trial.last.wrench_W.force;
      ASSERT_GT(force.norm(), 1.5);  // N: 1000 N/m, 2 mm
      worst_angle = std::max(worst_angle, std::acos(std::min(1.0, force.normalized().dot(out))));
    }
    std::cout << haptics::nameOf(type) << ": at most " << worst / h << " voxel off, force "
              << worst_angle * 180.0 / M_PI << " degrees\n";
    EXPECT_EQ(trial.illegal, 0);
    // a shell of points 0.6 mm apart bulges 0.015 voxel, and rolls
    EXPECT_LT(worst, 0.3 * h);
    EXPECT_LT(worst_angle, 0.15);  // rad
  }
}

/// Memory of this process that is really there [MB].
long residentMegabytes() {
  std::ifstream file{"/proc/self/statm"};
  long total = 0, resident = 0;
  file >> total >> resident;
  return resident * 4096 / 1'000'000;
}

// voxels that nobody wrote cost no memory; the contact is beyond the two thousand millionth
TEST(Numbers, AVolumeBeyondTwoToThe31VoxelsIsFeltAtItsFarEnd) {
  Grid grid;
  grid.dims = {1300, 1300, 1300};
  grid.spacing.setConstant(h);
  const long before = residentMegabytes();
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), ScalarType::UInt8).value();
  auto* v = static_cast<std::uint8_t*>(voxels.get());
  const std::int64_t c = 1260;
  for (std::int64_t k = c - 14; k <= c + 14; ++k)
    for (std::int64_t j = c - 14; j <= c + 14; ++j)
      for (std::int64_t i = c - 14; i <= c + 14; ++i) {
        const double d = Vec3{double(i - c), double(j - c), double(k - c)}.norm();
        v[(k * 1300 + j) * 1300 + i] =
            static_cast<std::uint8_t>(std::clamp(127.5 - 40.0 * (d - 10.0), 0.0, 255.0));
      }
  auto volume = haptics::makeVolume(grid, ScalarType::UInt8, std::move(voxels)).value();
  const double ball = 3e-3;
  const auto scene = made::scene(std::move(volume), ballTool(300, ball));
  const long grown = residentMegabytes() - before;
  std::cout << "a volume of 2,197 MB takes " << grown << " MB of memory, its pyramid "
            << scene->field.pyramid().bytes() / 1'000'000 << " MB\n";
  if (!made::kSanitized) {
    EXPECT_LT(grown, 2'700);  // the voxels once, and the pyramid
  }
  const Vec3 centre = grid.worldOf(Vec3::Constant(double(c)));
  Random random{221};
  for (int n = 0; n < 10; ++n) {
    const Vec3 out = random.direction();
    Trial trial{scene, 127.5, at(centre + 0.03 * out)};
    trial.carry(trial.proxy.X_WP, at(centre + 0.011 * out), 40);
    trial.hold(at(centre + 0.011 * out), 60);
    EXPECT_EQ(trial.illegal, 0);
    EXPECT_GT(trial.last.contacts, 0);
    EXPECT_NEAR((trial.place() - centre).norm(), 10.0 * h + ball, 0.2 * h);
    EXPECT_GT(trial.last.wrench_W.force.normalized().dot(out), 0.99);
  }
}

/// What happens in a scene whose every length is `scale` times as large.
struct Happening {
  std::vector<Vec3> places;  ///< over the scale
  std::vector<Quat> turns;
  std::vector<Vec3> forces;
  int contact = 0, recovered = 0;
};
Happening happen(double scale, const std::vector<Vec3>& points, const Vec3& origin, double noise) {
  Grid grid = datasets::centredGrid(40, h * scale);
  grid.origin += scale * origin;
  Random grain{222};
  std::vector<Vec3> scaled;
  for (const Vec3& p : points) scaled.push_back(scale * p);
  const auto scene =
      made::scene(datasets::filled(
                      grid, ScalarType::Float32,
                      [&](auto i, auto j, auto k) {
                        const Vec3 u = Vec3{double(i), double(j), double(k)} - Vec3::Constant(19.5);
                        return 1000.0 * (12.0 - u.norm()) + noise * grain.in(-1.0, 1.0);
                      }),
                  made::tool(std::move(scaled)));
  Random random{223};
  const auto place = [&](const Vec3& p) -> Vec3 { return scale * (origin + p); };
  Pose from = at(place({0, 0, 0.022}));
  Trial trial{scene, 0.0, from};
  trial.coupling.stiffness = 16e3 / scale;  // forces stay, and with them how fast one falls
  Happening happening;
  const auto note = [&] {
    happening.places.push_back(trial.place() / scale - origin);
    happening.turns.push_back(haptics::rotationOf(trial.proxy.X_WP));
    happening.forces.push_back(trial.last.wrench_W.force);
    happening.recovered += !trial.last.outside;
  };
  for (int n = 0; n < 24; ++n) {
    const Vec3 out = (Vec3::UnitZ() + random.box(0.9)).normalized();
    const Pose to =
        at(place(random.in(0.009, 0.016) * out), Quat::Identity().slerp(0.2, random.rotation()));
    trial.judged = false;
    // the surface leaps past the tool and back
    trial.isovalue = n % 6 == 5 ? -4000.0 : 0.0;
    for (int t = 1; t <= 40; ++t) {
      const double share = t / 40.0;
      trial.step(
          haptics::poseOf(from.translation() + share * (to.translation() - from.translation()),
                          Quat{from.linear()}.slerp(share, Quat{to.linear()})));
      note();
    }
    EXPECT_TRUE(trial.isLegal());
    from = to;
  }
  happening.contact = trial.contact;
  return happening;
}

std::vector<Vec3> stick() {
  std::vector<Vec3> points;
  Random random{224};
  for (int n = 0; n < 60; ++n)
    points.push_back(Vec3{1e-3, 1e-3, 6e-3}.cwiseProduct(random.box(1.0)));
  return points;
}

// by powers of two, so that nothing is rounded: a length that does not derive from voxel or tool
// would show
TEST(Numbers, AScaledSceneGivesTheScaledAnswerToTheBit) {
  for (const auto& points : {stick(), std::vector<Vec3>{Vec3::Zero()}}) {
    const Happening one = happen(1.0, points, Vec3::Zero(), 300.0);
    EXPECT_GT(one.contact, 300);
    EXPECT_GT(one.recovered, 0);
    // voxels of 15 um, and of 4 mm
    for (const double scale : {1.0 / 64.0, 4.0}) {
      const Happening other = happen(scale, points, Vec3::Zero(), 300.0);
      EXPECT_EQ(other.contact, one.contact);
      for (std::size_t n = 0; n < one.places.size(); ++n) {
        ASSERT_EQ(other.places[n], one.places[n])
            << points.size() << " points, scale " << scale << ", tick " << n;
        ASSERT_EQ(other.turns[n].coeffs(), one.turns[n].coeffs());
        ASSERT_EQ(other.forces[n], one.forces[n]);
      }
    }
  }
}

// from a micro-CT of 20 um to a body of two metres, ten metres away: rounding only
TEST(Numbers, AScaledSceneFarAwayGivesTheScaledAnswer) {
  const Happening one = happen(1.0, {Vec3::Zero()}, Vec3::Zero(), 0.0);
  for (const double scale : {0.02, 0.3, 5.0}) {
    const Happening other = happen(scale, {Vec3::Zero()}, Vec3{6, -6, 5} / scale, 0.0);
    double worst = 0.0;
    for (std::size_t n = 0; n < one.places.size(); ++n)
      worst = std::max(worst, (other.places[n] - one.places[n]).norm() / h);
    std::cout << "scale " << scale << ": at most " << worst << " voxel off\n";
    EXPECT_LT(worst, 1e-3);
  }
}

}  // namespace
