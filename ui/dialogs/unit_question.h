// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QPainterPath>
#include <QString>
#include <array>
#include <optional>

class QButtonGroup;

namespace ui {

/// A unit that the numbers of a mesh file may have.
struct FileUnit {
  const char* name;  ///< as the readers know it
  double metres;     ///< of one
};
inline constexpr std::array<FileUnit, 4> kFileUnits{
    {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 25.4e-3}}};

/// The outline of an open hand of 180 mm from wrist to fingertip, in mm: the wrist's middle at the
/// origin, the fingers along -y.
QPainterPath handOutline();
inline constexpr double kHandLength = 180.0;  // mm

/// The unit in which a tool of this size would be a hand tool: the first of mm, m, cm and in by
/// which its longest side is 10 to 500 mm; else mm. `numbers`: its sides as the file has them.
QString likelyUnit(const std::array<double, 3>& numbers);

/// Asks for the unit of a tool's file. Each unit has a picture of the tool's box beside a hand, to
/// scale, and the size that results.
class UnitDialog : public QDialog {
  Q_OBJECT
 public:
  UnitDialog(const QString& file, const std::array<double, 3>& numbers, QWidget* parent = nullptr);

  /// Name of the chosen unit.
  QString unit() const;

 private:
  QButtonGroup* choices_;
};

/// The unit; nothing if the user cancels.
std::optional<QString> askForUnit(QWidget* parent, const QString& file,
                                  const std::array<double, 3>& numbers);

}  // namespace ui
