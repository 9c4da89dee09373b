// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/study/stability/loops.h"
#include "haptics/carving/burr.h"
#include "haptics/proxy/cutting.h"

namespace study::stability {

/// What is cut: "plate", a half-space; "edge", two planes at a right angle; "thin wall", a plate of
/// three voxels that a press breaks through; "upright wall", such a plate on its edge.
const std::vector<std::string>& cutStages();

/// How the isovalue moves while the burr cuts: a slider is drawn.
enum class IsovalueWay { Still, Rising, ToAndFro };

/// A burr in a hand that cuts.
struct CutWay {
  std::string stage;
  Wall wall;
  double stiffness = 0.0;  ///< N/m
  unsigned seed = 0;       ///< of the grain of the bone
  bool slides = false;     ///< to and fro; else it presses
  IsovalueWay isovalue = IsovalueWay::Still;
};

/// What came of it.
struct CutResult {
  LoopResult loop;
  /// Ticks with a shell point inside, by the evaluator, in the voxels as that tick found them.
  int inside = 0;
  int longest_inside = 0;  ///< of them in a row
  int entered = 0;         ///< rows of them that begin where the isovalue has not fallen
  double removed = 0.0;    ///< m3
  std::vector<haptics::BurrCut> cuts;
  std::vector<double> trace;           ///< poses of device and proxy, wrenches: of every tick
  std::vector<std::byte> left;         ///< voxels at the end
  std::vector<std::byte> carved_anew;  ///< voxels of the uncut volume with the same cuts made
};
/// Deterministic. With `judged` not, `inside` and what follows it are not found out.
CutResult runCut(const CutWay& way, const haptics::CutLaw& law, bool judged = true);
/// A burr of 2 mm in soft bone.
haptics::CutLaw softBone();

}  // namespace study::stability
