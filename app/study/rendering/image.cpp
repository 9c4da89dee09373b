// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace study {
namespace {

constexpr int kReach = 5;  // pixels either side of a window's middle
constexpr double kDeviation = 1.5;
constexpr double kSteadyMean = (0.01 * 255) * (0.01 * 255);    // C1
constexpr double kSteadySpread = (0.03 * 255) * (0.03 * 255);  // C2

bool sameSize(const Image& a, const Image& b) { return a.width == b.width && a.height == b.height; }

/// One row of the window, which is the product of two.
std::array<double, 2 * kReach + 1> weights() {
  std::array<double, 2 * kReach + 1> w{};
  double sum = 0.0;
  for (int i = -kReach; i <= kReach; ++i)
    sum += w[static_cast<std::size_t>(i + kReach)] =
        std::exp(-0.5 * i * i / (kDeviation * kDeviation));
  for (double& weight : w) weight /= sum;
  return w;
}

/// The measure in the window about a pixel.
double similarity(const Image& a, const Image& b, int x, int y) {
  static const auto kWeights = weights();
  double mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
  for (int j = -kReach; j <= kReach; ++j)
    for (int i = -kReach; i <= kReach; ++i) {
      const double w = kWeights[static_cast<std::size_t>(i + kReach)] *
                       kWeights[static_cast<std::size_t>(j + kReach)];
      const double in_a = a.at(x + i, y + j), in_b = b.at(x + i, y + j);
      mean_a += w * in_a;
      mean_b += w * in_b;
      aa += w * in_a * in_a;
      bb += w * in_b * in_b;
      ab += w * in_a * in_b;
    }
  const double spread_a = aa - mean_a * mean_a, spread_b = bb - mean_b * mean_b;
  return (2 * mean_a * mean_b + kSteadyMean) * (2 * (ab - mean_a * mean_b) + kSteadySpread) /
         ((mean_a * mean_a + mean_b * mean_b + kSteadyMean) *
          (spread_a + spread_b + kSteadySpread));
}

}  // namespace

int Image::shown() const {
  return static_cast<int>(std::ranges::count_if(grey, [](double g) { return g > 0.0; }));
}

double rmse(const Image& a, const Image& b) {
  if (!sameSize(a, b)) return INFINITY;
  double sum = 0.0;
  int pixels = 0;
  for (std::size_t n = 0; n < a.grey.size(); ++n) {
    if (!(a.grey[n] > 0.0 || b.grey[n] > 0.0)) continue;
    sum += (a.grey[n] - b.grey[n]) * (a.grey[n] - b.grey[n]);
    ++pixels;
  }
  return std::sqrt(sum / pixels);
}

double ssim(const Image& a, const Image& b) {
  if (!sameSize(a, b)) return NAN;
  double sum = 0.0;
  int pixels = 0;
  for (int y = kReach; y < a.height - kReach; ++y)
    for (int x = kReach; x < a.width - kReach; ++x) {
      if (!a.shows(x, y) && !b.shows(x, y)) continue;
      sum += similarity(a, b, x, y);
      ++pixels;
    }
  return sum / pixels;
}

}  // namespace study
