// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/export_task.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "app/export/export.h"
#include "app/film/film.h"
#include "app/recording/replay.h"
#include "app/window/scan/sentence.h"
#include "haptics/process/output_file.h"

namespace app {
namespace {

using GoesOn = std::function<bool(double)>;

QString told(const std::filesystem::path& written) {
  return ExportTask::tr("\"%1\" was exported.")
      .arg(QString::fromStdString(written.filename().string()));
}

/// What was written, for the user; or why not.
haptics::Expected<QString> film(Recording& recording, const ExportRequest& request,
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
  options.look = request.look;
  options.goes_on = std::move(goes_on);
  const auto isOnView = [&](const RecordedScene& scene) {
    return request.volume && isOf(scene, *request.volume, request.hash);
  };
  // marks of another scan would stand at wrong places
  if (std::ranges::none_of(recording.scenes(), isOnView)) options.look.marks.clear();
  const auto volume = [&](std::uint32_t id) -> std::shared_ptr<const haptics::Volume> {
    const RecordedScene* scene = recording.scene(id);
    if (scene == nullptr || !isOnView(*scene)) return nullptr;
    // as it was when the scene was touched
    const auto volume_then = editedAsRecorded(request.volume, *scene);
    return volume_then ? *volume_then : nullptr;
  };
  const auto made = makeFilm(recording, volume, request.out, options);
  if (!made) return tl::unexpected(made.error());
  return told(made->film);
}

haptics::Expected<QString> table(Recording& recording, const ExportRequest& request,
                                 GoesOn goes_on) {
  const ui::ExportWish& wish = request.wish;
  exporting::ExportOptions options;
  options.from = wish.from;
  options.to = wish.to;
  options.rate = wish.rate.value_or(0.0);
  options.contacts = wish.contacts;
  options.goes_on = std::move(goes_on);
  std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>> volumes;
  if (request.volume && recording.isCut()) {
    auto edited = editedAsRecorded(request.volume, request.hash, recording);
    if (edited) volumes = std::move(*edited);
  }
  options.volume = [&](std::uint32_t id) {
    const auto found = volumes.find(id);
    return found == volumes.end() ? nullptr : found->second;
  };
  const auto made = exporting::kFormats[*wish.table].write(recording, request.out, options);
  if (!made) return tl::unexpected(made.error());
  if (made->cuts_without_voxels == 0) return told(request.out);
  return told(request.out) + ' ' +
         ExportTask::tr("The voxels that were cut are left out: they need their scan on view.");
}

haptics::Expected<QString> exported(const ExportRequest& request, const background::Watch& watch) {
  haptics::keepInput(request.recording);
  auto recording = Recording::open(request.recording);
  if (!recording) return tl::unexpected(recording.error());
  const auto goes_on = [&](double fraction) {
    watch.advanced(fraction);
    return !watch.cancelled();
  };
  return request.wish.table ? table(*recording, request, goes_on)
                            : film(*recording, request, goes_on);
}

}  // namespace

ExportTask::ExportTask(QObject* parent)
    : QObject(parent), task_([this](double fraction) { emit progressed(fraction); }) {}

bool ExportTask::start(ExportRequest request) {
  if (task_.isRunning()) return false;
  task_.start([request = std::move(request)](
                  const background::Watch& watch) { return exported(request, watch); },
              [this](const haptics::Expected<QString>& made) {
                if (made) return emit finished(true, *made);
                const haptics::Error& error = made.error();
                QString why = sentenceOf(error);
                if (error.reason == background::kNoMemory || error.reason == background::kThrew)
                  why = tr("There is not enough memory for this export; choose a shorter time.");
                emit finished(false, error.reason == "cancelled" ? QString{} : why);
              });
  return true;
}

}  // namespace app
