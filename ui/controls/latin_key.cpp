// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/latin_key.h"

#include <QChar>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenu>
#include <string_view>

QT_BEGIN_NAMESPACE
// QtGui exports it for the keys of QtTest: asks the widget whether it needs the key, and else the
// application's shortcuts; whether one of them took it
Q_GUI_EXPORT bool qt_sendShortcutOverrideEvent(QObject* widget, ulong timestamp, int key,
                                               Qt::KeyboardModifiers modifiers, const QString& text,
                                               bool repeats, ushort count);
QT_END_NAMESPACE

namespace ui {
namespace {

/// Keys that lie in a row, from a scan code on, without and with Shift.
struct Row {
  quint32 first;
  std::string_view plain, shifted;
};
// those of X, which are the kernel's and 8
constexpr Row kRows[] = {{10, "1234567890-=", "!@#$%^&*()_+"},
                         {24, "QWERTYUIOP[]", "QWERTYUIOP{}"},
                         {38, "ASDFGHJKL;'`", "ASDFGHJKL:\"~"},
                         {51, "\\ZXCVBNM,./", "|ZXCVBNM<>?"}};

/// The key at a place of a US keyboard; 0: none that writes.
int keyOnUsKeyboard(quint32 scan_code, bool shift) {
  for (const Row& row : kRows)
    if (scan_code >= row.first && scan_code - row.first < row.plain.size())
      return (shift ? row.shifted : row.plain)[scan_code - row.first];
  return 0;
}

bool isOfAnotherScript(char32_t letter) {
  switch (QChar::script(letter)) {
    case QChar::Script_Latin:
    case QChar::Script_Common:
    case QChar::Script_Inherited:
    case QChar::Script_Unknown:
      return false;
    default:
      return true;
  }
}

/// Whether a widget would write the letter.
bool isTyped(QObject& widget, const QKeyEvent& key) {
  QKeyEvent asked(QEvent::ShortcutOverride, key.key(), key.modifiers(), key.text());
  QCoreApplication::sendEvent(&widget, &asked);
  return asked.isAccepted();
}

}  // namespace

int latinKey(const QKeyEvent& event) {
  constexpr int kAscii = 0x80, kNamed = 0x01000000;  // from here on keys have names, as Space
  const int key = event.key();
  if (key < kAscii || key >= kNamed || (event.modifiers() & Qt::GroupSwitchModifier)) return key;
  const auto letter = static_cast<char32_t>(key);
  if (QChar::isDigit(letter)) return Qt::Key_0 + QChar::digitValue(letter);
  if (!isOfAnotherScript(letter)) return key;
  const int latin = keyOnUsKeyboard(event.nativeScanCode(), event.modifiers() & Qt::ShiftModifier);
  return latin != 0 ? latin : key;
}

LatinShortcuts::LatinShortcuts(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool LatinShortcuts::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const int latin = latinKey(key);
  if (latin == key.key()) return false;
  const bool strong = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  if (!strong && isTyped(*watched, key)) return false;
  const QString text = strong ? QString() : QString(QChar(latin));
  if (qt_sendShortcutOverrideEvent(watched, key.timestamp(), latin, key.modifiers(), text,
                                   key.isAutoRepeat(), static_cast<ushort>(key.count()))) {
    event->accept();
    return true;
  }
  // what is copied with Ctrl, and the letters of a menu; a list is searched by what was typed
  if (!strong && qobject_cast<QMenu*>(watched) == nullptr) return false;
  QKeyEvent same(QEvent::KeyPress, latin, key.modifiers(), key.nativeScanCode(),
                 key.nativeVirtualKey(), key.nativeModifiers(), text, key.isAutoRepeat(),
                 static_cast<ushort>(key.count()));
  QCoreApplication::sendEvent(watched, &same);
  event->accept();
  return true;
}

}  // namespace ui
