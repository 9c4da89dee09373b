// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QLabel>

#include "haptics/snapshot.h"
#include "ui/props/volume_prop.h"

namespace ui {

/// The one line that says how the touch and the picture are doing. What the servo loop's figures
/// jitter by is no news: they change where they differ noticeably, every five seconds at most.
class StatusLine : public QLabel {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);
  void display(const haptics::Snapshot& snapshot);
  void setHand(const QString& hand);
  void setSurface(const SurfaceChoice& choice);

 private:
  void compose();
  void displayLoop(const haptics::Snapshot& snapshot);
  QString touch_, loop_, hand_, surface_;
  haptics::Snapshot loop_shown_;
  QElapsedTimer since_loop_;
};

}  // namespace ui
