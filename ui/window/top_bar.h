// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QToolButton>
#include <QWidget>
#include <array>
#include <optional>

class QAction;
class QHBoxLayout;
class QMenu;

namespace ui {

class StateChip;

/// Groups of symbols on the bar, from the left.
enum class BarGroup { File, Tools, Views };
inline constexpr std::size_t kBarGroups = 3;

/// The button that takes the force away: an outline with its key on it. While there is a force it
/// is filled under the pointer and with the focus.
class StopButton : public QToolButton {
  Q_OBJECT
 public:
  explicit StopButton(QWidget* parent = nullptr);
  void setForce(bool force);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool force_ = false;
};

/// The bar below the menus: symbols of what is done often, the state of the force and of a
/// recording, and at the right end, where nothing else is, the stop button.
class TopBar : public QWidget {
  Q_OBJECT
 public:
  explicit TopBar(QWidget* parent = nullptr);

  /// Shows an action as a symbol, behind those of its group.
  void add(BarGroup group, QAction& action, const char* icon);
  void add(BarGroup group, QMenu& menu, const char* icon, const QString& tip);
  StateChip& force() { return *force_; }
  StopButton& stop() { return *stop_; }
  /// The time that was recorded [s]; none: nothing is being recorded.
  void showRecording(std::optional<double> elapsed);

 signals:
  void stopWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QToolButton* addButton(BarGroup group, const char* icon);

  std::array<QHBoxLayout*, kBarGroups> groups_{};
  StateChip* force_;
  StateChip* recording_;
  StopButton* stop_;
};

}  // namespace ui
