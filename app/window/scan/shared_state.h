// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "app/window/scan/loader.h"
#include "app/window/scan/volume_identity.h"
#include "haptics/session.h"

namespace app {

/// State that the window's controllers share: session, settings and volume. GUI thread.
struct SharedState {
  haptics::Session session;
  haptics::Settings settings;     ///< settings of the user; apply() passes them to the session
  haptics::Snapshot snapshot;     ///< newest snapshot of the session
  haptics::SceneOptions options;  ///< options of the next scene
  std::optional<Loaded> shown;    ///< volume and scene on view; none before the first volume
  bool replaying = false;         ///< a recording is on view, and no hand is open
  bool replays_other = false;     ///< one of another scan than the one on view
  VolumeIdentity identity;        ///< the hashes of volumes

  void apply() { session.set(settings); }
};

}  // namespace app
