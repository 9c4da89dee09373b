// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "app/window/program/preferences.h"
#include "haptics/session.h"
#include "ui/dialogs/preferences_window.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace app {

/// Reads the preferences at the start, writes them after changes, and shows them in a window of
/// their own, where a change is applied at once.
class PreferencesController : public QObject {
  Q_OBJECT
 public:
  /// If not `kept`, nothing is written.
  PreferencesController(ui::MainWindow& window, bool kept);

  Preferences& present() { return preferences_; }
  /// N/m with which a start begins.
  double firstStiffness() const;
  /// Of the hands that are opened; none: as a device's link carries.
  std::optional<haptics::ServoRate> servoRate() const;
  /// Restores the window's geometry, layout, theme and hints, and keys, units and mouse.
  void restoreWindow();
  /// Shows the notice, which counts as read once it is closed.
  void showNotice();
  void save();
  /// Shows the window of the preferences.
  void open();

 signals:
  /// The preferences are about to be written. A receiver adds its values to `preferences` in the
  /// call.
  void saving(app::Preferences& preferences);
  /// The user chose the stiffness [N/m] that holds at the start, and from now on.
  void stiffnessChosen(double stiffness);
  /// The user chose another servoRate().
  void servoRateChosen();
  /// The user chose another folder of recordings; empty: the own one.
  void recordingsChosen(const QString& folder);
  void rememberPlacesChosen(bool remember);
  void forgetPlacesWanted();

 private:
  ui::PreferenceChoices choices() const;
  void apply(const ui::PreferenceChoices& wanted);
  /// Shows the present choices, if the window is there.
  void show();

  ui::MainWindow& window_;
  ui::Views& views_;
  ui::Messages& messages_;
  ui::Menus& menus_;
  ui::PreferencesWindow* shown_ = nullptr;  ///< the main window's; null before it is opened
  Preferences preferences_;
  bool kept_;
};

}  // namespace app
