// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  /// 2 b / (T (1 + 2 delay)) [N/m]: the limit of a sampled spring, to first order in b T / m. A
  /// delay of d periods adds d to the half that holding the force costs.
  double theory() const {
    return 2.0 * totalDamping() / (period * (1.0 + 2.0 * device.linkage.delay));
  }
};

/// What is added to the spring, as shares of the rated damping.
struct Loop {
  const char* name;
  const char* unguarded;  ///< its name where the guard of passivity is off
  double damping, controller;
};
/// Those that every limit is found for.
inline constexpr Loop kLoops[] = {
    {"plain", "no guard", 0.0, 0.0},
    {"virtual damping", "no guard, virtual damping", 0.25, 0.0},
    {"passivity controller", "no guard, passivity controller", 0.0, 1.0}};
Wall withLoop(Wall plain, const Loop& loop);

/// What a measured limit must be of the theory's, at least.
inline constexpr double kLeastOfTheory = 0.85;

/// "1 kHz".
std::string rateOf(double period);

/// What two seconds on the wall came to.
struct Pressed {
  bool fed = false;        ///< the shaking is kept up by the wall, and is not the encoder's own
  double amplitude = 0.0;  ///< m, half of the way between the extremes of the last 0.2 s
  double energy = 0.0;     ///< J given to the hand
};
/// The hand arrives and presses. `each` is told time [s] and depth [m] of every period.
Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each = {});
/// The same with everything in the loop: the tick with a plate of points on a half-space, six
/// degrees of freedom, the limits of the device, no more than half of the rated force.
Pressed pressOnPlane(const Wall& wall, double stiffness);

/// How stiff a wall a loop carries [N/m]; 0 where not even the softest that was tried held.
struct Limit {
  double stiffness = 0.0;
  bool found = true;  ///< not: the stiffest that was tried held as well, so the limit lies above
};
/// The stiffness up to which the shaking dies, to 0.5 %; between a fifth and ten times of the
/// theory.
Limit measuredLimit(const Wall& wall);
/// The same from the spectral radius of the loop as a linear sampled system, without encoder, dry
/// friction and controller, and with a wall that pulls as well. Another way to the same figure.
Limit linearLimit(const Wall& wall);
/// The same through the tick, to 1 %; between 0.7 and twice of what the wall carries.
Limit planeLimit(const Wall& wall);

}  // namespace study::stability
