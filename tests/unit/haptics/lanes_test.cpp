// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/field/isosurface.h"
#include "haptics/field/spline_lanes.h"
#include "tests/support/every_target.h"
#include "tests/support/made.h"
#include "tests/unit/haptics/spline_reference.h"

namespace {

using datasets::Random;
using haptics::FieldKind;
using haptics::FieldSample;
using haptics::Isosurface;
using haptics::Pose;
using haptics::ScalarField;
using haptics::Vec3;
namespace lanes = haptics::lanes;

/// What every target has to find, to the bit: what the first one found.
class SameOnEveryTarget {
 public:
  void begin() {
    first_ = first_ && found_.empty();
    at_ = 0;
  }
  void found(double value) {
    if (first_) {
      found_.push_back(value);
      return;
    }
    ASSERT_LT(at_, found_.size());
    ASSERT_EQ(std::memcmp(&value, &found_[at_], sizeof value), 0) << value << ", " << found_[at_];
    ++at_;
  }
  std::size_t size() const { return found_.size(); }

 private:
  bool first_ = true;
  std::size_t at_ = 0;
  std::vector<double> found_;
};

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

/// Two volumes and two kinds of field.
class LanesOf : public testing::TestWithParam<FieldKind> {};
INSTANTIATE_TEST_SUITE_P(Lanes, LanesOf,
                         testing::Values(FieldKind::Trilinear, FieldKind::CubicSpline),
                         [](const auto& kind) {
                           return kind.param == FieldKind::Trilinear ? "Trilinear" : "CubicSpline";
                         });

TEST_P(LanesOf, AreTheScalarFieldToTheBitOnEveryTargetAndForEveryType) {
  SameOnEveryTarget same;
  onEveryTarget([&](const std::string& target) {
    SCOPED_TRACE(target);
    same.begin();
    Random random{91};
    int inside = 0, edges = 0, together = 0, empty = 0;
    for (int t = 0; t < 14; ++t) {
      const auto volume = testVolume(t, random);
      const haptics::VoxelBox box = volume->bounds();
      const ScalarField field{volume, GetParam()};
      const double range = volume->greatest - volume->least;
      // a spline leaves less of the noise
      const Isosurface solid{
          field, volume->least + (GetParam() == FieldKind::Trilinear ? 0.9 : 0.7) * range};
      for (int n = 0; n < 200; ++n) {
        const int count = 1 + random.below(lanes::kLanes);
        lanes::Places u{};
        for (int l = 0; l < count; ++l) put(somewhere(box, random), l, u);

        lanes::Survey raw, found;
        if (GetParam() == FieldKind::Trilinear)
          lanes::survey(field.lattice(), u, count, solid.ceiling(), raw);
        else
          lanes::spline::survey(field.lattice(), u, count, solid.ceiling(), raw);
        edges += raw.edge != 0;
        together += std::popcount(~raw.edge & ((1U << count) - 1U));
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
          for (int axis = 0; axis < 3; ++axis) same.found(placeIn(slopes.central, l)[axis]);
        }
      }
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(edges, 20);
    EXPECT_GT(together, 2000);
    EXPECT_GT(empty, 20);
  });
}

// what a chord is said to be clear of is clear, and what stops it is there
TEST_P(LanesOf, ClearOfAChordWhatTheScalarSearchFindsClear) {
  SameOnEveryTarget same;
  onEveryTarget([&](const std::string& target) {
    SCOPED_TRACE(target);
    same.begin();
    Random random{92};
    int through = 0, stopped = 0;
    for (int t = 0; t < 14; ++t) {
      const auto volume = testVolume(t, random);
      const haptics::VoxelBox box = volume->bounds();
      const ScalarField field{volume, GetParam()};
      const double level = volume->least + (GetParam() == FieldKind::Trilinear ? 0.8 : 0.65) *
                                               (volume->greatest - volume->least);
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
        field.clear(chords, count, until, cells);
        same.found(double(cells));
        for (int l = 0; l < count; ++l) {
          const Vec3 a = placeIn(chords.a, l), way = placeIn(chords.b, l) - a;
          const double to = std::min(1.0, until[l]);
          ASSERT_GE(until[l], chords.from[l]);
          same.found(until[l]);
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

/// Voxels about a cell, from 0 to 1000, that bend F up along `way` at x as far as voxels can, but
/// for those that level it there.
std::array<double, 64> bentUp(const Vec3& x, const Vec3& way) {
  std::array<double, 64> voxels{}, slopes{};
  double slope = 0.0, up = 0.0, down = 0.0;
  for (int v = 0; v < 64; ++v) {
    const auto n = static_cast<std::size_t>(v);
    const Vec3 voxel{v % 4 - 1.0, v / 4 % 4 - 1.0, v / 16 - 1.0};
    const auto weight = [&](double t) {
      const Vec3 away = x + t * way - voxel;
      return spline_reference::kernel(away.x()) * spline_reference::kernel(away.y()) *
             spline_reference::kernel(away.z());
    };
    constexpr double t = 0.01;
    if (weight(t) - 2.0 * weight(0.0) + weight(-t) < 0.0) {
      voxels[n] = 1000.0;
      slope += 1000.0 * (weight(t) - weight(-t));
    } else {
      slopes[n] = weight(t) - weight(-t);
      (slopes[n] > 0.0 ? up : down) += slopes[n];
    }
  }
  const double level = std::min(1000.0, -slope / (slope < 0.0 ? up : down));
  for (std::size_t n = 0; n < 64; ++n)
    if (slopes[n] * slope < 0.0) voxels[n] = level;
  return voxels;
}

// between its ends F rises no higher than the bound says, about voxels that bend it up as far as
// voxels can
TEST(SplineLanes, ClearNoChordThatReachesItsLevelBetweenItsEnds) {
  onEveryTarget([](const std::string& target) {
    SCOPED_TRACE(target);
    Random random{93};
    int cleared = 0, between = 0;
    double nearest = 0.0;  // share of the bound that a chord uses
    for (int n = 0; n < made::trials(400); ++n) {
      // often on a face of the cell, where a spline bends most, and along an axis
      Vec3 x = random.box(0.5) + Vec3::Constant(0.5), way = random.direction();
      for (int axis = 0; axis < 3; ++axis)
        if (random.below(2) == 0) x[axis] = random.below(2) == 0 ? 0.05 : 0.95;
      if (random.below(2) == 0) way = Vec3::Unit(random.below(3));
      const std::array<double, 64> voxels = bentUp(x, way);
      const auto volume = made::shared(datasets::filled(
          datasets::centredGrid(8, 1e-3), haptics::ScalarType::Float32,
          [&](auto i, auto j, auto k) {
            if (std::min({i, j, k}) < 2 || std::max({i, j, k}) > 5) return 500.0;
            return voxels[static_cast<std::size_t>((k - 2) * 16 + (j - 2) * 4 + i - 2)];
          }));
      const ScalarField field{volume, FieldKind::CubicSpline};
      // as long as the cell has room on both sides
      double half = random.in(0.005, 0.4);
      for (int axis = 0; axis < 3; ++axis)
        half =
            std::min(half, std::min(x[axis], 1.0 - x[axis]) / std::max(1e-9, std::abs(way[axis])));
      half *= 1.0 - 1e-6;
      const Vec3 a = Vec3::Constant(3.0) + x - half * way, b = a + 2.0 * half * way;
      const double ends = std::max(spline_reference::fieldAtIndex(*volume, a),
                                   spline_reference::fieldAtIndex(*volume, b));
      double top = ends;
      for (int k = 0; k <= 64; ++k)
        top = std::max(top, spline_reference::fieldAtIndex(*volume, a + (b - a) * k / 64.0));
      const double bound = 1000.0 * 2.0 * 4.0 * half * half / 8.0;
      nearest = std::max(nearest, (top - ends) / bound);
      between += top > ends + 1e-6;
      // as many levels as lanes: up to what F reaches, and above
      lanes::Chords chords{};
      for (int l = 0; l < lanes::kLanes; ++l) {
        put(a, l, chords.a);
        put(b, l, chords.b);
        chords.level[l] = top - 1e-9 + (l < 8 ? -(top - ends) * l / 8.0 : bound * (l - 7) / 2.0);
      }
      lanes::Numbers until;
      std::int64_t cells = 0;
      lanes::spline::clear(field.lattice(), chords, lanes::kLanes, until, cells);
      ASSERT_EQ(cells, lanes::kLanes);
      for (int l = 0; l < lanes::kLanes; ++l) {
        if (chords.level[l] <= top)
          ASSERT_EQ(until[l], 0.0) << "level " << chords.level[l] << " of " << top;
        else
          cleared += until[l] >= 1.0;
      }
    }
    EXPECT_GT(cleared, made::trials(400));
    EXPECT_GT(between, made::trials(100));
    EXPECT_GT(nearest, 0.9);
  });
}

}  // namespace
