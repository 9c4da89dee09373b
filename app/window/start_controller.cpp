// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/start_controller.h"

#include <algorithm>
#include <atomic>
#include <exception>

#include "app/window/thumbnails.h"
#include "datasets/readers/volume_reader.h"
#include "ui/start_page.h"

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
    : window_(window), preferences_(preferences) {
  // until the first volume is shown; the views behind it take no keys
  window.startPage().show();
  window.views().setEnabled(false);
  connect(&window, &ui::MainWindow::tourEnded, this, [this] {
    preferences_.present().tour_seen = true;
    preferences_.save();
  });
}

void StartController::drawLastScans() {
  if (window_.startPage().isHidden()) return;
  const QStringList places = preferences_.present().places;
  const int longest = qRound(ui::StartPage::kThumbnail * window_.startPage().devicePixelRatioF());
  task_.start(
      [this, places, longest](const background::Watch& watch) -> haptics::Expected<void> {
        background::goLast();
        for (const QString& place : places) {
          if (watch.cancelled()) break;
          watch.tell([this, place, picture = pictureOfPlace(place, longest, watch)] {
            window_.startPage().setThumbnail(place, picture);
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
