// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <array>
#include <optional>

#include "ui/overlays/measure.h"

class QAction;
class QLabel;
class QPushButton;
class QTableWidget;

namespace ui {

/// A line of the list.
struct MarkRow {
  QString text;   ///< name, or the words of a note
  QString value;  ///< with unit and accuracy; empty for a note
};

/// The list of measures, marks and notes, the actions that place them, and the way of the tool.
class MarksPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MarksPanel(QWidget* parent = nullptr);

  /// Whether there is a scan to measure.
  void setReady(bool ready);
  /// Shows these lines in this order.
  void show(const QList<MarkRow>& rows);
  using QWidget::show;
  void setCanRestore(bool can);
  void select(int index);
  /// Lets the user type the text of this line.
  void edit(int index);
  /// -1: nothing is being placed; else a MeasureKind.
  void showPlacing(int kind);
  /// A sentence about the tool's way; none: it is not measured.
  void showTravel(const std::optional<QString>& words);

  /// Begins to place a measure, or ends it. It has a key, for the widgets to which it is added.
  QAction* placeAction(MeasureKind kind) { return actions_[static_cast<std::size_t>(kind)]; }

 signals:
  /// -1: nothing.
  void placingWanted(int kind);
  void selected(int index);
  void goToWanted(int index);
  void renamed(int index, const QString& text);
  void removeWanted(int index);
  void restoreWanted();
  /// The user starts, or starts again, to measure the tool's way; false: ends it.
  void travelWanted(bool measure);
  /// The field in which a text was typed is closed.
  void typed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* buildTools();
  QWidget* buildTravel();
  void buildList();
  int chosen() const;
  void showChosen();

  std::array<QAction*, kMeasureKinds.size()> actions_{};
  QTableWidget* list_;
  QPushButton* go_;
  QPushButton* rename_;
  QPushButton* remove_;
  QPushButton* restore_;
  QPushButton* travel_start_;
  QPushButton* travel_end_;
  QLabel* travel_;
};

}  // namespace ui
