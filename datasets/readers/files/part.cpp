// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/part.h"

#include <string>

#include "datasets/readers/files/refusal.h"

namespace datasets {

haptics::Expected<Window> windowOf(const Part& part, const std::array<std::int64_t, 3>& dims) {
  if (part.step < 1) return unsupported("no-voxels", {"part-step", {std::to_string(part.step)}});
  Window window{.count = dims, .step = part.step};
  for (std::size_t a = 0; a < 3; ++a) {
    std::int64_t end = dims[a];
    if (part.box) {
      window.first[a] = part.box->first[a];
      end = part.box->end[a];
    }
    if (window.first[a] < 0 || end > dims[a] || end <= window.first[a])
      return unsupported("no-voxels", {"part-outside",
                                       {std::to_string(window.first[a]), std::to_string(end),
                                        std::to_string(dims[a])}});
    window.count[a] = (end - window.first[a] + part.step - 1) / part.step;
  }
  return window;
}

haptics::Grid gridOf(const haptics::Grid& whole, const Window& window) {
  haptics::Grid grid = whole;
  grid.dims = window.count;
  grid.origin =
      whole.worldOf({static_cast<double>(window.first[0]), static_cast<double>(window.first[1]),
                     static_cast<double>(window.first[2])});
  grid.spacing = whole.spacing * static_cast<double>(window.step);
  return grid;
}

}  // namespace datasets
