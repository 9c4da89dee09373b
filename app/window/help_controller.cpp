// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/help_controller.h"

#include <QApplication>

#include "app/window/sentence.h"

namespace app {

QString helpPlaceOf(const QString& sentence) {
  const resources::Row* row = resources::rowIn(sentence.toStdString(), windowsLanguage());
  return row != nullptr ? ui::helpPlaceOf(row->reason) : QString{};
}

HelpController::HelpController(ui::MainWindow& window) : window_(window) {
  window.setExplainer(helpPlaceOf);
  connect(&window, &ui::MainWindow::helpWanted, this, [this](const QString& place) {
    open(place.isEmpty() ? ui::helpPageOf(QApplication::focusWidget()) : place);
  });
}

void HelpController::open(const QString& place) {
  if (shown_ == nullptr) shown_ = new ui::HelpWindow(&window_);
  shown_->open(place);
}

}  // namespace app
