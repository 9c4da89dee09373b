// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>

#include "app/window/scan/shared_state.h"
#include "ui/panels/device_panel.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace app {

/// Lets the user choose the hand that holds the device, the stiffness, and whether there is a
/// force. A real device counts as a hand while it is connected. Its panel has the choices of tool
/// and field too, which belong to ToolController.
class HandController : public QObject {
  Q_OBJECT
 public:
  /// `hand`: the first hand. `stiffness` [N/m]: its initial stiffness.
  HandController(ui::Views& views, ui::Messages& messages, ui::SidePanel& panels,
                 ui::TouchState& touch, SharedState& shared, std::string hand, double stiffness);

  /// The mouse or a simulated hand, or a device's id.
  const std::string& name() const { return hand_; }
  ui::DevicePanel& panel() { return *panel_; }
  /// A stiffness [N/m] that the user did not choose here.
  void setStiffness(double stiffness);
  /// A real device was opened and holds the tool.
  void takeDevice(const QString& id, const QString& label, bool motors);
  /// The real device is gone; the mouse becomes the hand.
  void forgetDevice();
  /// Hands the scene on view to the session. Arguments as of OpeningController::loaded().
  void adopt(bool new_volume, bool placed);
  /// Brings the tool to a legal pose, with the force ramping from zero. A simulated hand begins its
  /// motion anew from there; the hand at a real device stays where it is.
  void bring(const haptics::Pose& X_WT, const haptics::Pose& X_WH);
  /// Takes the tool from the surface to a legal pose, where the mouse has it: a simulated hand
  /// would touch again.
  void lift(const haptics::Pose& X_WT);
  /// Whether a real device holds the tool.
  bool holdsDevice() const;
  /// Opens the hand if none is open, there is a scene, and no recording is on view.
  void reopen();
  /// The same for a new scene. If a simulated hand finds no target, opens the mouse instead.
  void resume();

 signals:
  /// The mouse or a simulated hand was opened in place of the previous hand or device.
  void opened();
  /// The user chose a hand while a recording is on view.
  void replayEndWanted();
  void changed(const QString& id);
  /// Asks to turn the view: to the tool if `at_tool`.
  void lookWanted(bool at_tool);

 private:
  /// Returns false and shows the reason if it failed; the previous hand then goes on.
  bool open(std::string name, const std::optional<haptics::Pose>& from = {});
  void choose(const QString& id);
  void show(const std::string& id, const QString& label, bool is_mouse, ui::Feel feel);

  ui::Views& views_;
  ui::Messages& messages_;
  ui::TouchState& touch_;
  SharedState& shared_;
  ui::DevicePanel* panel_;
  std::string hand_;
  QString label_;
};

}  // namespace app
