// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

#include "ui/panels/nearness_lines.h"
#include "ui/props/structures.h"

class QCheckBox;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QToolButton;

namespace ui {

class NumberBox;

/// The structures of the scan on view: a list with search, how each is seen, and how all are drawn.
class StructuresPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StructuresPanel(QWidget* parent = nullptr);

  /// Whether there is a scan whose structures can be opened.
  void setReady(bool ready);
  /// Shows these; without a map none.
  void show(const Structures& structures);
  using QWidget::show;
  /// Shows the distances of the structures that are watched, by number; the others have none.
  void showNear(const std::vector<std::pair<int, StructureNear>>& near);

 signals:
  void openWanted();
  void closeWanted();
  /// The user wants to see a structure, in 3-D and in the slices.
  void goToWanted(int number);
  void visibleChosen(int number, bool visible);
  void colourChosen(int number, const QColor& colour);
  void opacityChosen(int number, double opacity);
  /// Whether its distance is to be told while the tool moves.
  void watchChosen(int number, bool watched);
  /// From which distances on a structure is near, and close.
  void limitsChosen(const NearLimits& limits);
  void renamed(int number, const QString& name);
  /// This structure alone is to be seen.
  void aloneWanted(int number);
  /// All of them, or none.
  void allWanted(bool visible);
  void throughChosen(bool on);
  void filledChosen(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildList();
  QWidget* buildChosen();
  QWidget* buildAll();
  void search();
  int chosen() const;  ///< number; -1: none
  void showChosen();
  void askColour(int number);

  Structures shown_;
  QLineEdit* search_;
  QTableWidget* list_;
  QWidget* parts_;  ///< what is there with structures only
  QPushButton* go_;
  QPushButton* alone_;
  QPushButton* rename_;
  QPushButton* colour_;
  NumberBox* opacity_;
  QCheckBox* watch_;
  NumberBox* near_mm_;
  NumberBox* close_mm_;
  QCheckBox* through_;
  QCheckBox* filled_;
  QPushButton* open_;
  QPushButton* close_;
};

}  // namespace ui
