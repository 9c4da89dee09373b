// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/cohort/slice_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "app/study/reference/evaluator.h"

namespace cohort {
namespace {

using haptics::Vec3;

constexpr int kSide = 256;            // pixels
constexpr std::uint8_t kRed = 255;    // the palette's last colour, of isosurface and cross
constexpr std::uint8_t kWhite = 254;  // its greatest grey
constexpr int kCross = 9;             // pixels of an arm

void append(std::string& bytes, std::uint32_t value, int count) {
  for (int n = 0; n < count; ++n) bytes += static_cast<char>(value >> (8 * n) & 0xFFU);
}

/// 8 bits a pixel with a palette, rows from the upper one down.
std::string bitmapOf(const std::vector<std::uint8_t>& pixels) {
  constexpr std::uint32_t kHeaders = 14 + 40, kPalette = 4 * 256;
  std::string bytes = "BM";
  append(bytes, kHeaders + kPalette + kSide * kSide, 4);
  append(bytes, 0, 4);
  append(bytes, kHeaders + kPalette, 4);
  append(bytes, 40, 4);
  append(bytes, kSide, 4);
  append(bytes, static_cast<std::uint32_t>(-kSide), 4);  // negative: the upper row first
  append(bytes, 1, 2);
  append(bytes, 8, 2);
  append(bytes, 0, 4);
  append(bytes, kSide * kSide, 4);
  append(bytes, 0, 8);
  append(bytes, 256, 4);
  append(bytes, 0, 4);
  for (std::uint32_t grey = 0; grey <= kWhite; ++grey) append(bytes, grey * 0x010101U, 4);
  append(bytes, 0xFF3030U, 4);
  bytes.append(pixels.begin(), pixels.end());
  return bytes;
}

struct Plane {
  const char* name;
  int across, down;  ///< axes of W
  double down_sign;
  std::array<const char*, 4> letters;  ///< left, right, upper, lower
};
constexpr std::array<Plane, 3> kPlanes{{{"axial", 0, 1, 1.0, {"R", "L", "A", "P"}},
                                        {"coronal", 0, 2, -1.0, {"R", "L", "S", "I"}},
                                        {"sagittal", 1, 2, -1.0, {"A", "P", "S", "I"}}}};

}  // namespace

const std::array<const char*, 4>& lettersOf(const std::string& plane) {
  return std::ranges::find(kPlanes, plane, [](const Plane& p) { return std::string(p.name); })
      ->letters;
}

std::array<SlicePicture, 3> slicesThrough(const haptics::Volume& volume, double isovalue,
                                          const Vec3& place_W) {
  // the box in W that holds the grid
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int a = 0; a < 3; ++a)
      index[a] =
          (corner >> a & 1) != 0 ? double(volume.grid.dims[static_cast<std::size_t>(a)] - 1) : 0.0;
    const Vec3 p = volume.grid.worldOf(index);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).maxCoeff();
  const Vec3 middle = 0.5 * (low + high);
  const bool hounsfield = volume.unit == "HU";
  const double black = hounsfield ? -600.0 : volume.least;
  const double white = hounsfield ? 1000.0 : volume.greatest;

  std::array<SlicePicture, 3> pictures;
  for (std::size_t n = 0; n < 3; ++n) {
    const Plane& plane = kPlanes[n];
    const auto placeOf = [&](int x, int y) {
      Vec3 p = place_W;
      p[plane.across] = middle[plane.across] + size * ((x + 0.5) / kSide - 0.5);
      p[plane.down] = middle[plane.down] + plane.down_sign * size * ((y + 0.5) / kSide - 0.5);
      return p;
    };
    std::vector<double> values;
    values.reserve(kSide * kSide);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) values.push_back(evaluator::fieldAt(volume, placeOf(x, y)));
    const auto solid = [&](int x, int y) {
      return values[static_cast<std::size_t>(y * kSide + x)] >= isovalue;
    };
    std::vector<std::uint8_t> pixels(kSide * kSide);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const auto at = static_cast<std::size_t>(y * kSide + x);
        const bool border = (x + 1 < kSide && solid(x, y) != solid(x + 1, y)) ||
                            (y + 1 < kSide && solid(x, y) != solid(x, y + 1));
        const double grey = white > black ? (values[at] - black) / (white - black) : 0.0;
        pixels[at] =
            border ? kRed
                   : static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 1.0) * kWhite));
      }
    const int cross_x =
        static_cast<int>(std::floor(((place_W - middle)[plane.across] / size + 0.5) * kSide));
    const int cross_y = static_cast<int>(
        std::floor((plane.down_sign * (place_W - middle)[plane.down] / size + 0.5) * kSide));
    for (int d = -kCross; d <= kCross; ++d) {
      if (std::abs(d) < 3) continue;  // the place itself is left free
      for (const auto& [x, y] : {std::pair{cross_x + d, cross_y}, std::pair{cross_x, cross_y + d}})
        if (x >= 0 && x < kSide && y >= 0 && y < kSide)
          pixels[static_cast<std::size_t>(y * kSide + x)] = kRed;
    }
    pictures[n].plane = plane.name;
    pictures[n].bitmap = bitmapOf(pixels);
  }
  return pictures;
}

}  // namespace cohort
