// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/study/reference/evaluator.h"
#include "app/study/stability/trial.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/phantoms.h"
#include "resources/named_tools.h"
#include "tests/support/made.h"

/// A trial of the stability study, which can tell how deep it is.
struct Trial : study::stability::Trial {
  using study::stability::Trial::Trial;

  double penetration_mm() const {
    return evaluator::penetration_mm(*scene->volume, isovalue, scene->tool.shell.points,
                                     proxy.X_WP);
  }
};

/// A phantom as a scene, with the named tool or the made one.
struct Stage {
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
};
inline haptics::Tool namedTool(const std::string& name) {
  return haptics::makeTool(name, resources::namedToolMesh(name).value()).value();
}
inline Stage stageOf(const std::string& phantom, haptics::Tool tool) {
  datasets::Phantom made = datasets::makePhantom(phantom).value();
  return {haptics::makeScene(made::shared(std::move(made.volume)), std::move(tool)).value(),
          made.isovalue};
}
inline haptics::Tool ballTool(int count, double radius) {
  return made::tool(datasets::ballPoints(count, radius));
}
