// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "app/window/preferences.h"
#include "ui/main_window.h"

namespace app {

/// Reads the preferences at the start and writes them when something is to be remembered.
class PreferencesController : public QObject {
  Q_OBJECT
 public:
  /// Not `kept`: nothing is written.
  PreferencesController(ui::MainWindow& window, bool kept);

  Preferences& present() { return preferences_; }
  /// Gives the window the place and the docks that it had.
  void restoreWindow();
  /// Shows the notice, unless the user has read it.
  void showNotice();
  void save();

 signals:
  /// They are about to be written: a controller adds what it has to remember, at once.
  void saving(app::Preferences& preferences);

 private:
  ui::MainWindow& window_;
  Preferences preferences_;
  bool kept_;
};

}  // namespace app
