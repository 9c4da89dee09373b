// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/background/task.h"
#include "app/window/shared_state.h"
#include "ui/main_window.h"

namespace app {

/// Keeps the picture up to date: the newest snapshot and forces at display rate, the isovalue, and
/// without a usable GPU the fine mesh of the surface.
class PictureController : public QObject {
  Q_OBJECT
 public:
  PictureController(ui::MainWindow& window, SharedState& shared);

  void start() { display_.start(); }
  void stop() { display_.stop(); }
  /// Whether the view turns to the tool at the next snapshot.
  void look(bool at_tool) { look_ = at_tool; }

 signals:
  /// A picture is about to be drawn; emitted sixty times a second.
  void refreshing();

 private:
  void refresh();
  void showForces();
  void makeFineMesh(double isovalue);

  ui::MainWindow& window_;
  SharedState& shared_;
  QTimer display_;
  std::vector<haptics::ForceSample> samples_;
  bool look_ = false;
  background::Task<vtkSmartPointer<vtkPolyData>> mesher_;
  std::optional<double> mesh_next_;  ///< isovalue of the next mesh, while another is being made
};

}  // namespace app
