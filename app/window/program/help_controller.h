// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include "ui/dialogs/help_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"

namespace app {

/// The place in the help of a sentence that the program shows: the entry of its reason; empty if it
/// is none of resources/messages, or has no reason.
QString helpPlaceOf(const QString& sentence);

/// Shows the help: the page of the part of the window that has the focus, or the entry of a
/// reason.
class HelpController : public QObject {
  Q_OBJECT
 public:
  explicit HelpController(ui::Menus& menus, ui::Messages& messages);

 private:
  void open(const QString& place);

  ui::Messages& messages_;
  ui::HelpWindow* shown_ = nullptr;  ///< the main window's; null before it is opened
};

}  // namespace app
