// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/escape_filter.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QWindow>

namespace ui {

EscapeFilter::EscapeFilter(QWidget& main_window)
    : QObject(&main_window), main_window_(main_window) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool EscapeFilter::isSomethingOpen(const QObject& receiver) const {
  if (QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr)
    return true;
  // the receiver is a window of the system first, and then a widget within it
  if (const auto* widget = qobject_cast<const QWidget*>(&receiver);
      widget != nullptr && widget->window() != &main_window_)
    return true;
  if (receiver.isWindowType() && &receiver != main_window_.windowHandle()) return true;
  // what is typed in a list lies in the list's viewport
  const QWidget* field = QApplication::focusWidget();
  return qobject_cast<const QLineEdit*>(field) != nullptr && field->parentWidget() != nullptr &&
         qobject_cast<const QAbstractItemView*>(field->parentWidget()->parentWidget()) != nullptr;
}

bool EscapeFilter::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type != QEvent::KeyPress && type != QEvent::ShortcutOverride && type != QEvent::KeyRelease)
    return QObject::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (key.key() != Qt::Key_Escape) return QObject::eventFilter(watched, event);
  if (type == QEvent::KeyRelease) {
    is_down_ = false;
  } else {
    // What is open is looked at once: the first receiver may close it. The release of a key that
    // closes a window can be lost.
    if (!is_down_ || key.timestamp() != time_) {
      is_down_ = true;
      time_ = key.timestamp();
      closes_ = isSomethingOpen(*watched);
      for (const auto& [owner, end] : enders_)
        if (owner) closes_ = end() || closes_;
    }
    emit pressed(closes_);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace ui
