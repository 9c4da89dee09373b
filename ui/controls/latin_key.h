// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QKeyEvent;

namespace ui {

/// The key of an event as a keyboard with Latin letters has it, so that keys have their meanings on
/// keyboards of every script. Of a letter of another script, the key at its place on a US keyboard;
/// of another script's digit, the digit. Everything else is its own key: Latin letters and signs
/// wherever they lie, Space and arrows, what AltGr writes, and a letter whose place the event does
/// not tell (a nativeScanCode() of 0).
int latinKey(const QKeyEvent& event);

/// Makes shortcuts and the letters of menus do with a keyboard of another script what they do with
/// a Latin one, in every window of the application. Qt does so only where the user has a Latin
/// layout beside. A letter that is typed into a field stays what it is.
class LatinShortcuts : public QObject {
  Q_OBJECT
 public:
  explicit LatinShortcuts(QObject* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ui
