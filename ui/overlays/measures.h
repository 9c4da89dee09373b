// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFontMetricsF>
#include <QPolygonF>
#include <QString>
#include <QStringList>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "ui/overlays/measure.h"
#include "ui/overlays/measure_words.h"
#include "ui/overlays/overlay.h"

namespace ui {

/// The way of the tool since a moment, mm of W.
struct Travel {
  Eigen::Vector3d from_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_mm = Eigen::Vector3d::Zero();
  double length_mm = 0.0;  ///< along the way
};

/// A text beside a measure, in widget coordinates.
struct MeasureLabel {
  QString text;
  QRectF box;
  QPointF anchor;  ///< what it belongs to
};

/// The measures, marks and notes of a scan: it owns them, draws them over the views, and lets the
/// user place them and drag their handles. In a slice a handle moves in the plane that is parallel
/// to the picture, in 3-D along the touched surface. GUI thread.
///
/// In a slice a handle is solid within half a voxel of the plane and hollow up to kFaint_mm from
/// it, and not drawn beyond; in 3-D it is hollow behind the surface.
class Measures : public Overlay {
  Q_OBJECT
 public:
  static constexpr double kFaint_mm = 5.0;
  static constexpr int kMost = 10'000;  ///< measures of a scan

  explicit Measures(QObject* parent = nullptr);

  /// What is measured from now on. The measures stay; see replace().
  void setScan(const MeasuredScan& scan);
  const MeasuredScan& scan() const { return scan_; }
  /// The surface that the 3-D view shows is another: what lies behind it is sought again.
  void surfaceChanged();
  const std::vector<Measure>& all() const { return all_; }
  /// Shows these measures in place of the present ones, which restore() brings back.
  void replace(std::vector<Measure> measures);
  /// Forgets all measures and what could be brought back: for another scan.
  void clear();
  /// Text of at most kLongestMeasureText characters, made one line; an empty one changes nothing.
  void rename(int index, const QString& text);
  void remove(int index);
  /// Brings back what was removed last, where it was.
  void restore();
  bool canRestore() const { return !removed_.empty(); }
  /// Draws this one as chosen; -1: none.
  void select(int index);
  int selected() const { return selected_; }
  /// What a press on a view places next; none: nothing. It ends with the measure that is placed.
  void setPlacing(std::optional<MeasureKind> kind);
  std::optional<MeasureKind> placing() const { return placing_; }
  /// The way of the tool, drawn from its start to the tool; none: not drawn.
  void setTravel(const std::optional<Travel>& travel);

  void paint(QPainter& painter, const ViewGeometry& view) const override;
  /// What is written beside the measures of a view. Each has a line to its measure.
  std::vector<MeasureLabel> labelsIn(const ViewGeometry& view) const;
  QPolygonF markHandlesIn(const ViewGeometry& view) const override;
  bool press(const ViewGeometry& view, const QMouseEvent& event) override;
  bool drag(const ViewGeometry& view, const QMouseEvent& event) override;
  bool release(const ViewGeometry& view, const QMouseEvent& event) override;
  bool hover(const ViewGeometry& view, const QMouseEvent& event) override;
  bool key(const ViewGeometry& view, const QKeyEvent& event) override;
  Action keyForClick() const override { return Action::SetPlace; }
  Qt::CursorShape cursor() const override;
  QString hint() const override;
  QString note() const override;

 signals:
  /// A measure was added, removed, renamed or moved, or reads otherwise.
  void listChanged();
  void selectionChanged(int index);
  /// -1: nothing is placed; else a MeasureKind.
  void placingChanged(int kind);
  /// The user placed a whole measure.
  void placed(int index);

 private:
  /// A handle as it is drawn in a view.
  struct Handle {
    QPointF at;
    bool shown = false;   ///< in reach of the slice, and in front of the eye
    bool hollow = false;  ///< beside the slice, or behind the surface
  };
  /// A measure as it is drawn in a view.
  struct Drawn {
    std::vector<Handle> handles = {};
    QPolygonF line = {};
    bool any = false, dashed = false;
  };
  struct Removed {
    std::vector<std::pair<int, Measure>> measures;  ///< with their places in the list
  };

  Handle handleOf(const ViewGeometry& view, const Eigen::Vector3d& p_mm) const;
  bool isBehindSurface(const ViewGeometry& view, const Eigen::Vector3d& p_mm, QPointF at) const;
  /// The handle under the mouse: index of the measure and of its place.
  std::optional<std::pair<int, int>> handleAt(const ViewGeometry& view, QPointF at) const;
  Eigen::Vector3d inScan(const Eigen::Vector3d& p_mm) const;
  Drawn drawnOf(const ViewGeometry& view, const Measure& measure) const;
  void paintMeasure(QPainter& painter, const ViewGeometry& view, const Measure& measure,
                    bool chosen, bool whole) const;
  void finish();
  /// What is written beside a measure: in one line, and in more.
  QStringList labelsOf(const Measure& measure, const QFontMetricsF& metrics, double widest) const;
  QString freeName(MeasureKind kind) const;

  MeasuredScan scan_;
  std::vector<Measure> all_;
  std::vector<Removed> removed_;  ///< the last is brought back first
  int selected_ = -1;
  std::optional<MeasureKind> placing_;
  Measure begun_;                               ///< what is placed so far
  std::optional<Eigen::Vector3d> next_mm_;      ///< where its next place would be
  std::optional<std::pair<int, int>> dragged_;  ///< measure and place
  QPointF grab_;                                ///< from the mouse to the handle that is dragged
  QPointF pressed_;
  bool over_ = false;  ///< the mouse is over a handle
  std::optional<Travel> travel_;
  /// Where the line of sight to a handle meets the surface, for the last picture of the 3-D view:
  /// so that a repaint costs nothing while the eye stays.
  struct Sight {
    Eigen::Vector3d from, along, p;
    bool behind;
  };
  mutable std::vector<Sight> sights_;
};

}  // namespace ui
