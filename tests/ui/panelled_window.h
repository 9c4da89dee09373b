// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "app/window/device/device_controller.h"
#include "app/window/program/preferences_controller.h"
#include "app/window/touch/hand_controller.h"
#include "app/window/touch/isosurface_controller.h"
#include "app/window/touch/tool_controller.h"
#include "app/window/views/picture_controller.h"
#include "ui/window/main_window.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/start_page.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace window {

/// A window with the panels that are always to be seen, and no more of the application.
struct Panelled {
  ui::MainWindow window;
  app::SharedState shared;
  app::PreferencesController preferences{window, false};
  app::IsosurfaceController isosurface{window.views(), window.messages(), window.panels(), shared};
  app::HandController hand{window.views(), window.messages(), window.panels(), window.touch(),
                           shared,         "mouse",           1000.0};
  app::ToolController tool{hand.panel(), window.panels(), shared};
  app::PictureController picture{window.views(), window.touch(), shared};
  app::DeviceController device{window.views(),     window.messages(),
                               window.panels(),    window.touch(),
                               window.startPage(), shared,
                               preferences,        {}};

  /// Shows a volume, of which nothing is touched.
  void show(const ui::Picture& of, double isovalue, const QString& title) {
    window.show(of, isovalue, title);
    isosurface.show(of, isovalue);
  }
};

}  // namespace window
