// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/preferences_controller.h"

#include "ui/style/style.h"

namespace app {

PreferencesController::PreferencesController(ui::MainWindow& window, bool kept)
    : window_(window), preferences_(loadPreferences()), kept_(kept) {
  using ui::MainWindow;
  for (const auto changed :
       {&MainWindow::hintsChanged, &MainWindow::themeChanged, &MainWindow::panelsChanged})
    connect(&window, changed, this, &PreferencesController::save);
}

void PreferencesController::restoreWindow() {
  if (!kept_) return;
  window_.setHintsShown(preferences_.hints);
  window_.setTheme(ui::style::themeOf(preferences_.theme));
  if (preferences_.geometry.isEmpty()) return;
  window_.restoreGeometry(preferences_.geometry);
  window_.restoreLayout(preferences_.layout);
}

void PreferencesController::showNotice() {
  window_.showNotice();
  preferences_.notice_seen = true;
  save();
}

void PreferencesController::save() {
  preferences_.geometry = window_.saveGeometry();
  preferences_.layout = window_.layoutState();
  preferences_.theme = ui::style::nameOf(ui::style::theme());
  preferences_.hints = window_.hintsShown();
  emit saving(preferences_);
  if (kept_) savePreferences(preferences_);
}

}  // namespace app
