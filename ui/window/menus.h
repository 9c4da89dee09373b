// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>
#include <utility>

#include "ui/style/look.h"

class QActionGroup;
class QMainWindow;
class QMenu;

namespace ui {

class TopBar;
class Views;
struct Place;

/// The menus of the window, and the symbols of their entries on the bar. GUI thread.
class Menus : public QObject {
  Q_OBJECT
 public:
  Menus(QMainWindow& window, TopBar& bar, Views& views);

  /// The menu "Edit", for what its controller puts there.
  QMenu& edit() { return *edit_; }
  /// A menu of its own, before the help.
  QMenu& addMenu(const QString& title);
  /// The menu "View", for the entries of panels.
  QMenu& view() { return *view_; }
  /// Adds the entry for the preferences to the menu "Edit", below what is there by then.
  void offerPreferences();
  /// Each with what it is called in the menu.
  void setPhantoms(const QList<std::pair<QString, QString>>& names);
  /// The places of File > Open recent, newest first, and whether new ones are remembered.
  void setRecentPlaces(const QList<Place>& places, bool remembered);
  /// The place of the last scan: what is opened next is sought beside it.
  void setPlace(const QString& path);
  /// Whether there is a list of series to which the user can return.
  void setSeriesKnown(bool known);
  /// Whether an edited volume can be saved.
  void setEdited(bool edited);
  /// Whether each view says what the mouse does in it.
  bool hintsShown() const;
  void setHintsShown(bool shown);
  /// Asks for a file of structures.
  void askForStructures() { structures_->trigger(); }
  /// Applies a theme to the program.
  void setTheme(style::Theme theme);

 signals:
  void openWanted(const QString& path);
  /// A scan from an archive of a hospital.
  void pacsWanted();
  void phantomWanted(const QString& name);
  /// The menu of recent places is about to open.
  void recentPlacesSought();
  void rememberPlacesChanged(bool remember);
  void forgetPlacesWanted();
  /// The user wants to see the last list of series again.
  void seriesWanted();
  /// The user wants the structures of the scan on view from this file.
  void structuresWanted(const QString& path);
  /// The user wants the edited volume in this file.
  void saveEditedWanted(const QString& path);
  /// The user wants the surface on view as a file.
  void surfaceWanted();
  /// The user wants to open a recording, or to export the one that is chosen in their list.
  void recordingWanted(const QString& path);
  void exportWanted();
  /// The user wants to open what was saved of a view, or to save it.
  void viewWanted(const QString& path);
  void viewSaveWanted();
  /// The same in a file that the user chooses.
  void viewSaveAsWanted();
  void preferencesWanted();
  /// The help of the part with the focus.
  void helpWanted();
  /// The first steps.
  void tourWanted();
  /// A phantom with structures is wanted, to try them.
  void structuresTried();
  void logWanted();
  void layoutResetWanted();
  /// The user hid the hints, or brought them back.
  void hintsChanged();
  /// The user chose another theme.
  void themeChanged();

 private:
  void buildFileMenu();
  void buildViewMenu();
  void buildLayoutMenu(QMenu& menu);
  void buildThemeMenu(QMenu& menu);
  void buildHelpMenu();
  void askWhereToSave();
  void showControls();
  void showAbout();

  QMainWindow& window_;
  TopBar& bar_;
  Views& views_;
  QMenu* edit_ = nullptr;
  QMenu* view_ = nullptr;
  QMenu* phantoms_ = nullptr;
  QMenu* recent_ = nullptr;
  QAction* structures_ = nullptr;
  QAction* series_ = nullptr;
  QAction* save_edited_ = nullptr;
  QAction* hints_ = nullptr;
  QActionGroup* themes_ = nullptr;
  QString folder_;  ///< where a dialog begins; empty: where Qt has it
};

}  // namespace ui
