// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>

#include "app/window/shared_state.h"
#include "ui/main_window.h"

namespace app {

/// Lets the user choose which hand holds the device, how stiff it is held, and whether there is a
/// force. A real device counts as a hand while it is connected.
class HandController : public QObject {
  Q_OBJECT
 public:
  /// `hand`: the one that begins. `stiffness` [N/m]: what it begins with.
  HandController(ui::MainWindow& window, SharedState& shared, std::string hand, double stiffness);

  /// One of ours, or a device's id.
  const std::string& name() const { return hand_; }
  /// A real device was opened and holds the tool.
  void takeDevice(const QString& id, const QString& label);
  /// The real device is gone: the mouse is next.
  void forgetDevice();
  /// Hands the scene on view to the session. Arguments as of OpeningController::loaded().
  void adopt(bool new_volume, bool placed);
  /// Opens the hand where nothing holds the device: with a scene, and unless a recording is on
  /// view.
  void reopen();
  /// The same for a new scene: where a simulated hand finds nothing to aim at, the mouse may.
  void resume();

 signals:
  /// Another hand of ours was opened in place of whatever held the device.
  void opened();
  /// The user chose a hand while a recording is on view.
  void replayEndWanted();
  void changed(const QString& id);
  /// The view is to be turned to the tool.
  void lookWanted(bool at_tool);

 private:
  /// False, with the reason in the window, if the hand that was open goes on.
  bool open(std::string name);
  void choose(const QString& id);
  void show(const std::string& id, const QString& label, bool is_mouse);

  ui::MainWindow& window_;
  SharedState& shared_;
  std::string hand_;
  QString label_;
};

}  // namespace app
