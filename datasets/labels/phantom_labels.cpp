// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/phantom_labels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "datasets/phantoms/structures.h"
#include "datasets/readers/files/refusal.h"
#include "haptics/core/parallel.h"

namespace datasets {

haptics::Expected<LabelMap> phantomLabels(const std::string& phantom, const haptics::Grid& grid,
                                          const std::atomic<bool>* cancel) {
  auto map = LabelMap::over(grid);
  if (!map) return map;
  const auto& [ni, nj, nk] = grid.dims;
  for (const PhantomStructure& structure : phantomStructures(phantom)) {
    std::vector<std::uint8_t> belongs(std::size_t(grid.voxelCount()));
    haptics::inParallel(nk, [&, ni = ni, nj = nj](std::int64_t k) {
      if (cancel != nullptr && *cancel) return;
      for (std::int64_t j = 0; j < nj; ++j)
        for (std::int64_t i = 0; i < ni;) {
          const double distance =
              structure.distance(grid.worldOf({double(i), double(j), double(k)}));
          // all that is nearer than the surface lies on the same side of it
          const double far = std::abs(distance) / grid.spacing.x();
          const std::int64_t end =
              structure.exact ? i + std::int64_t(std::clamp(far, 1.0, double(ni - i))) : i + 1;
          const auto row = belongs.begin() + (k * nj + j) * ni;
          std::fill(row + i, row + end, std::uint8_t(distance <= 0.0));
          i = end;
        }
    });
    if (cancel != nullptr && *cancel) return cancelled();
    const std::uint8_t number = map->add({.name = structure.name, .colour = structure.colour});
    for (std::size_t n = 0; n < belongs.size(); ++n)
      if (belongs[n] != 0)
        if (auto marked = map->mark(std::int64_t(n), number); !marked)
          return tl::unexpected(marked.error());
  }
  return map;
}

}  // namespace datasets
