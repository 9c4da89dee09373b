// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include "app/window/scan/shared_state.h"
#include "app/window/touch/measurement.h"
#include "ui/panels/performance_panel.h"
#include "ui/window/side_panel.h"

namespace app {

/// Runs the panel "Performance": how many points this machine carries, and what the scene leaves
/// out.
class MeasurementController : public QObject {
  Q_OBJECT
 public:
  MeasurementController(ui::SidePanel& panels, SharedState& shared);

  /// Disables measuring while a volume is being loaded.
  void pause();
  /// Enables measuring of the scene on view, after loading or a failure.
  void resume();
  /// Another scene is shown.
  void showScene();
  /// Ends a running measurement. The panel shows `why`.
  void end(const QString& why);

 private:
  void measure();
  void showMeasured(const measurement::Capacity& capacity);

  SharedState& shared_;
  ui::PerformancePanel* panel_;  ///< the window's
  Measurement measurement_;
  haptics::Snapshot before_;
  QString conditions_;  ///< tool, hand and settings of the running measurement
};

}  // namespace app
