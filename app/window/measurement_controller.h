// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include "app/window/measurement.h"
#include "app/window/shared_state.h"
#include "ui/main_window.h"
#include "ui/panels/performance_panel.h"

namespace app {

/// Runs the panel "Performance": what this machine carries, and what the scene leaves out.
class MeasurementController : public QObject {
  Q_OBJECT
 public:
  MeasurementController(ui::MainWindow& window, SharedState& shared);

  /// Something is being loaded: that would disturb a measurement.
  void pause();
  /// What was loaded, or else what is still shown, may be measured.
  void resume();
  /// Another scene is shown.
  void showScene();
  /// Ends a measurement that is under way; the panel says why.
  void end(const QString& why);

 private:
  void measure();
  void showMeasured(const study::Here& here);

  SharedState& shared_;
  ui::PerformancePanel* panel_;  ///< the window's
  Measurement measurement_;
  haptics::Snapshot before_;
  QString conditions_;  ///< with what and how the measurement under way is made
};

}  // namespace app
