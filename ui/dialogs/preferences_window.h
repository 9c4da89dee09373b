// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <array>
#include <optional>

#include "ui/controls/lengths.h"
#include "ui/controls/mouse_choices.h"
#include "ui/style/look.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace ui {

class NumberBox;
class WarningLabel;

/// The servo loop's rates that can be chosen [Hz].
inline constexpr std::array kServoRateChoices{1000, 2000, 4000};

/// What the user can choose in the preferences, apart from keys.
struct PreferenceChoices {
  style::Theme theme = style::Theme::Dark;
  QString language = {};  ///< a code of kLanguages; empty: the system's
  bool hints = true;
  LengthUnit lengths = LengthUnit::Millimetres;
  MouseChoices mouse = {};
  /// N/m with which each start begins; none: the last that was set.
  std::optional<double> stiffness = {};
  /// Hz of the servo loop; none: as the device's link carries.
  std::optional<int> servo_rate = {};
  QString recordings = {};  ///< folder of recordings; empty: the user's own
  bool places_remembered = true;
  bool operator==(const PreferenceChoices&) const = default;
};

/// The preferences: pages of choices, and the list of all shortcuts. It is given values and emits
/// what the user chose, at once. It is not modal, so that the touch goes on beside it.
class PreferencesWindow : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesWindow(QWidget* parent = nullptr);

  /// Shows these; emits nothing. `own_folder`: where recordings are without a choice.
  void show(const PreferenceChoices& choices, const QString& own_folder);
  using QDialog::show;
  /// Says why a folder was not taken; empty: nothing.
  void showRefusal(const QString& sentence);
  /// How many recent places are remembered.
  void showPlaces(int count);

 signals:
  void changed(const ui::PreferenceChoices& choices);
  void keysChanged();
  void forgetPlacesWanted();

 private:
  QWidget* addPage(const QString& title);
  void buildGeneral();
  void buildMouse();
  void buildTouch();
  void buildRecordings();
  void buildPrivacy();
  void buildShortcuts();
  void chooseFolder();
  void showFolder();
  /// Shows what choices_ has.
  void showChoices();
  void tell();

  PreferenceChoices choices_;
  QString own_folder_;
  QListWidget* titles_;
  QStackedWidget* pages_;
  QComboBox* theme_;
  QComboBox* language_;
  QComboBox* lengths_;
  QCheckBox* hints_;
  QComboBox* servo_rate_;
  QComboBox* mouse_at_first_;
  QComboBox* slice_wheel_;
  QComboBox* zoom_wheel_;
  QCheckBox* stiffness_always_;
  NumberBox* stiffness_;
  QLabel* folder_;
  QPushButton* own_folder_button_;
  WarningLabel* refusal_;
  QCheckBox* places_;
  QLabel* places_said_;
};

}  // namespace ui
