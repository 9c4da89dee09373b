// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/surface/surface_check.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace datasets {
namespace {

/// Equal for equal places, and different for others but for one in 2^64.
std::uint64_t digestOf(const SurfacePoint& p) {
  std::uint64_t digest = 0x9e3779b97f4a7c15U;
  for (const float x : p) {
    digest ^= std::bit_cast<std::uint32_t>(x + 0.0F);  // -0 is 0
    digest = (digest ^ digest >> 30) * 0xbf58476d1ce4e5b9U;
    digest = (digest ^ digest >> 27) * 0x94d049bb133111ebU;
    digest ^= digest >> 31;
  }
  return digest;
}

}  // namespace

void SurfaceCheck::triangle(const std::array<std::int64_t, 3>& corners,
                            const std::array<SurfacePoint, 3>& points) {
  if (!begun_)
    for (std::size_t a = 0; a < 3; ++a) origin_mm_[a] = points[0][a];
  begun_ = true;
  std::array<std::uint64_t, 3> digest{};
  std::array<haptics::Vec3, 3> p;
  for (std::size_t n = 0; n < 3; ++n) {
    digest[n] = digestOf(points[n]);
    for (std::size_t a = 0; a < 3; ++a)
      p[n][static_cast<Eigen::Index>(a)] = static_cast<double>(points[n][a]) - origin_mm_[a];
  }
  volume_mm3_ += p[0].dot(p[1].cross(p[2])) / 6.0;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t m = (n + 1) % 3;
    sound_ = sound_ && digest[n] != digest[m];
    const auto [low, high] = std::minmax(digest[n], digest[m]);
    const auto [least, greatest] = std::minmax(corners[n], corners[m]);
    edges_.push_back({low, high, least, greatest, digest[n] == low});
  }
}

void SurfaceCheck::layer(std::int64_t first, std::int64_t end) {
  std::vector<Edge> all = std::exchange(open_, {});
  all.insert(all.end(), edges_.begin(), edges_.end());
  edges_.clear();
  std::ranges::sort(all, {}, [](const Edge& edge) { return std::pair{edge.low, edge.high}; });
  for (auto one = all.begin(); one != all.end();) {
    const auto other = std::find_if(one, all.end(), [&](const Edge& edge) {
      return edge.low != one->low || edge.high != one->high;
    });
    const bool pair = other - one == 2 && one[0].rises != one[1].rises;
    // the next layer may have its other triangle, and must have no further one
    const bool met_again = one->least >= first && one->greatest < end;
    sound_ = sound_ && (pair || (other - one == 1 && met_again));
    if (met_again) open_.insert(open_.end(), one, other);
    one = other;
  }
}

}  // namespace datasets
