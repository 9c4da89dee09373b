// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <string>

#include "app/background/task.h"
#include "app/window/scan/loader.h"
#include "app/window/scan/shared_state.h"
#include "ui/panels/device_panel.h"
#include "ui/window/side_panel.h"

namespace app {

/// Lets the user choose the tool and the kind of field, in the panel of the hand.
class ToolController : public QObject {
  Q_OBJECT
 public:
  ToolController(ui::DevicePanel& panel, ui::SidePanel& panels, SharedState& shared);

  /// Shows tool and field of the scene on view.
  void show();
  /// Prepares the scene on view with this tool.
  void changeTool(const ToolSource& tool);
  /// Shows what smoothing does at another isovalue, when that rests.
  void showFieldSoon() { rest_.start(); }

 signals:
  /// Asks to load the volume on view with another tool or field. `what`: the text beside the
  /// progress.
  void wanted(const app::LoadRequest& request, const QString& what);

 private:
  void changeField(const QString& id);
  /// Reads how large the tool of a file is, and asks for its unit.
  void askForUnit(const QString& path);
  void showField();
  /// A tool of the list: the one on view, which may be a file, or a named one.
  ToolSource toolNamed(const std::string& name) const;
  /// The user clicked on a tile: the tool in use stays as it is.
  void chooseTile(const std::string& name);
  /// A request for the volume on view with this tool.
  LoadRequest requestWith(const ToolSource& tool) const;

  ui::DevicePanel& panel_;
  SharedState& shared_;
  std::string coming_;  ///< tool that is being prepared; empty: none
  background::Task<std::array<double, 3>> sizer_;
  QTimer rest_;  ///< fires when the isovalue has rested
};

}  // namespace app
