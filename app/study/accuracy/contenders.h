// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/study/comparison/methods.h"

namespace study {

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

}  // namespace study
