// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/export_controller.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "app/export/export.h"
#include "app/film/face.h"
#include "app/log/log.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/view_camera.h"
#include "ui/dialogs/export_question.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/views/volume_view.h"

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

ExportController::ExportController(ui::Views& views, ui::Messages& messages, ui::Loading& loading,
                                   SharedState& shared, const Recordings& recordings,
                                   const ui::Measures& measures)
    : views_(views),
      messages_(messages),
      loading_(loading),
      shared_(shared),
      recordings_(recordings),
      measures_(measures) {
  connect(&loading, &ui::Loading::cancelWanted, &task_, &ExportTask::cancel);
  connect(&loading, &ui::Loading::cancelWanted, this, [this] { opener_.cancel(); });
  connect(&task_, &ExportTask::progressed, &loading, &ui::Loading::advanceBehind);
  connect(&task_, &ExportTask::finished, this, [this](bool well, const QString& what) {
    loading_.setBehind({});
    log::write(log::Level::Info, "export-ended", {{"whole", well}, {"cancelled", what.isEmpty()}});
    if (well) return messages_.showDone(what, folder_);
    if (!what.isEmpty()) messages_.showMessage(what);
  });
}

void ExportController::exportRecording(const QString& id) {
  const std::filesystem::path path = recordings_.pathOf(id);
  loading_.begin(tr("Reading the recording"));
  opener_.start(
      [path](const background::Watch& watch) -> haptics::Expected<Exported> {
        const auto recording = Recording::open(path, &watch.cancel);
        if (!recording) return tl::unexpected(recording.error());
        return Exported{path, recording->begin(), recording->end(), leastIsovalue(*recording),
                        recording->scenes()};
      },
      [this](const haptics::Expected<Exported>& recording) {
        loading_.end();
        if (!recording) return messages_.showMessage(sentenceOf(recording.error()));
        // the questions wait for the user: outside of what delivers the result
        QTimer::singleShot(0, this, [this, recording = *recording] { askAndExport(recording); });
      });
}

void ExportController::askAndExport(const Exported& recording) {
  const std::filesystem::path& path = recording.path;
  const auto wish = ui::askForExport(messages_.window(), recording.begin, recording.end, tables());
  if (!wish) return;
  ExportRequest request{.recording = path, .out = {}, .wish = *wish};
  const exporting::Format* const table = wish->table ? &exporting::kFormats[*wish->table] : nullptr;
  request.volume = shared_.shown ? scanOf(shared_.shown->volume()) : nullptr;
  if (request.volume) request.hash = shared_.identity.of(request.volume);
  if (table == nullptr) {
    if (wish->film.camera == ui::ExportWish::Film::Camera::Fixed)
      request.camera = cameraOf(views_.volume());
    const bool of_view =
        request.volume && std::ranges::any_of(recording.scenes, [&](const RecordedScene& scene) {
          return isOf(scene, *request.volume, request.hash);
        });
    if (!of_view &&
        !messages_.askWhether(
            tr("This film will show the tool alone."),
            tr("The recording is of another scan than the one on view. Open its scan first, and "
               "the film shows its surface, too."),
            tr("Make the film")))
      return;
    request.look = lookOf(views_.look(), filmMarks(measures_.all(), measures_.scan()));
    request.look.slices = wish->film.slices;
    request.look.tint = views_.volume().isTinted();
    double least =
        std::min(recording.least_isovalue, request.look.second.value_or(recording.least_isovalue));
    // a slice shows the skin whatever the isovalue, and may be a profile
    if (of_view && request.look.slices) least = request.volume->least;
    // said once for each film, before anything is written
    if (shared_.shown && !shared_.shown->place.empty() && mayShowAFace(*request.volume, least) &&
        !messages_.askWhether(
            tr("This film may show a face."),
            request.look.slices
                ? tr("Slices show the skin, and a profile can be recognised. Make the film "
                     "without slices at isovalues of bone, or give it only to people with "
                     "permission to see it.")
                : tr("At its isovalues skin may be drawn, and a face can be recognised. Choose "
                     "isovalues of bone, for a second surface too, or give the film only to "
                     "people with permission to see it."),
            tr("Make the film")))
      return;
  }
  const bool mp4 = !QStandardPaths::findExecutable("ffmpeg").isEmpty();
  const QString ending = table != nullptr ? table->ending : mp4 ? ".mp4" : ".ogv";
  QFileDialog dialog(messages_.window(), tr("Export to"));
  ui::askForOutput(dialog, table != nullptr ? translated(table->filter) : tr("Film (*.mp4 *.ogv)"),
                   ending.mid(1));
  dialog.selectFile(QString::fromStdString(path.stem().string()) + ending);
  if (table == nullptr &&
      std::ranges::count(measures_.all(), ui::MeasureKind::Note, &ui::Measure::kind) > 0)
    ui::addNotesWarning(dialog);
  if (dialog.exec() != QDialog::Accepted) return;
  QString out = dialog.selectedFiles().value(0);
  if (table != nullptr && !out.endsWith(ending)) out += ending;
  request.out = out.toStdString();
  // the dialog asks about the name that was chosen; what is written may have others
  std::vector<std::filesystem::path> written;
  if (table == nullptr)
    written = {std::filesystem::path(request.out).replace_extension(".frames.csv")};
  if (table != nullptr) {
    for (const char* file : table->files) written.emplace_back(request.out) += file;
    if (table->beside != nullptr)
      written.push_back(std::filesystem::path(request.out).replace_extension(table->beside));
  }
  if (out != dialog.selectedFiles().value(0)) written.push_back(request.out);
  const auto isThere = [](const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::exists(file, error);
  };
  if (std::ranges::any_of(written, isThere) &&
      !messages_.askWhether(tr("An export of that name is there already."),
                            tr("Its files are written over."), tr("Write over it")))
    return;
  exportTo(std::move(request));
}

void ExportController::exportTo(ExportRequest request) {
  const QString folder = QString::fromStdString(request.out.parent_path().string());
  if (!task_.start(std::move(request)))
    return messages_.showMessage(tr("An export is under way; wait for it, or cancel it first."));
  folder_ = folder;
  messages_.clear();
  loading_.setBehind(tr("Exporting"));
}

}  // namespace app
