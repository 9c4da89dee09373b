// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "app/window/preferences.h"
#include "ui/main_window.h"

namespace app {

/// Reads the preferences at the start and writes them after changes.
class PreferencesController : public QObject {
  Q_OBJECT
 public:
  /// If not `kept`, nothing is written.
  PreferencesController(ui::MainWindow& window, bool kept);

  Preferences& present() { return preferences_; }
  /// Restores the window's geometry, layout, theme and hints.
  void restoreWindow();
  /// Shows the notice, which counts as read once it is closed.
  void showNotice();
  void save();

 signals:
  /// The preferences are about to be written. A receiver adds its values to `preferences` in the
  /// call.
  void saving(app::Preferences& preferences);

 private:
  ui::MainWindow& window_;
  Preferences preferences_;
  bool kept_;
};

}  // namespace app
