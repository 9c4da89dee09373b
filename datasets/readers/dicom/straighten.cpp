// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/straighten.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace datasets {
namespace {

constexpr double kOnPixel = 1e-6;  // pixels and planes: what is as near counts as on it

/// A slice with its place in the box.
template <class T>
class Slice {
 public:
  Slice(const T* pixels, const Crooked& crooked, const haptics::Vec3& place)
      : pixels_{pixels}, columns_{crooked.columns}, rows_{crooked.rows} {
    split(place.x(), first_column_, share_x_);
    split(place.y(), first_row_, share_y_);
  }
  /// The value at a column and row of the box; NaN where the slice does not reach.
  double at(std::int64_t i, std::int64_t j) const {
    const std::int64_t x = i - first_column_, y = j - first_row_;
    const std::int64_t dx = share_x_ > 0.0 ? 1 : 0, dy = share_y_ > 0.0 ? columns_ : 0;
    if (x < 0 || y < 0 || x + dx >= columns_ || y + (dy > 0 ? 1 : 0) >= rows_)
      return std::numeric_limits<double>::quiet_NaN();
    const T* p = pixels_ + y * columns_ + x;
    const double here = between(double(p[0]), double(p[dx]), share_x_);
    return between(here, between(double(p[dy]), double(p[dy + dx]), share_x_), share_y_);
  }
  static double between(double a, double b, double share) { return a + share * (b - a); }

 private:
  /// Pixel n of the slice lies at `place` + n of the box, so the box's pixel i is the slice's
  /// i - first, and `share` of the way to the next.
  static void split(double place, std::int64_t& first, double& share) {
    first = static_cast<std::int64_t>(std::ceil(place - kOnPixel));
    share = static_cast<double>(first) - place;
    if (share < kOnPixel) share = 0.0;
  }
  const T* pixels_;
  std::int64_t columns_, rows_, first_column_ = 0, first_row_ = 0;
  double share_x_ = 0.0, share_y_ = 0.0;
};

template <class T>
T stored(double value) {
  if constexpr (std::is_integral_v<T>) value = std::nearbyint(value);
  return static_cast<T>(value);
}

template <class T>
bool straightenAs(const Stack& stack, const T* slices, T* box, const ReadProgress& progress) {
  const Crooked& crooked = *stack.crooked;
  const auto& dims = stack.geometry.dims;
  const std::int64_t pixels = crooked.columns * crooked.rows;
  T background = std::numeric_limits<T>::max();
  std::vector<Slice<T>> all;
  for (std::size_t k = 0; k < crooked.places.size(); ++k) {
    const T* first = slices + static_cast<std::int64_t>(k) * pixels;
    all.emplace_back(first, crooked, crooked.places[k]);
    for (const T* p = first; p != first + pixels; ++p)
      if (*p < background) background = *p;
  }
  std::size_t below = 0;  // the last slice that is not above the plane
  for (std::int64_t k = 0; k < dims[2]; ++k) {
    if (progress.isCancelled()) return false;
    progress.advanced(static_cast<double>(k) / static_cast<double>(dims[2]));
    const double plane = static_cast<double>(k);
    while (below + 1 < all.size() && crooked.places[below + 1].z() <= plane + kOnPixel) ++below;
    const double past = plane - crooked.places[below].z();
    const bool on_slice = past < kOnPixel || below + 1 == all.size();
    const std::size_t above = on_slice ? below : below + 1;
    const double share =
        on_slice ? 0.0 : past / (crooked.places[above].z() - crooked.places[below].z());
    for (std::int64_t j = 0; j < dims[1]; ++j)
      for (std::int64_t i = 0; i < dims[0]; ++i) {
        const double value = Slice<T>::between(all[below].at(i, j), all[above].at(i, j), share);
        *box++ = std::isnan(value) ? background : stored<T>(value);
      }
  }
  return true;
}

}  // namespace

bool straighten(const Stack& stack, haptics::ScalarType type, const void* slices, void* box,
                const ReadProgress& progress) {
  return haptics::visitVoxels(type, slices, [&](const auto* from) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(from)>>;
    return straightenAs<T>(stack, from, static_cast<T*>(box), progress);
  });
}

}  // namespace datasets
