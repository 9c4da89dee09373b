// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/rendering.h"

namespace study {

std::vector<Job> renderingJobs(Depth depth) {
  std::vector<Job> jobs;
  for (const std::string scene : {"sphere", "head"})
    jobs.push_back({"rendering " + scene, "Rendering", depth == Depth::Quick ? 5.0 : 60.0,
                    [=](std::uint64_t) { return drawScene(scene, depth); }});
  return jobs;
}

Outcome notDrawn(const std::string& scene, const std::string& why) {
  Outcome outcome;
  outcome.tables.push_back({"Omissions",
                            {"what", "why"},
                            {{"rendering: image error against frame time, " + scene, why}}});
  return outcome;
}

}  // namespace study
