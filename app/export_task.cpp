// SPDX-License-Identifier: BSD-3-Clause
#include "app/export_task.h"

#include <exception>
#include <utility>

#include "app/export/export.h"
#include "app/film/film.h"

namespace app {
namespace {

constexpr double kExportStep = 0.002;  // between two signals of progress

using GoesOn = std::function<bool(double)>;

/// The names of what was written, for the user; or why not.
haptics::Expected<QString> film(haptics::Recording& recording, const ExportRequest& request,
                                GoesOn goes_on) {
  const ui::ExportWish& wish = request.wish;
  FilmOptions options;
  options.from = wish.from;
  options.to = wish.to;
  options.width = wish.film.width;
  options.height = wish.film.height;
  options.frames_per_second = wish.film.frames_per_second;
  options.burn_in = wish.film.figures;
  options.recorded_camera = wish.film.camera == ui::ExportWish::Film::Camera::AsRecorded;
  options.camera = request.camera;
  options.goes_on = std::move(goes_on);
  const auto volume = [&](std::uint32_t id) -> std::shared_ptr<const haptics::Volume> {
    const haptics::RecordedScene* scene = recording.scene(id);
    const bool there = scene != nullptr && request.volume &&
                       haptics::liesLike(scene->volume, *request.volume) &&
                       haptics::compared(scene->hash, request.hash) != haptics::SameVolume::Another;
    return there ? request.volume : nullptr;
  };
  const auto made = makeFilm(recording, volume, request.out, options);
  if (!made) return tl::unexpected(made.error());
  return QString::fromStdString(made->film.filename().string());
}

haptics::Expected<QString> table(haptics::Recording& recording, const ExportRequest& request,
                                 GoesOn goes_on) {
  const ui::ExportWish& wish = request.wish;
  exporting::ExportOptions options;
  options.from = wish.from;
  options.to = wish.to;
  options.rate = wish.rate.value_or(0.0);
  options.contacts = wish.contacts;
  options.goes_on = std::move(goes_on);
  const auto write = wish.format == ui::ExportWish::Format::Csv    ? exporting::exportCsv
                     : wish.format == ui::ExportWish::Format::Hdf5 ? exporting::exportHdf5
                                                                   : exporting::exportMcap;
  const auto made = write(recording, request.out, options);
  if (!made) return tl::unexpected(made.error());
  return QString::fromStdString(request.out.filename().string());
}

}  // namespace

ExportTask::~ExportTask() {
  cancel_ = true;
  if (thread_.joinable()) thread_.join();
}

bool ExportTask::start(ExportRequest request) {
  if (running_) return false;
  if (thread_.joinable()) thread_.join();
  running_ = true;
  cancel_ = false;
  thread_ = std::thread{[this, request = std::move(request)] { work(request); }};
  return true;
}

void ExportTask::work(const ExportRequest& request) {
  double told = 0.0;
  const auto goes_on = [&](double fraction) {
    if (fraction - told >= kExportStep) {
      told = fraction;
      emit progressed(fraction);  // queued: the receivers live on another thread
    }
    return !cancel_.load();
  };
  bool well = false;
  QString what;
  try {
    auto recording = haptics::Recording::open(request.recording);
    if (!recording) throw recording.error();
    const auto made = request.wish.format == ui::ExportWish::Format::Film
                          ? film(*recording, request, goes_on)
                          : table(*recording, request, goes_on);
    well = made.has_value();
    if (made)
      what = tr("\"%1\" was exported.").arg(*made);
    else
      throw made.error();
  } catch (const haptics::Error& error) {
    if (error.reason != "cancelled") what = QString::fromStdString(error.what);
  } catch (const std::exception&) {
    what = tr("There is not enough memory for this export; choose a shorter time.");
  }
  QMetaObject::invokeMethod(
      this,
      [this, well, what] {
        running_ = false;
        emit finished(well, what);
      },
      Qt::QueuedConnection);
}

}  // namespace app
