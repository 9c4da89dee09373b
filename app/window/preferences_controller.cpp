// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/preferences_controller.h"

namespace app {

PreferencesController::PreferencesController(ui::MainWindow& window, bool kept)
    : window_(window), preferences_(loadPreferences()), kept_(kept) {
  connect(&window, &ui::MainWindow::hintsChanged, this, &PreferencesController::save);
}

void PreferencesController::restoreWindow() {
  if (!kept_) return;
  window_.setHintsShown(preferences_.hints);
  if (preferences_.geometry.isEmpty()) return;
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
  preferences_.hints = window_.hintsShown();
  emit saving(preferences_);
  if (kept_) savePreferences(preferences_);
}

}  // namespace app
