// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "app/window/device_controller.h"
#include "app/window/hand_controller.h"
#include "app/window/isosurface_controller.h"
#include "app/window/picture_controller.h"
#include "app/window/preferences_controller.h"
#include "app/window/tool_controller.h"
#include "ui/main_window.h"

namespace window {

/// A window with the panels that are always to be seen, and no more of the application.
struct Panelled {
  ui::MainWindow window;
  app::SharedState shared;
  app::PreferencesController preferences{window, false};
  app::IsosurfaceController isosurface{window, shared};
  app::HandController hand{window, shared, "mouse", 1000.0};
  app::ToolController tool{hand.panel(), shared};
  app::PictureController picture{window, shared};
  app::DeviceController device{window, shared, preferences, {}};

  /// Shows a volume, of which nothing is touched.
  void show(const ui::Picture& of, double isovalue, const QString& title) {
    window.show(of, isovalue, title);
    isosurface.show(of, isovalue);
  }
};

}  // namespace window
