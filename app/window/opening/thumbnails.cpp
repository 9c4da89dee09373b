// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/opening/thumbnails.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace app {

ui::SmallPicture pictureOf(const datasets::SeriesVerdict& series, int longest) {
  try {
    const auto small = datasets::thumbnailOf(series, longest);
    if (!small) return {};
    QImage picture(small->width, small->height, QImage::Format_Grayscale8);
    auto from = small->grey.begin();
    for (int y = 0; y < small->height; ++y, from += small->width)
      std::copy_n(from, small->width, picture.scanLine(y));
    return {.image = picture, .sides_known = small->plane.has_value()};
  } catch (const std::exception&) {  // no memory: then there is no picture
    return {};
  }
}

void Thumbnails::start(std::vector<datasets::SeriesVerdict> series, int longest) {
  task_.start(
      [this, series = std::move(series),
       longest](const background::Watch& watch) -> haptics::Expected<void> {
        background::goLast();
        for (std::size_t i = 0; i < series.size() && !watch.cancelled(); ++i)
          watch.tell([this, index = static_cast<int>(i), picture = pictureOf(series[i], longest)] {
            emit ready(index, picture);
          });
        return {};
      },
      [](const haptics::Expected<void>&) {});  // each picture was told of by itself
}

}  // namespace app
