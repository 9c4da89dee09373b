// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/opening/series_choice.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <utility>

#include "app/window/scan/sentence.h"
#include "datasets/labels/segments.h"
#include "ui/dialogs/part_question.h"
#include "ui/dialogs/series_browser.h"

namespace app {
namespace {

// DICOM parts the names of a person with carets
QString nameOf(const std::string& patient) {
  return QString::fromStdString(patient).replace('^', ' ').simplified();
}

ui::Verdict verdictOf(const datasets::SeriesVerdict& series) {
  switch (series.verdict) {
    case datasets::Verdict::Sound:
      return ui::Verdict::Sound;
    case datasets::Verdict::Correctable:
      return ui::Verdict::Correctable;
    case datasets::Verdict::Refused:
      break;
  }
  return series.unbroken_part ? ui::Verdict::InPart : ui::Verdict::Refused;
}

ui::SeriesRow rowOf(const datasets::SeriesVerdict& series) {
  ui::SeriesRow row{
      .patient = nameOf(series.labels.patient),
      .study = QString::fromStdString(series.labels.study).simplified(),
      .series = QString::fromStdString(series.labels.series).simplified(),
      .modality = QString::fromStdString(series.modality),
      .dims = series.dims,
      .spacing_mm = {series.spacing_mm.x(), series.spacing_mm.y(), series.spacing_mm.z()},
      .verdict = verdictOf(series),
      .sentence = sentenceOf(series.message),
      .bytes = series.bytes};
  if (const auto& part = series.unbroken_part) {
    row.dims[2] = part->slices;
    row.slices_there = part->of;
    row.spacing_mm = {part->spacing_mm.x(), part->spacing_mm.y(), part->spacing_mm.z()};
    row.bytes = row.bytes / part->of * part->slices;
  }
  if (!series.part.empty()) {
    if (!row.series.isEmpty()) row.series += QStringLiteral(", ");
    row.series += sentenceOf(series.part);
  }
  for (const haptics::Message& fault : series.faults) row.faults << sentenceOf(fault);
  return row;
}

ui::SeriesRow rowOf(const datasets::StructuresFound& found, const QString& sentence) {
  const bool drawn = found.kind == datasets::StructuresFound::Kind::Contours;
  ui::SeriesRow row;
  row.series = QString::fromStdString(datasets::shownName(found.name));
  row.modality = drawn ? QStringLiteral("RTSTRUCT") : QStringLiteral("SEG");
  row.verdict = ui::Verdict::Structures;
  row.sentence = sentence;
  return row;
}

// what is not known of its voxels is taken to be large
ui::LargeVolume largeVolumeOf(const datasets::SeriesVerdict& series, double free_bytes) {
  constexpr std::int64_t kGreatestVoxel = 4;  // bytes
  const std::int64_t voxels = series.dims[0] * series.dims[1] * series.dims[2];
  return {.dims = series.dims,
          .bytes = series.bytes > 0 ? series.bytes : voxels * kGreatestVoxel,
          .free_bytes = free_bytes};
}

}  // namespace

SeriesChoice::SeriesChoice(ui::Messages& messages, ui::Menus& menus,
                           std::function<double()> free_memory)
    : messages_(messages), menus_(menus), free_memory_(std::move(free_memory)) {
  connect(&menus, &ui::Menus::seriesWanted, this, &SeriesChoice::browse);
}

void SeriesChoice::take(const Surveyed& surveyed) {
  close();  // of the survey before
  surveyed_ = surveyed;
  menus_.setSeriesKnown(surveyed.survey.several);
}

bool SeriesChoice::ask(const LoadRequest& request, const haptics::Error& error) {
  const QString why = sentenceOf(error);
  if (error.reason == kWhichSeries) {
    browse();
    return true;
  }
  if (error.kind == haptics::Error::Kind::Correctable) {
    offerCorrection(request, why, error.reason);
    return true;
  }
  return (error.reason == kMissingSlices && offerLargestPart(request)) ||
         (error.reason == kTooLarge && offerPart(request, why));
}

void SeriesChoice::browse() {
  if (!surveyed_) return;
  close();
  QList<ui::SeriesRow> rows;
  for (const datasets::SeriesVerdict& series : surveyed_->survey.series) rows << rowOf(series);
  for (const datasets::StructuresFound& found : surveyed_->survey.structures)
    rows << rowOf(found, tr("Structures of a scan. Load their scan first; then they are opened in "
                            "it."));
  const QString place = surveyed_->name.isEmpty()
                            ? QString::fromStdString(surveyed_->place.filename().string())
                            : surveyed_->name;
  browser_ = new ui::SeriesBrowser(place, rows, messages_.window());
  browser_->setAttribute(Qt::WA_DeleteOnClose);
  connect(browser_, &ui::SeriesBrowser::loadWanted, this, &SeriesChoice::loadChosen);
  connect(browser_, &QDialog::finished, &thumbnails_, &Thumbnails::stop);
  connect(&thumbnails_, &Thumbnails::ready, browser_, &ui::SeriesBrowser::showThumbnail);
  // not modal: the touch goes on, and so does the stop button
  browser_->show();
  const double scale = browser_->devicePixelRatioF();
  thumbnails_.start(surveyed_->survey.series, qRound(ui::SeriesBrowser::kThumbnail * scale));
}

void SeriesChoice::close() {
  if (browser_) browser_->close();
}

void SeriesChoice::loadChosen(int row) {
  if (const auto of = static_cast<std::size_t>(row); of >= surveyed_->survey.series.size())
    return emit structuresWanted(
        surveyed_->survey.structures[of - surveyed_->survey.series.size()]);
  const datasets::SeriesVerdict& series = surveyed_->survey.series[static_cast<std::size_t>(row)];
  LoadRequest request{.path = surveyed_->path,
                      .name = surveyed_->name,
                      .chosen = ChosenSeries{.series = series,
                                             .among_others = surveyed_->survey.series.size() > 1,
                                             .place = surveyed_->place}};
  if (series.verdict == datasets::Verdict::Correctable)
    return offerCorrection(std::move(request), sentenceOf(series.message), series.reasons.front());
  if (series.unbroken_part) return void(offerLargestPart(std::move(request)));
  emit wanted(request);
}

bool SeriesChoice::offerLargestPart(LoadRequest request) {
  if (!request.chosen || !request.chosen->series.unbroken_part) return false;
  // the sentence of the survey says which part that is
  const QString why = sentenceOf(request.chosen->series.message);
  if (messages_.askWhether(
          why,
          tr("Only these slices are then seen and felt, unchanged; nothing is shown "
             "beyond the gaps. The files stay unchanged."),
          tr("Load the largest unbroken part"))) {
    request.largest_part = true;
    emit wanted(request);
  }
  return true;
}

void SeriesChoice::offerCorrection(LoadRequest request, const QString& why,
                                   const std::string& reason) {
  const bool agreed =
      reason == kIdentifiersDiffer
          ? messages_.askWhether(why,
                                 tr("Look at the slices before you rely on picture and touch: they "
                                    "may be of several people. The files stay unchanged."),
                                 tr("Load as one stack"))
          : messages_.askWhether(
                why,
                tr("Picture and touch are then interpolated between the scan's own "
                   "slices. The files stay unchanged."),
                tr("Resample and load"));
  if (!agreed) return;
  request.geometry = datasets::Geometry::Corrected;
  emit wanted(request);
}

bool SeriesChoice::offerPart(LoadRequest request, const QString& why) {
  // slices that are to be resampled are read whole
  if (!request.chosen || !request.part.isWhole() ||
      request.chosen->series.verdict != datasets::Verdict::Sound ||
      std::ranges::any_of(request.chosen->series.dims, [](auto n) { return n < 1; }))
    return false;
  const auto part = ui::askForPart(messages_.window(), why,
                                   largeVolumeOf(request.chosen->series, free_memory_()));
  if (!part) return true;
  request.part.step = part->step;
  if (part->box) request.part.box = datasets::Part::Box{part->box->first, part->box->end};
  emit wanted(request);
  return true;
}

}  // namespace app
