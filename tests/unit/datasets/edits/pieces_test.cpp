// SPDX-License-Identifier: BSD-3-Clause
// Pieces are what the trilinear field connects; one that goes takes its rim, and the rest stays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/edits/edited.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using namespace datasets;
using namespace haptics;
using datasets::Random;
using millimetre::h;

constexpr double kIso = 300.0;

Volume after(const std::shared_ptr<const Volume>& scan, const Edit& edit) {
  const std::vector<Edit> edits{edit};
  return *edited(scan, edits).value();
}
const std::int16_t* shorts(const Volume& volume) {
  return static_cast<const std::int16_t*>(volume.voxels.get());
}

/// Calls each(index, i, j, k).
template <class F>
void eachVoxel(const Grid& grid, F&& each) {
  for (std::int64_t k = 0, at = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i, ++at) each(at, i, j, k);
}

/// Voxels at or above an isovalue that are connected, by a search of their neighbours.
class SearchedPieces {
 public:
  SearchedPieces(const Volume& volume, double isovalue) : volume_{volume}, isovalue_{isovalue} {
    const auto& dims = volume.grid.dims;
    piece_.assign(std::size_t(volume.grid.voxelCount()), -1);
    eachVoxel(volume.grid, [&](std::int64_t at, std::int64_t i, std::int64_t j, std::int64_t k) {
      if (over(i, j, k) < 0.0 || piece_[std::size_t(at)] >= 0) return;
      std::vector<std::array<std::int64_t, 3>> open{{i, j, k}};
      piece_[std::size_t(at)] = int(sizes.size());
      sizes.push_back(0);
      while (!open.empty()) {
        const auto [a, b, c] = open.back();
        open.pop_back();
        ++sizes.back();
        for (int n = 0; n < 27; ++n) {
          const std::int64_t x = a + n % 3 - 1, y = b + n / 3 % 3 - 1, z = c + n / 9 - 1;
          if (x < 0 || y < 0 || z < 0 || x >= dims[0] || y >= dims[1] || z >= dims[2]) continue;
          const auto other = std::size_t((z * dims[1] + y) * dims[0] + x);
          if (piece_[other] >= 0 || !connected({a, b, c}, {x, y, z})) continue;
          piece_[other] = int(sizes.size()) - 1;
          open.push_back({x, y, z});
        }
      }
    });
  }
  int at(std::int64_t index) const { return piece_[std::size_t(index)]; }

  std::vector<std::int64_t> sizes;

 private:
  using Place = std::array<std::int64_t, 3>;
  double over(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return shorts(volume_)[(k * volume_.grid.dims[1] + j) * volume_.grid.dims[0] + i] - isovalue_;
  }
  bool connected(const Place& p, const Place& q) const {
    if (over(q[0], q[1], q[2]) < 0.0) return false;
    std::vector<std::size_t> axes;
    for (std::size_t a = 0; a < 3; ++a)
      if (p[a] != q[a]) axes.push_back(a);
    if (axes.size() == 1) return true;
    if (axes.size() != 2) return false;
    Place b = p, c = p;
    b[axes[0]] = q[axes[0]];
    c[axes[1]] = q[axes[1]];
    const double u = over(p[0], p[1], p[2]), v = over(q[0], q[1], q[2]), s = over(b[0], b[1], b[2]),
                 t = over(c[0], c[1], c[2]);
    if (s >= 0.0 || t >= 0.0) return true;
    // the value of the bilinear field at its saddle
    return (u * v - s * t) / (u + v - s - t) >= 0.0;
  }

  const Volume& volume_;
  double isovalue_;
  std::vector<int> piece_;
};

TEST(Pieces, AreThoseThatASearchFinds) {
  Random random{196};
  for (int k = 0; k < 8; ++k) {
    // about as much solid as makes many pieces, of many sizes; rows longer than a word
    const Grid grid = made::oddGrid(k, {k % 2 == 0 ? 130 : 40, 17, 19}, random);
    const auto scan = made::shared(datasets::filled(
        grid, ScalarType::Int16, [&](auto, auto, auto) { return random.in(-1000.0, 900.0); }));
    const SearchedPieces pieces{*scan, kIso};
    const double voxel = grid.spacing.prod();
    ASSERT_GT(pieces.sizes.size(), 50U);
    for (const std::int64_t most : {2, 5, 30}) {
      std::int64_t expected = 0;
      for (const std::int64_t size : pieces.sizes) expected += size < most ? size : 0;
      const auto removal =
          removalOf(*scan, RemoveSmallPieces{kIso, (double(most) - 0.5) * voxel}, kIso);
      ASSERT_TRUE(removal);
      EXPECT_NEAR(removal->volume / voxel, double(expected), 1e-6) << most;
    }
    int judged = 0;
    eachVoxel(grid, [&](std::int64_t at, std::int64_t i, std::int64_t j, std::int64_t kk) {
      if (pieces.at(at) < 0 || random.below(150) > 0) return;
      const Vec3 seed = grid.worldOf(Vec3{double(i), double(j), double(kk)});
      const auto removal = removalOf(*scan, RemovePiece{seed, kIso}, 0.0);
      ASSERT_TRUE(removal);
      EXPECT_NEAR(removal->volume / voxel, double(pieces.sizes[std::size_t(pieces.at(at))]), 1e-6);
      ++judged;
    });
    EXPECT_GT(judged, 2);
  }
}

// four voxels of a face: the field connects two across it or does not, as its saddle lies
TEST(Pieces, AreConnectedAcrossAFaceWhereItsSaddleIsSolid) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool turned : {false, true})
      for (const double beside : {200.0, -900.0}) {
        const Grid grid = datasets::centredGrid(8, h);
        const auto scan = made::shared(datasets::filled(
            grid, ScalarType::Int16, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
              std::array<std::int64_t, 3> at{i - 3, j - 3, k - 3};
              std::rotate(at.begin(), at.begin() + axis, at.end());
              if (at[2] != 0 || at[0] < 0 || at[1] < 0 || at[0] > 1 || at[1] > 1) return -1000.0;
              return (at[0] == at[1]) != turned ? 500.0 : beside;
            }));
        // 200 · 200 against 100 · 100, or 200 · 200 against 1200 · 1200
        const auto pieces = removalOf(*scan, RemoveSmallPieces{kIso, 1.5 * h * h * h}, kIso);
        EXPECT_EQ(pieces.has_value(), beside < 0.0) << axis << turned;
      }
}

/// Two balls with soft edges, some voxels apart, and grain.
struct TwoBalls {
  Grid grid = datasets::centredGrid(64, 40, 40, h);
  Vec3 left{-0.014, 0.0, 0.0}, right{0.012, 0.0, 0.0};
  double radius = 0.010;
  std::shared_ptr<const Volume> scan;

  explicit TwoBalls(double gap, unsigned seed = 197) {
    right.x() = left.x() + 2 * radius + gap;
    Random random{seed};
    scan = made::shared(datasets::filled(
        grid, ScalarType::Int16, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
          const Vec3 p = grid.worldOf(Vec3{double(i), double(j), double(k)});
          const double d = std::min((p - left).norm(), (p - right).norm()) - radius;
          return -1000.0 + 2000.0 * std::clamp(0.65 - d / (3 * h), 0.0, 1.0) +
                 random.in(-40.0, 40.0);
        }));
  }
  bool isLeft(std::int64_t i, std::int64_t j, std::int64_t k) const {
    const Vec3 p = grid.worldOf(Vec3{double(i), double(j), double(k)});
    return (p - left).norm() < (p - right).norm();
  }
};

TEST(RemovePiece, LeavesTheRestToTheVoxelAndTheSurfaceWhereItWas) {
  for (const double gap : {1 * h, 2 * h, 3 * h, 4 * h, 8 * h}) {
    const TwoBalls balls{gap};
    const Volume volume = after(balls.scan, RemovePiece{balls.left, kIso});
    const auto& dims = balls.grid.dims;
    const auto *before = shorts(*balls.scan), *now = shorts(volume);
    int near_kept = 0;
    eachVoxel(balls.grid, [&](std::int64_t at, std::int64_t i, std::int64_t j, std::int64_t k) {
      if (before[at] >= kIso) {
        ASSERT_EQ(now[at], balls.isLeft(i, j, k) ? std::int16_t(volume.least) : before[at]);
        if (balls.isLeft(i, j, k)) return;
        // every cell of the kept surface has its voxels
        for (std::int64_t c = std::max<std::int64_t>(0, k - 1); c < std::min(k + 2, dims[2]); ++c)
          for (std::int64_t b = std::max<std::int64_t>(0, j - 1); b < std::min(j + 2, dims[1]); ++b)
            for (std::int64_t a = std::max<std::int64_t>(0, i - 1); a < std::min(i + 2, dims[0]);
                 ++a) {
              const std::int64_t other = (c * dims[1] + b) * dims[0] + a;
              if (before[other] >= kIso && balls.isLeft(a, b, c)) continue;
              ASSERT_EQ(now[other], before[other]);
              ++near_kept;
            }
      }
    });
    EXPECT_GT(near_kept, 1000);
  }
}

TEST(RemovePiece, DoesNotComeBackWhenTheIsovalueFalls) {
  const TwoBalls balls{8 * h};
  // 300 voxel's values per h: the edge falls to -300 within a voxel of the piece
  const Volume volume = after(balls.scan, RemovePiece{balls.left, kIso});
  std::int64_t left = 0, before = 0;
  eachVoxel(balls.grid, [&](std::int64_t at, std::int64_t i, std::int64_t j, std::int64_t k) {
    left += balls.isLeft(i, j, k) && shorts(volume)[at] >= -300.0;
    before += balls.isLeft(i, j, k) && shorts(*balls.scan)[at] >= -300.0 &&
              shorts(*balls.scan)[at] < kIso;
  });
  EXPECT_EQ(left, 0);
  EXPECT_GT(before, 500) << "there was no rim";
}

TEST(KeepPiece, KeepsOnePiece) {
  const TwoBalls balls{6 * h};
  const Volume kept = after(balls.scan, KeepPiece{balls.right, kIso});
  const Volume removed = after(balls.scan, RemovePiece{balls.left, kIso});
  EXPECT_EQ(std::memcmp(kept.voxels.get(), removed.voxels.get(),
                        std::size_t(balls.grid.voxelCount()) * 2),
            0);
  const auto other = removalOf(*balls.scan, KeepPiece{balls.left, kIso}, 0.0);
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->volume, removalOf(*balls.scan, RemovePiece{balls.right, kIso}, 0.0)->volume,
              1e-15);
  const double ball = 4.0 / 3.0 * M_PI * std::pow(balls.radius, 3);
  EXPECT_NEAR(other->volume, ball, 0.1 * ball);
}

TEST(RemovePiece, TakesASeedWithinTwoVoxelsAndNoneFarther) {
  const TwoBalls balls{8 * h};
  const double whole = removalOf(*balls.scan, RemovePiece{balls.left, kIso}, 0.0)->volume;
  const Vec3 up = balls.left + Vec3{0.0, 0.0, balls.radius};
  const auto near = removalOf(*balls.scan, RemovePiece{up + Vec3{0, 0, 0.9 * h}, kIso}, 0.0);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->volume, whole);
  for (const Vec3& seed : {Vec3{up + Vec3{0, 0, 3.5 * h}}, Vec3{100.0, 0.0, 0.0},
                           Vec3{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}}) {
    const auto far = removalOf(*balls.scan, RemovePiece{seed, kIso}, 0.0);
    ASSERT_FALSE(far);
    EXPECT_EQ(far.error().reason, "no-piece");
  }
}

TEST(RemovePiece, LooksWithinTheCropAlone) {
  const TwoBalls balls{8 * h};
  // half of the left ball, and nothing of the right one
  const Crop crop{{{0, 0, 0}, {18, 40, 40}}};
  EditHistory history{balls.scan};
  ASSERT_TRUE(history.apply(crop));
  const auto left = removalOf(*history.present(), KeepPiece{balls.left, kIso}, 0.0);
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().reason, "nothing");
  ASSERT_TRUE(history.apply(RemovePiece{balls.left - Vec3{2 * h, 0, 0}, kIso}));
  eachVoxel(balls.grid, [&](std::int64_t at, std::int64_t i, std::int64_t, std::int64_t) {
    if (i >= 18) {
      ASSERT_EQ(shorts(*history.present())[at], shorts(*balls.scan)[at]);
    }
  });
}

TEST(Pieces, OfEveryTypeAreTheSame) {
  const Grid grid = datasets::centredGrid(20, h);
  for (const ScalarType type : made::kTypes) {
    const auto scan = made::shared(
        datasets::filled(grid, type, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
          const bool one = std::abs(i - 5) < 3 && std::abs(j - 5) < 3 && std::abs(k - 5) < 3;
          const bool two = std::abs(i - 13) < 2 && std::abs(j - 13) < 2 && std::abs(k - 13) < 2;
          return one || two ? 100.0 : 3.0;
        }));
    for (const double isovalue : {4.0, 50.5, 99.5, 100.0}) {
      const auto removal = removalOf(*scan, RemoveSmallPieces{isovalue, 50 * h * h * h}, 0.0);
      ASSERT_TRUE(removal) << nameOf(type) << " " << isovalue;
      EXPECT_NEAR(removal->volume, 27 * h * h * h, 1e-15) << nameOf(type) << " " << isovalue;
    }
    EXPECT_FALSE(removalOf(*scan, RemoveSmallPieces{100.5, 1.0}, 0.0));
  }
}

}  // namespace
