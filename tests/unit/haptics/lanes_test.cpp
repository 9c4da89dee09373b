// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/lanes.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <iostream>
#include <set>

#include "datasets/phantoms/making.h"
#include "haptics/field/isosurface.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::Cell;
using haptics::FieldSample;
using haptics::Isosurface;
using haptics::Pose;
using haptics::ScalarField;
using haptics::Vec3;
namespace lanes = haptics::lanes;

/// Runs `f` once for every kind of vector this machine has, and none.
template <class F>
void onEveryTarget(F&& f) {
  std::set<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    names.insert(lanes::targetName());
    f(std::string{lanes::targetName()});
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  std::cout << "on";
  for (const std::string& name : names) std::cout << ' ' << name;
  std::cout << '\n';
}

Vec3 placeIn(const lanes::Places& u, int l) { return {u.x[l], u.y[l], u.z[l]}; }
void put(const Vec3& p, int l, lanes::Places& u) {
  u.x[l] = p.x();
  u.y[l] = p.y();
  u.z[l] = p.z();
}

// inside, on voxels and faces, in the ring around them, and far away
Vec3 somewhere(const haptics::VoxelBox& box, Random& random) {
  Vec3 u;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    u[axis] = random.in(double(box.first[a]) - 2.5, double(box.end[a]) + 1.5);
    if (random.below(8) == 0) u[axis] = std::floor(u[axis]);
    if (random.below(40) == 0) u[axis] *= 1e4;
  }
  return u;
}

/// Every type: first the whole grid, then cropped so that the grid goes on behind every face.
std::shared_ptr<const haptics::Volume> testVolume(int t, Random& random) {
  haptics::Volume volume =
      made::randomVolume(made::oddGrid(t, {19, 23, 17}, random), made::kTypes[t % 7], random);
  if (t >= 7) volume.crop = haptics::VoxelBox{{3, 5, 2}, {14, 16, 13}};
  return made::shared(std::move(volume));
}

TEST(Lanes, AreTheScalarFieldToTheBitOnEveryTargetAndForEveryType) {
  onEveryTarget([](const std::string& target) {
    SCOPED_TRACE(target);
    Random random{91};
    int inside = 0, edges = 0, empty = 0;
    for (int t = 0; t < 14; ++t) {
      const auto volume = testVolume(t, random);
      const haptics::VoxelBox box = volume->bounds();
      const ScalarField field{volume};
      const Isosurface solid{field, volume->least + 0.9 * (volume->greatest - volume->least)};
      for (int n = 0; n < 200; ++n) {
        const int count = 1 + random.below(lanes::kLanes);
        lanes::Places u{};
        for (int l = 0; l < count; ++l) put(somewhere(box, random), l, u);

        lanes::Survey raw, found;
        lanes::survey(field.lattice(), u, count, solid.ceiling(), raw);
        edges += raw.edge != 0;
        solid.survey(u, count, found);
        lanes::Slopes slopes;
        field.slopes(u, count, true, slopes);
        for (int l = 0; l < count; ++l) {
          const Vec3 p = placeIn(u, l);
          const FieldSample here = field.sample(p);
          const auto bound = field.pyramid().bound(p, solid.ceiling());
          ASSERT_EQ(found.empty >> l & 1, bound.lipschitz == 0.0);
          empty += bound.lipschitz == 0.0;
          inside += here.value >= solid.ceiling();
          if (bound.lipschitz > 0.0) {
            ASSERT_EQ(found.value[l], here.value);
            ASSERT_EQ(found.lipschitz[l], bound.lipschitz);
            ASSERT_EQ(found.free[l], std::clamp((solid.ceiling() - here.value) / bound.lipschitz,
                                                0.0, bound.radius));
          } else {
            ASSERT_EQ(found.free[l], bound.radius);
          }
          ASSERT_EQ(slopes.value[l], here.value);
          ASSERT_EQ(placeIn(slopes.exact, l), here.gradient_W);
          ASSERT_LE((placeIn(slopes.central, l) - field.centralGradient(p)).norm(),
                    1e-12 * here.gradient_W.norm() + 1e-9);
        }
      }
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(edges, 20);
    EXPECT_GT(empty, 20);
  });
}

// what a chord is said to be clear of is clear, and what stops it is there
TEST(Lanes, ClearOfAChordWhatTheScalarSearchFindsClear) {
  onEveryTarget([](const std::string& target) {
    SCOPED_TRACE(target);
    Random random{92};
    int through = 0, stopped = 0;
    for (int t = 0; t < 14; ++t) {
      const auto volume = testVolume(t, random);
      const haptics::VoxelBox box = volume->bounds();
      const ScalarField field{volume};
      const double level = volume->least + 0.8 * (volume->greatest - volume->least);
      for (int n = 0; n < 200; ++n) {
        lanes::Chords chords{};
        const int count = 1 + random.below(lanes::kLanes);
        for (int l = 0; l < count; ++l) {
          const Vec3 a = somewhere(box, random);
          Vec3 way = random.in(0.0, 3.0) * random.direction();
          if (random.below(6) == 0) way[random.below(3)] = 0.0;
          put(a, l, chords.a);
          put(a + way, l, chords.b);
          chords.from[l] = random.below(2) == 0 ? 0.0 : random.in(0.0, 0.9);
          chords.level[l] = level;
        }
        lanes::Numbers until;
        std::int64_t cells = 0;
        lanes::clear(field.lattice(), chords, count, until, cells);
        for (int l = 0; l < count; ++l) {
          const Vec3 a = placeIn(chords.a, l), way = placeIn(chords.b, l) - a;
          const double to = std::min(1.0, until[l]);
          ASSERT_GE(until[l], chords.from[l]);
          for (int k = 0; k <= 40 && until[l] > chords.from[l]; ++k) {
            const double share = chords.from[l] + (to - chords.from[l]) * k / 40;
            ASSERT_LT(field.value(a + share * way), level + 1e-9 * volume->greatest)
                << "at " << share << " of " << until[l];
          }
          through += until[l] >= 1.0;
          stopped += until[l] < 1.0;
        }
      }
    }
    EXPECT_GT(through, 2000);
    EXPECT_GT(stopped, 2000);
  });
}

}  // namespace
