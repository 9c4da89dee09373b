// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace app {

/// A picture of a film: red, green and blue of each pixel, row by row from the lowest.
struct FilmFrame {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Size and rate of the frames of a film.
struct FilmFormat {
  int width = 0, height = 0;  ///< pixels, even
  int frames_per_second = 0;
};

/// Called while an encoder is waited for. Returning false ends the waiting.
using StillWanted = std::function<bool()>;

}  // namespace app
