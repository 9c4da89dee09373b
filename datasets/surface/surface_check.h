// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/surface/surface.h"

namespace datasets {

/// Finds whether triangles are closed and turned outwards, from the places that are written: each
/// edge must belong to two triangles, in opposite directions, and the volume must be positive. It
/// does not rely on how the surface was made.
class SurfaceCheck : public SurfaceReceiver {
 public:
  void triangle(const std::array<std::int64_t, 3>& corners,
                const std::array<SurfacePoint, 3>& points) override;
  void layer(std::int64_t first, std::int64_t end) override;
  /// After the last layer.
  bool holds() const { return sound_ && open_.empty() && volume_mm3_ > 0.0; }

 private:
  struct Edge {
    std::uint64_t low, high;       ///< digests of its ends, the lower one first
    std::int64_t least, greatest;  ///< numbers of its ends
    bool rises;                    ///< it leads from low to high
  };
  std::vector<Edge> edges_;  ///< of this layer
  std::vector<Edge> open_;   ///< of the layers before, that this one may meet
  bool sound_ = true;
  double volume_mm3_ = 0.0;
  std::array<double, 3> origin_mm_{};  ///< of the volumes: a corner, so that digits are not lost
  bool begun_ = false;
};

}  // namespace datasets
