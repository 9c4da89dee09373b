// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/pose_predictor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptics/servo/servo_loop.h"
#include "tests/scenario/fake_device.h"
#include "tests/support/made.h"

namespace {

using haptics::Pose;
using haptics::PosePredictor;
using haptics::Quat;
using haptics::ServoRate;
using haptics::Vec3;
using made::at;

constexpr double kLead = 0.125e-3;  // s

double apart(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

/// A handle that moves and turns evenly.
Pose evenly(double time) {
  return at(time * Vec3{0.3, -0.2, 0.1} + Vec3{0.01, 0.02, 0.03},
            Quat{Eigen::AngleAxisd{0.4 + 3.0 * time, Vec3{1.0, 2.0, -1.0}.normalized()}});
}

TEST(PosePredictor, TakesAHandThatMovesEvenlyToWhereItWillBe) {
  for (const ServoRate rate : haptics::kServoRates) {
    PosePredictor lead{kLead, 1e-5};
    for (int n = 0; n < 100; ++n) {
      // readings come up to 5 % early or late
      const double time = rate.period() * (n + 0.05 * std::sin(2.0 * n));
      const Pose X = lead.ahead(evenly(time), std::lround(1e9 * time));
      const bool begins = time < 0.9e-3;
      EXPECT_LT(apart(X, evenly(begins ? time : time + kLead)), 1e-9) << rate.hz << ", " << n;
    }
  }
}

TEST(PosePredictor, IsWrongByNoMoreThanItsHandAccelerates) {
  constexpr double kAcceleration = 10.0;  // m/s^2
  for (const ServoRate rate : haptics::kServoRates) {
    PosePredictor lead{kLead, 0.0};
    const auto place = [](double t) { return at(0.5 * kAcceleration * t * t, 0, 0); };
    for (int n = 0; n < 100; ++n) {
      const double time = rate.period() * n;
      const Pose X = lead.ahead(place(time), std::lround(1e9 * time));
      if (n <= rate.hz / 1000) continue;
      const double behind = (place(time + kLead).translation() - X.translation()).norm();
      EXPECT_NEAR(behind, 0.5 * kAcceleration * kLead * (kLead + 1e-3), 1e-9);
    }
  }
}

/// A place as encoders of this step read it.
Vec3 stepped(const Vec3& place, double step) {
  return step * (place / step).array().round().matrix();
}

// an encoder's step is no motion of the hand
TEST(PosePredictor, IsNotAheadOfASlowHandByWhatItsEncoderSteps) {
  constexpr double kStep = 1e-5;  // m
  const Vec3 velocity{1.5e-3, -0.7e-3, 0.2e-3};
  for (const ServoRate rate : haptics::kServoRates) {
    PosePredictor lead{kLead, kStep};
    double most = 0.0;
    for (int n = 0; n < rate.hz; ++n) {
      const double time = rate.period() * n;
      const Vec3 read = stepped(time * velocity, kStep);
      const Pose X = lead.ahead(at(read), std::lround(1e9 * time));
      if (time > 0.01) most = std::max(most, (X.translation() - read).norm());
    }
    // an eighth of a step over a millisecond; over eight, a 64th on each axis
    EXPECT_LT(most, 0.04 * kStep) << rate.hz;
    EXPECT_GT(most, 0.5 * kLead * velocity.norm()) << rate.hz;
  }
}

// what bends by more than a step is led as if encoders were exact
TEST(PosePredictor, FollowsAHandThatShakes) {
  constexpr double kStep = 1e-5, kAmplitude = 2e-4, kTurn = 2.0 * 3.14159 * 60.0;  // m, rad/s
  for (const ServoRate rate : haptics::kServoRates) {
    PosePredictor lead{kLead, kStep};
    for (int n = 0; n < rate.hz / 4; ++n) {
      const double time = rate.period() * n;
      const auto place = [&](double t) {
        return Vec3{kAmplitude * std::sin(kTurn * t), kAmplitude * std::cos(kTurn * t), 0.0};
      };
      const Pose X = lead.ahead(at(stepped(place(time), kStep)), std::lround(1e9 * time));
      if (time < 0.01) continue;
      const double off = (X.translation() - place(time + kLead)).norm();
      // acceleration times lead and half a window, and the steps
      EXPECT_LT(off, 0.5 * kAmplitude * kTurn * kTurn * kLead * 1.2e-3 + kStep) << rate.hz;
    }
  }
}

TEST(PosePredictor, SaysNothingOfAHandItHasNotSeen) {
  PosePredictor lead{kLead, 0.0}, none{0.0, 0.0};
  std::int64_t now = 0;
  const auto next = [&](PosePredictor& one, const Pose& X) { return one.ahead(X, now += 250'000); };
  for (int n = 0; n < 20; ++n) next(lead, evenly(1e-9 * double(now)));
  // the same reading again
  const Pose X = evenly(1e-9 * double(now));
  const Pose X_ahead = next(lead, X);
  EXPECT_GT(apart(X_ahead, X), 1e-5);
  EXPECT_EQ(apart(lead.ahead(X, now), X_ahead), 0.0);
  EXPECT_EQ(apart(next(none, X), X), 0.0);
  // what is no number is passed on, for the gate to see, and is forgotten
  Pose nowhere = X;
  nowhere.translation().y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(next(lead, nowhere).translation().y()));
  for (int n = 0; n < 8; ++n) EXPECT_TRUE(next(lead, X).matrix().allFinite()) << n;
  // after a gap, and after a jump
  now += 6'000'000;
  EXPECT_EQ(apart(next(lead, evenly(1.0)), evenly(1.0)), 0.0);
  for (int n = 0; n < 20; ++n) next(lead, evenly(1e-9 * double(now)));
  lead.forget();
  EXPECT_EQ(apart(next(lead, evenly(2.0)), evenly(2.0)), 0.0);
}

// the lead is of the hand: what the mapping makes of it grows as its motion does
TEST(PosePredictor, ADeviceInItsRatingIsLed) {
  constexpr double kScale = 3.0, kSpeed = 0.2;  // m/s, of the hand
  for (const ServoRate rate : haptics::kServoRates) {
    Vec3 places[2];
    for (const bool led : {false, true}) {
      auto made = std::make_unique<FakeDevice>(at(0, 0, 0));
      made->rated.lead = led ? kLead : 0.0;
      FakeDevice& device = *made;
      haptics::Settings settings;
      settings.position_scale = kScale;
      haptics::ServoLoop loop{std::move(made), settings, at(0, 0, 0.03), 0.0, rate};
      haptics::Snapshot taken;
      for (int n = 1; n <= 100; ++n) {
        device.X_BD.translation().x() = kSpeed * rate.period() * n;
        loop.step(rate.period() * n, n * rate.period_ns());
      }
      loop.snapshots.take(taken);
      places[led] = taken.X_WD.translation();
    }
    EXPECT_NEAR((places[1] - places[0]).x(), kScale * kSpeed * kLead, 1e-9) << rate.hz;
  }
}

// what comes after is another motion: a velocity over the break would be one that the hand never
// had
TEST(PosePredictor, BeginsAnewWhenTheDeviceWasNotReadyOrJumped) {
  const ServoRate rate{4000};
  for (const bool jumped : {false, true}) {
    auto made = std::make_unique<FakeDevice>(at(0, 0, 0));
    made->rated.lead = kLead;
    FakeDevice& device = *made;
    haptics::ServoLoop loop{std::move(made), {}, at(0, 0, 0.03), 0.0, rate};
    haptics::Snapshot taken;
    int n = 0;
    const auto steps = [&](int count) {
      for (int i = 0; i < count; ++i, ++n) loop.step(rate.period() * n, n * rate.period_ns());
      loop.snapshots.take(taken);
      return Vec3{taken.X_WD.translation()};
    };
    const Vec3 before = steps(20);
    // a twentieth of a millimetre is no jump
    const double step = jumped ? 0.02 : 0.05e-3;
    if (!jumped) {
      device.status = haptics::DeviceStatus::NotReady;
      steps(1);
      device.status = haptics::DeviceStatus::Ok;
    }
    device.X_BD.translation().x() += step;
    const Vec3 after = steps(1);
    const double moved = (after - before).x();
    EXPECT_NEAR(moved, jumped ? step : 0.0, 1e-12) << jumped;
    EXPECT_EQ(apart(at(steps(8)), at(after)), 0.0) << jumped;
  }
}

}  // namespace
