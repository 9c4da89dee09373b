// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <memory>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "app/window/views/fine_mesher.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace app {

/// Shows the unedited scan beside what is left of it, as long as the user wants it and until
/// another scan comes. Its picture is made in the background, and goes with the view; its voxels
/// are those of the scan. GUI thread.
class BeforeController : public QObject {
  Q_OBJECT
 public:
  BeforeController(ui::Views& views, ui::Messages& messages, SharedState& shared);

  /// Call it when another scene is on view.
  void showScene();

 private:
  void want(bool on);
  void show(const ui::Picture& picture);

  ui::Views& views_;
  ui::Messages& messages_;
  SharedState& shared_;
  std::shared_ptr<const haptics::Volume> scan_;  ///< that is shown, or will be; null: none
  background::Task<ui::Picture> painter_;
  FineMesher mesher_;
};

}  // namespace app
