// SPDX-License-Identifier: BSD-3-Clause
#include "app/application.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "haptics/session.h"
#include "tests/support/made_scans.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/section.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/edit_panel.h"
#include "ui/panels/histogram_slider.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/side_panel.h"
#include "ui/window/top_bar.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::ForceState;
using window::expectNothingCut;
using window::sphereInHand;
using window::waitFor;

constexpr double kSlewOfTick_N = 12.0 / 20.0;  // rated force within 20 ms

// Every tick's force, as the plot gets them, of at least so many ticks, in which no event is
// handled: the application's own timer would take them first.
std::vector<double> forcesOfTicks(haptics::Session& session, std::size_t ticks) {
  std::vector<double> forces;
  std::vector<haptics::ForceSample> samples(1024);
  do {
    while (const std::size_t count = session.forces(samples))
      for (std::size_t i = 0; i < count; ++i) forces.push_back(samples[i].force);
    if (forces.size() < ticks) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  } while (forces.size() < ticks);
  return forces;
}

TEST(Application, AHandPressesOnASphereAndEscapeDropsTheForce) {
  app::Application application(sphereInHand("tap"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
  window::keep(window::pictureOf(application.window()), "application_touching");
  forcesOfTicks(application.session(), 0);
  QTest::keyClick(&application.window().views().volume(), Qt::Key_Escape);
  // what was sent until the key was handled; after it, a tick under way may still end
  forcesOfTicks(application.session(), 0);
  const std::vector<double> after = forcesOfTicks(application.session(), 300);
  EXPECT_LE(std::count_if(after.begin(), after.end(), [](double f) { return f != 0.0; }), 1);
  EXPECT_TRUE(waitFor([&] { return application.snapshot().force_state == ForceState::Ready; }));
  EXPECT_EQ(application.snapshot().felt_W.force.norm(), 0.0);
  // it stays off, whatever the hand does, until the user wants it again
  window::afterTicks(application, 1'000);
  EXPECT_EQ(application.snapshot().felt_W.force.norm(), 0.0);
  QTest::mouseClick(application.window().findChild<QAbstractButton*>("forceOn"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
}

TEST(Application, NothingInAPanelIsCutAtTheFirstSizeOfTheWindow) {
  app::Application application(sphereInHand("mouse"));
  application.start();
  ui::MainWindow& window = application.window();
  window.resize(1280, 900);
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  int looked = 0;
  auto* side = window.findChild<ui::SidePanel*>("sidePanel");
  for (ui::Section* section : window.findChildren<ui::Section*>()) section->setFolded(false);
  for (const char* tab : {"scanTab", "touchTab", "deviceTab", "recordTab"}) {
    QTest::mouseClick(window.findChild<QAbstractButton*>(tab), Qt::LeftButton);
    QTest::qWait(100);
    looked += window::expectNothingBeside(*side, tab);
    window::keep(window::pictureOf(window), QString("application_%1").arg(tab).toUtf8());
  }
  window.panels().reveal(window.findChild<ui::EditPanel*>());
  for (const char* tool : {"cropTool", "planeTool", "piecesTool", "holderTool", "scalpelTool"}) {
    QTest::mouseClick(window.findChild<QToolButton*>(tool), Qt::LeftButton);
    QTest::qWait(100);
    looked += window::expectNothingBeside(*side, tool);
    window::keep(window::pictureOf(window), tool);
  }
  // with every choice that can come up
  for (const ui::EditConfirm confirm : {ui::EditConfirm::Piece, ui::EditConfirm::Removal}) {
    window.findChild<ui::EditPanel*>()->showPreview("This piece is as large as it is.", confirm);
    QTest::qWait(100);
    looked += window::expectNothingBeside(*side, "preview");
  }
  EXPECT_GT(looked, 150);
  // the views keep most of the window
  EXPECT_GT(window.views().layout().width(), 0.7 * window.width());
}

// ctest runs it at other scales, too
TEST(Application, NothingIsCutInAnyTabAtAnyScale) {
  app::Application application(sphereInHand("tap"));
  application.start();
  ui::MainWindow& window = application.window();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  window.resize(1280, 700);
  window.bar().showRecording(3'725.0);
  for (ui::Section* section : window.findChildren<ui::Section*>()) section->setFolded(false);
  const auto scale = int(std::lround(window.devicePixelRatioF() * 100.0));
  for (const char* tab : {"scanTab", "touchTab", "deviceTab", "recordTab"}) {
    QTest::mouseClick(window.findChild<QAbstractButton*>(tab), Qt::LeftButton);
    if (QString(tab) == "deviceTab") {  // devices are looked for, and their list changes
      auto* devices = window.findChild<QTreeWidget*>("deviceList");
      ASSERT_TRUE(waitFor([&] { return devices->topLevelItemCount() > 0; }));
    }
    QTest::qWait(100);
    EXPECT_EQ(window.size(), QSize(1280, 700)) << tab;
    expectNothingCut(window, tab);
    window.grab().save(QDir::tempPath() + "/palpate-window-tests/" +
                       QString("scale_%1_%2.png").arg(scale).arg(tab));
  }
  ASSERT_TRUE(waitFor([&] { return application.snapshot().force_state == ForceState::On; }));
  QTest::keyClick(&window.views().volume(), Qt::Key_Escape);
  auto* resume = window.findChild<QAbstractButton*>("forceOn");
  ASSERT_TRUE(waitFor([&] { return resume->isVisible(); }));
  QTest::qWait(50);
  expectNothingCut(window, "stopped");
}

TEST(Application, TheMouseMovesTheDeviceThroughTheSurfaceAndTheProxyStays) {
  app::Application application(sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::VolumeView& view = application.window().views().volume();
  const auto push = [&](int notches) {
    QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 120 * notches}, {},
                      {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
  };
  view.setMouseMode(ui::MouseMode::Hand);
  // 2 mm a notch; the tool waits some millimetres off. Pushed on, it would slide off the ball
  for (int i = 0; i < 20 && application.snapshot().felt_W.force.norm() < 0.5; ++i) {
    push(1);
    window::afterTicks(application, 200);
  }
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.3; }));
  window::afterTicks(application, 500);
  const haptics::Snapshot snapshot = application.snapshot();
  const haptics::Vec3 between = snapshot.X_WP.translation() - snapshot.X_WD.translation();
  EXPECT_LT(between.y(), -0.2e-3);  // the proxy stays in front of the device
  EXPECT_GT(snapshot.felt_W.force.dot(between), 0.0);
  EXPECT_GT(snapshot.contacts, 0);
  const QImage image = window::pictureAtRest(view);
  window::keep(window::pictureOf(application.window()), "application_mouse");
  EXPECT_GT(window::count(image, window::deviceColoured), 10);

  // the surface moved under the tool: the force changes, and not by a jump
  auto* slider = application.window().findChild<ui::HistogramSlider*>("isovalueSlider");
  slider->setFocus();
  for (const Qt::Key key : {Qt::Key_PageUp, Qt::Key_PageDown}) {
    std::vector<double> forces = forcesOfTicks(application.session(), 100);
    QTest::keyClick(slider, key);
    const std::vector<double> after = forcesOfTicks(application.session(), 1'500);
    forces.insert(forces.end(), after.begin(), after.end());
    double steepest = 0.0;
    for (std::size_t i = 1; i < forces.size(); ++i)
      steepest = std::max(steepest, std::abs(forces[i] - forces[i - 1]));
    EXPECT_LE(steepest, kSlewOfTick_N + 0.01) << "key " << key;
    const auto [least, greatest] = std::minmax_element(forces.begin(), forces.end());
    EXPECT_GT(*greatest - *least, 0.05) << "key " << key;
  }
}

TEST(Application, KeepsTheOldVolumeWhenTheNewOneCannotBeRead) {
  app::Application application(sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  const auto scene = application.snapshot().scene;
  QSignalSpy refused(&application, &app::Application::finished);
  emit application.window().menus().openWanted("/nowhere/at/all.nrrd");
  ASSERT_TRUE(waitFor([&] { return refused.count() > 0; }));
  EXPECT_EQ(refused.first().first().toInt(), 3);
  QTest::qWait(100);
  EXPECT_EQ(application.snapshot().scene, scene);
}

TEST(Application, SaysInItsTitleThatAScanWasResampled) {
  const auto scan = support::anyScans() / "dicom_oddities/series_failing/gantrytilting";
  app::Arguments arguments = sphereInHand("mouse");
  arguments.load.phantom = {};
  arguments.load.path = scan;
  arguments.load.geometry = datasets::Geometry::Corrected;
  app::Application application(arguments);
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  EXPECT_TRUE(application.window().windowTitle().startsWith("gantrytilting (resampled)"))
      << application.window().windowTitle().toStdString();
}

TEST(Application, AnIsovalueThatTheVolumeHasNotIsReplacedEverywhereAndSaid) {
  app::Arguments arguments = sphereInHand("mouse");
  arguments.load.isovalue = 1e9;
  app::Application application(std::move(arguments));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  auto* typed = application.window().findChild<QDoubleSpinBox*>("isovalueTyped");
  EXPECT_LT(typed->value(), 1e9);
  EXPECT_EQ(application.snapshot().isovalue, typed->value());
  auto* message = application.window().findChild<QLabel*>("message");
  EXPECT_TRUE(message->isVisible());
  EXPECT_TRUE(message->text().contains("instead of")) << message->text().toStdString();
}

TEST(Application, AnotherToolKeepsTheIsovalueThatMovedMeanwhile) {
  app::Application application(sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  const auto scene = application.snapshot().scene;
  emit window::panelOf<ui::DevicePanel>(application.window()).toolChosen("wrench");
  auto* slider = application.window().findChild<ui::HistogramSlider*>("isovalueSlider");
  QTest::keyClick(slider, Qt::Key_PageUp);
  const double chosen = application.window().findChild<QDoubleSpinBox*>("isovalueTyped")->value();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene > scene; }));
  window::afterTicks(application, 50);
  EXPECT_EQ(application.snapshot().isovalue, chosen);
}

TEST(Application, AnotherFieldIsTouchedLiveAndItsEffectSaid) {
  app::Application application(sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  auto* effect = application.window().findChild<QLabel*>("fieldEffect");
  EXPECT_FALSE(effect->isVisible());
  auto scene = application.snapshot().scene;
  emit window::panelOf<ui::DevicePanel>(application.window()).fieldChosen("spline");
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene > scene; }));
  EXPECT_TRUE(effect->isVisible());
  EXPECT_TRUE(effect->text().contains("erases")) << effect->text().toStdString();
  // it stays with another tool, and ends where the voxels themselves are wanted again
  scene = application.snapshot().scene;
  emit window::panelOf<ui::DevicePanel>(application.window()).toolChosen("wrench");
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene > scene; }));
  EXPECT_TRUE(effect->isVisible());
  scene = application.snapshot().scene;
  emit window::panelOf<ui::DevicePanel>(application.window()).fieldChosen("trilinear");
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene > scene; }));
  EXPECT_FALSE(effect->isVisible());
}

TEST(Application, ThePictureOfTheCommandLineHasWhatIsDrawnOverTheView) {
  const QTemporaryDir folder;
  app::Arguments arguments = sphereInHand("mouse");
  arguments.screenshot = folder.filePath("window.png").toStdString();
  arguments.screenshot_after = 1.0;
  app::Application application(arguments);
  QSignalSpy finished(&application, &app::Application::finished);
  application.start();
  ASSERT_TRUE(waitFor([&] { return finished.count() > 0; }));
  EXPECT_EQ(finished[0][0].toInt(), 0);
  const QImage image(folder.filePath("window.png"));
  ui::MainWindow& window = application.window();
  ASSERT_EQ(image.size(), window.size());
  // the letters of the 3-D view, at its left and right edge
  const QRect view(window.views().volume().mapTo(&window, QPoint{}),
                   window.views().volume().size());
  const auto yellow = [](QColor c) { return c.red() > 170 && c.green() > 130 && c.blue() < 90; };
  const QRect left(view.left(), view.center().y() - 20, 30, 40);
  EXPECT_GT(window::count(image.copy(left), yellow), 20);
  EXPECT_GT(window::count(image.copy(left.translated(view.width() - 30, 0)), yellow), 20);
}

}  // namespace
