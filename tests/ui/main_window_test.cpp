// SPDX-License-Identifier: BSD-3-Clause
#include "ui/main_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <cmath>
#include <functional>

#include "panelled_window.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/volume_view.h"
#include "window_support.h"

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

TEST(MainWindow, EscapeAnywhereSpaceInTheViewAndTheRedButtonWishTheForceOff) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(ctPicture(), 300.0, "Ball");
  window::showAndWait(window, {1240, 840});
  int wishes = 0;
  QObject::connect(&window, &ui::MainWindow::forceOffWanted, [&] { ++wishes; });
  const auto wished = [&] { return std::exchange(wishes, 0) > 0; };

  auto* red = window.findChild<QToolButton*>("forceOff");
  ASSERT_TRUE(red && red->isVisible());
  QTest::mouseClick(red, Qt::LeftButton);
  EXPECT_TRUE(wished());
  QTest::keyClick(&window.view(), Qt::Key_Space);
  EXPECT_TRUE(wished());
  for (QWidget* focus :
       {static_cast<QWidget*>(&window.view()),
        static_cast<QWidget*>(&window.slice(ui::Plane::Axial)),
        static_cast<QWidget*>(window.findChild<QDoubleSpinBox*>("isovalueTyped"))}) {
    QTest::keyClick(focus, Qt::Key_Escape);
    EXPECT_TRUE(wished());
  }
  // with a modal dialog in front; Escape closes it as well
  QDialog dialog(&window);
  QTimer::singleShot(200, &dialog, [&] { QTest::keyClick(&dialog, Qt::Key_Escape); });
  QTimer::singleShot(5'000, &dialog, [&] { dialog.done(77); });
  EXPECT_EQ(dialog.exec(), QDialog::Rejected);
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
    return window.askWhether("The slices are tilted.", "They are resampled.", "Resample");
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
  window.view().setSurfaceWish(ui::SurfaceMode::Mesh);
  panelled.show(ctPicture(), 300.0, "Ball");
  window::showAndWait(window, {1240, 840});
  double felt = 0.0;
  QObject::connect(&panelled.isosurface, &app::IsosurfaceController::changed,
                   [&](double s) { felt = s; });
  const QImage before = window::pictureAtRest(window.view());
  auto* slider = window.findChild<ui::HistogramSlider*>("isovalueSlider");
  const int x = static_cast<int>(std::lround(slider->width() * 0.35));
  QTest::mouseClick(slider, Qt::LeftButton, {}, {x, slider->height() / 2});
  EXPECT_NEAR(felt, slider->intensityAt(slider->value()), 1.0);
  EXPECT_LT(felt, 0.0);
  const QImage after = window::pictureAtRest(window.view());
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
  QTest::mouseClick(skin, Qt::LeftButton);
  EXPECT_EQ(felt, -300.0);
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

TEST(MainWindow, SaysForceAndServoAndPlotsThem) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(ctPicture(), 300.0, "Ball");
  window.show(window::octahedron(0.003));
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
  window.display(snapshot);
  std::vector<haptics::ForceSample> points;
  for (int i = 0; i < 12'000; ++i) {
    const double t = i * 1e-3;
    const bool spike = i == 8'000;  // one tick among ten thousand is still seen
    points.push_back({t, spike ? 9.5F : static_cast<float>(2.0 + std::sin(t)), 0.02F});
  }
  panelled.picture.appendForces(points);
  const QImage image = window::pictureOf(window);
  window::keep(image, "main_window_force");
  EXPECT_EQ(window.findChild<QLabel*>("forceNow")->text(), "5.00 N");
  const QString status = window.findChild<QLabel*>("statusLine")->text();
  for (const char* part :
       {"1000 Hz", "real-time", "42 µs", "7 contacts", "5.00 N", "Surface: mesh"})
    EXPECT_TRUE(status.contains(QString::fromUtf8(part))) << status.toStdString();
  EXPECT_FLOAT_EQ(window.findChild<ui::ForcePlot*>("forcePlot")->greatestForce(), 9.5F);
}

TEST(MainWindow, TheFrictionThatIsTypedIsWished) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  window::showAndWait(window, {1240, 840});
  double wished = -1.0;
  QObject::connect(&panelled.hand.panel(), &ui::DevicePanel::frictionChanged,
                   [&](double coefficient) { wished = coefficient; });
  auto* friction = window.findChild<QDoubleSpinBox*>("friction");
  EXPECT_EQ(friction->value(), 0.0);
  friction->setFocus();
  friction->selectAll();
  QTest::keyClicks(friction, QLocale().toString(0.3));
  QTest::keyClick(friction, Qt::Key_Return);
  EXPECT_EQ(wished, 0.3);
  friction->setValue(9.0);
  EXPECT_EQ(wished, 1.5);  // no rougher than the settings allow
}

}  // namespace
