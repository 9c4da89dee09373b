// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/main_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSplitter>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "app/window/program/preferences.h"
#include "haptics/settings.h"
#include "tests/ui/panelled_window.h"
#include "tests/ui/window_support.h"
#include "ui/controls/section.h"
#include "ui/controls/state_chip.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/panels/status_line.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/loading.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/top_bar.h"
#include "ui/window/touch_state.h"
#include "ui/window/tour.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;

// skin at 0, bone from 300 on, in HU
ui::Picture ctPicture(const char* unit = "HU") {
  const auto skin = window::ball(Vec3::Zero(), 0.026);
  const auto bone = window::ball({0.004, 0.0, 0.0}, 0.014);
  return ui::pictureOf(
      window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                       [=](const Vec3& p) { return -1000.0 + 10.4 * skin(p) + 9.0 * bone(p); },
                       {.unit = unit, .modality = "CT"}));
}

TEST(MainWindow, EscapeAnywhereSpaceInTheViewAndTheStopButtonWishTheForceOff) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(ctPicture(), 300.0, "Ball");
  window::showAndWait(window, {1240, 840});
  int wishes = 0;
  QObject::connect(&window.touch(), &ui::TouchState::forceOffWanted, [&] { ++wishes; });
  const auto wished = [&] { return std::exchange(wishes, 0) > 0; };

  auto* red = window.findChild<QToolButton*>("forceOff");
  ASSERT_TRUE(red && red->isVisible());
  QTest::mouseClick(red, Qt::LeftButton);
  EXPECT_TRUE(wished());
  QTest::keyClick(&window.views().volume(), Qt::Key_Space);
  EXPECT_TRUE(wished());
  for (QWidget* focus :
       {static_cast<QWidget*>(&window.views().volume()),
        static_cast<QWidget*>(&window.views().slice(ui::Plane::Axial)),
        static_cast<QWidget*>(window.findChild<QDoubleSpinBox*>("isovalueTyped"))}) {
    QTest::keyClick(focus, Qt::Key_Escape);
    EXPECT_TRUE(wished());
  }
  // with a modal dialog in front Escape closes it, and without motors that alone
  const auto closeDialog = [&] {
    QDialog dialog(&window);
    QTimer::singleShot(200, &dialog, [&] { QTest::keyClick(&dialog, Qt::Key_Escape); });
    QTimer::singleShot(120'000, &dialog, [&] { dialog.done(77); });
    EXPECT_EQ(dialog.exec(), QDialog::Rejected);
    return wished();
  };
  EXPECT_FALSE(closeDialog());
  QTest::keyClick(&window.views().volume(), Qt::Key_Escape);
  EXPECT_TRUE(wished()) << "nothing is open any more";
  window.touch().setHand("omega.6", ui::Feel::Felt);
  EXPECT_TRUE(closeDialog()) << "motors stop whatever else Escape closes";
  window.touch().setHand("Mouse", ui::Feel::Shown);
  // a menu, and a list that drops down
  QMenu menu(&window);
  menu.addAction("One");
  menu.popup(window.mapToGlobal(QPoint{100, 100}));
  QTest::keyClick(&menu, Qt::Key_Escape);
  EXPECT_FALSE(menu.isVisible());
  EXPECT_FALSE(wished());
  // the first steps
  window.showTour();
  auto* tour = window.findChild<ui::Tour*>();
  ASSERT_TRUE(tour->isVisible());
  QTest::keyClick(&window.views().volume(), Qt::Key_Escape);
  EXPECT_FALSE(tour->isVisible());
  EXPECT_FALSE(wished());
  QTest::keyClick(&window.views().volume(), Qt::Key_Escape);
  EXPECT_TRUE(wished());
  // even in the smallest window the button is there
  window.resize(window.minimumSizeHint());
  QTest::qWait(100);
  EXPECT_TRUE(red->isVisible());
  EXPECT_FALSE(red->visibleRegion().isEmpty());
}

TEST(MainWindow, AsksBeforeItResamplesAndTakesEnterForNo) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  window.show();
  const auto answered = [&](const std::function<void(QMessageBox&)>& answer) {
    QTimer::singleShot(200, &window, [answer] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      EXPECT_EQ(box->text(), "The slices are tilted.");
      answer(*box);
    });
    return window.messages().askWhether("The slices are tilted.", "They are resampled.",
                                        "Resample");
  };
  EXPECT_FALSE(answered([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Return); }));
  EXPECT_FALSE(answered([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Escape); }));
  EXPECT_TRUE(answered([](QMessageBox& box) {
    for (QAbstractButton* button : box.buttons())
      if (button->text().contains("Resample")) QTest::mouseClick(button, Qt::LeftButton);
  }));
}

TEST(MainWindow, TheSliderOnTheHistogramChangesPictureAndTouch) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
  panelled.show(ctPicture(), 300.0, "Ball");
  window::showAndWait(window, {1240, 840});
  double felt = 0.0;
  QObject::connect(&panelled.isosurface, &app::IsosurfaceController::changed,
                   [&](double s) { felt = s; });
  const QImage before = window::pictureAtRest(window.views().volume());
  auto* slider = window.findChild<ui::HistogramSlider*>("isovalueSlider");
  const int x = static_cast<int>(std::lround(slider->width() * 0.35));
  QTest::mouseClick(slider, Qt::LeftButton, {}, {x, slider->height() / 2});
  EXPECT_NEAR(felt, slider->intensityAt(slider->value()), 1.0);
  EXPECT_LT(felt, 0.0);
  const QImage after = window::pictureAtRest(window.views().volume());
  EXPECT_GT(window::differing(before, after), 0.05);
  window::keep(window::pictureOf(window), "main_window");
}

TEST(MainWindow, PresetsStandOnlyBesideHounsfieldUnits) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(ctPicture(), 100.0, "Ball");
  window::showAndWait(window, {1240, 840});
  double felt = 0.0;
  QObject::connect(&panelled.isosurface, &app::IsosurfaceController::changed,
                   [&](double s) { felt = s; });
  auto* bone = window.findChild<QAbstractButton*>("presetBone");
  auto* skin = window.findChild<QAbstractButton*>("presetSkin");
  ASSERT_TRUE(bone->isVisible());
  QTest::mouseClick(bone, Qt::LeftButton);
  EXPECT_EQ(felt, 300.0);
  EXPECT_TRUE(bone->isChecked());
  QTest::mouseClick(bone, Qt::LeftButton);
  EXPECT_TRUE(bone->isChecked());  // a second click changes nothing
  QTest::mouseClick(skin, Qt::LeftButton);
  EXPECT_EQ(felt, -300.0);
  EXPECT_FALSE(bone->isChecked());
  for (const auto& [name, isovalue] :
       {std::pair{"presetAirway", -500.0}, {"presetVessels", 180.0}, {"presetTeeth", 1500.0}}) {
    auto* chip = window.findChild<QAbstractButton*>(name);
    QTest::mouseClick(chip, Qt::LeftButton);
    // no farther than the volume's values go
    EXPECT_EQ(felt, ui::allowedIsovalue(*ctPicture().volume, isovalue)) << name;
  }
  panelled.show(ctPicture(""), 100.0, "Ball");
  QTest::qWait(50);
  EXPECT_FALSE(bone->isVisible());
}

TEST(MainWindow, AnIsovalueAtTheBackgroundIsRefusedInWords) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(ctPicture(), 300.0, "Ball");
  window::showAndWait(window, {1240, 840});
  double felt = 0.0;
  QObject::connect(&panelled.isosurface, &app::IsosurfaceController::changed,
                   [&](double s) { felt = s; });
  auto* typed = window.findChild<QDoubleSpinBox*>("isovalueTyped");
  typed->setFocus();
  typed->selectAll();
  QTest::keyClicks(typed, "-1000");
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_EQ(felt, -999.0);
  EXPECT_EQ(typed->value(), -999.0);
  EXPECT_TRUE(window.statusBar()->currentMessage().contains("least value"));
}

TEST(MainWindow, WhatWasWrittenIsToldApartFromAWarningAndShowsItsFolder) {
  ui::MainWindow window;
  window::showAndWait(window, {1240, 840});
  auto* done = window.findChild<QLabel*>("done");
  auto* message = window.findChild<QLabel*>("message");
  const auto has = [](const QLabel& words, const QColor& colour) {
    return window::count(window::pictureOf(*words.parentWidget()),
                         [&](QColor c) { return c.rgb() == colour.rgb(); });
  };
  QSignalSpy folders(&window.messages(), &ui::Messages::folderWanted);
  window.messages().showMessage("The disk is full; make room.");
  QTest::qWait(30);
  EXPECT_GT(has(*message, ui::style::kDark.attention_ground), 2'000);
  window.messages().showDone("\"head.nrrd\" was saved.", "/home/somebody/scans");
  QTest::qWait(30);
  window::keep(window::pictureOf(window), "main_window_done");
  EXPECT_TRUE(done->isVisible());
  EXPECT_FALSE(message->isVisible());
  EXPECT_EQ(done->text(), "\"head.nrrd\" was saved.");
  EXPECT_EQ(has(*done, ui::style::kDark.attention_ground), 0);
  EXPECT_GT(has(*done, ui::style::kDark.on), 5);
  auto* folder = window.findChild<QPushButton*>("showInFolder");
  EXPECT_EQ(folder->text(), "Show in folder");
  QTest::mouseClick(folder, Qt::LeftButton);
  ASSERT_EQ(folders.count(), 1);
  EXPECT_EQ(folders.at(0).at(0).toString(), "/home/somebody/scans");
  window.messages().showMessage("Another warning.");
  EXPECT_FALSE(done->isVisible());
  window.messages().showDone("Saved.", "/tmp");
  window.messages().clear();
  EXPECT_FALSE(done->isVisible());
}

TEST(MainWindow, WorkBehindOtherWorkIsShownUntilItEnds) {
  ui::MainWindow window;
  window.show(ui::pictureOf(window::volumeOf(window::cubeGrid(16), haptics::ScalarType::Int16,
                                             [](const Vec3&) { return 0.0; })),
              50.0, "Scan");
  window::showAndWait(window, {1240, 840});
  ui::Loading& loading = window.loading();
  const auto says = [&](const QString& words) {
    return loading.isVisible() &&
           std::ranges::any_of(loading.findChildren<QLabel*>(),
                               [&](const QLabel* label) { return label->text() == words; });
  };
  loading.setBehind("Exporting");
  EXPECT_TRUE(says("Exporting"));
  loading.begin("Saving the view");
  loading.advanceBehind(0.5);
  EXPECT_TRUE(says("Saving the view"));
  loading.end();
  EXPECT_TRUE(says("Exporting"));
  loading.begin("Editing");
  loading.setBehind({});
  EXPECT_TRUE(says("Editing"));
  loading.end();
  EXPECT_FALSE(loading.isVisible());
}

TEST(MainWindow, SaysForceAndServoAndPlotsThem) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(ctPicture(), 300.0, "Ball");
  window.views().show(window::octahedron(0.003));
  window::showAndWait(window, {1240, 840});
  haptics::Snapshot snapshot;
  snapshot.X_WP.translation() = Vec3{0.0, -0.03, 0.0};
  snapshot.X_WD.translation() = Vec3{0.0, -0.02, 0.0};
  snapshot.felt_W.force = Vec3{0.0, -3.0, 4.0};
  snapshot.felt_W.torque = Vec3{0.0, 0.02, 0.0};
  snapshot.contacts = 7;
  snapshot.servo_rate = 999.6;
  snapshot.tick_p99 = 42e-6;
  snapshot.policy = haptics::SchedulingPolicy::RealTime;
  snapshot.force_state = haptics::ForceState::On;
  window.views().display(snapshot);
  window.touch().display(snapshot);
  std::vector<haptics::ForceSample> points;
  for (int i = 0; i < 12'000; ++i) {
    const double t = i * 1e-3;
    const bool spike = i == 8'000;  // one tick among ten thousand is still seen
    points.push_back({t, spike ? 9.5F : static_cast<float>(2.0 + std::sin(t)), 0.02F});
  }
  panelled.picture.appendForces(points);
  const QImage image = window::pictureOf(window);
  window::keep(image, "main_window_force");
  EXPECT_EQ(window.findChild<QLabel*>("forceNow")->text(), "5.00");
  const QString status = window.findChild<QLabel*>("statusLine")->text();
  for (const char* part :
       {"1000 Hz", "real-time", "42 µs", "7 contacts", "5.00 N", "Surface: mesh"})
    EXPECT_TRUE(status.contains(QString::fromUtf8(part))) << status.toStdString();
  EXPECT_FLOAT_EQ(window.findChild<ui::ForcePlot*>("forcePlot")->greatestForce(), 9.5F);
}

/// A window with a volume, and what it is told of the force.
struct Told {
  explicit Told(QSize size = {1280, 860}) {
    panelled.window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
    panelled.show(ctPicture(), 300.0, "Ball");
    panelled.window.views().show(window::octahedron(0.003));
    panelled.window.touch().setHand("Mouse", ui::Feel::Shown);
    window::showAndWait(panelled.window, size);
  }
  void tell(haptics::ForceState state, haptics::ForceReason reason = haptics::ForceReason::User,
            bool live = true) {
    haptics::Snapshot snapshot;
    snapshot.X_WP.translation() = snapshot.X_WD.translation() = Vec3{0.0, -0.03, 0.0};
    snapshot.force_state = state;
    snapshot.reason = reason;
    snapshot.felt_W.force = state == haptics::ForceState::On ? Vec3{0.0, -1.5, 0.0} : Vec3::Zero();
    if (live) snapshot.policy = haptics::SchedulingPolicy::Ordinary;
    window.views().display(snapshot);
    window.touch().display(snapshot);
    QTest::qWait(30);
  }
  std::string state() { return window.findChild<QLabel*>("forceStateBar")->text().toStdString(); }
  QLabel* sentence() { return window.findChild<QLabel*>("stopped"); }
  QPushButton* resume() { return window.findChild<QPushButton*>("forceOn"); }

  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
};

TEST(MainWindow, SaysTheStateOfTheForceOnceAndOffersOneWayOn) {
  using haptics::ForceReason, haptics::ForceState;
  Told t;
  int wishes = 0, resumed = 0;
  QObject::connect(&t.window.touch(), &ui::TouchState::forceOffWanted, [&] { ++wishes; });
  QObject::connect(&t.window.touch(), &ui::TouchState::forceOnWanted, [&] { ++resumed; });
  const auto* stop = t.window.findChild<QToolButton*>("forceOff");
  EXPECT_EQ(stop->text(), "STOP FORCE");
  // of a mouse nothing is felt
  t.tell(ForceState::On);
  EXPECT_EQ(t.state(), "Force shown, not felt");
  EXPECT_FALSE(t.resume()->isVisible());
  // Escape where nothing has been stopped yet, and then who stopped it
  const QRect views = t.window.views().layout().geometry();
  QTest::keyClick(&t.window.views().volume(), Qt::Key_Escape);
  EXPECT_GT(wishes, 0);
  t.tell(ForceState::Ready);
  EXPECT_EQ(t.state(), "Force stopped");
  ASSERT_TRUE(t.sentence()->isVisible());
  EXPECT_EQ(t.sentence()->text(), "Force stopped by Escape");
  EXPECT_EQ(t.window.views().layout().geometry(), views) << "the sentence moved the views";
  const QWidget& bar = *t.sentence()->parentWidget();
  const QWidget& space = t.window.views().volume();
  EXPECT_EQ(bar.mapTo(&t.window, QPoint{}).x(), space.mapTo(&t.window, QPoint{}).x());
  EXPECT_LT(bar.width(), space.width() - 90) << "it hides the cube, or what slices say";
  const auto* larger = space.parentWidget()->findChild<QToolButton*>("maximise");
  ASSERT_NE(larger, nullptr);
  EXPECT_GE(bar.mapTo(&t.window, QPoint{}).y(),
            larger->mapTo(&t.window, QPoint{0, larger->height()}).y());
  EXPECT_EQ(t.resume()->text(), "Resume");
  EXPECT_TRUE(stop->isVisible());
  window::keep(window::pictureOf(t.window), "main_window_stopped");
  // a press more does not change who it was
  QTest::keyClick(&t.window.views().volume(), Qt::Key_Space);
  t.tell(ForceState::Ready);
  EXPECT_EQ(t.sentence()->text(), "Force stopped by Escape");
  QTest::mouseClick(t.resume(), Qt::LeftButton);
  EXPECT_EQ(resumed, 1);
  t.tell(ForceState::Ramping);
  EXPECT_EQ(t.state(), "Force rising");
  EXPECT_FALSE(t.sentence()->isVisible());
  t.tell(ForceState::On);
  QTest::keyClick(&t.window.views().volume(), Qt::Key_Space);
  t.tell(ForceState::Ready);
  EXPECT_EQ(t.sentence()->text(), "Force stopped by Space");

  // a device is felt, and armed first
  t.window.touch().setHand("omega.6", ui::Feel::Felt);
  t.tell(ForceState::Ready);
  EXPECT_EQ(t.state(), "Force off");
  EXPECT_EQ(t.resume()->text(), "Arm");
  t.tell(ForceState::On);
  EXPECT_EQ(t.state(), "Force on");
  t.tell(ForceState::Fault, ForceReason::Jump);
  EXPECT_EQ(t.state(), "Fault: no force");
  EXPECT_EQ(t.resume()->text(), "Arm again");
  window::keep(window::pictureOf(t.window), "main_window_fault");
  t.tell(ForceState::Fault, ForceReason::Lost);
  EXPECT_FALSE(t.resume()->isVisible());  // what is gone is not armed
  t.window.touch().setHand("SpaceMouse", ui::Feel::Nothing);
  t.tell(ForceState::Ready);
  EXPECT_EQ(t.state(), "No motors, no force");
  EXPECT_FALSE(t.resume()->isVisible());
  // what is shown of a recording is no force now
  t.window.touch().setHand("omega.6", ui::Feel::Felt);
  t.tell(ForceState::On, ForceReason::User, false);
  EXPECT_EQ(t.state(), "Replay");
  const auto* chip = t.window.findChild<QLabel*>("forceStateBar");
  EXPECT_EQ(chip->sizeHint(), chip->minimumSizeHint());  // and no hand stands behind it
  EXPECT_FALSE(t.resume()->isVisible());
  // the words stand in one place: nothing else on the window says on or off
  int said = 0;
  for (const QLabel* label : t.window.findChildren<QLabel*>())
    said += label->isVisible() && label->text().contains("Force ", Qt::CaseInsensitive);
  EXPECT_EQ(said, 0);
}

TEST(MainWindow, TheStateOfTheForceHasTheDeviceAndItsRateBesideIt) {
  ui::MainWindow window;
  const auto& chip = window.bar().force();
  QString card;  // which shows the same
  QObject::connect(&window.touch(), &ui::TouchState::handNamed, &window,
                   [&](const QString& words) { card = words; });
  window.touch().setHand("omega.6", ui::Feel::Felt);
  EXPECT_EQ(chip.detail(), "omega.6");
  haptics::Snapshot snapshot;
  snapshot.policy = haptics::SchedulingPolicy::RealTime;
  snapshot.force_state = haptics::ForceState::On;
  snapshot.servo_rate = 998.7;
  window.touch().display(snapshot);
  EXPECT_EQ(chip.text(), "Force on");
  EXPECT_EQ(chip.detail(), "omega.6 · 1 kHz");
  EXPECT_EQ(card, "omega.6 · 1 kHz");
  // another hand, whose loop is slower, and then does not run
  window.touch().setHand("Falcon", ui::Feel::Felt);
  const auto says = [&](const char* detail) {
    return window::waitFor([&] {
      window.touch().display(snapshot);
      return chip.detail() == detail;
    });
  };
  snapshot.servo_rate = 612.0;
  EXPECT_TRUE(says("Falcon · 0.6 kHz"));
  snapshot.policy = haptics::SchedulingPolicy::NotStarted;
  EXPECT_TRUE(says("Falcon")) << chip.detail().toStdString();
  window::showAndWait(window, {1280, 800});
  EXPECT_GE(chip.width(), chip.sizeHint().width());
  window::keep(window::pictureOf(window), "force_chip");
}

TEST(MainWindow, TheLineOfTheScanShortensItsNameInTheMiddle) {
  ui::ScanLine line;
  const QString name = "Temporal_bone_of_a_long_study_left_0.2mm.nrrd";
  line.setScan(name, "10 × 10 × 10 voxels");
  const auto seenIn = [&](int width) {
    line.resize(width, 20);
    return line.seen();
  };
  EXPECT_EQ(seenIn(2000), name + " · 10 × 10 × 10 voxels");
  for (const int width : {300, 60}) {
    const QString seen = seenIn(width);
    EXPECT_LE(line.fontMetrics().horizontalAdvance(seen), width);
    EXPECT_TRUE(seen.startsWith("T")) << seen.toStdString();
    EXPECT_EQ(seen.contains("voxels"), width == 300) << seen.toStdString();
    EXPECT_TRUE(seen.contains(QChar(0x2026)));
  }
  EXPECT_TRUE(line.toolTip().contains(name));
  // drawn as it is said
  line.resize(300, 20);
  const QImage image = line.grab().toImage();
  line.setScan(line.seen().section(" · ", 0, 0), "10 × 10 × 10 voxels");
  EXPECT_EQ(line.grab().toImage(), image);
}

TEST(MainWindow, TheMeansOfDrawingTheSurfaceIsMarked) {
  ui::MainWindow window;
  const QList<QAction*> means = window.findChild<QMenu*>("surfaceMenu")->actions();
  ASSERT_EQ(means.size(), 3);
  for (QAction* chosen : {means[0], means[2], means[1]}) {
    if (chosen != means[0]) chosen->trigger();
    for (const QAction* one : means) EXPECT_EQ(one->isChecked(), one == chosen);
  }
}

TEST(MainWindow, SaysThatWhatIsDraggedOverItWillOpen) {
  ui::MainWindow window;
  window::showAndWait(window, {1000, 700});
  const auto* area = window.findChild<QWidget*>("dropArea");
  EXPECT_FALSE(area->isVisible());
  QMimeData words, file;
  words.setText("no file");
  file.setUrls({QUrl::fromLocalFile(QDir::tempPath())});
  const auto enter = [&](const QMimeData& data) {
    QDragEnterEvent event({500, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
  };
  enter(words);
  EXPECT_FALSE(area->isVisible());
  enter(file);
  EXPECT_TRUE(area->isVisible());
  window::keep(window::pictureOf(window), "drop_area");
  QDragLeaveEvent leave;
  QCoreApplication::sendEvent(&window, &leave);
  EXPECT_FALSE(area->isVisible());
  enter(file);
  QSignalSpy dropped(&window, &ui::MainWindow::dropped);
  QDropEvent drop({500, 300}, Qt::CopyAction, &file, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &drop);
  EXPECT_EQ(dropped.count(), 1);
  EXPECT_FALSE(area->isVisible());
}

TEST(MainWindow, TheStatusLineSaysWhereItIsCut) {
  ui::StatusLine line;
  line.setHand("a device with a long name, and numbers behind it: 12345");
  line.show();
  line.resize(150, 24);
  const QImage cut = window::pictureOf(line);
  QLabel said;
  said.setFont(line.font());
  said.setText(line.fontMetrics().elidedText(line.text(), Qt::ElideRight, 150));
  EXPECT_TRUE(said.text().endsWith(QChar(0x2026)));
  said.show();
  said.resize(150, 24);
  EXPECT_EQ(cut, window::pictureOf(said));
}

TEST(MainWindow, LooksForTheNextScanWhereTheLastOneLies) {
  const QTemporaryDir folder;
  ASSERT_TRUE(QDir(folder.path()).mkdir("scan"));
  ui::MainWindow window;
  window.menus().setPlace(folder.filePath("scan"));
  for (const char* name : {"openFolder", "openFile"}) {
    QString begins;
    QTimer::singleShot(0, [&] {
      if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
        begins = dialog->directory().absolutePath();
        dialog->reject();
      }
    });
    window.findChild<QAction*>(name)->trigger();
    EXPECT_EQ(begins, QDir(folder.path()).absolutePath()) << name;
  }
  // and for a view where the last one was saved
  const QTemporaryDir views;
  QFileDialog saved;
  ui::askForOutput(saved, "Views (*.palpate-view)", "palpate-view");
  emit saved.fileSelected(views.filePath("a.palpate-view"));
  QString begins;
  QTimer::singleShot(0, [&] {
    if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      begins = dialog->directory().absolutePath();
      dialog->reject();
    }
  });
  window.findChild<QAction*>("openView")->trigger();
  EXPECT_EQ(begins, QDir(views.path()).absolutePath());
}

TEST(MainWindow, SaysThatItRecordsAsLongAsItDoes) {
  Told t;
  auto* chip = t.window.findChild<QLabel*>("recordingChip");
  EXPECT_FALSE(chip->isVisible());
  t.window.bar().showRecording(12.9);
  QTest::qWait(50);
  EXPECT_EQ(chip->text(), "REC 0:12");
  EXPECT_EQ(chip->visibleRegion().boundingRect().size(), chip->size());
  window::keep(window::pictureOf(t.window), "main_window_recording");
  // in the smallest window, too
  t.window.resize(t.window.minimumSizeHint());
  QTest::qWait(100);
  EXPECT_EQ(chip->visibleRegion().boundingRect().size(), chip->size());
  EXPECT_GE(chip->width(), chip->minimumSizeHint().width());
  t.window.bar().showRecording(std::nullopt);
  EXPECT_FALSE(chip->isVisible());
}

TEST(MainWindow, TheStopButtonFillsUnderThePointerOnlyWhileThereIsAForce) {
  Told t;
  auto* stop = t.window.findChild<QToolButton*>("forceOff");
  const auto filled = [&] {
    return window::count(window::pictureOf(*stop), [](QColor c) {
             return c.rgb() == ui::style::kDark.stop_fill.rgb();
           }) > 1'000;
  };
  t.window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&t.window, 120'000));
  t.tell(haptics::ForceState::On);
  EXPECT_FALSE(filled());
  stop->setFocus(Qt::TabFocusReason);
  EXPECT_TRUE(filled());
  window::keep(window::pictureOf(t.window), "main_window_stop_focus");
  t.tell(haptics::ForceState::Ready);
  EXPECT_FALSE(filled());
}

TEST(MainWindow, WearsEveryThemeAndItsViewsStayDark) {
  Told t;
  t.tell(haptics::ForceState::On);
  const auto* rail = t.window.findChild<QWidget*>("rail");
  const auto ground = [&] {
    const QImage image = window::pictureOf(t.window);
    return image.pixelColor(rail->mapTo(&t.window, QPoint{4, rail->height() - 20}));
  };
  int chosen = 0;
  QObject::connect(&t.window.menus(), &ui::Menus::themeChanged, [&] { ++chosen; });
  for (const ui::style::Theme theme :
       {ui::style::Theme::Light, ui::style::Theme::HighContrast, ui::style::Theme::Dark}) {
    const QString name = ui::style::nameOf(theme);
    t.window.findChild<QAction*>("theme_" + name)->trigger();
    QTest::qWait(100);
    EXPECT_EQ(ui::style::theme(), theme);
    EXPECT_EQ(ground().rgb(), ui::style::coloursOf(theme).ground.rgb()) << name.toStdString();
    const QImage view = window::pictureAtRest(t.window.views().volume());
    EXPECT_LT(view.pixelColor(5, view.height() / 3).lightness(), 30) << name.toStdString();
    window::keep(window::pictureOf(t.window), ("main_window_" + name).toUtf8());
  }
  EXPECT_EQ(chosen, 3);
}

TEST(MainWindow, FitsASmallScreenAndALargeOne) {
  Told t({1366, 738});  // 768 less a title bar
  EXPECT_LE(t.window.minimumSizeHint().width(), 1366);
  EXPECT_LE(t.window.minimumSizeHint().height(), 738);
  for (const QSize size : {QSize(1366, 738), QSize(3840, 2130)}) {
    t.window.resize(size);
    QTest::qWait(150);
    const QRect all = t.window.rect();
    auto* bar = t.window.findChild<QWidget*>("forceBar");
    int left = 0;  // no part of the bar lies over another
    QList<QWidget*> parts = bar->findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    std::ranges::sort(parts, {}, &QWidget::x);
    for (QWidget* part : parts) {
      if (!part->isVisible()) continue;
      EXPECT_GE(part->x(), left) << part->objectName().toStdString();
      left = part->geometry().right() + 1;
      EXPECT_GE(part->width(), part->minimumSizeHint().width()) << part->objectName().toStdString();
    }
    EXPECT_LE(left, bar->width());
    for (const char* name : {"forceOff", "forceStateBar", "forceCard", "rail", "details"}) {
      auto* part = t.window.findChild<QWidget*>(name);
      EXPECT_EQ(part->visibleRegion().boundingRect().size(), part->size()) << name;
      EXPECT_TRUE(all.contains(QRect(part->mapTo(&t.window, QPoint{}), part->size()))) << name;
    }
    // the anatomy has the most of it
    EXPECT_GT(double(t.window.views().layout().width()) * t.window.views().layout().height(),
              0.55 * size.width() * size.height());
    window::keep(window::pictureOf(t.window), QString("main_window_%1").arg(size.width()).toUtf8());
  }
}

TEST(MainWindow, RemembersItsPanelsAndGivesTheFirstOnesBack) {
  ui::WindowLayout first, moved;
  {
    Told t;
    first = t.window.layoutState();
    EXPECT_EQ(first.panels.tab, "touch");
    QTest::mouseClick(t.window.findChild<QAbstractButton*>("deviceTab"), Qt::LeftButton);
    auto* surface = t.window.findChild<ui::Section*>("surfaceSection");
    surface->findChild<QAbstractButton*>("sectionHead")->click();
    EXPECT_TRUE(surface->folded());
    t.window.findChild<QToolButton*>("details")->click();
    EXPECT_TRUE(t.window.findChild<QLabel*>("statusLine")->isVisible());
    auto* splitter = t.window.findChild<QSplitter*>("panelSplitter");
    splitter->setSizes({360, splitter->width() - 360});
    emit t.window.views().layout().findChildren<ui::ViewGap*>().front()->moved(40);
    moved = t.window.layoutState();
    app::Preferences preferences = app::loadPreferences();
    preferences.layout = moved;
    preferences.theme = "light";
    app::savePreferences(preferences);
  }
  EXPECT_EQ(app::loadPreferences().layout, moved);
  EXPECT_EQ(app::loadPreferences().theme, "light");
  Told t;
  t.window.restoreLayout(app::loadPreferences().layout);
  const ui::WindowLayout now = t.window.layoutState();
  EXPECT_EQ(now.panels, moved.panels);
  EXPECT_EQ(now.borders, moved.borders);
  EXPECT_TRUE(now.details);
  EXPECT_NEAR(now.panel_width, moved.panel_width, 3);
  EXPECT_TRUE(t.window.findChild<ui::Section*>("surfaceSection")->folded());
  // nonsense changes nothing
  t.window.restoreLayout({.views = "round",
                          .borders = "1 1|x",
                          .panels = {.tab = "kitchen", .folded = {"nobody"}},
                          .panel_width = 0,
                          .details = true});
  EXPECT_EQ(t.window.layoutState().panels, moved.panels);
  EXPECT_EQ(t.window.layoutState().borders, moved.borders);
  t.window.findChild<QAction*>("resetLayout")->trigger();
  EXPECT_EQ(t.window.layoutState().panels, first.panels);
  EXPECT_EQ(t.window.layoutState().borders, first.borders);
  EXPECT_FALSE(t.window.layoutState().details);
  EXPECT_NEAR(t.window.layoutState().panel_width, first.panel_width, 3);
  QSettings().remove("window");
}

TEST(MainWindow, TheFrictionIsAListWithNumbers) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  window::showAndWait(window, {1240, 840});
  double wished = -1.0;
  QObject::connect(&panelled.hand.panel(), &ui::DevicePanel::frictionChanged,
                   [&](double coefficient) { wished = coefficient; });
  auto* friction = window.findChild<QComboBox*>("friction");
  EXPECT_EQ(friction->currentText(), "none");
  friction->setFocus();
  for (const double coefficient : {0.1, 0.3, 0.6, 1.0}) {
    QTest::keyClick(friction, Qt::Key_Down);
    EXPECT_EQ(wished, coefficient);
    EXPECT_TRUE(friction->currentText().endsWith(QLocale().toString(coefficient, 'f', 1)))
        << friction->currentText().toStdString();
  }
  EXPECT_LE(wished, haptics::kFrictionRange.most);
}

}  // namespace
