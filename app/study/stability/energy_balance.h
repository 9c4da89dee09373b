// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "app/study/report/outcome.h"
#include "haptics/coupling/passivity.h"
#include "haptics/simulation/grip.h"
#include "haptics/solver/mass_metric.h"

namespace study::stability {

/// What a loop gives to the hand, against what is unavoidable and what is taken away, tick by tick.
///
/// A sampled spring gives K/2 times the square of the change of its stretch in a tick. Device and
/// hand take b/T times the square of the motion along the force. Up to the limit of a sampled
/// spring, K = 2 b / T, more is taken than given; beyond it a loop that shakes gives ever more.
class EnergyBalance {
 public:
  EnergyBalance(double stiffness, const haptics::Grip& grip, double period)
      : stiffness_{stiffness}, grip_{grip}, period_{period} {}

  /// `given` [J]: to the hand since the start. `motion`: the handle's since the last tick, while
  /// `held` acted. `stretch` [m]: of the spring now, by the tool's metric.
  void add(double given, const haptics::Wrench& held, const haptics::Twist& motion,
           const haptics::Vector6& stretch) {
    sampled_ += 0.5 * stiffness_ * (stretch - stretch_).squaredNorm();
    stretch_ = stretch;
    const double force = held.force.norm(), torque = held.torque.norm();
    const double along = force > 0.0 ? motion.linear.dot(held.force) / force : 0.0;
    const double about =
        torque > 0.0 ? grip_.gyration * motion.angular.dot(held.torque) / torque : 0.0;
    damped_ += grip_.damping / period_ * (along * along + about * about);
    most_given_ = worse(most_given_, given);
    most_own_ = worse(most_own_, given - sampled_);
    most_left_ = worse(most_left_, given - damped_);
  }

  double mostGiven() const { return most_given_; }  ///< J
  /// J, the most beyond what sampling gives: the method's own share.
  double mostOwn() const { return most_own_; }
  /// J, the most beyond what damping takes: what makes a loop shake.
  double mostLeft() const { return most_left_; }
  double sampled() const { return sampled_; }  ///< J

 private:
  double stiffness_;  ///< N/m
  haptics::Grip grip_;
  double period_;  ///< s
  haptics::Vector6 stretch_ = haptics::Vector6::Zero();
  double sampled_ = 0.0, damped_ = 0.0;
  double most_given_ = 0.0, most_own_ = 0.0, most_left_ = 0.0;
};

}  // namespace study::stability
