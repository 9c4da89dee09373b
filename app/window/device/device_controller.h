// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "app/window/device/device_watch.h"
#include "app/window/program/preferences_controller.h"
#include "app/window/scan/shared_state.h"
#include "ui/panels/haptic_device_panel.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/start_page.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace app {

/// Connects a haptic device, maps its motion to the scan, and reports the state of its force.
class DeviceController : public QObject {
  Q_OBJECT
 public:
  DeviceController(ui::Views& views, ui::Messages& messages, ui::SidePanel& panels,
                   ui::TouchState& touch, ui::StartPage& start, SharedState& shared,
                   PreferencesController& preferences, DeviceCatalogue catalogue);

  /// Shows the device as disconnected; the session has closed it already. Restores the stiffness of
  /// before the connection. The panel shows `why`.
  void forget(const QString& why);
  /// There is something to touch: connects the device that the user chose before.
  void openWaiting();
  /// Called at display rate.
  void refresh();
  /// The stiffness [N/m] that holds without a device of its own.
  void setStiffness(double stiffness);
  /// Shows the state of the force in the newest snapshot.
  void showForce() { panel_->display(shared_.snapshot); }

 signals:
  /// A device is about to be opened; a recording on view is closed.
  void taking();
  void taken(const QString& id, const QString& name, bool motors);
  /// The device was disconnected.
  void forgotten();
  /// The user disconnected the device; another hand may take the tool.
  void released();
  /// The stiffness [N/m] that suits the device, or the one of before.
  void stiffnessWanted(double stiffness);
  /// A transition of the force, as the text of a recording's event.
  void forceChanged(const QString& transition);

 private:
  void connectPanel();
  void watchDevices();
  void open(const ui::DeviceWish& wish);
  QString nameOf(const QString& id) const;
  bool hasMotors(const QString& id) const;
  void take(const ui::DeviceWish& wish, const DeviceWatch::Opened& device);
  void letGo();
  void restoreStiffness();
  void map(const ui::Mapping& mapping);
  void handle();
  void tellOfFault(haptics::ForceReason why);

  ui::Views& views_;
  ui::Messages& messages_;
  ui::SidePanel& panels_;
  ui::TouchState& touch_;
  SharedState& shared_;
  ui::HapticDevicePanel* panel_;
  DeviceWatch watch_;
  QList<ui::DeviceLine> devices_;
  bool seen_ = false;                        ///< the panel is in view
  std::optional<ui::DeviceWish> connected_;  ///< the device that is open
  std::optional<ui::DeviceWish> waiting_;    ///< chosen while there was nothing to touch
  QString connected_name_;
  std::optional<double> own_stiffness_;  ///< N/m, stiffness before a device was connected
  ui::Mapping mapping_;
  haptics::Handling handling_;
};

}  // namespace app
