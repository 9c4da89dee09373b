// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/menus.h"

#include <QActionGroup>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "ui/controls/bindings.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/messages.h"
#include "ui/window/start_page.h"
#include "ui/window/top_bar.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace ui {
namespace {

QString themeAction(style::Theme theme) { return "theme_" + style::nameOf(theme); }

}  // namespace

Menus::Menus(QMainWindow& window, TopBar& bar, Views& views)
    : QObject(&window), window_(window), bar_(bar), views_(views) {
  buildFileMenu();
  edit_ = window_.menuBar()->addMenu(tr("&Edit"));
  buildViewMenu();
  buildHelpMenu();
}

void Menus::buildFileMenu() {
  QMenu* file = window_.menuBar()->addMenu(tr("&File"));
  // emits `wish` with what was chosen
  const auto ask = [this](QFileDialog::FileMode mode, const QString& title, const QString& filter,
                          void (Menus::*wish)(const QString&), const QString& begin = {}) {
    // Qt's own dialog: in a foreign one Escape would not reach the application
    QFileDialog dialog(&window_, title);
    dialog.setFileMode(mode);
    dialog.setNameFilter(filter);
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    const QString& from = begin.isEmpty() ? folder_ : begin;
    if (QFileInfo(from).isDir()) dialog.setDirectory(from);
    if (dialog.exec() == QDialog::Accepted) emit(this->*wish)(dialog.selectedFiles().value(0));
  };
  const QString any = tr("All files (*)");
  QAction* open = file->addAction(tr("&Open file…"), this, [ask, any] {
    ask(QFileDialog::ExistingFile, tr("Open a scan"), any, &Menus::openWanted);
  });
  open->setObjectName("openFile");
  giveKeys(*open, Action::OpenFile, tr("Opens a scan in a file"));
  QAction* folder = file->addAction(tr("Open &folder…"), this, [ask, any] {
    ask(QFileDialog::Directory, tr("Open a folder of slices"), any, &Menus::openWanted);
  });
  folder->setObjectName("openFolder");
  bar_.add(BarGroup::File, *folder, "open");
  giveKeys(*folder, Action::OpenFolder, tr("Opens a folder of slices"));
  file->addAction(tr("From PA&CS…"), this, &Menus::pacsWanted)->setObjectName("fromPacs");
  recent_ = file->addMenu(tr("Open &recent"));
  recent_->setObjectName("recent");
  recent_->setToolTipsVisible(true);
  connect(recent_, &QMenu::aboutToShow, this, &Menus::recentPlacesSought);
  phantoms_ = file->addMenu(tr("Open &phantom"));
  structures_ = file->addAction(tr("Open s&tructures…"), this, [ask, any] {
    ask(QFileDialog::ExistingFile, tr("Open structures of the scan on view"), any,
        &Menus::structuresWanted);
  });
  structures_->setObjectName("openStructures");
  QAction* recording = file->addAction(tr("Open recor&ding…"), this, [ask] {
    ask(QFileDialog::ExistingFile, tr("Open a recording"), tr("Recordings (*.palpate)"),
        &Menus::recordingWanted);
  });
  recording->setObjectName("openRecordingFile");
  file->addAction(tr("E&xport recording…"), this, &Menus::exportWanted)
      ->setObjectName("exportRecordingAction");
  file->addSeparator();
  QAction* view = file->addAction(tr("Open &view…"), this, [ask] {
    ask(QFileDialog::ExistingFile, tr("Open a view"), tr("Views (*.palpate-view)"),
        &Menus::viewWanted, folderOfOutput());  // where they are saved
  });
  view->setObjectName("openView");
  QAction* save = file->addAction(tr("Save vie&w"), this, &Menus::viewSaveWanted);
  save->setObjectName("saveView");
  giveKeys(*save, Action::SaveView);
  file->addAction(tr("Save view &as…"), this, &Menus::viewSaveAsWanted)
      ->setObjectName("saveViewAs");
  file->addSeparator();
  series_ = file->addAction(tr("&Series of this folder…"), this, &Menus::seriesWanted);
  series_->setObjectName("seriesOfThisFolder");
  setSeriesKnown(false);
  file->addSeparator();
  save_edited_ = file->addAction(tr("Save &edited volume as…"), this, &Menus::askWhereToSave);
  save_edited_->setObjectName("saveEdited");
  save_edited_->setEnabled(false);
  file->addAction(tr("Export s&urface…"), this, &Menus::surfaceWanted)
      ->setObjectName("exportSurface");
  file->addSeparator();
  giveKeys(*file->addAction(tr("&Quit"), &window_, &QWidget::close), Action::Quit);
}

void Menus::buildViewMenu() {
  view_ = window_.menuBar()->addMenu(tr("&View"));
  QMenu* layout = view_->addMenu(tr("&Layout"));
  buildLayoutMenu(*layout);
  view_->addMenu(&views_.slices().menu());
  buildThemeMenu(*view_->addMenu(tr("T&heme")));
  view_->addAction(tr("&Reset layout"), this, &Menus::layoutResetWanted)
      ->setObjectName("resetLayout");
  hints_ = view_->addAction(tr("Hi&nts"));
  hints_->setObjectName("showHints");
  hints_->setCheckable(true);
  hints_->setChecked(true);
  connect(hints_, &QAction::toggled, &views_.layout(), &ViewLayout::setHintsShown);
  connect(hints_, &QAction::triggered, this, &Menus::hintsChanged);
  connect(&views_, &Views::hintsUnwanted, hints_, &QAction::trigger);
  view_->addSeparator();
  views_.addActions(*view_, bar_);
  bar_.add(BarGroup::Views, *layout, "layout", tr("Layout of the views"));
  for (QAction* action : views_.slices().menu().actions())
    if (action->objectName() == QLatin1String("showCrosshair"))
      bar_.add(BarGroup::Views, *action, "crosshair");
  QMenu* surface = view_->addMenu(tr("&Drawing of the surface"));
  VolumeView& volume = views_.volume();
  surface->setObjectName("surfaceMenu");
  auto* means = new QActionGroup(this);
  const auto add = [&](const QString& text, std::optional<SurfaceMode> wish) {
    QAction* action =
        surface->addAction(text, this, [&volume, wish] { volume.setSurfaceWish(wish); });
    action->setCheckable(true);
    action->setChecked(!wish);
    means->addAction(action);
  };
  add(tr("&Automatic"), std::nullopt);
  add(tr("&Ray casting"), SurfaceMode::RayCast);
  add(tr("&Mesh"), SurfaceMode::Mesh);
}

void Menus::buildHelpMenu() {
  QMenu* help = window_.menuBar()->addMenu(tr("&Help"));
  QAction* pages = help->addAction(tr("&Help"), this, &Menus::helpWanted);
  pages->setObjectName("showHelp");
  giveKeys(*pages, Action::ShowHelp);
  // in the windows beside this one too
  pages->setShortcutContext(Qt::ApplicationShortcut);
  giveKeys(*help->addAction(tr("&Controls"), this, &Menus::showControls), Action::ShowControls);
  help->addAction(tr("&First steps"), this, &Menus::tourWanted)->setObjectName("showTour");
  help->addAction(tr("&Try structures"), this, &Menus::structuresTried)
      ->setObjectName("tryStructures");
  help->addAction(tr("Show &log"), this, &Menus::logWanted)->setObjectName("showLog");
  help->addAction(tr("&About Palpate"), this, &Menus::showAbout);
}

void Menus::buildLayoutMenu(QMenu& menu) {
  menu.setObjectName("layoutMenu");
  ViewLayout& layout = views_.layout();
  auto* arrangements = new QActionGroup(this);
  const auto add = [&](const QString& text, Arrangement arrangement) {
    QAction* action =
        menu.addAction(text, this, [&layout, arrangement] { layout.arrange(arrangement); });
    action->setObjectName(ViewLayout::nameOf(arrangement));
    action->setCheckable(true);
    action->setChecked(arrangement == layout.arrangement());
    arrangements->addAction(action);
  };
  add(tr("&One view"), Arrangement::One);
  add(tr("&Two by two"), Arrangement::FourUp);
  add(tr("&3-D large"), Arrangement::VolumeLarge);
  add(tr("&Slices large"), Arrangement::SlicesLarge);
  connect(&layout, &ViewLayout::arranged, arrangements, [arrangements](Arrangement arrangement) {
    for (QAction* action : arrangements->actions())
      action->setChecked(action->objectName() == ViewLayout::nameOf(arrangement));
  });
  menu.addSeparator();
  menu.addAction(tr("&First sizes"), &layout, &ViewLayout::resetBorders)
      ->setObjectName("resetBorders");
  QAction* maximise =
      menu.addAction(tr("View &alone, or all"), &layout, &ViewLayout::toggleMaximised);
  maximise->setObjectName("maximiseView");
  giveKeys(*maximise, Action::ViewAlone);
  QAction* next = menu.addAction(tr("&Next view"), &layout, &ViewLayout::nextView);
  next->setObjectName("nextView");
  giveKeys(*next, Action::NextView);
  // F is a letter in a field for text
  maximise->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  layout.addAction(maximise);
}

QMenu& Menus::addMenu(const QString& title) {
  QMenuBar& bar = *window_.menuBar();
  auto* menu = new QMenu(title, &window_);
  bar.insertMenu(bar.actions().last(), menu);
  return *menu;
}

void Menus::offerPreferences() {
  edit_->addSeparator();
  QAction* preferences = edit_->addAction(tr("Pre&ferences…"), this, &Menus::preferencesWanted);
  preferences->setObjectName("preferences");
  giveKeys(*preferences, Action::ShowPreferences);
}

void Menus::setTheme(style::Theme theme) {
  if (theme != style::theme()) style::applyTheme(*qApp, theme);
  for (QAction* action : themes_->actions())
    action->setChecked(action->objectName() == themeAction(theme));
}

void Menus::buildThemeMenu(QMenu& menu) {
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

bool Menus::hintsShown() const { return hints_->isChecked(); }

void Menus::setHintsShown(bool shown) { hints_->setChecked(shown); }

void Menus::askWhereToSave() {
  QFileDialog dialog(&window_, tr("Save edited volume as"));
  askForOutput(dialog, tr("NRRD (*.nrrd)"), "nrrd");
  if (dialog.exec() == QDialog::Accepted) emit saveEditedWanted(dialog.selectedFiles().value(0));
}

void Menus::setPhantoms(const QList<std::pair<QString, QString>>& names) {
  phantoms_->clear();
  for (const auto& [name, title] : names)
    phantoms_->addAction(title, this, [this, name = name] { emit phantomWanted(name); });
}

void Menus::setRecentPlaces(const QList<Place>& places, bool remembered) {
  constexpr int kLongest = 480;  // pixels
  recent_->clear();
  for (const Place& place : places) {
    QString text = window_.fontMetrics().elidedText(place.path, Qt::ElideMiddle, kLongest);
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
  connect(remember, &QAction::toggled, this, &Menus::rememberPlacesChanged);
  QAction* forget =
      recent_->addAction(tr("&Forget recent places"), this, &Menus::forgetPlacesWanted);
  forget->setObjectName("forgetPlaces");
}

void Menus::setPlace(const QString& path) {
  // where a folder of slices lies there are others beside it
  folder_ = QFileInfo(path).absolutePath();
}

void Menus::setSeriesKnown(bool known) { series_->setEnabled(known); }

void Menus::setEdited(bool edited) { save_edited_->setEnabled(edited); }

void Menus::showControls() {
  // longer than many a screen is high
  auto* text = new QTextBrowser;
  text->setHtml(
      tr("<p><b>Force off</b>: Escape anywhere, Space in the 3-D view, or the stop button. Without "
         "motors the first Escape closes what is open.</p>"
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
  QDialog dialog(&window_);
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

void Menus::showAbout() {
  QMessageBox::about(
      &window_, tr("About Palpate"),
      tr("<p><b>Palpate %1</b></p><p>See a CT scan, and feel it through a haptic "
         "device.</p><p><b>%2</b></p><p>BSD-3-Clause licence. Palpate uses Qt (LGPL-3), "
         "VTK, vtk-dicom, Eigen, HDF5, DCMTK, CharLS, OpenJPEG, libarchive, "
         "libdeflate, hidapi and libusb (LGPL-2.1), libseccomp (LGPL-2.1), elfutils (LGPL-3), "
         "SQLite and others, as Debian packages them. The help lists all of them, with "
         "their licences.</p>")
          .arg(QCoreApplication::applicationVersion(), noticeText()));
}

}  // namespace ui
