// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "app/window/scan/shared_state.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/views.h"

namespace app {

/// The isovalue: its panel, the surface in the views, and the surface that is touched.
class IsosurfaceController : public QObject {
  Q_OBJECT
 public:
  IsosurfaceController(ui::Views& views, ui::Messages& messages, ui::SidePanel& panels,
                       SharedState& shared);

  /// Call it when another scene is on view. `new_volume`: its volume and isovalue are new.
  void showScene(bool new_volume);
  /// Shows an isovalue of this volume in panel and views; the touch keeps its own.
  void show(const ui::Picture& picture, double isovalue);
  /// Shows an isovalue that the volume on view can have, and has it touched.
  void set(double isovalue);

 signals:
  /// Another isovalue is shown and touched.
  void changed(double isovalue);

 private:
  void apply(double isovalue);

  ui::Views& views_;
  SharedState& shared_;
  ui::IsosurfacePanel* panel_;
};

}  // namespace app
