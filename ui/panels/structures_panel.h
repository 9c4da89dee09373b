// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <utility>
#include <vector>

#include "ui/panels/nearness_lines.h"
#include "ui/props/structures.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace ui {

class ElidedLabel;
class NumberBox;

/// The structures of the scan on view: a list with search, how each is seen, and how all are drawn.
class StructuresPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StructuresPanel(QWidget* parent = nullptr);

  /// Whether there is a scan whose structures can be opened.
  void setReady(bool ready);
  /// Files of structures that were found with the scan; without any no button.
  void showFound(const QStringList& names);
  /// Shows these; without a map none.
  void show(const Structures& structures);
  using QWidget::show;
  void setLimits(const NearLimits& limits);
  /// Whether the system can play a sound.
  void setSoundPossible(bool possible);
  /// Shows the distances of the structures that are watched, by number; the others have none.
  void showNear(const std::vector<std::pair<int, StructureNear>>& near);

 signals:
  void openWanted();
  /// One of those that were found with the scan.
  void foundWanted(int number);
  void closeWanted();
  /// The user wants to see a structure, in 3-D and in the slices.
  void goToWanted(int number);
  void visibleChosen(int number, bool visible);
  void colourChosen(int number, const QColor& colour);
  void opacityChosen(int number, double opacity);
  /// Whether its distance is to be told while the tool moves.
  void watchChosen(int number, bool watched);
  /// How it is to be felt.
  void feelChosen(int number, const StructureFeel& feel);
  /// What it is to take to cut it.
  void cuttingChosen(int number, const StructureCutting& cutting);
  /// From which distances on a structure is near, and close.
  void limitsChosen(const NearLimits& limits);
  /// Whether a sound is to say it, too.
  void soundChosen(bool on);
  void renamed(int number, const QString& name);
  /// This structure alone is to be seen, or again what was seen before.
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
  QWidget* buildFeel();
  void buildCutting(QGridLayout& grid, int row);
  QWidget* buildAll();
  void search();
  int chosen() const;  ///< number; -1: none
  void showChosen();
  void showFeel(const StructureFeel& feel);
  StructureFeel feelNow() const;
  void showCutting(const StructureCutting& cutting);
  void askColour(int number);

  Structures shown_;
  QLineEdit* search_;
  QTableWidget* list_;
  QWidget* parts_;      ///< what is there with structures only
  ElidedLabel* title_;  ///< whose settings stand below
  QPushButton* go_;
  QPushButton* alone_;
  QPushButton* rename_;
  QPushButton* colour_;
  NumberBox* opacity_;
  QCheckBox* watch_;
  QComboBox *feel_, *cutting_;
  NumberBox* cut_energy_;
  /// A number of a way to feel, which has it or not.
  struct FeelNumber {
    StructureFeel::Kind kind;
    double StructureFeel::*value;
    QLabel* label;
    NumberBox* box;
  };
  std::vector<FeelNumber> feel_numbers_;
  NumberBox* near_mm_;
  NumberBox* close_mm_;
  QCheckBox* sound_;
  QCheckBox* through_;
  QCheckBox* filled_;
  QPushButton* open_;
  QPushButton* found_;
  QPushButton* close_;
};

}  // namespace ui
