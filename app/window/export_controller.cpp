// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/export_controller.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QTimer>

#include "app/export/export.h"
#include "app/film/face.h"
#include "app/log/log.h"
#include "app/window/edited_volume.h"
#include "app/window/sentence.h"
#include "app/window/view_camera.h"
#include "ui/export_question.h"
#include "ui/save_dialog.h"
#include "ui/volume_view.h"

namespace app {

namespace {

QString translated(const char* words) {
  return QCoreApplication::translate("app::exporting", words);
}

std::vector<ui::ExportFormat> tables() {
  std::vector<ui::ExportFormat> tables;
  for (const exporting::Format& format : exporting::kFormats)
    tables.push_back({translated(format.title), translated(format.about)});
  return tables;
}

}  // namespace

ExportController::ExportController(ui::MainWindow& window, SharedState& shared,
                                   const Recordings& recordings, const VolumeIdentity& identity)
    : window_(window), shared_(shared), recordings_(recordings), identity_(identity) {
  connect(&window, &ui::MainWindow::cancelWanted, &task_, &ExportTask::cancel);
  connect(&window, &ui::MainWindow::cancelWanted, this, [this] { opener_.cancel(); });
  connect(&task_, &ExportTask::progressed, &window, &ui::MainWindow::showProgress);
  connect(&task_, &ExportTask::finished, this, [this](bool well, const QString& what) {
    window_.endLoading();
    log::write(log::Level::Info, "export-ended", {{"whole", well}, {"cancelled", what.isEmpty()}});
    if (well) return window_.showDone(what, folder_);
    if (!what.isEmpty()) window_.showMessage(what);
  });
}

void ExportController::exportRecording(const QString& id) {
  const std::filesystem::path path = recordings_.pathOf(id);
  window_.showLoading(tr("Reading the recording"));
  opener_.start(
      [path](const background::Watch& watch) -> haptics::Expected<Exported> {
        const auto recording = haptics::Recording::open(path, &watch.cancel);
        if (!recording) return tl::unexpected(recording.error());
        return Exported{path, recording->begin(), recording->end(), leastIsovalue(*recording)};
      },
      [this](const haptics::Expected<Exported>& recording) {
        window_.endLoading();
        if (!recording) return window_.showMessage(sentenceOf(recording.error()));
        // the questions wait for the user: outside of what delivers the result
        QTimer::singleShot(0, this, [this, recording = *recording] { askAndExport(recording); });
      });
}

void ExportController::askAndExport(const Exported& recording) {
  const std::filesystem::path& path = recording.path;
  const auto wish = ui::askForExport(&window_, recording.begin, recording.end, tables());
  if (!wish) return;
  ExportRequest request{.recording = path, .out = {}, .wish = *wish};
  const exporting::Format* const table = wish->table ? &exporting::kFormats[*wish->table] : nullptr;
  if (table == nullptr) {
    request.volume = shared_.shown ? scanOf(shared_.shown->volume()) : nullptr;
    if (request.volume) request.hash = identity_.of(request.volume);
    if (wish->film.camera == ui::ExportWish::Film::Camera::Fixed)
      request.camera = cameraOf(window_.view());
    // said once for each film, before anything is written
    if (shared_.shown && !shared_.shown->place.empty() &&
        mayShowAFace(*request.volume, recording.least_isovalue) &&
        !window_.askWhether(
            tr("This film may show a face."),
            tr("The skin is drawn at this isovalue, and a face can be recognised. Raise the "
               "isovalue to bone, or give the film only to people with permission to see it."),
            tr("Make the film")))
      return;
  }
  const QString ending = table != nullptr ? table->ending : ".mp4";
  QFileDialog dialog(&window_, tr("Export to"));
  ui::askForOutput(dialog, table != nullptr ? translated(table->filter) : tr("Film (*.mp4 *.ogv)"),
                   ending.mid(1));
  dialog.selectFile(QString::fromStdString(path.stem().string()) + ending);
  if (dialog.exec() != QDialog::Accepted) return;
  QString out = dialog.selectedFiles().value(0);
  if (table != nullptr && !out.endsWith(ending)) out += ending;
  request.out = out.toStdString();
  // the dialog asks about the name that was chosen; what is written may have others
  std::filesystem::path beside = request.out;
  if (table == nullptr)
    beside.replace_extension(".frames.csv");
  else if (!table->files.empty())
    beside += table->files.front();
  std::error_code error;
  if (out != dialog.selectedFiles().value(0) || beside != request.out)
    if (std::filesystem::exists(beside, error) &&
        !window_.askWhether(tr("An export of that name is there already."),
                            tr("Its files are written over."), tr("Write over it")))
      return;
  exportTo(std::move(request));
}

void ExportController::exportTo(ExportRequest request) {
  const QString folder = QString::fromStdString(request.out.parent_path().string());
  if (!task_.start(std::move(request)))
    return window_.showMessage(tr("An export is under way; wait for it, or cancel it first."));
  folder_ = folder;
  window_.clearMessage();
  window_.showLoading(tr("Exporting"));
}

}  // namespace app
