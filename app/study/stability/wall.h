// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "haptics/simulation/device_model.h"

namespace study {

/// A device in a hand, pressed along z on a virtual wall z < 0: one degree of freedom and no
/// proxy, to find what the sampled loop by itself can carry.
struct Wall {
  haptics::DeviceModel device;  ///< its linkage's delay counts
  haptics::HumanHand hand;
  double period = 1e-3;     ///< s
  double damping = 0.0;     ///< N·s/m, virtual
  double controller = 0.0;  ///< N·s/m that the passivity controller may use; 0: none

  /// N·s/m: of device, hand and virtual damper.
  double totalDamping() const { return device.damping + hand.damping + damping; }
  /// 2 b / (T (1 + 2 delay)) [N/m]: the limit of a sampled spring; a delay of d periods adds d to
  /// the half that holding the force costs. To first order in b T / m.
  double theory() const;
};

/// What two seconds on the wall came to.
struct Pressed {
  bool fed = false;        ///< the shaking is kept up by the wall, and is not the encoder's own
  double amplitude = 0.0;  ///< m, half of the way between the extremes of the last 0.2 s
  double energy = 0.0;     ///< J given to the hand
};

/// The hand arrives with 50 mm/s and presses with 3 N. What decides is whether energy is kept up,
/// not how much shakes at the end, for a lightly damped device rings for long without being
/// unstable: the mean kinetic energy of the last half second is not a tenth below that of the half
/// second a second earlier. (A shaking that grows does so until the hand bounces off the wall, and
/// stays.) Up to two steps of the encoder in amplitude are the encoder's own doing. `each` is told
/// time [s] and depth [m] of every period.
Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each = {});

/// The stiffness [N/m] up to which the shaking dies, to 0.5 %; between a fifth and ten times
/// of the theory.
double measuredLimit(const Wall& wall);

/// The same from the spectral radius of the loop as a linear sampled system, without encoder, dry
/// friction and controller, and with a wall that pulls as well. Another way to the same figure.
double linearLimit(const Wall& wall);

}  // namespace study
