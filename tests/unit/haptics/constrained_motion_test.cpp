// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/constrained_motion.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "datasets/phantoms/making.h"
#include "haptics/solver/row_lanes.h"
#include "tests/support/every_target.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::ConstrainedMotion;
using haptics::constrainedMotion;
using haptics::MassMetric;
using haptics::Mat3;
using haptics::MotionRow;
using haptics::Quat;
using haptics::Twist;
using haptics::Vec3;
using haptics::Vector6;

constexpr double kReach = 0.03;  // m: size of the made tools

double slack(const MotionRow& row, const Twist& V) {
  return row.n_W.dot(V.linear + V.angular.cross(row.r_W)) + row.room;
}
bool allowed(const std::vector<MotionRow>& rows, const Twist& V, double tolerance) {
  for (const MotionRow& row : rows)
    if (slack(row, V) < -tolerance) return false;
  return true;
}
Twist between(const Twist& A, const Twist& B) {
  return {A.linear - B.linear, A.angular - B.angular};
}

/// A tool, where it stands, and what it is asked to do, all at one length scale.
struct Case {
  MassMetric metric{Mat3::Identity()};
  Mat3 R_WP = Mat3::Identity();
  Twist free;
  std::vector<MotionRow> rows;

  double inner(const Twist& A, const Twist& B) const {
    return metric.whitened(A, R_WP).dot(metric.whitened(B, R_WP));
  }
  ConstrainedMotion solve() const { return constrainedMotion(free, rows, metric, R_WP); }
};

Twist twist(Random& random, double size, double reach) {
  return {size * random.direction() * random.in(0.0, 1.0),
          size / reach * random.direction() * random.in(0.0, 1.0)};
}

Case someCase(Random& random, int count, double scale = 1.0) {
  const double reach = kReach * scale;
  Case c;
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(Vec3{1, 0.3, 0.5}.cwiseProduct(random.box(reach)));
  c.metric = MassMetric{haptics::makeShell(points)->inertia};
  c.R_WP = random.rotation().toRotationMatrix();
  c.free = twist(random, 5e-3 * scale, reach);
  // rooms with which a common motion is allowed: some must leave, some may approach
  const Twist some = twist(random, 5e-4 * scale, reach);
  for (int i = 0; i < count; ++i) {
    MotionRow row{random.direction(), random.box(reach), 0.0};
    row.room = random.in(0.0, 3e-4) * scale - slack(row, some);
    c.rows.push_back(row);
  }
  return c;
}

// V is the optimum exactly if it is allowed and no allowed U lies on free's side of it.
TEST(ConstrainedMotion, IsTheNearestMotionThatLeavesEveryContactItsRoom) {
  Random random{21};
  int slowed = 0, rivals = 0, pushed = 0;
  const int trials = made::trials(2000);
  for (int trial = 0; trial < trials; ++trial) {
    SCOPED_TRACE(trial);
    const Case c = someCase(random, 1 + trial % 12);
    const ConstrainedMotion motion = c.solve();
    const Twist& V = motion.twist;
    ASSERT_EQ(motion.status, ConstrainedMotion::Status::Exact);
    // m; rounding of lengths of some mm
    ASSERT_TRUE(allowed(c.rows, V, 1e-15));
    const Twist moved = between(V, c.free);
    for (int n = 0; n < 50; ++n) {
      const double size = n % 2 == 0 ? 1e-4 : 5e-3;
      Twist U = twist(random, size, kReach);
      U.linear += V.linear;
      U.angular += V.angular;
      if (!allowed(c.rows, U, 0.0)) continue;
      ASSERT_GE(c.inner(moved, between(U, V)), -1e-16);  // m²
      ++rivals;
    }
    slowed += c.inner(moved, moved) > 1e-14;
    for (const MotionRow& row : c.rows) pushed += row.room < 0.0;
  }
  EXPECT_GT(slowed, trials / 2);  // the sample must hold both kinds, and rivals
  EXPECT_LT(slowed, trials);
  EXPECT_GT(rivals, 5 * trials);
  EXPECT_GT(pushed, trials);
}

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Non-negative least squares: the multipliers whose rows best make up `target`; Lawson and
/// Hanson's active sets, in no hurry and in long double. Returns what is missing.
double shortfall(const std::vector<Vector6>& rows, const Vector6& wanted) {
  const Vector target = wanted.cast<Real>();
  Vector x = Vector::Zero(static_cast<Eigen::Index>(rows.size()));
  Matrix A(6, static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    A.col(static_cast<Eigen::Index>(i)) = rows[i].cast<Real>();
  std::vector<Eigen::Index> passive;
  for (int round = 0; round < 300; ++round) {
    const Vector w = A.transpose() * (target - A * x);
    Eigen::Index best = -1;
    Real most = 1e-18L * target.norm();
    for (Eigen::Index i = 0; i < w.size(); ++i)
      if (w[i] > most && std::find(passive.begin(), passive.end(), i) == passive.end()) {
        most = w[i];
        best = i;
      }
    if (best < 0) break;
    passive.push_back(best);
    while (!passive.empty()) {
      Matrix P(6, static_cast<Eigen::Index>(passive.size()));
      for (std::size_t i = 0; i < passive.size(); ++i)
        P.col(static_cast<Eigen::Index>(i)) = A.col(passive[i]);
      const Vector s = P.completeOrthogonalDecomposition().solve(target);
      Real step = 1.0L;
      for (std::size_t i = 0; i < passive.size(); ++i) {
        const Real from = x[passive[i]], to = s[static_cast<Eigen::Index>(i)];
        if (to < 0.0L) step = std::min(step, from / (from - to));
      }
      std::vector<Eigen::Index> kept;
      for (std::size_t i = 0; i < passive.size(); ++i) {
        Real& value = x[passive[i]];
        value += step * (s[static_cast<Eigen::Index>(i)] - value);
        if (step == 1.0L || value > 0.0L)
          kept.push_back(passive[i]);
        else
          value = 0.0L;
      }
      passive = kept;
      if (step == 1.0L) break;
    }
  }
  return static_cast<double>((target - A * x).norm());
}

/// How far a motion is from being the optimum, relative to the size of the problem: approach
/// beyond the room, and what no pushing rows in contact can make up of the change.
double karushKuhnTucker(const Case& c, const ConstrainedMotion& motion) {
  const Vector6 y_free = c.metric.whitened(c.free, c.R_WP);
  const Vector6 y = c.metric.whitened(motion.twist, c.R_WP);
  double scale = y_free.norm();
  for (const MotionRow& row : c.rows) scale = std::max(scale, std::abs(row.room));
  double worst = 0.0;
  std::vector<Vector6> touching;
  for (const MotionRow& row : c.rows) {
    const Vector6 a = c.metric.row(row.n_W, row.r_W, c.R_WP);
    const double left = (a.dot(y) + row.room) / a.norm();
    worst = std::max(worst, -left / scale);
    if (left < 1e-9 * scale) touching.push_back(a / a.norm());
  }
  return std::max(worst, shortfall(touching, y - y_free) / scale);
}

// relative: sixteen digits, less what nearly parallel rows cost
TEST(ConstrainedMotion, MeetsTheOptimalityConditionsAtEveryScale) {
  Random random{22};
  int active = 0;
  for (int trial = 0; trial < made::trials(1500); ++trial) {
    SCOPED_TRACE(trial);
    const double scale = std::pow(10.0, 3 * (trial % 3) - 3);  // 30 um, 30 mm, 30 m
    const Case c = someCase(random, 1 + trial % 60, scale);
    const ConstrainedMotion motion = c.solve();
    ASSERT_EQ(motion.status, ConstrainedMotion::Status::Exact);
    ASSERT_LT(karushKuhnTucker(c, motion), 1e-12);
    active += motion.active;
  }
  EXPECT_GT(active, made::trials(2000));
}

TEST(ConstrainedMotion, MeetsThemForCoplanarAndNearlyParallelRows) {
  Random random{23};
  int bent = 0;
  for (int trial = 0; trial < made::trials(1500); ++trial) {
    SCOPED_TRACE(trial);
    const double tilt = std::pow(10.0, -2.0 * (trial % 8));  // rad; the eighth are 1e-14
    const int count = 2 + trial % 59;
    Case c = someCase(random, 0);
    const Vec3 n = random.direction();
    c.free.linear -= 4e-3 * n;
    for (int i = 0; i < count; ++i) {
      Vec3 r = random.box(kReach);
      r -= n * n.dot(r) + 0.5 * kReach * n;  // one plane below the tool
      const Vec3 leaning = trial % 8 == 0 ? n : (n + tilt * random.direction()).normalized();
      c.rows.push_back({leaning, r, 1e-5 * (trial % 5 - 1)});
    }
    const ConstrainedMotion motion = c.solve();
    ASSERT_EQ(motion.status, ConstrainedMotion::Status::Exact);
    // within 1e-8 to 1e-12 rad of parallel the multipliers lose half their digits, and the push of
    // a row may be wrong by that much of it; the rooms are kept to the last digit all the same
    const bool ill = tilt < 1e-7 && tilt > 1e-13;
    ASSERT_LT(karushKuhnTucker(c, motion), ill ? 5e-9 : 1e-12);
    ASSERT_TRUE(allowed(c.rows, motion.twist, 1e-14));  // m
    bent += motion.active > 1;
  }
  EXPECT_GT(bent, made::trials(500));
}

TEST(ConstrainedMotion, TwinRowsAreOneRow) {
  Random random{24};
  for (int trial = 0; trial < 300; ++trial) {
    const Case once = someCase(random, 1 + trial % 6);
    Case many = once;
    for (int n = 0; n < 8; ++n)
      many.rows.insert(many.rows.end(), once.rows.begin(), once.rows.end());
    const Twist difference = between(once.solve().twist, many.solve().twist);
    EXPECT_LT(std::sqrt(once.inner(difference, difference)), 1e-14);  // m
  }
}

TEST(ConstrainedMotion, WithoutRowsInTheWayIsTheFreeMotionToTheBit) {
  Random random{25};
  for (int trial = 0; trial < 100; ++trial) {
    Case c = someCase(random, 10);
    for (MotionRow& row : c.rows) row.room = 1.0;  // m: beyond all reach
    const ConstrainedMotion motion = c.solve();
    EXPECT_EQ(motion.active, 0);
    EXPECT_EQ(motion.twist.linear, c.free.linear);
    EXPECT_EQ(motion.twist.angular, c.free.angular);
  }
}

TEST(ConstrainedMotion, RowsThatContradictEachOtherAreRelaxedAndNoneIsApproached) {
  Random random{26};
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    Case c = someCase(random, 0);
    const Vec3 n = random.direction(), r = random.box(kReach);
    // both sides of a slit ask to be left, and a third row has room
    c.rows = {{n, r, -1e-5}, {-n, r, -2e-5}, {n.unitOrthogonal(), random.box(kReach), 1e-4}};
    const ConstrainedMotion motion = c.solve();
    ASSERT_EQ(motion.status, ConstrainedMotion::Status::Relaxed);
    Case relaxed = c;
    relaxed.rows[0].room = relaxed.rows[1].room = 0.0;
    EXPECT_LT(karushKuhnTucker(relaxed, motion), 1e-12);
    EXPECT_GT(c.inner(motion.twist, motion.twist), 0.0);  // along the slit it may go
  }
}

/// A few hundred problems, with any number of rows, rows that are equal, and rows that say nothing.
std::vector<Case> manyCases() {
  Random random{27};
  std::vector<Case> cases;
  for (int trial = 0; trial < 300; ++trial) {
    Case c = someCase(random, 1 + trial % 80);
    if (trial % 3 == 0) c.rows.insert(c.rows.end(), c.rows.begin(), c.rows.begin() + 1);
    if (trial % 5 == 0) c.rows.front().n_W.setZero();
    cases.push_back(std::move(c));
  }
  return cases;
}

TEST(ConstrainedMotion, EveryKindOfVectorGivesTheSameBits) {
  const std::vector<Case> cases = manyCases();
  std::vector<ConstrainedMotion> first;
  onEveryTarget([&](const std::string& target) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      SCOPED_TRACE(target + ", case " + std::to_string(i));
      const ConstrainedMotion motion = cases[i].solve();
      if (first.size() == i) first.push_back(motion);
      ASSERT_EQ(motion.status, first[i].status);
      ASSERT_EQ(motion.pivots, first[i].pivots);
      ASSERT_EQ(motion.active, first[i].active);
      ASSERT_EQ(motion.bearing, first[i].bearing);
      ASSERT_EQ(motion.reaction, first[i].reaction);
      ASSERT_EQ(motion.whitened, first[i].whitened);
      ASSERT_EQ(motion.twist.linear, first[i].twist.linear);
      ASSERT_EQ(motion.twist.angular, first[i].twist.angular);
    }
  });
}

TEST(ConstrainedMotion, TheMostViolatedRowIsTheFirstOfEquals) {
  namespace lanes = haptics::row_lanes;
  Random random{28};
  onEveryTarget([&](const std::string& target) {
    SCOPED_TRACE(target);
    for (int trial = 0; trial < 500; ++trial) {
      lanes::Rows rows;
      rows.count = lanes::kWidest * (1 + trial % (lanes::kMostRows / lanes::kWidest));
      // few values, so that there are equals; of each row one coordinate
      for (int i = 0; i < rows.count; ++i) {
        for (auto& coordinate : rows.a) coordinate[i] = 0.0;
        rows.a[i % 6][i] = 1.0;
        rows.b[i] = random.below(5);
      }
      double y[6];
      for (double& at : y) at = random.below(3);
      const double tolerance = random.below(3);
      int best = -1;
      double least = -tolerance;
      for (int i = 0; i < rows.count; ++i)
        if (y[i % 6] - rows.b[i] < least) {
          least = y[i % 6] - rows.b[i];
          best = i;
        }
      ASSERT_EQ(lanes::mostViolated(rows, rows.b, y, tolerance), best);
    }
  });
}

TEST(ConstrainedMotion, SaysWhatItCost) {
  for (const Case& c : manyCases()) {
    const ConstrainedMotion motion = c.solve();
    EXPECT_GT(motion.work, 15 * motion.pivots);
    // 10 ns a unit: what a tick does between two looks at its budget
    EXPECT_LT(motion.work, 1000);
  }
}

TEST(ConstrainedMotion, NumbersThatAreNotFiniteYieldNoMotion) {
  Case c;
  c.free = {{NAN, 0, 0}, {0, 0, 0}};
  c.rows = {{Vec3::UnitZ(), Vec3::Zero(), 0.0}};
  const ConstrainedMotion motion = c.solve();
  EXPECT_EQ(motion.status, ConstrainedMotion::Status::Infeasible);
  EXPECT_TRUE(motion.twist.linear.isZero());
  EXPECT_TRUE(motion.twist.angular.isZero());
}

}  // namespace
