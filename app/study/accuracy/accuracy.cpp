// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/accuracy.h"

#include "app/study/accuracy/carving.h"
#include "app/study/accuracy/closed_forms.h"
#include "app/study/accuracy/collision.h"
#include "app/study/accuracy/field_error.h"
#include "app/study/accuracy/projection.h"
#include "app/study/accuracy/scenes.h"
#include "app/study/comparison/scenes.h"

namespace study::accuracy {
namespace {

unsigned narrow(std::uint64_t seed) { return static_cast<unsigned>(seed ^ (seed >> 32)); }

/// What is not measured, and why; what diverged.
Outcome omissions() {
  Outcome outcome;
  outcome.tables.push_back(
      {"Omissions",
       {"what", "why"},
       {{"single precision",
         "Ours computes in double throughout and has no other. In a prototype single-precision "
         "look-ups were 1.8 times as fast and needed a second, exact look at every candidate."},
        {"literal, charitable and accept-inside with a spline",
         "The paper defines its algorithm on the trilinear field; so does the reference."},
        {"rivals with more than 2,126 points",
         "Their time grows with the points: 10^5 take a tenth of a second a tick."},
        {"cases on the spline field's penetration",
         "Its surface is another one than the trilinear field's, by which the scenes are judged: "
         "what the diagrams give as its depth is the distance of the two surfaces. That it does "
         "not enter its own is held by the tests."},
        {"the interpolating spline in the scenes",
         "Palpate does not offer it: it would need a second copy of the volume and makes noise "
         "worse. Its errors as a field are shown."}}});
  return outcome;
}

}  // namespace

Study accuracyStudy(Depth depth) {
  const bool quick = depth == Depth::Quick;
  Study study{
      "accuracy",
      "Error against run time",
      {"How wrong each method is, and what it costs, all methods in one process. Times are "
       "CPU time of the thread. The references share no code with what they judge: closed "
       "forms, sampling in double, enumeration in long double. One does: the best of many "
       "starts, which is our own tick with nothing to hurry it, or any method's legal end "
       "if that is nearer.",
       "Literal, charitable and accept-inside are readings of Chan, Conti, Blevins and "
       "Salisbury (2011). Penalty is the method of McNeely, Puterbaugh and Troy (1999) with the "
       "field as distance, god object the static one of Ortega, Redon and Coquillart "
       "(2007) with the equilibrium of Wan and McNeely (2003) once it is inside; both are "
       "written from their papers. Ours is what Palpate runs."}};
  const auto add = [&](std::string name, const char* section, double cost,
                       std::function<Outcome(std::uint64_t)> run) {
    study.jobs.push_back({std::move(name), section, cost, std::move(run)});
  };
  for (const std::string& solid : analyticSolids())
    add("closed form " + solid, "Closed forms", quick ? 2.0 : 20.0, [=](std::uint64_t seed) {
      return closedForms(solid, quick ? HeldEffort{3, 3, false} : HeldEffort{}, narrow(seed));
    });
  for (const std::string& target : targetNames())
    add("arcs " + target, "Collision", quick ? 2.0 : 120.0, [=](std::uint64_t seed) {
      return collisions(detectors(), target, quick ? 1'000 : 50'000, narrow(seed));
    });
  for (const int rows : {1, 3, 6, 12})
    for (const bool coplanar : {false, true})
      add("projection " + std::to_string(rows) + (coplanar ? " coplanar" : " general"),
          "Projection", rows == 12 ? 3.0 : 0.5, [=](std::uint64_t seed) {
            const int most = rows == 12 ? 300 : 3'000;
            return projections(solvers(), rows, coplanar, quick ? most / 10 : most, narrow(seed));
          });
  for (const double noise : {0.0, 0.02})
    add("field, noise " + shortly(noise), "Fields", quick ? 2.0 : 6.0,
        [=](std::uint64_t seed) { return fieldErrors(noise, quick ? 300 : 2'000, narrow(seed)); });
  add("plates", "Fields", quick ? 2.0 : 20.0, [=](std::uint64_t seed) {
    return plateErrors(quick ? 1 : 6, quick ? 100 : 400, narrow(seed));
  });
  const CarvingEffort carving =
      quick ? CarvingEffort{{1.5, 2.0, 3.0, 6.0}, 4, 300} : CarvingEffort{};
  for (const std::string& shape : carvedShapes())
    add("carved " + shape, "Carving", quick ? 1.0 : 60.0,
        [=](std::uint64_t seed) { return carvings(carvers(), shape, carving, narrow(seed)); });
  add("carved ball at another isovalue", "Carving", quick ? 0.5 : 10.0, [=](std::uint64_t seed) {
    return carvedAtOtherIsovalues(carvers().front(), carving, narrow(seed));
  });
  add("rate of removal", "Carving", quick ? 2.0 : 30.0, [=](std::uint64_t) {
    return carvingRates(pressedLaw(), quick ? RateEffort{{0.5, 2.0, 10.0}, {1000}} : RateEffort{});
  });
  const SceneEffort effort = quick ? SceneEffort{.hands = 5,
                                                 .seconds = 0.2,
                                                 .holds = 8,
                                                 .detours = 2,
                                                 .every_setting = false,
                                                 .stuck_slacks = 3,
                                                 .trials = 50,
                                                 .over_inside = 1.1}
                                   : SceneEffort{};
  SceneEffort fewer = effort;
  fewer.hands = quick ? 2 : 5;
  for (const std::string& scene : comparison::sceneNames()) {
    // the bunny alone takes seconds to make
    if (quick && scene != "hole") continue;
    add("scene " + scene, "The paper's scenes", quick ? 35.0 : 850.0,
        [=](std::uint64_t seed) { return sceneStudy(scene, effort, narrow(seed)); });
    add("scene " + scene + ", epsilon and sub-steps", "The paper's scenes", quick ? 10.0 : 60.0,
        [=](std::uint64_t seed) { return finenessStudy(scene, fewer, narrow(seed)); });
    add("scene " + scene + ", stuck", "The paper's scenes", quick ? 12.0 : 250.0,
        [=](std::uint64_t seed) {
          return stuckStudy(scene, quick ? fewer : effort, narrow(seed));
        });
  }
  add("points flat", "Many points", quick ? 5.0 : 60.0, [=](std::uint64_t) {
    return pointStudy(true,
                      quick ? std::vector{1'000, 10'000}
                            : std::vector{1'000, 3'000, 10'000, 30'000, 100'000, 1'000'000},
                      quick ? std::vector{200} : std::vector{100, 200, 500});
  });
  if (!quick)
    add("points bunny", "Many points", 90.0, [=](std::uint64_t) {
      return pointStudy(false, {1'000, 10'000, 100'000, 1'000'000}, {100, 200, 500});
    });
  add("omissions", "Omissions", 0.1, [](std::uint64_t) { return omissions(); });
  study.front = {
      {{"The tool never enters the surface: the deepest point of any tick is {worst} inside, in "
        "{count} runs.",
        ": penetration"},
       {"No point of the tool passes through a wall: {worst} in {count} runs.",
        ": points through walls"},
       {"Held still against a solid whose nearest place is known in closed form, the proxy is at "
        "most {worst} from it.",
        ": position of ours"},
       {"The tool stands still though a legal pose within 0.5 mm is nearer to the device by more "
        "than a rest gap (truly stuck) in at most {worst} of the contact, of {count} hands, rates "
        "and stiffnesses.",
        ": truly stuck"},
       {"Freed of the paper's freezing, the proxy stays nearer to the device: its mean distance is "
        "at most {worst} times that of the paper's algorithm as it is written, on the same hands.",
        ": coupling distance, ours over literal"},
       {"What a burr leaves of a solid is the ideal ball, groove or cavity within {worst} on the "
        "mean square, in {count} shapes, materials and radii.",
        ": place of the wall, rms"},
       {"A burr that is pressed removes what its law says: off by at most {worst}, in {count} "
        "presses.",
        ": volume removed, off the law"}},
      {"bone: distance to the best pose", "engine: distance to the best pose",
       "hole: distance to the best pose", "Ball held in the wedge: position",
       "Lag of a plate flat on a plane"}};
  return study;
}

}  // namespace study::accuracy
