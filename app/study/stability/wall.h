// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "haptics/simulation/device_model.h"

namespace study::stability {

/// A device in a hand, pressed along z on a virtual wall z < 0: one degree of freedom and no
/// proxy, to find what the sampled loop by itself can carry.
struct Wall {
  haptics::DeviceModel device;  ///< its linkage's delay counts
  haptics::HumanHand hand = {};
  double period = 1e-3;     ///< s
  double damping = 0.0;     ///< N·s/m, virtual
  double controller = 0.0;  ///< N·s/m that the passivity controller may use; 0: none

  /// N·s/m: of device, hand and virtual damper.
  double totalDamping() const { return device.damping + hand.damping + damping; }
  /// 2 b / (T (1 + 2 delay)) [N/m]: the limit of a sampled spring; a delay of d periods adds d to
  /// the half that holding the force costs. To first order in b T / m.
  double theory() const;
};

/// How long a press for a limit takes [s], how fast the hand arrives [m/s] and how hard it presses
/// [N].
inline constexpr double kPressTime = 2.0, kArrival = 0.05, kPressForce = 3.0;

/// Tells whether a press shakes on. What decides is whether energy is kept up, not how much shakes
/// at the end, for a lightly damped device rings for long without being unstable: the mean kinetic
/// energy of the last half second is not a tenth below that of the half second a second earlier. (A
/// shaking that grows does so until the hand bounces off the wall, and stays.)
class Shaking {
 public:
  /// The handle's place [m] and speed [m/s] at a time [s] since the arrival, in every period.
  void add(double time, double place, double speed);
  /// m, half of the way between the extremes of the last 0.2 s.
  double amplitude() const { return 0.5 * (highest_ - lowest_); }
  /// A metre or a kilometre a second away, or what is no number: nothing to go on with.
  bool isLost() const { return lost_; }
  /// Up to two steps of the encoder [m] in amplitude are the encoder's own doing.
  bool isFed(double encoder) const {
    return lost_ || (late_ > 0.9 * early_ && amplitude() > 2.0 * encoder);
  }

 private:
  bool lost_ = false;
  double early_ = 0.0, late_ = 0.0, lowest_ = INFINITY, highest_ = -INFINITY;
};

/// How stiff a wall a loop carries [N/m]; 0 where not even the softest that was tried held.
struct Limit {
  double stiffness = 0.0;
  bool found = true;  ///< not: the stiffest that was tried held as well, so the limit lies above
};

/// "1234", or "over 1234" where no limit was found.
std::string toWords(const Limit& limit);

/// The stiffness up to which all `holds`: from `least` to `most` [N/m] in steps of a ratio, since
/// beyond its limit a bouncing loop may be quiet again; then by bisection to `resolution`, a ratio
/// too.
template <class Holds>
Limit stiffestThatHolds(double least, double most, double step, double resolution, Holds&& holds) {
  if (!holds(least)) return {};
  double low = least, high = least;
  while (high == low) {
    if (low >= most) return {low, false};
    high = std::min(step * low, most);
    if (holds(high)) low = high;
  }
  while (high > resolution * low) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return {low, true};
}

/// What two seconds on the wall came to.
struct Pressed {
  bool fed = false;        ///< the shaking is kept up by the wall, and is not the encoder's own
  double amplitude = 0.0;  ///< m, half of the way between the extremes of the last 0.2 s
  double energy = 0.0;     ///< J given to the hand
};

/// The hand arrives and presses. `each` is told time [s] and depth [m] of every period.
Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each = {});

/// The stiffness up to which the shaking dies, to 0.5 %; between a fifth and ten times of the
/// theory.
Limit measuredLimit(const Wall& wall);

/// The same from the spectral radius of the loop as a linear sampled system, without encoder, dry
/// friction and controller, and with a wall that pulls as well. Another way to the same figure.
double linearLimit(const Wall& wall);

}  // namespace study::stability
