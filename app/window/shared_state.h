// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "app/window/loader.h"
#include "haptics/session.h"

namespace app {

/// What the window's controllers share: the touch, and what is touched. GUI thread.
struct SharedState {
  haptics::Session session;
  haptics::Settings settings;     ///< as the user set them; the session has them after apply()
  haptics::Snapshot snapshot;     ///< the newest of the session
  haptics::SceneOptions options;  ///< of the next scene
  std::optional<Loaded> shown;    ///< what is seen and touched; none before the first volume
  bool replaying = false;         ///< a recording is on view, and no hand is at work

  void apply() { session.set(settings); }
};

}  // namespace app
