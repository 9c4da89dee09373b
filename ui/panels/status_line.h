// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <vector>

#include "haptics/snapshot.h"
#include "ui/controls/spoken.h"
#include "ui/panels/nearness_lines.h"
#include "ui/props/volume_prop.h"

namespace ui {

/// One line on the state of the touch and the picture. The servo loop's figures are updated only if
/// they differ noticeably, first after 5 s and then ever more rarely, down to once in 40 s: each
/// update paints the whole window where there is no GPU. A screen reader reads it when it is asked
/// to; no change is told, since the force's card tells what matters.
class StatusLine : public QLabel, public Spoken {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);
  void display(const haptics::Snapshot& snapshot);
  /// The tool is near these structures; none: none is watched. The nearest is told.
  void showNear(const std::vector<StructureNear>& near, const NearLimits& limits);
  void setHand(const QString& hand);
  void setSurface(const SurfaceChoice& choice);

  QAccessible::Role spokenRole() const override { return QAccessible::StatusBar; }
  QString spokenName() const override { return text(); }

 protected:
  /// Where it is cut, it says so.
  void paintEvent(QPaintEvent* event) override;

 private:
  void compose();
  void displayLoop(const haptics::Snapshot& snapshot);
  QString touch_, near_, loop_, hand_, surface_;
  haptics::Snapshot loop_shown_;
  QElapsedTimer since_loop_;
  int loop_ms_ = 0;  ///< until the next change of the servo loop's figures
};

/// The scan on view: its name, shortened in the middle where there is no room, and its size.
class ScanLine : public QLabel {
 public:
  explicit ScanLine(QWidget* parent = nullptr);

  void setScan(const QString& name, const QString& size);
  /// The words that are painted.
  QString seen() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString name_, size_;
};

}  // namespace ui
