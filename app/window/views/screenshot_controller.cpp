// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/screenshot_controller.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/film/face.h"
#include "haptics/process/output_file.h"
#include "resources/messages/messages.h"
#include "ui/views/volume_view.h"
#include "ui/window/screenshot.h"

namespace app {

ScreenshotController::ScreenshotController(ui::MainWindow& window, SharedState& shared,
                                           std::string path, double after)
    : window_(window),
      views_(window.views()),
      shared_(shared),
      path_(std::move(path)),
      after_(after) {}

void ScreenshotController::prepare(bool new_volume) {
  if (isWanted() && new_volume && awaited_ == 0)
    QTimer::singleShot(static_cast<int>(after_ * 1000.0), this, &ScreenshotController::take);
}

void ScreenshotController::arrived(bool done) {
  if (awaited_ == 0) return;
  --awaited_;
  done ? prepare(true) : fail(tr("The view was not opened."));
}

void ScreenshotController::fail(const QString& sentence) {
  awaited_ = 0;
  if (!isWanted()) return;
  std::fprintf(stderr, "%s\n", qUtf8Printable(sentence));
  emit finished(3);
}

void ScreenshotController::take() {
  const std::optional<Loaded>& shown = shared_.shown;
  // a slice shows the skin whatever the isovalue
  const bool slices = views_.showsSlices();
  const double isovalue = shared_.settings.isovalue;
  const double least = std::min(isovalue, views_.volume().surface().second().value_or(isovalue));
  if (shown && !shown->place.empty() &&
      mayShowAFace(*shown->volume(), slices ? shown->volume()->least : least))
    std::fprintf(stderr,
                 "Skin is drawn, and a face or a profile can tell who the patient is: look at the "
                 "picture before you pass it on.\n");
  QBuffer picture;
  const QString ending = QFileInfo(QString::fromStdString(path_)).suffix();
  const QImage image = ui::screenshotOf(
      window_, views_, {.whole_window = true, .scale = ui::screenScaleOf(window_)});
  const bool drawn = image.save(&picture, ending.isEmpty() ? "PNG" : qPrintable(ending));
  if (!drawn) {
    std::fprintf(stderr, "The picture could not be drawn.\n");
    return emit finished(4);
  }
  const auto saved =
      haptics::writeFile(path_, {picture.data().constData(), std::size_t(picture.data().size())});
  if (!saved) std::fprintf(stderr, "%s\n", resources::sentence(saved.error()).c_str());
  emit finished(saved ? 0 : 4);
}

}  // namespace app
