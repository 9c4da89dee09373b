// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edits/surface_controller.h"

#include <QFileDialog>
#include <QLocale>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/film/face.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "datasets/edits/edited.h"
#include "datasets/surface/surface_file.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/window/menus.h"

namespace app {

SurfaceController::SurfaceController(ui::MainWindow& window, SharedState& shared)
    : messages_(window.messages()),
      loading_(window.loading()),
      shared_(shared),
      writer_([this](double fraction) { loading_.advance(fraction); }) {
  connect(&window.menus(), &ui::Menus::surfaceWanted, this, &SurfaceController::ask);
  connect(&window.loading(), &ui::Loading::cancelWanted, this, [this] { writer_.cancel(); });
}

void SurfaceController::ask() {
  if (!shared_.shown)
    return messages_.showMessage(tr("There is no surface yet; open a scan first."));
  if (writer_.isRunning())
    return messages_.showMessage(
        tr("A surface is being written; wait for it, or cancel it first."));
  volume_ = shared_.shown->volume();
  isovalue_ = shared_.settings.isovalue;
  const bool shows_a_face = !shared_.shown->place.empty() && mayShowAFace(*volume_, isovalue_);
  std::vector<QString> endings;
  for (const auto& format : datasets::kSurfaceFormats) endings.emplace_back(format.ending);
  QString words = tr("at the isovalue %1").arg(QLocale().toString(isovalue_, 'g', 6));
  if (!volume_->unit.empty()) words += " " + QString::fromStdString(volume_->unit);
  ui::SurfaceDialog dialog(words, endings, datasets::editedOf(*volume_) != nullptr,
                           messages_.window());
  dialog_ = &dialog;
  connect(&dialog, &ui::SurfaceDialog::surfaceChanged, this, [&] { count(dialog.wish()); });
  count(dialog.wish());
  const bool agreed = dialog.exec() == QDialog::Accepted;
  counter_.abandon();
  if (agreed &&
      (!shows_a_face ||
       messages_.askWhether(
           tr("This surface may show a face."),
           tr("It may have skin, and a face can be recognised. Choose an isovalue of bone, or give "
              "the file only to people with permission to see it."),
           tr("Export the surface"))))
    write(dialog.wish());
  surface_.reset();
  volume_.reset();
}

void SurfaceController::count(const ui::SurfaceWish& wish) {
  surface_.reset();
  counter_.start(
      [volume = wish.removed ? scanOf(volume_) : volume_, isovalue = isovalue_,
       largest = wish.largest](const background::Watch& watch) -> haptics::Expected<MadeSurface> {
        auto surface = datasets::Surface::of(volume, isovalue, largest, {.cancel = &watch.cancel});
        if (!surface) return tl::unexpected(surface.error());
        return std::make_shared<const datasets::Surface>(std::move(*surface));
      },
      [this](haptics::Expected<MadeSurface> surface) {
        if (!dialog_) return;
        if (!surface) return dialog_->showProblem(sentenceOf(surface.error()));
        surface_ = std::move(*surface);
        std::vector<std::int64_t> bytes;
        for (const auto& format : datasets::kSurfaceFormats)
          bytes.push_back(bytesOf(*surface_, format.format));
        dialog_->showSize(surface_->triangles(), std::move(bytes));
      });
}

void SurfaceController::write(const ui::SurfaceWish& wish) {
  const datasets::SurfaceFormatName& format = datasets::kSurfaceFormats.at(wish.format);
  const QString ending = format.ending;
  QFileDialog dialog(messages_.window(), tr("Export the surface to"));
  ui::askForOutput(dialog, tr("Surface (*%1)").arg(ending), ending.mid(1));
  dialog.selectFile(tr("surface") + ending);
  if (dialog.exec() != QDialog::Accepted) return;
  const auto chosen = ui::withEnding(messages_, dialog.selectedFiles().value(0), ending);
  if (!chosen) return;
  const QString path = *chosen;
  const std::filesystem::path out = path.toStdString();
  messages_.clear();
  loading_.begin(tr("Writing the surface"));
  writer_.start(
      [surface = surface_, out, format = format.format,
       frame = wish.ras ? datasets::SurfaceFrame::Ras : datasets::SurfaceFrame::Lps](
          const background::Watch& watch) -> haptics::Expected<QString> {
        const datasets::EditWatch told{.cancel = &watch.cancel,
                                       .advanced = [&](double done) { watch.advanced(done); }};
        const auto written = datasets::writeSurface(*surface, out, format, frame, told);
        if (!written) return tl::unexpected(written.error());
        return QString::fromStdString(out.filename().string());
      },
      [this, folder = QString::fromStdString(out.parent_path().string())](
          const haptics::Expected<QString>& name) {
        loading_.end();
        QString why;
        if (name)
          messages_.showDone(tr("\"%1\" was exported.").arg(*name), folder);
        else if (name.error().kind != haptics::Error::Kind::Cancelled)
          why = sentenceOf(name.error());
        if (!why.isEmpty()) messages_.showMessage(why);
        emit written(name.has_value(), why);
      });
}

}  // namespace app
