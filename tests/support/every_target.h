// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <iostream>
#include <set>
#include <string>

#include "haptics/field/lanes.h"

/// Runs `f` once for every kind of vector this machine has, and none.
template <class F>
void onEveryTarget(F&& f) {
  std::set<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    names.insert(haptics::lanes::targetName());
    f(std::string{haptics::lanes::targetName()});
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  std::cout << "on";
  for (const std::string& name : names) std::cout << ' ' << name;
  std::cout << '\n';
}
