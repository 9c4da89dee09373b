// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <optional>

namespace ui {

class NumberBox;

/// The second surface, which is seen and not felt: its isovalue, and its opacity beside it. Hidden
/// while there is none.
class SecondSurface : public QWidget {
  Q_OBJECT
 public:
  explicit SecondSurface(QWidget* parent = nullptr);

  /// Takes range, steps and unit of this field for isovalues.
  void setLike(const NumberBox& isovalues);
  /// Emits nothing.
  void show(std::optional<double> isovalue, double opacity);
  using QWidget::show;

 signals:
  void isovalueWanted(double isovalue);
  void opacityWanted(double opacity);

 private:
  NumberBox* isovalue_;
  NumberBox* opacity_;
};

}  // namespace ui
