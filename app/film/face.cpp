// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/face.h"

#include <algorithm>
#include <array>
#include <limits>

namespace app {
namespace {

// bone begins above it; skin, fat and muscle lie well below
constexpr double kAboveSkin_HU = 200.0;
// eyes, nose and mouth, and how far the nose stands out
constexpr double kFaceWidth_mm = 60.0, kFaceDepth_mm = 20.0;

}  // namespace

bool mayShowAFace(const haptics::Volume& volume, double isovalue) {
  std::array<double, 3> edges_mm{};
  for (std::size_t a = 0; a < 3; ++a)
    edges_mm[a] = double(volume.grid.dims[a]) * volume.grid.spacing[Eigen::Index(a)] * 1e3;
  std::ranges::sort(edges_mm);
  if (edges_mm[0] < kFaceDepth_mm || edges_mm[1] < kFaceWidth_mm) return false;
  return volume.unit != "HU" || !(isovalue >= kAboveSkin_HU);
}

double leastIsovalue(const Recording& recording) {
  double least = std::numeric_limits<double>::infinity();
  for (const RecordedEvent& event : recording.events())
    if (event.kind == "isovalue" && event.value) least = std::min(least, *event.value);
  return least;
}

}  // namespace app
