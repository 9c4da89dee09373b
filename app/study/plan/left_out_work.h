// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/collision/second_look.h"
#include "haptics/omissions.h"

namespace study::plan {

/// Does what collision detection left out, where `plan` says that it is not to be left out:
///
/// - not empty space: samples every point at every pose, and every cell of its path, without the
///   pyramid;
/// - not room that motion has not used up: surveys every point at every pose, and follows those
///   that could be reached;
/// - not gradients of far points: looks for the surface along the gradient of every point.
class LeftOutWork final : public haptics::SecondLook {
 public:
  LeftOutWork(const haptics::Plan& plan, const haptics::ShellTree& tree);

  bool collected(const haptics::NearTool& tool, double reach,
                 haptics::Budget& budget) HAPTICS_RT override;
  void gathered(const haptics::NearTool& tool, const haptics::Tolerances& lengths,
                haptics::SurfaceRows& surface, haptics::Budget& budget) HAPTICS_RT override;
  void swept(const haptics::NearTool& tool, const haptics::Twist& motion,
             const haptics::Tolerances& lengths, haptics::Sweep& sweep,
             haptics::Budget& budget) HAPTICS_RT override;

 private:
  haptics::Plan plan_;
  std::vector<std::size_t> follow_;  ///< places that a sweep must look at; room for every point
  std::size_t follow_count_ = 0;
  double reach_ = -1.0;         ///< m: what was looked at, in `search_`
  std::uint32_t search_ = 0;    ///< of the clearance
  std::uint32_t gathered_ = 0;  ///< the search whose rows were looked at
};

}  // namespace study::plan
