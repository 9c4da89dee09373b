// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>

#include "app/window/loader.h"
#include "app/window/shared_state.h"
#include "ui/main_window.h"

namespace app {

/// Lets the user choose the tool that touches, and the field that is touched.
class ToolController : public QObject {
  Q_OBJECT
 public:
  ToolController(ui::MainWindow& window, SharedState& shared);

  /// Tool and field of what is shown.
  void show();

 signals:
  /// The volume on view is to be touched with these. `what`: the words beside the progress.
  void wanted(const app::LoadRequest& request, const QString& what);

 private:
  void changeTool(const ToolSource& tool);
  void changeField(const QString& id);
  void showField();
  /// Of the volume on view, with this tool.
  LoadRequest requestWith(const ToolSource& tool) const;

  ui::MainWindow& window_;
  SharedState& shared_;
  QTimer rest_;  ///< since the isovalue last moved
};

}  // namespace app
