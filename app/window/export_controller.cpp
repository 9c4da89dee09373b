// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/export_controller.h"

#include <QFileDialog>

#include "app/film/face.h"
#include "app/window/view_camera.h"
#include "ui/export_question.h"
#include "ui/panels/recording_panel.h"
#include "ui/volume_view.h"

namespace app {

namespace {

/// The ending of a format's files, and what it is called.
struct Ending {
  const char* ending;
  const char* label;
};
Ending endingOf(ui::ExportWish::Format format) {
  switch (format) {
    case ui::ExportWish::Format::Csv:
      return {"", QT_TRANSLATE_NOOP("app::ExportController",
                                    "Motion-BIDS: the beginning of the names")};
    case ui::ExportWish::Format::Hdf5:
      return {".h5", QT_TRANSLATE_NOOP("app::ExportController", "HDF5 (*.h5)")};
    case ui::ExportWish::Format::Mcap:
      return {".mcap", QT_TRANSLATE_NOOP("app::ExportController", "MCAP (*.mcap)")};
    case ui::ExportWish::Format::Film:
      break;
  }
  return {".mp4", QT_TRANSLATE_NOOP("app::ExportController", "Film (*.mp4 *.ogv)")};
}

}  // namespace

ExportController::ExportController(ui::MainWindow& window, SharedState& shared,
                                   const Recordings& recordings, const VolumeIdentity& identity)
    : window_(window), shared_(shared), recordings_(recordings), identity_(identity) {
  connect(&window.recordingPanel(), &ui::RecordingPanel::exportWanted, this,
          &ExportController::exportRecording);
  connect(&window, &ui::MainWindow::cancelWanted, &task_, &ExportTask::cancel);
  connect(&task_, &ExportTask::progressed, &window, &ui::MainWindow::showProgress);
  connect(&task_, &ExportTask::finished, this, [this](bool, const QString& what) {
    window_.endLoading();
    if (!what.isEmpty()) window_.showMessage(what);
  });
}

void ExportController::exportRecording(const QString& id) {
  const std::filesystem::path path = recordings_.pathOf(id);
  const auto recording = haptics::Recording::open(path);
  if (!recording) return window_.showMessage(QString::fromStdString(recording.error().what));
  const auto wish = ui::askForExport(&window_, recording->begin(), recording->end());
  if (!wish) return;
  ExportRequest request{.recording = path, .out = {}, .wish = *wish};
  if (wish->format == ui::ExportWish::Format::Film) {
    request.volume = shared_.shown ? shared_.shown->picture.volume : nullptr;
    if (request.volume) request.hash = identity_.of(request.volume);
    if (wish->film.camera == ui::ExportWish::Film::Camera::Fixed)
      request.camera = cameraOf(window_.view());
    // said once for each film, before anything is written
    if (shared_.shown && !shared_.shown->place.empty() &&
        mayShowAFace(*request.volume, leastIsovalue(*recording)) &&
        !window_.askWhether(
            tr("This film may show a face."),
            tr("At this isovalue the skin is drawn, and skin can be a face that somebody knows. "
               "Raise the isovalue to bone, or give the film only to those who may see it."),
            tr("Make the film")))
      return;
  }
  const Ending ending = endingOf(wish->format);
  // Qt's own dialog: in a foreign one Escape would not reach the application
  QFileDialog dialog(&window_, tr("Export to"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setOption(QFileDialog::DontUseNativeDialog);
  dialog.setNameFilter(tr(ending.label));
  dialog.setDefaultSuffix(QString(ending.ending).mid(1));
  dialog.selectFile(QString::fromStdString(path.stem().string()) + ending.ending);
  if (dialog.exec() != QDialog::Accepted) return;
  QString out = dialog.selectedFiles().value(0);
  const bool film = wish->format == ui::ExportWish::Format::Film;
  if (!film && !out.endsWith(ending.ending)) out += ending.ending;
  request.out = out.toStdString();
  // the dialog asks about the name that was chosen; what is written may have others
  std::filesystem::path beside = request.out;
  if (wish->format == ui::ExportWish::Format::Csv) beside += "_motion.tsv";
  if (film) beside.replace_extension(".frames.csv");
  std::error_code error;
  if (out != dialog.selectedFiles().value(0) || beside != request.out)
    if (std::filesystem::exists(beside, error) &&
        !window_.askWhether(tr("An export of that name is there already."),
                            tr("Its files are written over."), tr("Write over it")))
      return;
  exportTo(std::move(request));
}

void ExportController::exportTo(ExportRequest request) {
  if (!task_.start(std::move(request)))
    return window_.showMessage(tr("An export is under way; wait for it, or cancel it first."));
  window_.clearMessage();
  window_.showLoading(tr("Exporting"));
}

}  // namespace app
