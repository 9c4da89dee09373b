// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/touch/measurement_controller.h"

#include <QLocale>

#include "app/window/scan/sentence.h"

namespace app {

MeasurementController::MeasurementController(ui::SidePanel& panels, SharedState& shared)
    : shared_(shared), panel_(new ui::PerformancePanel) {
  panels.add(panel_, tr("Performance"), tr("Performance"), "performanceSection", ui::Tab::Touch,
             ui::Fold::Folded);
  connect(panel_, &ui::PerformancePanel::measureWanted, this, &MeasurementController::measure);
  connect(panel_, &ui::PerformancePanel::cancelWanted, this,
          [this] { end(tr("The measurement was cancelled.")); });
  connect(&measurement_, &Measurement::progressed, panel_, &ui::PerformancePanel::showProgress);
  connect(&measurement_, &Measurement::measured, this, &MeasurementController::showMeasured);
  connect(&measurement_, &Measurement::failed, panel_, &ui::PerformancePanel::showNothing);
}

void MeasurementController::pause() {
  end(tr("The measurement was cancelled: another scan or tool is being loaded."));
  panel_->setReady(false);
}

void MeasurementController::resume() {
  if (shared_.shown) panel_->setReady(true);
}

void MeasurementController::showScene() {
  panel_->showNothing({});  // what was measured was another scene
  QList<ui::LeftOut> left_out;
  for (const haptics::PlanLine& line : shared_.shown->scene->planned)
    if (line.left_out) left_out.push_back({sentenceOf(line.what), sentenceOf(line.why)});
  panel_->showLeftOut(left_out);
  panel_->setReady(true);
}

void MeasurementController::measure() {
  if (!shared_.shown) return;
  const Loaded& shown = *shared_.shown;
  const haptics::Settings& settings = shared_.settings;
  const QString unit = QString::fromStdString(shown.volume()->unit);
  conditions_ = tr("Touched with %1 at the isovalue %2, %3 N/m: simulated hands slid, tapped, "
                   "hooked and wedged, on one thread of ordinary priority. A rate is carried if "
                   "the tool stays, on average, within %L4 of a voxel of its place without a "
                   "budget, and at most one tick in a thousand is longer than its period.")
                    .arg(labelOf(shown.tool), QLocale().toString(settings.isovalue, 'g', 6) +
                                                  (unit.isEmpty() ? QString() : ' ' + unit))
                    .arg(settings.stiffness, 0, 'f', 0)
                    .arg(measurement::kMostLag);
  before_ = shared_.snapshot;
  panel_->showMeasuring();
  const haptics::ServoRate rate = shared_.session.rate();
  measurement_.start(
      {.scene = shown.scene,
       .isovalue = settings.isovalue,
       .coupling = {settings.stiffness, settings.angular_stiffness, settings.friction},
       .allowance = {.nanoseconds = rate.budget_ns(), .period = rate.period(), .rate = rate}});
}

void MeasurementController::end(const QString& why) {
  if (measurement_.cancel()) panel_->showNothing(why);
}

void MeasurementController::showMeasured(const measurement::Capacity& capacity) {
  const auto timesOf = [](const measurement::Load& load) {
    return ui::TickTimes{load.points, load.median, load.p99, load.longest, load.carried};
  };
  const haptics::Snapshot& now = shared_.snapshot;
  ui::Performance shown{.conditions = conditions_,
                        .present = timesOf(capacity.present),
                        .ticks = capacity.present.ticks,
                        .cut = capacity.present.cut,
                        .missed = capacity.present.missed,
                        .lag = capacity.present.lag,
                        .budget = capacity.budget,
                        .most = capacity.most,
                        .too_many = capacity.too_many,
                        .dense = capacity.dense,
                        .suggested = capacity.suggested,
                        .suggested_spacing = capacity.spacing(capacity.suggested),
                        .voxel = capacity.voxel,
                        .live_ticks = now.tick - before_.tick,
                        .live_late = now.late_ticks - before_.late_ticks,
                        .live_missed = now.missed_ticks - before_.missed_ticks};
  for (const measurement::Load& load : capacity.tried) shown.tried.push_back(timesOf(load));
  panel_->show(shown);
}

}  // namespace app
