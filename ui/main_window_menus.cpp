// SPDX-License-Identifier: BSD-3-Clause
#include "ui/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/bindings.h"
#include "ui/save_dialog.h"
#include "ui/start_page.h"
#include "ui/style/style.h"
#include "ui/tour.h"
#include "ui/view_actions.h"
#include "ui/volume_view.h"

namespace ui {
namespace {

QString themeAction(style::Theme theme) { return "theme_" + style::nameOf(theme); }

}  // namespace

void MainWindow::buildFileMenu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  // emits `wish` with what was chosen
  const auto ask = [this](QFileDialog::FileMode mode, const QString& title, const QString& filter,
                          void (MainWindow::*wish)(const QString&)) {
    // Qt's own dialog: in a foreign one Escape would not reach the application
    QFileDialog dialog(this, title);
    dialog.setFileMode(mode);
    dialog.setNameFilter(filter);
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    if (dialog.exec() == QDialog::Accepted) emit(this->*wish)(dialog.selectedFiles().value(0));
  };
  const QString any = tr("All files (*)");
  QAction* open = file->addAction(tr("&Open file…"), this, [ask, any] {
    ask(QFileDialog::ExistingFile, tr("Open a scan"), any, &MainWindow::openWanted);
  });
  open->setObjectName("openFile");
  bar_->add(BarGroup::File, *open, "open");
  giveKeys(*open, Action::OpenFile, tr("Opens a scan in a file"));
  QAction* folder = file->addAction(tr("Open &folder…"), this, [ask, any] {
    ask(QFileDialog::Directory, tr("Open a folder of slices"), any, &MainWindow::openWanted);
  });
  folder->setObjectName("openFolder");
  giveKeys(*folder, Action::OpenFolder);
  file->addAction(tr("From &PACS…"), this, &MainWindow::pacsWanted)->setObjectName("fromPacs");
  recent_ = file->addMenu(tr("Open &recent"));
  recent_->setObjectName("recent");
  recent_->setToolTipsVisible(true);
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::recentPlacesSought);
  phantoms_ = file->addMenu(tr("Open &phantom"));
  QAction* recording = file->addAction(tr("Open recor&ding…"), this, [ask] {
    ask(QFileDialog::ExistingFile, tr("Open a recording"), tr("Recordings (*.palpate)"),
        &MainWindow::recordingWanted);
  });
  recording->setObjectName("openRecordingFile");
  file->addAction(tr("&Export recording…"), this, &MainWindow::exportWanted)
      ->setObjectName("exportRecordingAction");
  file->addSeparator();
  QAction* view = file->addAction(tr("Open &view…"), this, [ask] {
    ask(QFileDialog::ExistingFile, tr("Open a view"), tr("Views (*.palpate-view)"),
        &MainWindow::viewWanted);
  });
  view->setObjectName("openView");
  QAction* save = file->addAction(tr("Save view &as…"), this, &MainWindow::viewSaveWanted);
  save->setObjectName("saveView");
  giveKeys(*save, Action::SaveView);
  file->addSeparator();
  series_ = file->addAction(tr("&Series of this folder…"), this, &MainWindow::seriesWanted);
  series_->setObjectName("seriesOfThisFolder");
  setSeriesKnown(false);
  file->addSeparator();
  save_edited_ = file->addAction(tr("Save &edited volume as…"), this, &MainWindow::askWhereToSave);
  save_edited_->setObjectName("saveEdited");
  save_edited_->setEnabled(false);
  file->addSeparator();
  giveKeys(*file->addAction(tr("&Quit"), this, &QWidget::close), Action::Quit);
}

void MainWindow::buildMenus() {
  buildFileMenu();
  edit_menu_ = menuBar()->addMenu(tr("&Edit"));
  QMenu* look = menuBar()->addMenu(tr("&View"));
  view_menu_ = look;
  QMenu* layout = look->addMenu(tr("&Layout"));
  buildLayoutMenu(*layout);
  look->addMenu(&slice_set_->menu());
  buildThemeMenu(*look->addMenu(tr("T&heme")));
  look->addAction(tr("&Reset layout"), this,
                  [this] {
                    resetLayout();
                    emit panelsChanged();
                  })
      ->setObjectName("resetLayout");
  hints_ = look->addAction(tr("Hi&nts"));
  hints_->setObjectName("showHints");
  hints_->setCheckable(true);
  hints_->setChecked(true);
  connect(hints_, &QAction::toggled, views_, &ViewLayout::setHintsShown);
  connect(hints_, &QAction::triggered, this, &MainWindow::hintsChanged);
  look->addSeparator();
  view_actions_ = new ViewActions(*look, *bar_, *view_);
  view_actions_->setParent(this);
  connect(view_actions_, &ViewActions::isovalueWanted, this, &MainWindow::isovalueWanted);
  connect(view_actions_, &ViewActions::pictureWanted, this,
          [this] { emit pictureWanted(activeSlice()); });
  connect(slice_set_, &SliceSet::pictureWanted, this, [this] {
    const auto shown = std::ranges::find_if(slices_, &SliceView::isVisible);
    SliceView* first = shown == slices_.end() ? nullptr : *shown;
    emit pictureWanted(activeSlice() != nullptr ? activeSlice() : first);
  });
  connect(view_actions_, &ViewActions::pictureCopyWanted, this, &MainWindow::pictureCopyWanted);
  bar_->add(BarGroup::Views, *layout, "layout", tr("Layout of the views"));
  for (QAction* action : slice_set_->menu().actions())
    if (action->objectName() == QLatin1String("showCrosshair"))
      bar_->add(BarGroup::Views, *action, "crosshair");
  QMenu* surface = look->addMenu(tr("Drawing of the &surface"));
  surface->addAction(tr("Automatic"), this, [this] { view_->setSurfaceWish(std::nullopt); });
  surface->addAction(tr("Ray casting"), this,
                     [this] { view_->setSurfaceWish(SurfaceMode::RayCast); });
  surface->addAction(tr("Mesh"), this, [this] { view_->setSurfaceWish(SurfaceMode::Mesh); });

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  QAction* pages = help->addAction(tr("&Help"), this, [this] { emit helpWanted({}); });
  pages->setObjectName("showHelp");
  giveKeys(*pages, Action::ShowHelp);
  // in the windows beside this one too
  pages->setShortcutContext(Qt::ApplicationShortcut);
  giveKeys(*help->addAction(tr("&Controls"), this, &MainWindow::showControls),
           Action::ShowControls);
  help->addAction(tr("&First steps"), this, &MainWindow::showTour)->setObjectName("showTour");
  help->addAction(tr("Show &log"), this, &MainWindow::logWanted)->setObjectName("showLog");
  help->addAction(tr("&About Palpate"), this, &MainWindow::showAbout);
}

void MainWindow::buildLayoutMenu(QMenu& menu) {
  menu.setObjectName("layoutMenu");
  auto* arrangements = new QActionGroup(this);
  const auto add = [&](const QString& text, Arrangement arrangement) {
    QAction* action =
        menu.addAction(text, this, [this, arrangement] { views_->arrange(arrangement); });
    action->setObjectName(ViewLayout::nameOf(arrangement));
    action->setCheckable(true);
    action->setChecked(arrangement == views_->arrangement());
    arrangements->addAction(action);
  };
  add(tr("&One view"), Arrangement::One);
  add(tr("&Two by two"), Arrangement::FourUp);
  add(tr("&3-D large"), Arrangement::VolumeLarge);
  add(tr("&Slices large"), Arrangement::SlicesLarge);
  connect(views_, &ViewLayout::arranged, arrangements, [arrangements](Arrangement arrangement) {
    for (QAction* action : arrangements->actions())
      action->setChecked(action->objectName() == ViewLayout::nameOf(arrangement));
  });
  menu.addSeparator();
  menu.addAction(tr("&First sizes"), views_, &ViewLayout::resetBorders)
      ->setObjectName("resetBorders");
  QAction* maximise =
      menu.addAction(tr("View &alone, or all"), views_, &ViewLayout::toggleMaximised);
  maximise->setObjectName("maximiseView");
  giveKeys(*maximise, Action::ViewAlone);
  QAction* next = menu.addAction(tr("&Next view"), views_, &ViewLayout::nextView);
  next->setObjectName("nextView");
  giveKeys(*next, Action::NextView);
  // F is a letter in a field for text
  maximise->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  views_->addAction(maximise);
}

void MainWindow::offerPreferences() {
  edit_menu_->addSeparator();
  QAction* preferences =
      edit_menu_->addAction(tr("Pre&ferences…"), this, &MainWindow::preferencesWanted);
  preferences->setObjectName("preferences");
  giveKeys(*preferences, Action::ShowPreferences);
}

void MainWindow::setTheme(style::Theme theme) {
  if (theme != style::theme()) style::dress(*qApp, theme);
  for (QAction* action : themes_->actions())
    action->setChecked(action->objectName() == themeAction(theme));
}

void MainWindow::buildThemeMenu(QMenu& menu) {
  menu.setObjectName("themeMenu");
  themes_ = new QActionGroup(this);
  using style::Theme;
  const auto add = [&](const QString& text, Theme theme) {
    QAction* action = menu.addAction(text, this, [this, theme] {
      setTheme(theme);
      emit themeChanged();
    });
    action->setObjectName(themeAction(theme));
    action->setCheckable(true);
    action->setChecked(theme == style::theme());
    themes_->addAction(action);
  };
  add(tr("As the &desktop"), Theme::System);
  add(tr("D&ark"), Theme::Dark);
  add(tr("&Light"), Theme::Light);
  add(tr("&High contrast"), Theme::HighContrast);
}

bool MainWindow::hintsShown() const { return hints_->isChecked(); }

void MainWindow::setHintsShown(bool shown) { hints_->setChecked(shown); }

void MainWindow::askWhereToSave() {
  QFileDialog dialog(this, tr("Save edited volume as"));
  askForOutput(dialog, tr("NRRD (*.nrrd)"), "nrrd");
  if (dialog.exec() == QDialog::Accepted) emit saveEditedWanted(dialog.selectedFiles().value(0));
}

void MainWindow::setPhantoms(const QList<std::pair<QString, QString>>& names) {
  phantoms_->clear();
  for (const auto& [name, title] : names)
    phantoms_->addAction(title, this, [this, name = name] { emit phantomWanted(name); });
}

void MainWindow::setRecentPlaces(const QList<Place>& places, bool remembered) {
  constexpr int kLongest = 480;  // pixels
  start_->setPlaces(places, remembered);
  recent_->clear();
  for (const Place& place : places) {
    QString text = fontMetrics().elidedText(place.path, Qt::ElideMiddle, kLongest);
    QAction* open = recent_->addAction(text.replace('&', "&&"), this,
                                       [this, path = place.path] { emit openWanted(path); });
    open->setEnabled(place.exists);
    open->setToolTip(place.path);
  }
  recent_->addSeparator();
  QAction* remember = recent_->addAction(tr("&Remember recent places"));
  remember->setObjectName("rememberPlaces");
  remember->setCheckable(true);
  remember->setChecked(remembered);
  connect(remember, &QAction::toggled, this, &MainWindow::rememberPlacesChanged);
  QAction* forget =
      recent_->addAction(tr("&Forget recent places"), this, &MainWindow::forgetPlacesWanted);
  forget->setObjectName("forgetPlaces");
  forget->setEnabled(!places.isEmpty());
}

void MainWindow::setSeriesKnown(bool known) { series_->setEnabled(known); }

void MainWindow::showControls() {
  // longer than many a screen is high
  auto* text = new QTextBrowser;
  text->setHtml(
      tr("<p><b>Force off</b>: Escape anywhere, Space in the 3-D view, or the stop button.</p>"
         "<p><b>Haptic device</b> (View > Haptic device): Connect, then Arm. While %1 is held in "
         "the 3-D view the tool stays and the hand moves freely; with hold-to-run, the force is "
         "on while %2 is held.</p>"
         "<p><b>Mouse</b>: it turns the picture until you take the tool (%3, or the button), and "
         "then moves the tool. The tool itself can be dragged at any time.</p>"
         "<p><b>Measures</b>: click where the places are, or drag a distance. Handles can be "
         "dragged in every view.</p>"
         "<p><b>Slices</b>: a right click, the key %4 or the button in the corner opens the "
         "choices: windows, slabs, contour, following the tool, the view down the tool.</p>"
         "<p><b>Replay</b>: on its bar, ▼ are marks, ◆ settings, ■ scene and camera, "
         "● force and device, × samples lost and ticks late.</p>"
         "<p>Keys can be changed: Edit > Preferences, Shortcuts.</p>")
          .arg(keyOf(Action::Clutch), keyOf(Action::HoldToRun), keyOf(Action::TakeTool),
               keyOf(Action::SliceMenu)) +
      controlsText());
  QDialog dialog(this);
  dialog.setObjectName("controls");
  dialog.setWindowTitle(tr("Controls"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(&dialog);
  column->addWidget(text);
  column->addWidget(buttons);
  dialog.resize(680, 640);
  dialog.exec();
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About Palpate"),
      tr("<p><b>Palpate %1</b></p><p>See a CT scan, and feel it through a haptic "
         "device.</p><p><b>%2</b></p><p>BSD-3-Clause licence. Palpate uses Qt (LGPL-3), "
         "VTK, vtk-dicom, Eigen, HDF5, DCMTK, CharLS, OpenJPEG, libarchive, "
         "libdeflate, hidapi and libusb (LGPL-2.1), libseccomp (LGPL-2.1), elfutils (LGPL-3), "
         "SQLite and others, as Debian packages them. The help lists all of them, with "
         "their licences.</p>")
          .arg(QCoreApplication::applicationVersion(), noticeText()));
}

}  // namespace ui
