// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/stability.h"

#include "app/study/stability/rivals.h"

namespace study::stability {
namespace {

/// What is coarser than the full product of everything with everything, so that nothing is skipped
/// silently.
Outcome omissions(Depth depth) {
  Table table{
      "Omissions",
      {"part", "in full it would be", "what is run", "why"},
      {{"presses at 4 kHz", "every stiffness of 1 kHz",
        "50, 1000, 5000 and 20,000 N/m beside the default and what is allowed",
        "four times the ticks each"},
       {"presses without the guard, with virtual damping, with the passivity controller",
        "every device, stiffness, noise and delay",
        "four devices (a coarse encoder, torque motors, the stiffest, the weakest), without noise, "
        "at 1, 1.6 and 4 times what is allowed",
        "none of it is shipped; the limits are found for every device in each way"},
       {"presses on the paper's scenes", "every device, stiffness, noise and delay",
        "wedge, pry and hook, lambda.7, as shipped at what is allowed, and at 5000 N/m with and "
        "without the controller",
        "some seconds for a scene and a hundred thousand ticks and more a hand; noise is part of "
        "each scene"},
       {"limits through the tick", "every delay, with dry friction, on groove and ball",
        "on the plane, in time and as late as the device's link, with and without its lead",
        "there the tick must keep 85 % of the wall's; delay and friction are swept on the wall"},
       {"devices with an arm", "limits of stiffness", "presses and a turned handle",
        "the limits are of translation, in which an arm is nothing"},
       {"recorded hands", "people, on real devices", "none",
        "there are no recordings, and nothing here was measured on a device"}}};
  if (depth == Depth::Quick)
    table.rows.insert(table.rows.begin(),
                      {"all of it", "the full study", "--quick",
                       "minutes: a tenth of the tries, fewer stiffnesses, noises, delays and "
                       "devices, one of the paper's scenes; run it without --quick"});
  return {.tables = {table}};
}

}  // namespace

Study stabilityStudy(Depth depth) {
  Study study{"stability", "Numerical stability on stiff and extreme cases", {}, {}};
  study.introduction = {
      "Each case has a bound, a figure, and passes or fails. A device is a mass in a human hand "
      "(spring, damper, mass), with encoders, motors within their rating, a force held between two "
      "ticks, and where it is said a period of delay. Ratings are the makers'; moving masses, "
      "damping and what encoders resolve are mostly not public, and then defaults: see "
      "haptics/simulation/device_model.h for which is which. Nothing here was measured on a real "
      "device.",
      "The stiffest wall is one degree of freedom, so that what the sampled loop can carry is "
      "known apart from the rendering: measured, by the theory 2 b / (T + 2 lateness), where the "
      "lateness is the delay less the lead, and by the spectral radius of the linear loop. The "
      "presses, hands and failures go through the tick itself, with a counted budget, so that "
      "every run is the same.",
      "A case is the program as it is shipped: the guard of passivity, the ramp, the limits of the "
      "device, and no stiffer than is allowed for its device, delay and rate, which is its rating "
      "and at most 0.45 of 2 b / (T (1 + 2 delay)). What is stiffer, or runs without the guard or "
      "with what is not shipped, are rows of tables.",
      "Energy is what the loop gives to the hand less what it takes, exact for a force that is "
      "held. After a press and release nothing is stored any more: what is left was generated."};
  for (const auto& jobs : {failureJobs(depth), limitJobs(depth), pressJobs(depth), handJobs(depth),
                           structureJobs(), cutJobs(depth), rateJobs(depth), rivalJobs(depth)})
    study.jobs.insert(study.jobs.end(), jobs.begin(), jobs.end());
  study.jobs.push_back(
      {"omissions", "What is left out", 0.01, [=](std::uint64_t) { return omissions(depth); }});
  study.front = {
      {{"In {count} of the paper's and our own failure cases at most {worst} ticks end with a "
        "point "
        "inside.",
        "/ticks inside"},
       {"In {count} presses the evaluator finds a point inside {worst} times.",
        "/looks that found it inside"},
       {"A burr that cuts plates, edges and thin walls never enters what it leaves: {worst} ticks "
        "in {count} sweeps of stiffness.",
        "/ticks inside what is left"},
       {"Nothing diverges: {worst} values that are not finite in {count} runs.", "/not finite"},
       {"A press and its release give the hand at most {worst}, which is less than a touch of a "
        "fingertip; {count} presses, with each device, stiffness, noise and delay.",
        "/energy given"},
       {"The stiffest wall that a device can carry is reached to {worst} of what theory allows, in "
        "{count} configurations.",
        "/plain"}},
      {"A press on a wall: omega.6", "press/omega.6/plane: energy given in a press",
       "Energy given: bone"}};
  return study;
}

}  // namespace study::stability
