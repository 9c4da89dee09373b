// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QWidget>
#include <optional>

#include "haptics/snapshot.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/nearness_lines.h"

class QLabel;
class QToolButton;

namespace ui {

/// The intensity that is touched.
struct TouchedValue {
  double value = 0.0;      ///< half a voxel behind the surface, in the volume's unit
  QString unit = {};       ///< empty: the volume has none
  QString structure = {};  ///< that is solid there; empty: none
};

/// The card in a corner of the 3-D view: the force on the hand in large figures, the torque, a plot
/// of the last seconds, what is touched, how near structures are, and with what. A button folds it
/// to one line. It is dark in every theme, as the view is. Screen readers are told where a force or
/// a touch begins and ends, and what differs by kSaid, once a second at most.
class ForcePanel : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kSaid = 0.5;  ///< N

  explicit ForcePanel(QWidget* parent = nullptr);
  /// `touched`: none where nothing is touched, or its value is not known.
  void display(const haptics::Snapshot& snapshot, const std::optional<TouchedValue>& touched = {});
  /// How near the tool is to the structures that are watched; none: no line.
  void showNear(const std::vector<StructureNear>& near, const NearLimits& limits);
  /// Device and the rate of its loop, in the words of the bar at the top.
  void setHand(const QString& label);
  void clear() { plot_->clear(); }
  void append(std::span<const haptics::ForceSample> points) { plot_->append(points); }
  /// The force alone, where the view is small.
  void setCompact(bool compact);
  /// px, of the card as it is, and if it were folded or not.
  int heightIf(bool folded) const;
  /// To one line where there is no room for more, whatever the user wishes.
  void setFolded(bool folded);

 signals:
  /// The user folded the card, or unfolded it.
  void foldWanted(bool folded);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void showParts();
  void sayForce(const haptics::Snapshot& snapshot);
  void sayTouch(const haptics::Snapshot& snapshot);

  QLabel* force_;
  QLabel* torque_;
  QLabel* unit_;
  QLabel* touch_;
  QLabel* with_;  ///< device and rate
  QLabel* line_;  ///< all of it in a line
  QToolButton* fold_;
  ForcePlot* plot_;
  NearnessLines* near_;
  bool watches_ = false;  ///< there are lines of structures
  bool compact_ = false, folded_ = false;
  double said_ = 0.0;       ///< N, as screen readers were told last
  double said_time_ = 0.0;  ///< s of the loop
  int said_touch_ = 0;      ///< 0: nothing is touched, 1: something, -1: the force is withheld
  double touch_time_ = 0.0;
};

}  // namespace ui
