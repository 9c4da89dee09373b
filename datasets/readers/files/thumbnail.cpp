// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "datasets/readers/files/refusal.h"

namespace datasets {

haptics::Expected<Thumbnail> thumbnailOf(const SlicePixels& slice, int longest) {
  const double width = static_cast<double>(slice.columns) * slice.column_step;
  const double height = static_cast<double>(slice.rows) * slice.row_step;
  const double scale = longest / std::max(width, height);
  if (!std::isfinite(scale)) return unsupported("bad-header", {"thumbnail-no-size", {}});
  Thumbnail small{std::max(1, static_cast<int>(std::lround(scale * width))),
                  std::max(1, static_cast<int>(std::lround(scale * height))),
                  {}};
  std::vector<double> values;
  haptics::visitVoxels(slice.type, slice.pixels, [&](const auto* from) {
    for (int y = 0; y < small.height; ++y)
      for (int x = 0; x < small.width; ++x)
        values.push_back(
            static_cast<double>(from[(2 * y + 1) * slice.rows / (2 * small.height) * slice.columns +
                                     (2 * x + 1) * slice.columns / (2 * small.width)]));
  });
  std::vector<double> sorted;
  for (const double v : values)
    if (!slice.padding || v < slice.padding->front() || v > slice.padding->back())
      sorted.push_back(v);
  if (sorted.empty()) sorted = values;
  std::ranges::sort(sorted);
  // metal and noise aside
  const double black = sorted[sorted.size() / 50],
               white = sorted[sorted.size() - 1 - sorted.size() / 50];
  for (const double v : values) {
    const double share = white > black ? (v - black) / (white - black) : 0.5;
    const double grey = 255.0 * std::clamp(share, 0.0, 1.0);
    small.grey.push_back(static_cast<std::uint8_t>(slice.inverted ? 255.0 - grey : grey));
  }
  return small;
}

}  // namespace datasets
