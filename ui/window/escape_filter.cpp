// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/escape_filter.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace ui {

EscapeFilter::EscapeFilter(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool EscapeFilter::eventFilter(QObject* watched, QEvent* event) {
  // one press passes here several times, on its way through windows and widgets: saying it
  // again does no harm, missing it would
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride)
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) emit pressed();
  return QObject::eventFilter(watched, event);
}

}  // namespace ui
