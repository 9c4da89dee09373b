// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "app/window/scan/shared_state.h"
#include "ui/window/main_window.h"
#include "ui/window/messages.h"
#include "ui/window/screenshot.h"
#include "ui/window/views.h"

namespace app {

/// Brings the tool to a place that the user points at, and to the crosshair and back; saves and
/// copies pictures.
class ViewController : public QObject {
  Q_OBJECT
 public:
  ViewController(ui::MainWindow& window, SharedState& shared);

  /// Brings the tool to a place of the surface [m]. Without a normal (zero), to the surface nearest
  /// to the place.
  void bringTool(const haptics::Vec3& p_W, const haptics::Vec3& normal_W);
  void bringToCross();
  /// Brings the tool to a pose where it was, or, where the solid is there now, close to it.
  void bringBack(const haptics::Pose& X_WP);
  /// Takes the tool back along its axis until it is free, or to where it was at first.
  void liftTool();
  void moveCrossToTool();
  /// Asks what to take a picture of and where to, and writes it. `first`: the slice that is offered
  /// first; null: the 3-D view.
  void savePicture(const ui::SliceView* first);
  void copyPicture();

 signals:
  /// The tool is to be at this legal pose.
  void toolPlaced(const haptics::Pose& X_WT, const haptics::Pose& X_WH);
  /// The tool is to leave the surface for this legal pose.
  void toolLifted(const haptics::Pose& X_WT);

 private:
  /// Whether a tool can be brought anywhere now; if not, says why.
  bool mayBring();
  /// Whether the picture may leave the program: the user is asked if it may show a face.
  bool mayLeave(bool with_slices);

  ui::MainWindow& window_;
  ui::Views& views_;
  ui::Messages& messages_;
  SharedState& shared_;
};

}  // namespace app
