// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/study/comparison/methods.h"
#include "app/study/report/outcome.h"
#include "haptics/proxy/tick.h"

namespace study::accuracy {

/// The readings of the paper, as the diagrams call them.
struct Reading {
  const char* name;
  reference::Variant variant;
};
inline constexpr Reading kReadings[] = {{"literal", reference::Variant::Literal},
                                        {"charitable", reference::Variant::Charitable},
                                        {"accept-inside", reference::Variant::AcceptInside}};

/// Ours on its fields and with its normals.
struct Kind {
  const char* name;
  haptics::FieldKind field;
  haptics::NormalKind normal;
};
inline constexpr Kind kKinds[] = {
    {"ours", haptics::FieldKind::Trilinear, haptics::NormalKind::Central},
    {"ours, cell normals", haptics::FieldKind::Trilinear, haptics::NormalKind::Cell},
    {"ours, spline normals", haptics::FieldKind::Trilinear, haptics::NormalKind::Spline},
    {"ours, spline field", haptics::FieldKind::CubicSpline, haptics::NormalKind::Cell}};

/// Methods with settings, each a point of a diagram; the two lists belong together.
struct Contenders {
  struct Name {
    std::string method, setting;
  };
  std::vector<Name> names;
  std::vector<std::unique_ptr<comparison::Method>> methods;
  void add(std::string method, std::string setting, std::unique_ptr<comparison::Method> made) {
    names.push_back({std::move(method), std::move(setting)});
    methods.push_back(std::move(made));
  }
};

/// A tick's work by default, counted: what is judged runs with it, so that no clock decides.
inline const std::string kCounted = "work 20,000";
inline constexpr comparison::Limit kByCount{0, haptics::kTickWork};

/// The rivals, each swept over its own settings; without `every_setting` over few of them.
/// app/study/rivals/README.md has the wider sweep that the best settings are from.
inline void addRivals(Contenders& all, const comparison::Touched& scene,
                      const haptics::PointShell& shell, bool every_setting) {
  const auto counted = [](int sub_steps) {
    return std::to_string(sub_steps) + (sub_steps == 1 ? " sub-step" : " sub-steps");
  };
  for (const Reading& reading : kReadings) {
    reference::Choices choices = reference::choicesFor(scene.volume->grid, reading.variant);
    const auto add = [&](int share, int sub_steps) {
      choices.epsilon = choices.feature / share;
      all.add(
          reading.name,
          "epsilon f/" + std::to_string(share) + (sub_steps > 1 ? ", " + counted(sub_steps) : ""),
          comparison::rival(scene, shell, choices, sub_steps));
    };
    add(10, 1);
    if (!every_setting) continue;
    for (const int share : {2, 50}) add(share, 1);
    add(10, 4);
  }
  // softer ones hold with coarser steps
  std::vector<std::pair<double, int>> stiffnesses{{30e3, 4}, {3e3, 2}};
  std::vector<int> motions{8, 4};
  if (every_setting) {
    stiffnesses.insert(stiffnesses.end(), {{3e3, 1}, {10e3, 4}, {30e3, 8}, {100e3, 8}});
    motions.insert(motions.end(), {6, 16});
  }
  for (const auto& [stiffness, sub_steps] : stiffnesses) {
    rivals::PenaltySettings settings;
    settings.point_stiffness = stiffness;
    settings.sub_steps = sub_steps;
    all.add("penalty", shortly(1e-3 * stiffness) + " kN/m, " + counted(sub_steps),
            comparison::penalty(scene, shell, settings));
  }
  for (const int sub_steps : motions)
    all.add("god object", counted(sub_steps),
            comparison::godObject(scene, shell, {.sub_steps = sub_steps}));
}

/// Values of what is a constant for everybody but studies; among them the constant itself.
struct FinenessSweep {
  std::vector<double> epsilons = {0.0125, 0.025, 0.05, 0.1, 0.2};  ///< voxels
  std::vector<int> sub_steps = {1, 2, 4, 8, 16, 32};
};

/// Ours with each of them, by counted work. The field is that of `built`.
inline Contenders withFineness(const haptics::Scene& built, double isovalue,
                               const FinenessSweep& sweep) {
  Contenders all;
  const auto add = [&](const char* method, const std::string& setting, haptics::Fineness fineness) {
    haptics::SceneOptions options;
    options.fineness = fineness;
    all.add(method, setting,
            comparison::ours(haptics::makeScene(built.volume, built.tool, options, &built).value(),
                             isovalue, kByCount));
  };
  for (const double epsilon : sweep.epsilons)
    add("ours, epsilon", shortly(epsilon) + " voxel", {.epsilon = epsilon});
  for (const int sub_steps : sweep.sub_steps)
    add("ours, sub-steps", std::to_string(sub_steps), {.sub_steps = sub_steps});
  return all;
}

}  // namespace study::accuracy
