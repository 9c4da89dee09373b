// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/help_controller.h"

#include <QApplication>

#include "app/window/scan/sentence.h"

namespace app {

QString helpPlaceOf(const QString& sentence) {
  const resources::Row* row = resources::rowIn(sentence.toStdString(), windowsLanguage());
  return row != nullptr ? ui::helpPlaceOf(row->reason) : QString{};
}

HelpController::HelpController(ui::Menus& menus, ui::Messages& messages) : messages_(messages) {
  messages.setExplainer(helpPlaceOf);
  connect(&messages, &ui::Messages::helpWanted, this, &HelpController::open);
  connect(&menus, &ui::Menus::helpWanted, this,
          [this] { open(ui::helpPageOf(QApplication::focusWidget())); });
}

void HelpController::open(const QString& place) {
  if (shown_ == nullptr) shown_ = new ui::HelpWindow(messages_.window());
  shown_->open(place);
}

}  // namespace app
