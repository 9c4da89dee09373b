// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/stability.h"

#include <iterator>

#include "app/study/stability/failures.h"
#include "app/study/stability/hands.h"
#include "app/study/stability/limits.h"
#include "app/study/stability/presses.h"

namespace study {

Study stabilityStudy(Depth depth) {
  Study study{"stability", "Numerical stability on stiff and extreme cases", {}, {}};
  study.introduction = {
      "Each case has a bound, a figure, and passes or fails. A device is a mass in a human hand "
      "(spring, damper, mass), with encoders, motors within their rating, a force held between "
      "two ticks, and where it is said a period of delay. Ratings are the makers'; moving masses, "
      "damping and what encoders resolve are mostly not public, and then defaults: see "
      "haptics/simulation/device_model.h for which is which. Nothing here was measured on a real "
      "device.",
      "The stiffest wall is one degree of freedom, so that what the sampled loop can carry is "
      "known apart from the rendering: measured, by the theory 2 b / (T (1 + 2 delay)), and by the "
      "spectral radius of the linear loop. The presses, hands and failures go through the tick "
      "itself, with a counted budget, so that every run is the same.",
      "Energy is what the loop gives to the hand less what it takes, exact for a force that is "
      "held. After a press and release nothing is stored any more: what is left was generated."};
  for (const auto& jobs : {failureJobs(depth), limitJobs(), pressJobs(depth), handJobs(depth)})
    study.jobs.insert(study.jobs.end(), jobs.begin(), jobs.end());
  return study;
}

}  // namespace study
