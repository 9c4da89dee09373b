// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/opening/start_controller.h"

#include <algorithm>
#include <atomic>
#include <exception>

#include "app/window/opening/thumbnails.h"
#include "datasets/readers/volume_reader.h"
#include "ui/window/start_page.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace app {
namespace {

/// The series that a picture of a place shows: the largest that can be loaded.
const datasets::SeriesVerdict* largestOf(const datasets::Survey& survey) {
  const datasets::SeriesVerdict* largest = nullptr;
  const auto voxels = [](const datasets::SeriesVerdict& series) {
    return series.dims[0] * series.dims[1] * series.dims[2];
  };
  for (const datasets::SeriesVerdict& series : survey.series)
    if (series.verdict != datasets::Verdict::Refused &&
        (largest == nullptr || voxels(series) > voxels(*largest)))
      largest = &series;
  return largest;
}

ui::SmallPicture pictureOfPlace(const QString& place, int longest, const background::Watch& watch) {
  try {
    const auto survey = datasets::survey(place.toStdString(), {.cancel = &watch.cancel});
    if (!survey) return {};
    const datasets::SeriesVerdict* series = largestOf(*survey);
    return series == nullptr ? ui::SmallPicture{} : pictureOf(*series, longest);
  } catch (const std::exception&) {  // no memory: then there is no picture
    return {};
  }
}

}  // namespace

StartController::StartController(ui::MainWindow& window, PreferencesController& preferences)
    : window_(window), start_(window.startPage()), preferences_(preferences) {
  // until the first volume is shown; the views behind it take no keys
  start_.show();
  window.views().layout().setEnabled(false);
  connect(&window, &ui::MainWindow::tourEnded, this, [this] {
    preferences_.present().tour_seen = true;
    preferences_.save();
  });
}

void StartController::drawLastScans() {
  if (start_.isHidden()) return;
  const QStringList places = preferences_.present().places;
  const int longest = qRound(ui::StartPage::kThumbnail * start_.devicePixelRatioF());
  task_.start(
      [this, places, longest](const background::Watch& watch) -> haptics::Expected<void> {
        background::goLast();
        for (const QString& place : places) {
          if (watch.cancelled()) break;
          watch.tell([this, place, picture = pictureOfPlace(place, longest, watch)] {
            start_.setThumbnail(place, picture);
          });
        }
        return {};
      },
      [](const haptics::Expected<void>&) {});  // each picture was told of by itself
}

void StartController::offerTour() {
  if (!preferences_.present().tour_seen) window_.showTour();
}

}  // namespace app
