// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QStyledItemDelegate>

namespace ui {

/// Draws a recording in the list: the first line of its words as they are, those below it dim, and
/// in the column of forces a small curve under its greatest force.
class RecordingLines : public QStyledItemDelegate {
  Q_OBJECT
 public:
  /// Of a cell with a curve: its greatest forces [N] as a QList<float>. What is not a number is a
  /// gap.
  static constexpr int kCurve = Qt::UserRole + 1;
  static constexpr int kCurveWidth = 72;  // px
  static constexpr int kLines = 3;        ///< of words

  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
};

/// The greatest of these forces [N]; 0 if there is none.
float greatestOf(const QList<float>& forces);

}  // namespace ui
