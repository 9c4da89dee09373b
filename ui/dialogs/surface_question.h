// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

/// What is to be written of a surface.
struct SurfaceWish {
  std::size_t format = 0;  ///< index of the endings
  bool ras = false;        ///< axes of the file: right, anterior, superior; else left, posterior
  bool largest = false;    ///< only the largest connected piece
  bool removed = false;    ///< with the parts that the user removed
};

/// Asks for the options of an exported surface, and says how large it will be. It agrees only when
/// that is known.
class SurfaceDialog : public QDialog {
  Q_OBJECT
 public:
  /// `surface`: the surface in words; `endings`: of the formats, such as ".stl"; `edited`: whether
  /// parts were removed.
  SurfaceDialog(const QString& surface, const std::vector<QString>& endings, bool edited,
                QWidget* parent = nullptr);
  SurfaceWish wish() const;
  /// The size of the surface that was asked for last; `bytes` for each format.
  void showSize(std::int64_t triangles, std::vector<std::int64_t> bytes);
  /// There is no such surface, and why.
  void showProblem(const QString& sentence);

 signals:
  /// Another surface is asked for: its size must be found. Not for another format or other axes.
  void surfaceChanged();

 private:
  void change();
  void showFormat();

  QComboBox* formats_;
  QComboBox* frames_;
  QComboBox* pieces_;
  QCheckBox* removed_;
  QLabel* size_;
  QPushButton* export_ = nullptr;
  std::int64_t triangles_ = 0;
  std::vector<std::int64_t> bytes_;  ///< empty: not known yet
};

}  // namespace ui
