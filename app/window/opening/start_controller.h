// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>

#include "app/background/task.h"
#include "app/window/program/preferences_controller.h"
#include "ui/window/main_window.h"

namespace app {

/// The first minute: the pictures of the last scans on the page of an empty window, and the tour of
/// the first steps. A picture is made from the scan each time, and kept nowhere.
class StartController : public QObject {
  Q_OBJECT
 public:
  StartController(ui::MainWindow& window, PreferencesController& preferences);

  /// The window is empty: draws the last scans, one after another, on a thread of low priority.
  void drawLastScans();
  /// Something is being loaded: drops what is not drawn yet.
  void stopDrawing() { task_.abandon(); }
  /// Shows the tour, unless the user has seen it.
  void offerTour();

 private:
  ui::MainWindow& window_;
  ui::StartPage& start_;
  PreferencesController& preferences_;
  background::Task<void> task_;
};

}  // namespace app
