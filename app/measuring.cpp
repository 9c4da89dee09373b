// SPDX-License-Identifier: BSD-3-Clause
// What the application does about the panel "Performance".
#include "app/application.h"
#include "ui/panels/performance_panel.h"

namespace app {

void Application::connectMeasurement() {
  ui::PerformancePanel& panel = window_.performancePanel();
  connect(&panel, &ui::PerformancePanel::measureWanted, this, &Application::measure);
  connect(&panel, &ui::PerformancePanel::cancelWanted, this,
          [this] { endMeasuring(tr("The measurement was cancelled.")); });
  connect(&measurement_, &Measurement::progressed, &panel, &ui::PerformancePanel::showProgress);
  connect(&measurement_, &Measurement::measured, this, &Application::showMeasured);
  connect(&measurement_, &Measurement::failed, &panel, &ui::PerformancePanel::showNothing);
}

void Application::measure() {
  if (!shown_) return;
  const QString unit = QString::fromStdString(shown_->picture.volume->unit);
  measured_ =
      tr("Touched with %1 at the isovalue %2, %3 N/m: simulated hands slid, tapped, hooked and "
         "wedged, on one thread of ordinary priority. Carried is what keeps the tool, on "
         "average, within %4 of a voxel of where ticks without a budget would bring it, with at "
         "most one tick in a thousand longer than its period.")
          .arg(labelOf(shown_->tool),
               QString::number(settings_.isovalue) + (unit.isEmpty() ? QString() : ' ' + unit))
          .arg(settings_.stiffness, 0, 'f', 0)
          .arg(study::kMostLag);
  before_measuring_ = snapshot_;
  window_.performancePanel().showMeasuring();
  measurement_.start(
      {.scene = shown_->scene,
       .isovalue = settings_.isovalue,
       .coupling = {settings_.stiffness, settings_.angular_stiffness, settings_.friction}});
}

void Application::endMeasuring(const QString& why) {
  if (measurement_.cancel()) window_.performancePanel().showNothing(why);
}

void Application::showMeasured(const study::Here& here) {
  const auto timesOf = [](const study::Load& load) {
    return ui::TickTimes{load.points, load.median, load.p99, load.longest, load.carried};
  };
  ui::Performance shown{.conditions = measured_,
                        .present = timesOf(here.present),
                        .ticks = here.present.ticks,
                        .cut = here.present.cut,
                        .missed = here.present.missed,
                        .lag = here.present.lag,
                        .budget = here.budget,
                        .most = here.most,
                        .too_many = here.too_many,
                        .dense = here.dense,
                        .suggested = here.suggested,
                        .suggested_spacing = here.spacing(here.suggested),
                        .voxel = here.voxel,
                        .live_ticks = snapshot_.tick - before_measuring_.tick,
                        .live_late = snapshot_.late_ticks - before_measuring_.late_ticks,
                        .live_missed = snapshot_.missed_ticks - before_measuring_.missed_ticks};
  for (const study::Load& load : here.tried) shown.tried.push_back(timesOf(load));
  window_.performancePanel().show(shown);
}

}  // namespace app
