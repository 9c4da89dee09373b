// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QLabel>

#include "haptics/snapshot.h"
#include "ui/props/volume_prop.h"

namespace ui {

/// One line on the state of the touch and the picture. The servo loop's figures are updated at most
/// every five seconds, and only if they differ noticeably.
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
