// SPDX-License-Identifier: BSD-3-Clause
// The first minute: what an empty window offers, the notice, and the tour of the first steps.
#include "ui/window/start_page.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <thread>

#include "app/application.h"
#include "app/window/program/preferences.h"
#include "app/window/scan/loader.h"
#include "haptics/session.h"
#include "tests/support/turned_scan.h"
#include "tests/ui/window_support.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/haptic_device_panel.h"
#include "ui/panels/histogram_slider.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/screenshot.h"
#include "ui/window/side_panel.h"
#include "ui/window/tour.h"
#include "ui/window/views.h"

namespace {

using window::waitFor;
using namespace std::chrono_literals;

/// A folder of the user's, which is no temporary one, with a small scan in it.
class OwnFolder {
 public:
  OwnFolder() : path_(QDir::currentPath() + "/start_page_test_scans") {
    QDir().mkpath(path_);
    QFile scan(this->scan());
    EXPECT_TRUE(scan.open(QFile::WriteOnly));
    scan.write(
        "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 40 40 40\n"
        "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\n");
    // a bright ball
    QByteArray voxels(40 * 40 * 40, '\0');
    for (int k = 0, at = 0; k < 40; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i, ++at)
          if ((i - 20) * (i - 20) + (j - 20) * (j - 20) + (k - 20) * (k - 20) < 150)
            voxels[at] = char(200);
    scan.write(voxels);
  }
  ~OwnFolder() { QDir(path_).removeRecursively(); }
  QString scan() const { return path_ + "/ball.nrrd"; }
  QString gone() const { return path_ + "/gone.nrrd"; }
  QStringList files() const { return QDir(path_).entryList(QDir::Files); }

 private:
  QString path_;
};

class StartPage : public testing::Test {
 protected:
  StartPage() { QSettings().clear(); }
  ~StartPage() override { QSettings().clear(); }

  app::Application& start(app::Arguments arguments = {}) {
    arguments.surface = ui::SurfaceMode::Mesh;
    application_ = std::make_unique<app::Application>(std::move(arguments));
    application_->start();
    return *application_;
  }
  app::Application& startEmpty() {
    app::Arguments arguments;
    arguments.notice = false;
    app::Application& application = start(std::move(arguments));
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window(), 120'000));
    return application;
  }

  ui::MainWindow& window() { return application_->window(); }
  ui::StartPage& page() { return window().startPage(); }
  template <class Widget>
  Widget* named(const char* name) {
    auto* found = window().findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* name) {
    auto* button = named<QAbstractButton>(name);
    ASSERT_TRUE(button->isVisible() && button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  bool isTouched() {
    return waitFor([&] { return application_->snapshot().scene != 0; });
  }
  QList<QToolButton*> tiles() {
    QList<QToolButton*> tiles;
    for (auto* tile : window().findChildren<QToolButton*>("lastScan"))
      if (tile->isVisible()) tiles << tile;
    return tiles;
  }
  static void remember(const QStringList& places) {
    app::Preferences preferences;
    preferences.places = places;
    preferences.notice_seen = preferences.tour_seen = true;
    app::savePreferences(preferences);
  }
  ui::Tour& tour() { return *window().findChild<ui::Tour*>(); }
  QString tourSentence() { return named<QLabel>("tourSentence")->text(); }

  std::unique_ptr<app::Application> application_;
};

TEST_F(StartPage, AnEmptyWindowOffersThreeWaysToBeginAndTheDemoIsOneClickAway) {
  startEmpty();
  EXPECT_TRUE(page().isVisible());
  EXPECT_TRUE(named<QLabel>("purpose")->isVisible());
  for (const char* name : {"startFolder", "startFile", "startDemo", "startDevice"}) {
    auto* button = named<QPushButton>(name);
    EXPECT_TRUE(button->isVisible()) << name;
    EXPECT_FALSE(button->toolTip().isEmpty()) << name;
  }
  EXPECT_EQ(window().windowTitle(), "Palpate");
  for (const char* name : {"undo", "redo", "cropBox"})
    EXPECT_FALSE(named<QAction>(name)->isEnabled()) << name;
  EXPECT_FALSE(application_->shown());
  const QImage seen = window::pictureOf(window());
  window::keep(seen, "start_page");
  // a picture of the window has the cards, not the view that they cover
  const QImage picture = ui::screenshotOf(window(), window().views(), {.whole_window = true});
  EXPECT_LT(window::differing(picture, seen, 8), 0.002);
  window().activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window(), 120'000));
  named<QPushButton>("startDemo")->setFocus();
  click("startDemo");
  // its progress takes the place of the cards
  EXPECT_FALSE(named<QPushButton>("startDemo")->isVisible());
  EXPECT_TRUE(named<QPushButton>("startCancel")->isVisible());
  // who leads by keys goes on there
  EXPECT_TRUE(named<QPushButton>("startCancel")->hasFocus());
  ASSERT_TRUE(isTouched());
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(window().windowTitle().startsWith("demo"));
  // it has no place to which one could come back
  EXPECT_TRUE(app::loadPreferences().places.isEmpty());
}

TEST_F(StartPage, AClickBesideTheButtonsOfACardIsOneOnTheFirst) {
  startEmpty();
  // of two buttons the first; what it opens is not wanted here
  QObject::disconnect(&page(), &ui::StartPage::folderWanted, nullptr, nullptr);
  QObject::disconnect(&page(), &ui::StartPage::fileWanted, nullptr, nullptr);
  const QSignalSpy folders(&page(), &ui::StartPage::folderWanted);
  const QSignalSpy files(&page(), &ui::StartPage::fileWanted);
  QTest::mouseClick(named<QPushButton>("startFolder")->parentWidget(), Qt::LeftButton, {},
                    {60, 60});
  EXPECT_EQ(folders.count(), 1);
  EXPECT_EQ(files.count(), 0);
  auto* demo = named<QPushButton>("startDemo");
  QTest::mouseClick(demo->parentWidget(), Qt::LeftButton, {}, {60, 60});
  EXPECT_TRUE(isTouched());
}

TEST_F(StartPage, CardsStandBelowEachOtherWhereThereIsNoRoomBeside) {
  ui::StartPage page;
  const auto placeOf = [&](const char* button) {
    return page.findChild<QWidget*>(button)->mapTo(&page, QPoint{});
  };
  int rows = 0;
  for (const int width : {1100, 700, 380}) {
    window::showAndWait(page, {width, 700});
    window::keep(window::pictureOf(page), qPrintable(QString("start_page_%1").arg(width)));
    std::set<int> tops;
    for (const char* button : {"startFolder", "startDemo", "startDevice"})
      tops.insert(placeOf(button).y() / 20);
    EXPECT_GT(int(tops.size()), rows) << width;
    rows = int(tops.size());
    EXPECT_EQ(page.horizontalScrollBar()->maximum(), 0) << width;
  }
}

TEST_F(StartPage, IsLedByTheKeyboard) {
  startEmpty();
  window().activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window(), 120'000));
  // from any place in the window, Tab comes to the card
  auto* demo = named<QPushButton>("startDemo");
  for (int presses = 0; presses < 100 && !demo->hasFocus(); ++presses)
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  ASSERT_TRUE(demo->hasFocus());
  QTest::keyClick(demo, Qt::Key_Space);
  EXPECT_TRUE(isTouched());
}

TEST_F(StartPage, TheCardOfDevicesShowsTheirList) {
  startEmpty();
  click("startDevice");
  EXPECT_TRUE(window::panelOf<ui::HapticDevicePanel>(window()).isVisible());
  EXPECT_EQ(window().layoutState().panels.tab, "device");
}

TEST_F(StartPage, AHandChosenInAnEmptyWindowHoldsTheToolOfTheFirstScan) {
  startEmpty();
  emit window::panelOf<ui::DevicePanel>(window()).handChosen("tap");
  EXPECT_FALSE(named<QLabel>("message")->isVisible());
  click("startDemo");
  ASSERT_TRUE(isTouched());
  EXPECT_TRUE(named<QLabel>("statusLine")->text().contains("tap"))
      << named<QLabel>("statusLine")->text().toStdString();
}

TEST_F(StartPage, TheLastScansHavePicturesThatAreMadeAgainAndKeptNowhere) {
  const OwnFolder folder;
  remember({folder.scan(), folder.gone()});
  const QStringList before = folder.files();
  startEmpty();
  ASSERT_EQ(tiles().size(), 2);
  EXPECT_EQ(tiles()[0]->text(), "ball.nrrd");
  EXPECT_FALSE(tiles()[1]->isEnabled());
  const auto middle = [&] {
    const QImage picture = tiles()[0]->icon().pixmap(96, 96).toImage();
    return picture.pixelColor(picture.width() / 2, picture.height() / 2).lightness();
  };
  // another one than the place that is gone has
  const auto pictureAt = [&](int tile) { return tiles()[tile]->icon().pixmap(96, 96).toImage(); };
  EXPECT_TRUE(waitFor([&] { return pictureAt(0) != pictureAt(1) && middle() > 200; }));
  window::keep(window::pictureOf(window()), "start_page_last_scans");
  EXPECT_EQ(folder.files(), before);
  // in the preferences there are their paths, and of the window its geometry
  emit window().layoutChanged();  // they are saved
  QSettings settings;
  for (const QString& key : settings.allKeys()) {
    if (key == "window/geometry") continue;
    EXPECT_NE(settings.value(key).typeId(), QMetaType::QByteArray) << key.toStdString();
    EXPECT_LT(settings.value(key).toStringList().join(' ').size(), 500) << key.toStdString();
  }
  settings.beginGroup("places");
  EXPECT_EQ(settings.allKeys(), (QStringList{"recent", "remembered"}));
  EXPECT_EQ(settings.value("recent").toStringList(), (QStringList{folder.scan(), folder.gone()}));
  // one click opens it again
  QTest::mouseClick(tiles()[0], Qt::LeftButton);
  ASSERT_TRUE(isTouched());
  EXPECT_TRUE(window().windowTitle().startsWith("ball.nrrd"));
}

TEST_F(StartPage, APictureIsWholeAndStandsInItsOwnTileAlone) {
  ui::StartPage alone;
  alone.setPlaces({{.path = "/wide", .exists = true}, {.path = "/other", .exists = true}}, true);
  const auto tiles = alone.findChildren<QToolButton*>("lastScan");
  ASSERT_EQ(tiles.size(), 2);
  const auto iconOf = [&](int tile) {
    constexpr int kSide = ui::StartPage::kThumbnail;
    return tiles[tile]->icon().pixmap(kSide, kSide).toImage().scaled(kSide, kSide);
  };
  const QImage symbol = iconOf(0);
  EXPECT_GT(window::count(symbol, [&](QColor c) { return c != symbol.pixelColor(1, 1); }), 50);
  // twice as wide as high, its left half dark
  QImage picture(96, 48, QImage::Format_Grayscale8);
  picture.fill(200);
  for (int y = 0; y < 48; ++y) std::fill_n(picture.scanLine(y), 48, uchar{90});
  alone.setThumbnail("/wide", {.image = picture});
  alone.setThumbnail("/wide", {});  // one that could not be made leaves the tile as it is
  alone.setThumbnail("/elsewhere", {.image = picture});
  const QImage shown = iconOf(0);
  const int side = shown.width();
  const auto grey = [&](double x, double y) {
    const QColor c = shown.pixelColor(int(x * side), int(y * side));
    return c.red() == c.green() && c.green() == c.blue() ? c.red() : -1;
  };
  for (const double y : {0.3, 0.5, 0.7}) {
    EXPECT_NEAR(grey(0.05, y), 90, 3) << y;
    EXPECT_NEAR(grey(0.45, y), 90, 3) << y;
    EXPECT_NEAR(grey(0.55, y), 200, 3) << y;
    EXPECT_NEAR(grey(0.95, y), 200, 3) << y;
  }
  const QColor ground = ui::style::colours().ground;
  for (const double y : {0.05, 0.2, 0.8, 0.95})
    EXPECT_EQ(shown.pixelColor(side / 4, int(y * side)).rgb(), ground.rgb()) << y;
  EXPECT_EQ(iconOf(1), symbol);
}

TEST_F(StartPage, PicturesOfTheLastScansShowTheFrontAboveHoweverTheyAreStored) {
  const OwnFolder folder;
  QStringList places;
  for (const auto& [name, bytes] : turned::frontFiles()) {
    places << QFileInfo(folder.scan()).dir().filePath(QString::fromStdString(name));
    QFile file(places.back());
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(bytes.data(), qint64(bytes.size()));
  }
  remember(places);
  startEmpty();
  ASSERT_EQ(tiles().size(), 3);
  const auto lightness = [&](int tile, double x, double y) {
    const QImage seen = tiles()[tile]->icon().pixmap(96).toImage();
    return seen.pixelColor(int(x * seen.width()), int(y * seen.height())).lightness();
  };
  // the patient's right is at the left
  const auto drawn = [&](int tile) { return lightness(tile, 0.3, 0.25) > 240; };
  EXPECT_TRUE(waitFor([&] { return drawn(0) && drawn(1) && drawn(2); }));
  window::keep(window::pictureOf(window()), "start_page_turned_scans");
  for (const int tile : {0, 1}) {
    EXPECT_NEAR(lightness(tile, 0.7, 0.25), 127, 6) << tile;
    EXPECT_LT(lightness(tile, 0.3, 0.75), 15) << tile;
    EXPECT_FALSE(tiles()[tile]->toolTip().contains("left and right")) << tile;
  }
  EXPECT_TRUE(tiles()[2]->toolTip().contains("left and right are unknown"));
}

TEST_F(StartPage, APictureOfAScanThatDoesNotSayHowItLiesSaysSo) {
  ui::StartPage alone;
  alone.setPlaces({{.path = "/known", .exists = true}, {.path = "/unknown", .exists = true}}, true);
  const auto tiles = alone.findChildren<QToolButton*>("lastScan");
  ASSERT_EQ(tiles.size(), 2);
  QImage picture(96, 96, QImage::Format_Grayscale8);
  picture.fill(120);
  alone.setThumbnail("/known", {.image = picture});
  alone.setThumbnail("/unknown", {.image = picture, .sides_known = false});
  const auto coloured = [&](int tile) {
    const QImage icon = tiles[tile]->icon().pixmap(ui::StartPage::kThumbnail).toImage();
    return window::count(icon, [](QColor c) { return c.saturation() > 60; });
  };
  EXPECT_EQ(coloured(0), 0);
  EXPECT_GT(coloured(1), 100);
  for (const QString& told : {tiles[1]->toolTip(), tiles[1]->accessibleName()})
    EXPECT_TRUE(told.contains("unknown") && told.contains("left and right are unknown"))
        << told.toStdString();
  EXPECT_FALSE(tiles[0]->toolTip().contains("left and right"));
  EXPECT_EQ(tiles[0]->accessibleName(), "Open known");
  // one that is drawn later, and says it
  alone.setThumbnail("/unknown", {.image = picture});
  EXPECT_EQ(tiles[1]->accessibleName(), "Open unknown");
  EXPECT_EQ(coloured(1), 0);
}

TEST_F(StartPage, NoScanIsNamedOnceTheyAreForgotten) {
  const OwnFolder folder;
  remember({folder.scan()});
  startEmpty();
  ASSERT_EQ(tiles().size(), 1);
  EXPECT_EQ(named<QLabel>("lastScans")->text(), "Last scans");
  emit window().menus().forgetPlacesWanted();
  EXPECT_TRUE(tiles().isEmpty());
  emit window().menus().rememberPlacesChanged(false);
  EXPECT_TRUE(named<QLabel>("lastScans")->text().contains("not remembered"));
}

TEST_F(StartPage, AScanThatCannotBeOpenedBringsTheCardsBackUnderTheReason) {
  const OwnFolder folder;
  app::Arguments arguments;
  arguments.notice = false;
  arguments.load.path = folder.gone().toStdString();
  start(std::move(arguments));
  EXPECT_TRUE(waitFor([&] { return named<QLabel>("message")->isVisible(); }));
  EXPECT_TRUE(named<QPushButton>("startDemo")->isVisible());
  EXPECT_TRUE(named<QLabel>("message")->text().contains("gone.nrrd"));
  window::keep(window::pictureOf(window()), "start_page_refused");
}

TEST_F(StartPage, LoadingCanBeCancelledThere) {
  startEmpty();
  // at once, and when its thread has probably ended
  for (const std::chrono::seconds later : {0s, 2s}) {
    click("startDemo");
    std::this_thread::sleep_for(later);
    click("startCancel");
    EXPECT_TRUE(waitFor([&] { return named<QPushButton>("startDemo")->isVisible(); }));
    EXPECT_FALSE(application_->shown());
    EXPECT_TRUE(page().isVisible());
  }
}

TEST_F(StartPage, NothingMovesBehindANoticeThatWasNotRead) {
  bool seen = false;
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr || seen) return;
    seen = true;
    QTest::qWait(1500);  // long enough for the sphere, were it being loaded
    EXPECT_FALSE(application_->shown());
    EXPECT_FALSE(application_->session().isOpen());
    box->accept();
  });
  watch.start(20);
  app::Arguments arguments;
  arguments.load.phantom = "sphere";
  arguments.hand = "tap";
  start(std::move(arguments));
  EXPECT_TRUE(seen);
  EXPECT_TRUE(isTouched());
  EXPECT_TRUE(app::loadPreferences().notice_seen);
}

TEST_F(StartPage, TheTourShowsThreeControlsOnceAndHelpShowsItAgain) {
  remember({});
  QSettings().setValue("tour/seen", false);
  app::Arguments arguments;
  arguments.load.phantom = "sphere";
  start(arguments);
  ASSERT_TRUE(isTouched());
  ASSERT_TRUE(waitFor([&] { return tour().isVisible(); }));
  // the focus stays where it is, also after a click on its button: Space takes the force away
  window().views().volume().setFocus();
  const auto leavesTheFocus = [&] {
    EXPECT_EQ(window().focusWidget(), &window().views().volume()) << tour().step();
  };
  const auto beside = [&](const QWidget* control) {
    // the bubble touches its control and leaves it free
    const QRect bubble = tour().geometry();
    const QRect target(control->mapTo(&window(), QPoint{}), control->size());
    return target.adjusted(-2, -2, 2, 2).intersects(bubble) && !target.intersects(bubble);
  };
  EXPECT_EQ(tour().step(), 0);
  EXPECT_TRUE(beside(named<QToolButton>("openFolderButton")));
  window::keep(window::pictureOf(window()), "tour_1");
  leavesTheFocus();
  // it opens the tab of its control when it comes to it, and not before
  auto* side = window().findChild<ui::SidePanel*>("sidePanel");
  side->setTab(ui::Tab::Record);
  click("tourNext");
  EXPECT_EQ(tour().step(), 1);
  leavesTheFocus();
  EXPECT_EQ(window().layoutState().panels.tab, "touch");
  auto* histogram = named<ui::HistogramSlider>("isovalueSlider");
  EXPECT_TRUE(histogram->isVisible());
  EXPECT_TRUE(waitFor([&] { return beside(histogram); }));
  window::keep(window::pictureOf(window()), "tour_2");
  click("tourNext");
  EXPECT_EQ(tour().step(), 2);
  leavesTheFocus();
  EXPECT_TRUE(tourSentence().contains("Escape")) << tourSentence().toStdString();
  EXPECT_TRUE(window().rect().contains(tour().geometry()));
  window::keep(window::pictureOf(window()), "tour_3");
  EXPECT_FALSE(app::loadPreferences().tour_seen);
  click("tourNext");
  EXPECT_FALSE(tour().isVisible());
  EXPECT_TRUE(app::loadPreferences().tour_seen);

  start(arguments);
  ASSERT_TRUE(isTouched());
  QTest::qWait(300);
  EXPECT_FALSE(tour().isVisible());
  window().findChild<ui::SidePanel*>("sidePanel")->setTab(ui::Tab::Record);
  window().findChild<QAction*>("showTour")->trigger();
  ASSERT_TRUE(tour().isVisible());
  EXPECT_EQ(window().layoutState().panels.tab, "record");
  // it stays in the window that becomes smaller, and its rest can be skipped
  click("tourNext");
  EXPECT_EQ(window().layoutState().panels.tab, "touch");
  window().resize(1000, 640);
  QTest::qWait(200);
  EXPECT_TRUE(window().rect().contains(tour().geometry()));
  click("tourSkip");
  EXPECT_FALSE(tour().isVisible());
}

}  // namespace
