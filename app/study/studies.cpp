// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/studies.h"

#include "app/study/accuracy/accuracy.h"
#include "app/study/plan/plan.h"
#include "app/study/stability/stability.h"

namespace study {
namespace {

constexpr std::pair<const char*, Study (*)(Depth)> kStudies[] = {
    {"accuracy", accuracy::accuracyStudy},
    {"stability", stability::stabilityStudy},
    {"plan", plan::planStudy}};

}  // namespace

std::vector<std::string> studyNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : kStudies) names.emplace_back(name);
  return names;
}

std::optional<Study> makeStudy(const std::string& name, Depth depth) {
  for (const auto& [known, make] : kStudies)
    if (name == known) return make(depth);
  return {};
}

}  // namespace study
