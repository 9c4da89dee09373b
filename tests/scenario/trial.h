// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/study/reference/evaluator.h"
#include "app/study/stability/failures.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/phantoms.h"
#include "resources/named_tools.h"
#include "tests/support/made.h"

/// A trial whose judge is the evaluator.
struct Trial : study::stability::Trial {
  Trial(std::shared_ptr<const haptics::Scene> in, double s, const haptics::Pose& X_start)
      : study::stability::Trial{
            std::move(in), s, X_start,
            [](const haptics::Volume& volume, double level,
               const std::vector<haptics::Vec3>& points, const haptics::Pose& X_WP) {
              return evaluator::isLegal(volume, level, points, X_WP);
            }} {}

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
