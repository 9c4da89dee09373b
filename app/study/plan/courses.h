// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/plan/comparison.h"
#include "haptics/core/error.h"

namespace study::plan {

/// How the hand of a course goes.
enum class Way {
  Aimed,   ///< by one of the simulated hand's motions, against the surface
  Held,    ///< pressed against the surface, and then still
  Within,  ///< through the volume and back, whatever is there
  Beyond   ///< the same a metre beside it
};

/// A course before it is made.
struct Planned {
  std::string name;
  std::string phantom;  ///< "grain": a half-space of 10^3 voxels
  std::string tool;     ///< "point": a single one
  int points = 0;       ///< 0: the mesh's vertices
  Way way = Way::Aimed;
  haptics::HandMotion motion = haptics::HandMotion::Slide;
  haptics::SceneOptions options = {};
  double friction = 0.0;
  bool above_everything = false;  ///< the isovalue is above the greatest voxel
  bool brief = false;             ///< only the touch itself: for very many points
};

/// The courses of the study.
std::vector<Planned> courses(Depth depth);

haptics::Expected<Course> made(const Planned& planned, int ticks, std::uint64_t seed);

}  // namespace study::plan
