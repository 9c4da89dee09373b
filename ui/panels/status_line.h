// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

#include "haptics/snapshot.h"
#include "ui/props/volume_prop.h"

namespace ui {

/// The one line that says how the touch and the picture are doing.
class StatusLine : public QLabel {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);
  void display(const haptics::Snapshot& snapshot);
  void setHand(const QString& hand);
  void setSurface(const SurfaceChoice& choice);

 private:
  void compose();
  QString servo_, hand_, surface_;
};

}  // namespace ui
