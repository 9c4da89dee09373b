// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <array>
#include <vector>

class QLabel;

namespace ui {

/// How near is near: distances [mm] from which on a structure is near, and close.
struct NearLimits {
  double near_mm = 5.0, close_mm = 2.0;

  bool operator==(const NearLimits&) const = default;
};
inline constexpr double kLeastNear_mm = 0.1, kMostNear_mm = 20.0;

/// How near the tool's nearest point is to a structure.
struct StructureNear {
  QString name;
  QColor colour;
  double distance_mm = 0.0;  ///< negative inside
  bool is_farther = false;   ///< than that: it is the greatest distance that is told
};

/// "3.2 mm", "over 20 mm", "inside".
QString distanceWords(const StructureNear& near);
/// "3.2 mm, near": what its colour says, too.
QString nearWords(const StructureNear& near, const NearLimits& limits);

/// The structures that the tool is nearest to, a line each, the nearest first: name, and distance
/// in large figures. Near, close and inside differ by colour, sign and word.
class NearnessLines : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kLines = 3;

  explicit NearnessLines(QWidget* parent = nullptr);
  /// None: no line.
  void show(std::vector<StructureNear> near, const NearLimits& limits);
  using QWidget::show;

 private:
  struct Line {
    QLabel* mark;  ///< the structure's colour
    QLabel* name;
    QLabel* sign;
    QLabel* distance;
  };
  std::array<Line, kLines> lines_;
};

}  // namespace ui
