// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "datasets/edits/walls.h"
#include "haptics/scene/watch.h"
#include "ui/window/messages.h"

namespace app {

/// Structures that are solid or not there, for the touch alone. The volume that is touched is made
/// again in the background when they, the scene or the isovalue change, and handed over as a new
/// scene; what is on view stays. Until then the touch has the scene before.
class WallsController : public QObject {
  Q_OBJECT
 public:
  WallsController(ui::Messages& messages, SharedState& shared);

  /// The structures that are watched, and how they are felt; null: none is.
  void setWatch(const std::shared_ptr<const haptics::Watch>& watch);
  /// Call it when another scene is on view, and when a replay ends.
  void showScene();
  /// Call it when another isovalue is touched.
  void showIsovalue();

 signals:
  /// The scene of the volume on view, with walls or again without. The receiver puts it into
  /// `shared.shown`.
  void made(const app::Loaded& loaded);

 private:
  bool isAsWanted() const;
  void make();
  void deliver(const std::shared_ptr<const haptics::Scene>& seen,
               haptics::Expected<std::shared_ptr<const haptics::Scene>> scene);

  ui::Messages& messages_;
  SharedState& shared_;
  std::vector<datasets::StructureWall> walls_;
  QTimer soon_;  ///< the isovalue is at rest
  background::Task<std::shared_ptr<const haptics::Scene>> maker_;
};

}  // namespace app
