// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <array>

class QComboBox;
class QLabel;
class QSlider;

namespace ui {

class NumberBox;
class ToolList;
class ToolTiles;

/// A choice: its name in the program, and its text for the user.
struct Choice {
  QString id;
  QString label;
};

/// Tool, stiffness, friction, hand and field.
class DevicePanel : public QWidget {
  Q_OBJECT
 public:
  explicit DevicePanel(QWidget* parent = nullptr);

  /// Shows the present tool, and all that can be chosen.
  ToolList& tools() { return *tools_; }
  ToolTiles& tiles() { return *tiles_; }
  /// Rarely used: how the surface is made from the voxels. For a section of its own.
  QWidget& details() { return *details_; }
  void setHands(const QList<Choice>& hands);
  void setFields(const QList<Choice>& fields);
  /// Shows the present choice. These functions emit no signal.
  void showHand(const QString& id, const QString& label);
  void showStiffness(double newton_per_metre);
  /// `effect`: a sentence on how the field changes the solid, or empty.
  void showField(const QString& id, const QString& effect);
  /// Asks for the unit of a tool's file; toolFileChosen() may follow. `numbers`: the sides of the
  /// tool's box, as the file has them.
  void askForUnit(const QString& path, const std::array<double, 3>& numbers);

 signals:
  void handChosen(const QString& id);
  void toolChosen(const QString& id);
  /// The user named a file; its size is needed for the question of its unit.
  void toolFileFound(const QString& path);
  /// `unit` is m, mm, cm or in.
  void toolFileChosen(const QString& path, const QString& unit);
  void stiffnessChanged(double newton_per_metre);
  /// Coulomb's coefficient.
  void frictionChanged(double coefficient);
  void fieldChosen(const QString& id);

 private:
  void chooseFile();
  QComboBox* hands_;
  ToolTiles* tiles_;
  ToolList* tools_;
  NumberBox* stiffness_typed_;
  QSlider* stiffness_;
  QComboBox* friction_;
  QWidget* details_;
  QComboBox* fields_;
  QLabel* effect_;
};

}  // namespace ui
