// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <utility>
#include <vector>

class QWidget;

namespace ui {

/// Escape in every window of the application, dialogs included, before any other receiver. It is
/// passed on, so that what is open closes by itself. GUI thread.
class EscapeFilter : public QObject {
  Q_OBJECT
 public:
  explicit EscapeFilter(QWidget& main_window);

  /// Ends what the user is busy with; returns whether there was something.
  using Ender = std::function<bool()>;
  /// Called at each press of Escape while `owner` lives.
  void addEnder(QObject& owner, Ender end) { enders_.push_back({&owner, std::move(end)}); }

 signals:
  /// Escape is pressed. `closes`: it closes something that is open, or ends something. One press is
  /// told several times, on its way through windows and widgets, with the same `closes`.
  void pressed(bool closes);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Whether a menu, a list, a dialog or a field within a list is open, or the key is pressed in
  /// another window.
  bool isSomethingOpen(const QObject& receiver) const;

  QWidget& main_window_;
  std::vector<std::pair<QPointer<QObject>, Ender>> enders_;
  bool is_down_ = false;
  bool closes_ = false;          ///< of the present press
  unsigned long long time_ = 0;  ///< of it, as the system has it
};

}  // namespace ui
