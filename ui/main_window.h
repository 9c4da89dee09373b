// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <array>
#include <functional>
#include <optional>
#include <utility>

#include "haptics/core/triangle_mesh.h"
#include "haptics/snapshot.h"
#include "ui/panels/force_words.h"
#include "ui/props/volume_prop.h"
#include "ui/side_panel.h"
#include "ui/slice_set.h"
#include "ui/style/look.h"
#include "ui/top_bar.h"
#include "ui/view_layout.h"
#include "ui/view_look.h"

class QAction;
class QActionGroup;
class QFrame;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QSplitter;
class QToolButton;

namespace ui {

class Banner;
class ForcePanel;
class ReplayBar;
class StartPage;
class StatusLine;
class Tour;
class ViewActions;
class VolumeView;
struct Place;

/// How the window is laid out, for the preferences.
struct WindowLayout {
  QString views = {};    ///< arrangement of the views, as viewState() has it
  QString borders = {};  ///< and where their borders are
  PanelState panels = {};
  int panel_width = 0;  ///< px; 0: the first start's
  bool details = false;
  bool operator==(const WindowLayout&) const = default;
};

/// What becomes of what is in no file.
enum class Unsaved { Save, Discard, Cancel };

/// The window: views, menus, bar and sections. Its panels are made by others. It shows what it is
/// given and emits what the user asks for.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);

  /// Shows another volume instead of the present one. `stated`: the grey windows that its file
  /// states.
  void show(const Picture& picture, double isovalue, const QString& title,
            const std::vector<GreyPreset>& stated = {});
  void show(const haptics::TriangleMesh& tool);
  /// Shows other voxels of the same grid; camera, crosshair and grey window stay.
  void replace(const Picture& picture);
  /// Whether something was taken away from the volume: the title says so, and it may be saved.
  void setEdited(bool edited);
  /// The menu "Edit", for what its controller puts there.
  QMenu& editMenu() { return *edit_menu_; }
  /// Adds its entry for the preferences, below what is there by then.
  void offerPreferences();
  using QMainWindow::show;
  /// The isovalue of surface and contour, without asking for it to be touched.
  void setIsovalue(double isovalue);
  /// The surface that is touched, for all views; given with every scene.
  void setTouched(const TouchedSurface& touched);
  /// Draws this above all views, and asks it first for mouse and keys.
  void addOverlay(Overlay& overlay);
  /// Its key works while a view has the focus.
  void addViewAction(QAction& action);
  /// How the views look at the scan, and the same again.
  ViewLook look() const;
  void setLook(const ViewLook& look);
  /// The linked crosshair of the slices.
  const Eigen::Vector3d& cross_mm() const { return slice_set_->cross_mm(); }
  void setCross(const Eigen::Vector3d& cross_W_mm) { slice_set_->moveCross(cross_W_mm); }
  /// The state of the touch, at display rate. Pictures are updated at once, texts ten times a
  /// second (worded()).
  void display(const haptics::Snapshot& snapshot);
  /// Shows only the state of the force, because the poses belong to another volume.
  void displayForce(const haptics::Snapshot& snapshot);
  /// Each with what it is called in the menu.
  void setPhantoms(const QList<std::pair<QString, QString>>& names);
  /// Adds a panel as a section below those of its tab, with an entry in the View menu unless it is
  /// empty. `name` is the name of the section, under which the preferences know it.
  void addPanel(QWidget* panel, const QString& title, const QString& entry, const char* name,
                Tab tab, Fold fold = Fold::Open);
  /// Brings a panel into view: its tab in front, its section unfolded.
  void reveal(const QWidget* panel) { side_->reveal(panel); }
  /// Shows the force in the corner of the 3-D view.
  void setForceCard(ForcePanel& card);
  /// The bar below the menus, for the symbols of what controllers do.
  TopBar& bar() { return *bar_; }
  /// The places of File > Open recent and of the start page, newest first, and whether new ones are
  /// remembered.
  void setRecentPlaces(const QList<Place>& places, bool remembered);
  /// Whether there is a list of series to which the user can return.
  void setSeriesKnown(bool known);

  /// Shows a sentence until the user closes it, or until clearMessage().
  void showMessage(const QString& sentence);
  /// Hides what showMessage() or showDone() shows.
  void clearMessage();
  /// Shows in place of a message that something was written, with a button for its folder.
  void showDone(const QString& sentence, const QString& folder);
  /// Shows a sentence in a bar of its own, with a button that hides the bar and calls `take`.
  void showOffer(const QString& sentence, const QString& button, std::function<void()> take);
  /// Shows a sentence in a separate bar, which only the user closes.
  void showFault(const QString& sentence);
  /// Names the place in the help that explains a sentence; empty: none. Where it names one, the bar
  /// with the sentence has the button "More".
  using Explainer = std::function<QString(const QString& sentence)>;
  void setExplainer(Explainer explainer) { explainer_ = std::move(explainer); }
  void showLoading(const QString& what);
  void showProgress(double fraction);
  void endLoading();
  /// Asks whether to go on. Enter means Cancel. True if the user agrees.
  bool askWhether(const QString& what, const QString& consequence, const QString& yes);
  /// Asks what becomes of what is in no file. Enter means Cancel.
  Unsaved askToSave(const QString& what, const QString& consequence);
  /// Asked before the user closes the window; false keeps it open. Without one it closes.
  void setCloseGuard(std::function<bool()> guard) { close_guard_ = std::move(guard); }
  void showNotice();
  /// Explains the first steps, in bubbles beside the controls.
  void showTour();
  /// The hand that holds the tool, and what comes of the force.
  void setHand(const QString& label, Feel feel);
  /// The time that was recorded [s]; none: nothing is being recorded.
  void showRecording(std::optional<double> elapsed) { bar_->showRecording(elapsed); }

  VolumeView& view() { return *view_; }
  /// Below the views; hidden until it is given a recording.
  ReplayBar& replayBar() { return *replay_; }
  /// Covers the views until the first volume is shown.
  StartPage& startPage() { return *start_; }
  SliceView& slice(Plane plane) { return slice_set_->slice(plane); }
  /// The slice that had the focus last; null: the 3-D view had it.
  SliceView* activeSlice() const;
  /// Whether a slice is in view, and so in a picture of the window.
  bool showsSlices() const;
  SliceSet& slices() { return *slice_set_; }
  ViewLayout& views() { return *views_; }
  /// How the views are laid out, in a word for the preferences; one that is not known is left out.
  QString viewState() const;
  void restoreViews(const QString& state);
  /// Whether each view says what the mouse does in it.
  bool hintsShown() const;
  void setHintsShown(bool shown);
  /// Views, borders, panels and details; empty parts stay as they are.
  WindowLayout layoutState() const;
  void restoreLayout(const WindowLayout& layout);
  /// As at the first start.
  void resetLayout();
  /// What the mouse does in all views.
  void setMouse(const MouseChoices& mouse);
  /// Dresses the program.
  void setTheme(style::Theme theme);

 signals:
  void openWanted(const QString& path);
  /// The user wants to open a recording.
  void recordingWanted(const QString& path);
  void pacsWanted();    ///< a scan from an archive of a hospital
  void exportWanted();  ///< of the recording that is chosen in their list
  /// The user wants the edited volume in this file.
  void saveEditedWanted(const QString& path);
  /// The user wants to open what was saved of a view, or to save it.
  void viewWanted(const QString& path);
  void viewSaveWanted();
  /// Files and folders were dropped on the window: one or more.
  void dropped(const QStringList& paths);
  /// The user wants to see the last list of series again.
  void seriesWanted();
  /// The menu of recent places is about to open.
  void recentPlacesSought();
  void preferencesWanted();
  /// The user wants to read a place of the help; empty: that of the part with the focus.
  void helpWanted(const QString& place);
  void logWanted();  ///< the user wants to read the log
  /// The user hid the hints, or brought them back.
  void hintsChanged();
  /// The user chose another theme, tab or layout of the panels.
  void themeChanged();
  void panelsChanged();
  void rememberPlacesChanged(bool remember);
  void forgetPlacesWanted();
  void phantomWanted(const QString& name);
  /// The user wants to see the haptic devices.
  void devicesWanted();
  void cancelWanted();
  /// The user wants to see this folder in a program for folders.
  void folderWanted(const QString& folder);
  /// The user chose a preset in the View menu.
  void isovalueWanted(double isovalue);
  /// The state of the touch is due in words, at most ten times a second.
  void worded(const haptics::Snapshot& snapshot);
  /// The tool is to come to a place [m]. `normal_W`: unit, out of the solid there; zero if it is
  /// not known, as in a slice.
  void toolWanted(const haptics::Vec3& p_W, const haptics::Vec3& normal_W);
  void toolToCrossWanted();
  void crossToToolWanted();
  /// The user wants a picture in a file, at first of this slice, or of the 3-D view (null); or one
  /// in the clipboard.
  void pictureWanted(ui::SliceView* first);
  void pictureCopyWanted();
  /// The first steps were explained, or skipped.
  void tourEnded();
  void forceOffWanted();
  void forceOnWanted();
  void closing();

 protected:
  void closeEvent(QCloseEvent* event) override;
  /// Tab goes through bar, tabs, panels, views and status bar as they are laid out.
  bool focusNextPrevChild(bool next) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildViews();
  void buildStartPage();
  void buildBanners();
  /// Gives a bar with a sentence the button "More", for as long as the help explains it.
  void explain(QPushButton& more, const QString& sentence);
  void buildMenus();
  void buildThemeMenu(QMenu& menu);
  void buildLayoutMenu(QMenu& menu);
  void buildFileMenu();
  void buildStatusBar();
  void displayWords();
  /// Says the state of the force on the bar, and what the user can do about it above the views.
  void sayForce(const haptics::Snapshot& snapshot);
  void stopForce(const QString& by);
  void showTitle();
  void askWhereToSave();
  void showControls();
  void showAbout();

  VolumeView* view_;
  SliceSet* slice_set_;
  std::array<SliceView*, 4> slices_{};
  ViewLayout* views_ = nullptr;
  StartPage* start_;
  ReplayBar* replay_;
  TopBar* bar_;
  SidePanel* side_;
  QSplitter* splitter_;
  QMenu* view_menu_ = nullptr;
  QMenu* edit_menu_ = nullptr;
  QAction* hints_ = nullptr;
  QActionGroup* themes_ = nullptr;
  std::function<bool()> close_guard_;
  QAction* save_edited_ = nullptr;
  QString title_;  ///< of the volume; empty: none
  bool edited_ = false;
  ViewActions* view_actions_ = nullptr;
  StatusLine* status_;
  QLabel* scan_line_;
  QLabel* graphics_;
  QToolButton* details_;
  Banner* fault_;
  Banner* message_;
  QPushButton* more_of_fault_;
  QPushButton* more_of_message_;
  Explainer explainer_;
  Banner* done_;
  QString done_folder_;  ///< of what done_ tells
  Banner* offer_;
  QPushButton* take_offer_;
  std::function<void()> offered_;
  Banner* stopped_;
  QPushButton* resume_;
  Feel feel_ = Feel::Shown;
  bool is_force_ = false;  ///< of the last snapshot
  QString stopped_by_;     ///< sentence on who stopped the force; empty: nobody since it was armed
  std::optional<haptics::Snapshot> unsaid_;  ///< snapshot that arrived while words_ ran
  QTimer words_;                             ///< runs after the texts changed
  QFrame* loading_;
  QLabel* loading_what_;
  QProgressBar* progress_;
  Tour* tour_;
  QMenu* phantoms_ = nullptr;
  QMenu* recent_ = nullptr;
  QAction* series_ = nullptr;
};

/// The safety notice that every user must read once.
QString noticeText();

}  // namespace ui
