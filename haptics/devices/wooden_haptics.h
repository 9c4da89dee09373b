// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "haptics/devices/capstan_board.h"
#include "haptics/devices/catalogue.h"

namespace haptics {

// WoodenHaptics, an arm of plywood that people build from its makers' drawings: three encoders,
// three motors on capstans, behind the board of capstan_board.h. Its parameters are those that its
// makers published (haptikfabrikenapi, models woodenhaptics_v2015 and _v2019; its board 0.4,
// firmware of October 2019). It senses no rotation: its board has no pins for a gimbal.
//
// The two models differ by their motors alone, 0.0259 N·m/A in 2015 and 0.0603 in 2019, and nothing
// tells them apart: the stronger ones are taken, so that no arm pushes harder than it is asked to.
// One of 2015 pushes with 0.43 of that. For motor a of 2019 their programs have 0.321, which they
// corrected to 0.0603 for the same motor of a Polhem; here too.
//
// Not verified on hardware: all signs. The makers' programs do not agree on them: here those of the
// program for this firmware. Their newest, over a serial line to other firmware, turns b and c.
//
// Not compensated: the arm's own weight.
//
// Not driven: the same arm of aluminium (aluhaptics_v2), whose rest pose is not published, firmware
// of before October 2019, and boards of other makes.

/// The encoders' counts in the rest pose: the upper arm upright, the forearm level.
inline constexpr BoardCounts kWoodenRest{0, 0, 6000, 0, 0, 0};

/// The arm, 2000 counts a turn of its motors.
///
/// A body turns by a about the vertical. In its plane, with r away from the axis and z up, the
/// shoulder stands at z = La = 80 mm. From it the upper arm, Lb = 205 mm, goes at angle b from the
/// vertical to the elbow, and from there the forearm, Lc = 245 mm, at angle c from straight down to
/// the handle; motor c turns c by itself, whatever b does:
///
///   r = Lb sin b + Lc sin c    z = La + Lb cos b - Lc cos c
///
/// Nothing where an encoder of a gimbal counts more than 100: then it is another arm.
std::optional<ArmState> woodenArm(const BoardCounts& counts) noexcept;

/// The arm, for its board.
const CapstanArm& woodenHaptics();

/// The driver "woodenhaptics": without a which, the first that can be opened.
std::vector<DeviceEntry> surveyWoodenHaptics();
Expected<std::unique_ptr<Device>> openWoodenHaptics(const OpenRequest& request);

}  // namespace haptics
