// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "ui/props/view_look.h"
#include "ui/window/view_frame.h"
#include "ui/window/view_gap.h"

namespace ui {

/// The views of the window, each in its frame: the 3-D view and the four slices. It shares the room
/// among them; the borders between them can be moved. One view can have it all for a while.
class ViewLayout : public QWidget {
  Q_OBJECT
 public:
  /// In this order: the 3-D view, axial, coronal, sagittal, oblique.
  using Frames = std::array<ViewFrame*, LayoutLook::kViews>;
  explicit ViewLayout(const Frames& frames, QWidget* parent = nullptr);

  void arrange(Arrangement arrangement);
  Arrangement arrangement() const { return arrangement_; }
  /// Gives the views the sizes again that the arrangement began with.
  void resetBorders();
  /// As at the first start: the 3-D view is large, and no border was moved.
  void reset();
  /// Whether each view has a line at its foot that says what the mouse does.
  void setHintsShown(bool shown);
  /// Whether the oblique slice has a place.
  void setObliqueShown(bool shown);
  /// Makes the view that was last used as large as all, or gives the others back.
  void toggleMaximised();
  bool maximised() const { return alone_; }
  /// Gives the focus to the next view that has a place; it is shown if one view is shown alone.
  void nextView();
  /// The view that had the focus last, counted as the frames.
  std::size_t active() const { return active_; }
  QSize minimumSizeHint() const override;
  /// Where the borders are that were moved, of every arrangement, in words for the preferences;
  /// empty: none was. Words that fit no arrangement are left out.
  QString borders() const;
  void restoreBorders(const QString& borders);
  /// The layout that is on view as numbers, and the same again. Shares for another arrangement are
  /// left out.
  LayoutLook look() const;
  void look(const LayoutLook& look);

  /// Names for the preferences: "one", "four_up", "volume_large", "slices_large".
  static QString nameOf(Arrangement arrangement);
  static std::optional<Arrangement> arrangementOf(const QString& name);

 signals:
  void arranged(ui::Arrangement arrangement);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Cell {
    std::size_t view = 0;
    double share = 1.0;  ///< of its column's height
  };
  struct Column {
    double share = 1.0;  ///< of the width
    std::vector<Cell> cells;
  };
  /// What a border comes after: a column, or a cell of a column.
  struct Border {
    std::size_t column = 0;
    std::optional<std::size_t> cell;
  };

  using Shares = std::vector<std::vector<double>>;
  /// An arrangement, and whether the oblique slice has a place in it.
  using Kind = std::pair<Arrangement, bool>;
  static Shares sharesOf(const std::vector<Column>& columns);
  /// Remembers these shares as moved borders.
  void keepShares(const Kind& kind, const Shares& shares);
  /// The columns with which it begins.
  std::vector<Column> firstColumns(const Kind& kind) const;
  void makeColumns();
  void makeBorders();
  void moveBorder(const Border& border, int px);
  void place();
  void setActive(std::size_t view);

  Frames frames_;
  Arrangement arrangement_ = Arrangement::VolumeLarge;
  Arrangement several_ = Arrangement::VolumeLarge;  ///< the last one that was not One
  bool oblique_ = false;
  bool alone_ = false;  ///< one view is maximised
  std::size_t active_ = 0;
  std::vector<Column> columns_;
  std::map<Kind, std::vector<Column>> moved_;  ///< whose borders are not where they began
  std::vector<Border> borders_;
  std::vector<ViewGap*> gaps_;  ///< one for each border, and hidden ones
};

}  // namespace ui
