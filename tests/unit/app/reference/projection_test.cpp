// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/projection.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace {

using reference::MassMetric;
using reference::Row;
using reference::Twist;
using reference::Vec3;

using Real = long double;
using Vec6 = Eigen::Matrix<Real, 6, 1>;
using Mat6 = Eigen::Matrix<Real, 6, 6>;
using MatX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using VecX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// The same question answered by trying every set of at most six rows as the active one.
class Enumeration {
 public:
  Enumeration(const Twist& free, const std::vector<Row>& rows, const MassMetric& M) {
    M_ = Mat6::Zero();
    M_.topLeftCorner<3, 3>() = Eigen::Matrix<Real, 3, 3>::Identity() * Real(M.mass);
    M_.bottomRightCorner<3, 3>() = M.inertia_W.cast<Real>();
    free_ << free.linear.cast<Real>(), free.angular.cast<Real>();
    A_.resize(static_cast<int>(rows.size()), 6);
    b_.resize(static_cast<int>(rows.size()));
    for (int i = 0; i < A_.rows(); ++i) {
      A_.row(i) << rows[i].n_W.cast<Real>().transpose(),
          rows[i].r_W.cross(rows[i].n_W).cast<Real>().transpose();
      b_[i] = rows[i].bias;
    }
  }

  /// False if no set of rows gives a minimum.
  bool solve(Vec6& best) const {
    bool found = false;
    Real least = 0;
    for (unsigned set = 0; set < 1u << A_.rows(); ++set) {
      std::vector<int> active;
      for (int i = 0; i < A_.rows(); ++i)
        if (set >> i & 1) active.push_back(i);
      Vec6 x;
      if (active.size() > 6 || !minimum(active, x)) continue;
      const Real cost = (x - free_).dot(M_ * (x - free_));
      if (found && cost >= least) continue;
      found = true, least = cost, best = x;
    }
    return found;
  }

 private:
  bool minimum(const std::vector<int>& active, Vec6& x) const {
    x = free_;
    if (!active.empty()) {
      const MatX A = A_(active, Eigen::all);
      const MatX response = M_.fullPivLu().solve(A.transpose());
      const auto lu = (A * response).fullPivLu();
      if (!lu.isInvertible()) return false;
      const VecX share = lu.solve(VecX{b_(active) - A * free_});
      if ((share.array() < 0).any()) return false;
      x += response * share;
    }
    // rounding of long double, far below the tolerance of the comparison
    return ((A_ * x - b_).array() >= -1e-15L * (1 + free_.norm())).all();
  }

  Mat6 M_;
  Vec6 free_;
  MatX A_;
  VecX b_;
};

class ProjectionGenerator {
 public:
  double number(double size) { return size * std::uniform_real_distribution{-1.0, 1.0}(random_); }
  Vec3 vector(double size) { return {number(size), number(size), number(size)}; }
  /// Normals about +z so that cones have room, points of a tool of 50 mm, gaps of microns.
  std::vector<Row> rows(int count, bool coplanar, bool biased) {
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i) {
      Row row;
      row.r_W = vector(0.05);
      row.n_W = coplanar ? Vec3::UnitZ() : Vec3{vector(1.5) + Vec3::UnitZ()}.normalized();
      if (coplanar) row.r_W.z() = -0.02;
      if (biased) row.bias = std::abs(number(1e-5));
      rows.push_back(row);
    }
    return rows;
  }
  Twist twist() { return {vector(0.01), vector(0.3)}; }
  MassMetric metric() {
    haptics::Mat3 root;
    root << vector(0.02), vector(0.02), vector(0.02);
    return {1.0, root * root.transpose() + 1e-5 * haptics::Mat3::Identity()};
  }

 private:
  std::mt19937 random_{7};
};

Twist minus(const Twist& a, const Twist& b) { return {a.linear - b.linear, a.angular - b.angular}; }

TEST(ReferenceProjection, AgreesWithEverySetOfRowsTried) {
  ProjectionGenerator make;
  int slowed = 0, compared = 0;
  for (int trial = 0; trial < 600; ++trial) {
    SCOPED_TRACE(trial);
    const auto rows = make.rows(1 + trial % 8, trial % 5 == 0, trial % 3 == 0);
    const Twist free = make.twist();
    const MassMetric M = make.metric();
    Vec6 exact;
    if (!Enumeration{free, rows, M}.solve(exact)) continue;
    ++compared;
    const Twist expected{exact.head<3>().cast<double>(), exact.tail<3>().cast<double>()};
    const Twist found = reference::constrainedMotion(free, rows, M);
    // 1e-10 of the motion asked for, in the metric
    const Twist difference = minus(found, expected);
    EXPECT_LE(std::sqrt(M.inner(difference, difference)), 1e-10 * std::sqrt(M.inner(free, free)));
    const Twist lost = minus(found, free);
    slowed += M.inner(lost, lost) > 1e-6 * M.inner(free, free);
  }
  EXPECT_GT(compared, 550);
  EXPECT_GT(slowed, 200);  // the sample must hold both kinds
  EXPECT_LT(slowed, 590);
}

// V is the optimum exactly if it is allowed and no allowed U lies on free's side of it
TEST(ReferenceProjection, IsTheNearestAllowedMotionWithManyRows) {
  ProjectionGenerator make;
  int rivals = 0;
  for (const int count : {12, 40, 200}) {
    for (int trial = 0; trial < 60; ++trial) {
      SCOPED_TRACE(testing::Message() << count << " rows, trial " << trial);
      const auto rows = make.rows(count, trial % 2 == 0, false);
      const Twist free = make.twist();
      const MassMetric M = make.metric();
      const Twist V = reference::constrainedMotion(free, rows, M);
      for (const Row& row : rows) EXPECT_GE(reference::excess(row, V), -1e-12);  // m
      const Twist lost = minus(V, free);
      // the cone holds 0 and 2 V: what is lost must be orthogonal to V
      EXPECT_NEAR(M.inner(lost, V), 0.0, 1e-12 * M.inner(free, free));
      for (int rival = 0; rival < 200; ++rival) {
        const Twist U = make.twist();
        bool allowed = true;
        for (const Row& row : rows) allowed = allowed && reference::excess(row, U) >= 0;
        if (!allowed) continue;
        ++rivals;
        EXPECT_GE(M.inner(lost, minus(U, V)), -1e-12);
      }
    }
  }
  EXPECT_GT(rivals, 300);
}

TEST(ReferenceProjection, LeavesAFreeMotionAlone) {
  const Twist free{.linear = {0.01, 0.002, 0.003}, .angular = {0.1, 0.2, 0.3}};
  const std::vector<Row> rows(3);  // z may only grow
  const Twist found = reference::constrainedMotion(free, rows, {});
  EXPECT_EQ(found.linear, free.linear);
  EXPECT_EQ(found.angular, free.angular);
}

TEST(ReferenceProjection, GivesNoMotionWhereNothingIsAllowed) {
  // a slot narrower than both its rows ask for
  const std::vector<Row> rows = {{.n_W = Vec3::UnitZ(), .bias = 1e-5},
                                 {.n_W = -Vec3::UnitZ(), .bias = 1e-5}};
  const Twist found = reference::constrainedMotion({Vec3{0.01, 0, 0}, Vec3::Zero()}, rows, {});
  EXPECT_EQ(found.linear.norm(), 0.0);
  EXPECT_EQ(found.angular.norm(), 0.0);
}

}  // namespace
