// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/wall.h"
#include "haptics/simulation/device_model.h"

namespace study::stability {

/// "1 kHz".
std::string rateOf(double period);

/// What is added to the spring, as shares of the rated damping.
struct Loop {
  const char* name;
  double damping, controller;
};
/// Those that every limit is found for.
inline constexpr Loop kLoops[] = {
    {"plain", 0.0, 0.0}, {"virtual damping", 0.25, 0.0}, {"passivity controller", 0.0, 1.0}};
Wall withLoop(Wall plain, const Loop& loop);

/// A diagram of measured over theoretical limit: a mark for each device, by its number in the table
/// of devices.
Plot limitPlot(const std::string& title, const std::string& description);

/// The measured limit of stiffness of a device on a wall over 2 (b + b_hand) / T, which must be at
/// least 0.85 where the damping is 5 N·s/m or more. `lag`: periods by which a planted error brings
/// the force late, and of which the theory knows nothing.
Case limitCase(const haptics::DeviceModel& device, double period, int lag);

/// The limits of every rated device at 1 and 4 kHz, with and without virtual damping, passivity
/// controller and dry friction, with no and one period of delay; in full two and four as well.
std::vector<Job> limitJobs(Depth depth);

}  // namespace study::stability
