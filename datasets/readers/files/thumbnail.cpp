// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "datasets/readers/files/refusal.h"

namespace datasets {
namespace {

using haptics::Mat3;

/// The patient's axis that each axis of a file is nearest to, every time another one.
std::array<int, 3> nearestAxes(const Mat3& direction) {
  std::array<int, 3> axes{0, 1, 2}, nearest = axes;
  double most = 0.0;
  do {
    double along = 0.0;
    for (int a = 0; a < 3; ++a) along += std::abs(direction(axes[static_cast<std::size_t>(a)], a));
    if (along > most) nearest = axes;
    most = std::max(most, along);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return nearest;
}

/// One side of a picture, and where its pixels are in the file.
struct Side {
  std::int64_t count = 0;   ///< of the file's columns or rows
  double step = 1.0;        ///< from one to the next
  std::int64_t stride = 1;  ///< likewise, in the file's pixels
  bool turned = false;      ///< the file counts them the other way

  double length() const { return static_cast<double>(count) * step; }
  std::int64_t offsetOf(int pixel, int pixels) const {
    const std::int64_t n = (2 * pixel + 1) * count / (2 * pixels);
    return (turned ? count - 1 - n : n) * stride;
  }
};

/// A slice as its picture has it.
struct Layout {
  Side across, down;
  std::optional<AnatomicalPlane> plane = {};
};

Layout layoutOf(const SlicePixels& slice) {
  Layout layout{.across = {slice.columns, slice.column_step, 1},
                .down = {slice.rows, slice.row_step, slice.columns}};
  if (!slice.direction) return layout;
  struct Convention {
    AnatomicalPlane plane;
    int across, down;  ///< axes of W
    double down_sign;  ///< -1: the picture's lower edge is where the axis begins
  };
  // by the axis that goes through the plane
  static constexpr std::array<Convention, 3> kConventions{{{AnatomicalPlane::Sagittal, 1, 2, -1.0},
                                                           {AnatomicalPlane::Coronal, 0, 2, -1.0},
                                                           {AnatomicalPlane::Axial, 0, 1, 1.0}}};
  const std::array<int, 3> axes = nearestAxes(*slice.direction);
  const Convention& shown = kConventions[static_cast<std::size_t>(axes[2])];
  const int across = axes[0] == shown.across ? 0 : 1;
  if (across == 1) std::swap(layout.across, layout.down);
  layout.across.turned = (*slice.direction)(shown.across, across) < 0.0;
  layout.down.turned = shown.down_sign * (*slice.direction)(shown.down, 1 - across) < 0.0;
  layout.plane = shown.plane;
  return layout;
}

}  // namespace

haptics::Expected<Thumbnail> thumbnailOf(const SlicePixels& slice, int longest) {
  const Layout layout = layoutOf(slice);
  const Side &across = layout.across, &down = layout.down;
  const double scale = longest / std::max(across.length(), down.length());
  if (!std::isfinite(scale)) return unsupported("bad-header", {"geometry-not-finite", {}});
  const auto pixelsOf = [scale](const Side& side) {
    return std::max(1, static_cast<int>(std::lround(scale * side.length())));
  };
  Thumbnail small{
      .width = pixelsOf(across), .height = pixelsOf(down), .grey = {}, .plane = layout.plane};
  std::vector<double> values;
  haptics::visitVoxels(slice.type, slice.pixels, [&](const auto* from) {
    for (int y = 0; y < small.height; ++y)
      for (int x = 0; x < small.width; ++x)
        values.push_back(static_cast<double>(
            from[down.offsetOf(y, small.height) + across.offsetOf(x, small.width)]));
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

std::int64_t middleOf(std::int64_t count, const std::optional<Mat3>& direction) {
  const std::int64_t middle = count / 2;
  const bool turned = direction && (*direction)(nearestAxes(*direction)[2], 2) < 0.0;
  return turned ? count - 1 - middle : middle;
}

}  // namespace datasets
