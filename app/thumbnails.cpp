// SPDX-License-Identifier: BSD-3-Clause
#include "app/thumbnails.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace app {
namespace {

constexpr int kLowPriority = 10;  // a nice value: the touch and the window go first

QImage pictureOf(const datasets::SeriesVerdict& series, int longest) {
  try {
    const auto small = datasets::thumbnailOf(series, longest);
    if (!small) return {};
    QImage picture(small->width, small->height, QImage::Format_Grayscale8);
    auto from = small->grey.begin();
    for (int y = 0; y < small->height; ++y, from += small->width)
      std::copy_n(from, small->width, picture.scanLine(y));
    return picture;
  } catch (const std::exception&) {  // no memory: then there is no picture
    return {};
  }
}

}  // namespace

void Thumbnails::start(std::vector<datasets::SeriesVerdict> series, int longest) {
  stop();
  Job& job = jobs_.emplace_back();
  job.thread = std::jthread([this, &job, number = number_, series = std::move(series),
                             longest](const std::stop_token& stop) {
    work(number, series, longest, stop);
    job.done = true;
  });
}

void Thumbnails::stop() {
  ++number_;
  for (Job& job : jobs_) job.thread.request_stop();
  jobs_.remove_if([](const Job& job) { return job.done.load(); });
}

void Thumbnails::work(std::uint64_t number, const std::vector<datasets::SeriesVerdict>& series,
                      int longest, const std::stop_token& stop) {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowPriority);
  for (std::size_t i = 0; i < series.size() && !stop.stop_requested(); ++i) {
    const QImage picture = pictureOf(series[i], longest);
    QMetaObject::invokeMethod(
        this,
        [this, number, index = static_cast<int>(i), picture] {
          if (number == number_) emit ready(index, picture);
        },
        Qt::QueuedConnection);
  }
}

}  // namespace app
