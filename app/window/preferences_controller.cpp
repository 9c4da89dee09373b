// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/preferences_controller.h"

namespace app {

PreferencesController::PreferencesController(ui::MainWindow& window, bool kept)
    : window_(window), preferences_(loadPreferences()), kept_(kept) {}

void PreferencesController::restoreWindow() {
  if (preferences_.geometry.isEmpty() || !kept_) return;
  window_.restoreGeometry(preferences_.geometry);
  window_.restoreState(preferences_.layout);
  window_.restoreViews(preferences_.views);
}

void PreferencesController::showNotice() {
  if (preferences_.notice_seen) return;
  window_.showNotice();
  preferences_.notice_seen = true;
  save();
}

void PreferencesController::save() {
  preferences_.geometry = window_.saveGeometry();
  preferences_.layout = window_.saveState();
  preferences_.views = window_.viewState();
  emit saving(preferences_);
  if (kept_) savePreferences(preferences_);
}

}  // namespace app
