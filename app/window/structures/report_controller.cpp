// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/structures/report_controller.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/export/text.h"
#include "app/recording/recording.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "datasets/labels/distances.h"
#include "haptics/process/output_file.h"
#include "ui/dialogs/report_moments.h"
#include "ui/dialogs/save_dialog.h"

namespace app {
namespace {

constexpr const char* kOtherScan = "another-volume";
constexpr std::size_t kMostMoments = 500;  // of contacts, in the list

/// The structures of a report: those that are watched or that the recording watched, else the first
/// that the scan has.
std::vector<int> numbersFor(const std::set<int>& watched, const Recording& recording,
                            const datasets::LabelMap& labels) {
  const auto isThere = [&](int number) {
    const auto of = static_cast<std::size_t>(number);
    return of < labels.structures().size() && labels.structures()[of].voxels > 0;
  };
  std::vector<int> numbers;
  const auto add = [&](int number) {
    if (numbers.size() < haptics::kMostWatched && isThere(number) &&
        std::ranges::find(numbers, number) == numbers.end())
      numbers.push_back(number);
  };
  for (const std::uint8_t number : recording.structures()) add(number);
  for (const int number : watched) add(number);
  if (numbers.empty())
    for (int number = 0; number < static_cast<int>(labels.structures().size()); ++number)
      add(number);
  std::ranges::sort(numbers);
  return numbers;
}

std::string textOf(const report::Report& all, const std::filesystem::path& out) {
  if (out.extension() == ".json") return report::jsonOf(all).dump(2) + "\n";
  if (out.extension() == ".csv") return report::csvOf(all);
  return report::htmlOf(all);
}

}  // namespace

ReportController::ReportController(ui::Messages& messages, ui::Loading& loading,
                                   SharedState& shared, const Recordings& recordings,
                                   const StructuresController& structures)
    : messages_(messages),
      loading_(loading),
      shared_(shared),
      recordings_(recordings),
      structures_(structures),
      task_([this](double fraction) { loading_.advance(fraction); }) {
  connect(&loading, &ui::Loading::cancelWanted, this, [this] { task_.cancel(); });
}

void ReportController::reportRecording(const QString& id) {
  if (!structures_.labels())
    return messages_.showMessage(
        tr("A report tells distances to structures: open the scan of the recording and its "
           "structures first."));
  QFileDialog dialog(messages_.window(), tr("Save report as"));
  ui::askForOutput(dialog, tr("Report (*.html *.json *.csv)"), "html");
  dialog.selectFile(QFileInfo(id).completeBaseName() + "-report.html");
  if (dialog.exec() != QDialog::Accepted) return;
  reportTo(id, dialog.selectedFiles().value(0).toStdString());
}

void ReportController::reportTo(const QString& id, const std::filesystem::path& out) {
  if (!structures_.labels() || task_.isRunning()) return;
  const std::filesystem::path path = recordings_.pathOf(id);
  const auto scan = scanOf(shared_.shown->volume());
  messages_.clear();
  loading_.begin(tr("Making the report"));
  task_.start(
      [path, out, scan, hash = shared_.identity.of(scan), labels = structures_.labels(),
       known = structures_.distances(), looks = structures_.shown().looks,
       limits = structures_.limits()](const background::Watch& watch) -> haptics::Expected<Made> {
        haptics::keepInput(path);
        auto recording = Recording::open(path, &watch.cancel);
        if (!recording) return tl::unexpected(recording.error());
        if (std::ranges::none_of(recording->scenes(), [&](const RecordedScene& scene) {
              return isOf(scene, *scan, hash);
            }))
          return tl::unexpected(
              haptics::Error{haptics::Error::Kind::Unsupported,
                             tr("The recording is of another scan than the one on view; open its "
                                "scan and the structures of that.")
                                 .toStdString(),
                             kOtherScan});
        std::set<int> watched;
        for (std::size_t n = 0; n < looks.size(); ++n)
          if (looks[n].watched) watched.insert(static_cast<int>(n));
        haptics::Watch over;
        report::Report all;
        std::vector<std::vector<double>> margins;
        const std::vector<int> numbers = numbersFor(watched, *recording, *labels);
        const datasets::DistanceOptions options = datasets::distancesOf(haptics::kMostWatched);
        for (const int number : numbers) {
          const auto structure = static_cast<std::uint8_t>(number);
          const auto found = known.find(number);
          haptics::Expected<haptics::DistanceMap> map =
              found != known.end()
                  ? found->second
                  : datasets::distancesTo(*labels, structure, options,
                                          [&](double) { return !watch.cancelled(); });
          if (!map) return tl::unexpected(map.error());
          const ui::StructureLook& look = looks[structure];
          std::set<double> of{limits.close_mm, limits.near_mm};
          if (look.feel.kind == ui::StructureFeel::Kind::Guarded) of.insert(look.feel.margin_mm);
          std::vector<double> m;
          for (const double mm : of)
            if (mm / ui::kMmPerM < double(float(map->told()))) m.push_back(mm / ui::kMmPerM);
          all.structures.push_back(
              {.number = number + 1,
               .name = look.own_name ? exporting::plain(look.name.toStdString()) : std::string{},
               .error = map->error,
               .told = map->told(),
               .margins = m});
          margins.push_back(std::move(m));
          over.structures.push_back({structure, std::move(*map)});
        }
        auto session = report::sessionOf(*recording, over, scan, hash, margins, [&](double done) {
          watch.advanced(done);
          return !watch.cancelled();
        });
        if (!session) return tl::unexpected(session.error());
        all.sessions.push_back(std::move(*session));
        if (auto written = haptics::writeFile(out, textOf(all, out)); !written)
          return tl::unexpected(written.error());
        return Made{std::move(all.structures), std::move(all.sessions.front())};
      },
      [this, path, out](haptics::Expected<Made> made) {
        loading_.end();
        if (!made) {
          const QString why = sentenceOf(made.error());
          if (made.error().kind != haptics::Error::Kind::Cancelled) messages_.showMessage(why);
          return emit finished(false, why);
        }
        const QFileInfo file(QString::fromStdString(out.string()));
        messages_.showDone(
            made->session.differing == 0
                ? tr("The report was written: \"%1\".").arg(file.fileName())
                : tr("The report was written: \"%1\". The recording has other distances: it "
                     "was made with other structures.")
                      .arg(file.fileName()),
            file.absolutePath());
        showMoments(path, *made);
        if (out.extension() == ".html") emit pageWanted(file.absoluteFilePath());
        emit finished(true, {});
      });
}

void ReportController::showMoments(const std::filesystem::path& recording, const Made& made) {
  QList<ui::ReportMoment> moments;
  const auto mm = [](double m) { return QLocale().toString(m * ui::kMmPerM, 'f', 1); };
  const auto& looks = structures_.shown().looks;
  for (std::size_t n = 0; n < made.structures.size(); ++n) {
    const auto number = static_cast<std::size_t>(made.structures[n].number - 1);
    const QString name = number < looks.size() ? looks[number].name : QString{};
    const report::FiguresOf& figures = made.session.figures.structures[n];
    if (std::isfinite(figures.nearest.at))
      moments.append({figures.nearest.at,
                      figures.nearest.value <= 0.0
                          ? tr("Farthest inside %1: %2 mm").arg(name, mm(-figures.nearest.value))
                          : tr("Nearest to %1: %2 mm").arg(name, mm(figures.nearest.value))});
    for (const report::Encounter& encounter :
         std::span{figures.encounters}.first(std::min(kMostMoments, figures.encounters.size()))) {
      if (!encounter.guarded) continue;
      moments.append(
          {encounter.from,
           encounter.nearest <= 0.0 && encounter.cut
               ? tr("Burr inside %1, which was guarded: %2 mm").arg(name, mm(-encounter.nearest))
           : encounter.nearest <= 0.0
               ? tr("Inside %1, which was guarded: %2 mm").arg(name, mm(-encounter.nearest))
               : tr("Contact with %1, which was guarded: %2 N")
                     .arg(name, QLocale().toString(encounter.push, 'f', 1))});
    }
  }
  std::ranges::stable_sort(moments, {}, &ui::ReportMoment::time);
  if (moments_) moments_->close();
  moments_ = new ui::ReportMoments(QString::fromStdString(recording.stem().string()), moments,
                                   messages_.window());
  moments_->setAttribute(Qt::WA_DeleteOnClose);
  connect(moments_, &ui::ReportMoments::momentWanted, this,
          [this, recording](double time) { emit momentWanted(recording, time); });
  moments_->show();
}

}  // namespace app
