// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QGridLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace ui {

class NumberBox;

/// A tool that cuts: its name in the program, and its text for the user.
struct BurrChoice {
  QString id, label, tip;
};

/// From a value of the scan on, what a material takes.
struct BurrBand {
  double from = 0.0, energy_J_mm3 = 1.0;
};

/// How fast a burr turns, and what its material takes.
struct BurrNumbers {
  double speed_rpm = 60'000.0;
  double energy_J_mm3 = 1.0;
  bool vibrates = false;
  QList<BurrBand> bands = {};  ///< in any order
};

/// The volume that a burr has removed, by the strokes that are in force.
struct CutTold {
  QList<double> strokes_mm3 = {};  ///< oldest first
};

/// The panel "Cut": chooses a burr, says whether it turns, and what it has removed.
class CutPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CutPanel(QWidget* parent = nullptr);

  void setBurrs(const QList<BurrChoice>& burrs);
  /// The tool in use; one that is no burr leaves all buttons up.
  void showTool(const QString& id);
  BurrNumbers numbers() const;
  /// Whether the scan may be cut with it.
  enum class State {
    NoBurr,     ///< the tool has none
    Preparing,  ///< it can soon
    Solid,      ///< structures are solid for the touch: they would be cut
    Ready,
    Turning
  };
  /// `force`: N, on the turning burr.
  void showState(State state, double force = 0.0);
  void show(const CutTold& told);
  /// How many structures may not be cut, and how many take an energy of their own.
  void showTissues(int never, int own);
  /// The scan's values: where a band may begin. Their unit may be empty.
  void setValues(double least, double greatest, const QString& unit);
  using QWidget::show;
  void setSteps(bool undo, bool redo);
  bool tint() const;
  /// Whether the system can play the sound of the burr.
  void setSoundPossible(bool possible);
  /// Whether the unedited scan is shown beside what is left.
  void setBeforeAfter(bool on, bool possible);

 signals:
  void burrChosen(const QString& id);
  void numbersChanged();
  void undoWanted();
  void redoWanted();
  void tintChosen(bool on);
  /// Whether the burr is to be heard.
  void soundChosen(bool on);
  void beforeAfterChosen(bool on);

 private:
  /// A row of the table of materials.
  struct BandRow {
    QWidget* row;
    NumberBox *from, *energy;
  };
  QWidget* buildBands();
  void addBand();

  QButtonGroup* burrs_;
  QGridLayout* burr_rows_;
  QLabel *state_, *removed_, *tissues_;
  QListWidget* strokes_;
  NumberBox *speed_, *energy_;
  QVBoxLayout* band_rows_ = nullptr;
  QPushButton* add_band_;
  QList<BandRow> bands_;
  double least_ = 0.0, greatest_ = 0.0;  ///< values of the scan
  QString unit_;
  QPushButton *undo_, *redo_;
  QCheckBox *vibration_, *sound_, *tint_, *before_after_;
  State shown_ = State::Preparing;
  double shown_force_ = -1.0;
};

}  // namespace ui
