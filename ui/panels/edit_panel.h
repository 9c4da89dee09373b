// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QWidget>
#include <array>
#include <optional>

#include "ui/props/slice.h"

class QButtonGroup;
class QComboBox;
class QFrame;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace ui {

class NumberBox;

/// The tools that take parts of a scan away. One at a time is on.
enum class EditTool { None, Crop, Plane, Pieces, Holder, Scalpel };

/// The crop along one axis of the grid, as numbers.
struct CropRange {
  QString axis = {};                           ///< "x" of LPS, or "i" of the grid
  double least = 0.0, most = 1.0, step = 1.0;  ///< mm
  double from = 0.0, to = 1.0;                 ///< mm
};

/// What the user may do with what is previewed.
enum class EditConfirm { Piece, Removal, Cut };

/// How many edits there are, and where undo and redo lead.
struct EditSteps {
  int in_force = 0;
  bool undo = false, redo = false;
};

/// The panel "Edit": chooses a tool, shows its numbers, previews and applies. It reaches everything
/// that the handles in the views do.
class EditPanel : public QWidget {
  Q_OBJECT
 public:
  explicit EditPanel(QWidget* parent = nullptr);

  /// Whether there is a volume that may be edited.
  void setReady(bool ready);
  EditTool tool() const { return tool_; }
  /// Switches a tool on, as the user would.
  void setTool(EditTool tool);

  /// The box. `axes_told`: what the numbers count.
  void show(const std::array<CropRange, 3>& ranges, const QString& axes_told);
  /// The clip plane: none before it is placed, then its numbers.
  struct PlaneNumbers {
    double position_mm = 0.0;  ///< of the plane along its normal, from the middle of the volume
    double towards_deg = 0.0;  ///< of the normal about the patient's axis: 0 to L, 90 to P
    double raised_deg = 0.0;   ///< of the normal towards S
  };
  void show(const std::optional<PlaneNumbers>& plane, std::size_t clicks);
  void showPreview(const QString& words, EditConfirm confirm);
  void hidePreview();
  void show(const EditSteps& steps);
  /// A sentence that stands until the wait is over or cancelled; empty: nothing waits.
  void showWait(const QString& sentence);
  QSize minimumSizeHint() const override;
  /// mm; none: through everything.
  std::optional<double> depth_mm() const;
  bool cutsInside() const;

 signals:
  void toolChosen(ui::EditTool tool);
  void cropNumberChanged(int axis, bool high, double mm);
  void cropToViewWanted();
  void cropResetWanted();
  void cropApplyWanted();
  void planeFromSliceWanted(ui::Plane plane);
  void planeAgainWanted();
  void planeFlipWanted();
  void planeNumbersChanged(double position_mm, double towards_deg, double raised_deg);
  void planeApplyWanted();
  /// Depth or side of the scalpel.
  void scalpelChanged();
  void smallWanted(double least_cm3);
  void holderWanted();
  void keepPieceWanted();
  void removePieceWanted();
  /// The piece is to be shown as one of these would leave it.
  void fateShown(bool keep);
  void removalWanted();
  void previewCancelled();
  void undoWanted();
  void redoWanted();
  void resetWanted();
  void waitCancelled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* cropPage();
  QWidget* planePage();
  QWidget* piecesPage();
  QWidget* holderPage();
  QWidget* scalpelPage();
  QFrame* previewBar();
  void showPage();
  void keepInSight(QWidget& what);
  void emitPlaneNumbers();

  EditTool tool_ = EditTool::None;
  QButtonGroup* tools_;
  QStackedWidget* pages_;
  QLabel* crop_axes_ = nullptr;
  std::array<std::array<QLabel*, 2>, 3> crop_names_{};
  std::array<std::array<NumberBox*, 2>, 3> crop_numbers_{};
  QLabel* plane_hint_ = nullptr;
  QWidget* plane_controls_ = nullptr;
  NumberBox *plane_position_ = nullptr, *plane_towards_ = nullptr, *plane_raised_ = nullptr;
  NumberBox* small_ = nullptr;
  NumberBox* depth_ = nullptr;
  QComboBox* side_ = nullptr;
  QFrame* preview_ = nullptr;
  QLabel* preview_words_ = nullptr;
  QPushButton *keep_ = nullptr, *remove_piece_ = nullptr, *remove_ = nullptr;
  QPushButton *undo_ = nullptr, *redo_ = nullptr, *reset_ = nullptr;
  QLabel* steps_ = nullptr;
  QFrame* wait_ = nullptr;
  QLabel* wait_words_ = nullptr;
};

}  // namespace ui
