// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace study {

/// A picture in grey levels from 0 to 255, rows from the bottom up. The background is 0, and
/// nothing else is.
struct Image {
  int width = 0, height = 0;
  std::vector<double> grey = {};

  double at(int x, int y) const { return grey[static_cast<std::size_t>(y) * width + x]; }
  bool shows(int x, int y) const { return at(x, y) > 0.0; }
  /// How many pixels show the object.
  int shown() const;
};

/// Root mean square difference over the pixels where either shows the object, grey levels. Not a
/// number where neither shows any, infinite for pictures of different sizes.
double rmse(const Image& a, const Image& b);

/// Mean structural similarity after Wang, Bovik, Sheikh and Simoncelli (2004), 1 for equal
/// pictures: Gaussian windows of 11 x 11 pixels and standard deviation 1.5, K1 = 0.01, K2 = 0.03,
/// range 255; over the windows within the picture whose middle shows the object in either. Not a
/// number where there is none or the sizes differ.
double ssim(const Image& a, const Image& b);

}  // namespace study
