// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <optional>

#include "haptics/core/trouble.h"
#include "haptics/settings.h"
#include "haptics/snapshot.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;
class QTreeWidget;

namespace ui {

class NumberBox;
class StateChip;

/// A haptic device in the list.
struct DeviceLine {
  QString id;
  QString name;
  int sensed = 0, actuated = 0;  ///< degrees of freedom
  bool present = false;
  haptics::Trouble trouble = haptics::Trouble::None;  ///< None: it can be connected
  QString why = {};                                   ///< a sentence; or empty
  double force = 0.0;      ///< N, the maker's rating; 0: unknown, or no motors
  double stiffness = 0.0;  ///< N/m, the maker's rating; 0: unknown, or no motors

  bool operator==(const DeviceLine&) const = default;
};

/// The connection that the user asks for.
struct DeviceWish {
  QString id;
  QString firmware = {};  ///< path of the maker's firmware, or empty
  QString turned_by =
      {};  ///< id of the device that turns the tool; empty: the device's own rotation, or none

  bool operator==(const DeviceWish&) const = default;
};

/// How the hand at the device moves the tool in the volume. Buttons count from 0, -1 is none.
struct Mapping {
  double position_scale = 1.0;  ///< m in the volume per m of the hand
  double force_scale = 1.0;     ///< N at the hand per N in the volume
  bool follow_camera = true;    ///< right, up and near of the hand follow the picture
  int clutch_button = -1;       ///< while this button is down the tool stays
  bool hold_to_run = false;     ///< force only while hold_button or the key H is down
  int hold_button = -1;
  int cut_button = -1;  ///< while this button is down the burr turns

  bool operator==(const Mapping&) const = default;
};

/// The connected haptic device, the mapping of its motion to the volume, and the gate between the
/// computed force and its motors.
class HapticDevicePanel : public QWidget {
  Q_OBJECT
 public:
  explicit HapticDevicePanel(QWidget* parent = nullptr);

  /// Shows all devices in this order, present ones first. The selection is kept. Devices of the
  /// same name also show their place, which is the part of the id after the colon.
  void show(const QList<DeviceLine>& devices);
  using QWidget::show;
  /// A device is being connected, is connected, or no longer is. `why` is a sentence, or empty.
  void showConnecting(const QString& name);
  void showConnected(const QString& id);
  void showDisconnected(const QString& why);
  /// The device could not be connected. If it lacks its maker's firmware, which only opening shows,
  /// the panel says so until the device is tried again or removed.
  void showRefused(const QString& id, haptics::Trouble trouble, const QString& why);
  void show(const Mapping& mapping);
  /// The settings, and the settings in force under the allowed stiffness of the connected device.
  void showStiffness(const haptics::Settings& wished,
                     const std::optional<haptics::Settings>& in_force);
  /// The state of the force, at display rate. Shown only for a connected device.
  void display(const haptics::Snapshot& snapshot);

 signals:
  /// The panel became visible or hidden.
  void seen(bool visible);
  void surveyWanted();
  void connectWanted(const ui::DeviceWish& wish);
  /// Also cancels a connection under way.
  void disconnectWanted();
  void mappingChanged(const ui::Mapping& mapping);
  /// Allows the device the whole stiffness of its rating, although it may shake. Each connection
  /// begins with false.
  void stiffnessLifted(bool lifted);
  void armWanted();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  enum class Link { None, Connecting, Connected };

  QWidget* buildList();
  QWidget* buildForce();
  QWidget* buildMapping();
  const DeviceLine* selected() const;
  void showSelected();
  void listTurners(const DeviceLine* device);
  void chooseFirmware();
  void connectSelected();
  void showSetUp();
  void changeMapping();
  void showMappingWords();

  QTreeWidget* list_;
  QLabel* why_;
  QWidget* firmware_row_;
  QLineEdit* firmware_;
  QWidget* turned_row_;
  QComboBox* turned_by_;
  QPushButton* connect_;
  QPushButton* set_up_;
  QLabel* link_words_;
  QPushButton* arm_;
  StateChip* state_;
  QLabel* reason_;
  QLabel* share_;
  NumberBox* position_scale_;
  QLabel* position_words_;
  NumberBox* force_scale_;
  QCheckBox* follow_camera_;
  QComboBox* clutch_button_;
  QCheckBox* hold_to_run_;
  QComboBox* hold_button_;
  QComboBox* cut_button_;
  QLabel* stiffness_;
  QLabel* capped_;
  QCheckBox* lift_;
  QLabel* lifted_words_;
  QList<DeviceLine> surveyed_;  ///< as passed to show()
  QList<DeviceLine> devices_;   ///< in the order of the list
  Link link_ = Link::None;
  QString connected_;         ///< id
  bool motors_ = true;        ///< the connected device has motors
  bool lost_ = false;         ///< the connected device is lost
  QString without_firmware_;  ///< id of the device that was refused because it lacks firmware
  QString firmware_words_;    ///< the message of that refusal
  QTimer* patience_;          ///< time limit of a connection in progress
  Mapping mapping_;
};

}  // namespace ui
