// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMainWindow>
#include <functional>
#include <vector>

#include "ui/props/picture.h"
#include "ui/views/grey_presets.h"
#include "ui/window/side_panel.h"

class QLabel;
class QSplitter;
class QToolButton;

namespace ui {

class Banner;
class DropArea;
class EscapeFilter;
class Loading;
class Menus;
class Messages;
class ReplayBar;
class StartPage;
class ScanLine;
class StatusLine;
class TopBar;
class TouchState;
class Tour;
class Views;

/// How the window is laid out, for the preferences.
struct WindowLayout {
  QString views = {};    ///< arrangement of the views, as Views::state() has it
  QString borders = {};  ///< and where their borders are
  PanelState panels = {};
  int panel_width = 0;  ///< px; 0: the first start's
  bool details = false;
  bool operator==(const WindowLayout&) const = default;
};

/// Makes the parts of the window and places them. Each part shows what it is given and emits what
/// the user wishes; controllers take the parts that they use. GUI thread.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);

  Views& views() { return *views_; }
  Messages& messages() { return *messages_; }
  Loading& loading() { return *loading_; }
  Menus& menus() { return *menus_; }
  SidePanel& panels() { return *panels_; }
  TouchState& touch() { return *touch_; }
  /// Escape in every window.
  EscapeFilter& escape() { return *escape_; }
  /// The bar below the menus, for the symbols of what controllers do.
  TopBar& bar() { return *bar_; }
  /// Below the views; hidden until it is given a recording.
  ReplayBar& replayBar() { return *replay_; }
  /// Covers the views until the first volume is shown.
  StartPage& startPage() { return *start_; }

  /// Shows another volume instead of the present one. `stated`: the grey windows that its file
  /// states.
  void show(const Picture& picture, double isovalue, const QString& title,
            const std::vector<GreyPreset>& stated = {});
  using QMainWindow::show;
  /// Whether something was taken away from the volume: the title says so, and it may be saved.
  void setEdited(bool edited);
  /// Views, borders, panels and details; empty parts stay as they are.
  WindowLayout layoutState() const;
  void restoreLayout(const WindowLayout& layout);
  /// As at the first start.
  void resetLayout();
  /// Lays a sentence over the 3-D view, so that no view moves, below those that were added before.
  void addOverView(Banner& banner);
  /// Explains the first steps, in bubbles beside the controls.
  void showTour();
  /// Asked before the user closes the window; false keeps it open. Without one it closes.
  void setCloseGuard(std::function<bool()> guard) { close_guard_ = std::move(guard); }

 signals:
  /// Files and folders were dropped on the window: one or more.
  void dropped(const QStringList& paths);
  /// The user changed tabs, panels, details or the layout of the views.
  void layoutChanged();
  /// The first steps were explained, or skipped.
  void tourEnded();
  /// The window is about to close, also where nobody was asked.
  void closing();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  /// Tab goes through bar, tabs, panels, views and status bar as they are laid out.
  bool focusNextPrevChild(bool next) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildViews();
  void buildStartPage();
  void buildStatusBar();
  void showTitle();
  void placeOverView();

  Views* views_;
  StartPage* start_;
  ReplayBar* replay_;
  TopBar* bar_;
  Messages* messages_;
  Loading* loading_;
  StatusLine* status_;
  Banner* stopped_;
  std::vector<Banner*> over_view_;
  QWidget* above_;  ///< the room above the views that one of these needs
  TouchState* touch_;
  EscapeFilter* escape_;
  Menus* menus_;
  SidePanel* panels_;
  QSplitter* splitter_;
  ScanLine* scan_line_;
  QLabel* graphics_;
  QToolButton* details_;
  Tour* tour_;
  DropArea* drop_;
  std::function<bool()> close_guard_;
  QString title_;  ///< of the volume; empty: none
  bool edited_ = false;
};

}  // namespace ui
