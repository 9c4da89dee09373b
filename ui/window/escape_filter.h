// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

namespace ui {

/// Reacts to Escape in every window of the application, dialogs included, before any other
/// receiver, and passes it on.
class EscapeFilter : public QObject {
  Q_OBJECT
 public:
  explicit EscapeFilter(QObject* parent = nullptr);

 signals:
  void pressed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ui
