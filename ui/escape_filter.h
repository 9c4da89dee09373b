// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

namespace ui {

/// Sees Escape in every window of the application, dialogs too, before anything else may swallow
/// it; and lets it pass on.
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
