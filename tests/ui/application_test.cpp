// SPDX-License-Identifier: BSD-3-Clause
#include "app/application.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "ui/panels/histogram_slider.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/volume_view.h"
#include "window_support.h"

namespace {

using haptics::ForceState;

app::Arguments sphere(const char* hand) {
  app::Arguments arguments;
  arguments.load.phantom = "sphere";
  arguments.hand = hand;
  arguments.surface = ui::SurfaceMode::Mesh;
  arguments.screenshot = "unused";  // neither notice nor preferences of the user
  arguments.screenshot_after = 3'600.0;
  arguments.notice = false;
  return arguments;
}

// runs until `done` or for at most so many seconds
bool waitFor(const std::function<bool()>& done, double seconds) {
  for (int i = 0; i < seconds * 100.0 && !done(); ++i) QTest::qWait(10);
  return done();
}

TEST(Application, AHandPressesOnASphereAndEscapeDropsTheForce) {
  app::Application application(sphere("tap"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }, 60.0));
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }, 20.0));
  window::keep(window::pictureOf(application.window()), "application_touching");
  QTest::keyClick(&application.window().view(), Qt::Key_Escape);
  QTest::qWait(100);
  EXPECT_EQ(application.snapshot().force_state, ForceState::Off);
  EXPECT_EQ(application.snapshot().felt_W.force.norm(), 0.0);
  // it stays off, whatever the hand does, until the user wants it again
  QTest::qWait(1'000);
  EXPECT_EQ(application.snapshot().felt_W.force.norm(), 0.0);
  QTest::mouseClick(application.window().findChild<QAbstractButton*>("forceOn"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }, 20.0));
}

TEST(Application, TheMouseMovesTheDeviceThroughTheSurfaceAndTheProxyStays) {
  app::Application application(sphere("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }, 60.0));
  ui::VolumeView& view = application.window().view();
  const auto push = [&](int notches) {
    QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 120 * notches}, {},
                      {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
  };
  // 2 mm a notch; the tool waits some millimetres off
  for (int i = 0; i < 20 && application.snapshot().felt_W.force.norm() < 1.0; ++i) {
    push(1);
    QTest::qWait(200);
  }
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.3; }, 5.0));
  QTest::qWait(500);
  const haptics::Snapshot snapshot = application.snapshot();
  const haptics::Vec3 between = snapshot.X_WP.translation() - snapshot.X_WD.translation();
  EXPECT_LT(between.y(), -0.5e-3);  // the proxy stays in front of the device
  EXPECT_GT(snapshot.felt_W.force.dot(between), 0.0);
  EXPECT_GT(snapshot.contacts, 0);
  const QImage image = window::pictureAtRest(view);
  window::keep(window::pictureOf(application.window()), "application_mouse");
  EXPECT_GT(window::count(image, window::deviceColoured), 10);

  // the surface moved under the tool: the force changes, and not by a jump
  const double before = application.snapshot().felt_W.force.norm();
  auto* slider = application.window().findChild<ui::HistogramSlider*>("isovalueSlider");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageUp);
  EXPECT_TRUE(waitFor(
      [&] { return std::abs(application.snapshot().felt_W.force.norm() - before) > 0.01; }, 5.0));
}

TEST(Application, KeepsTheOldVolumeWhenTheNewOneCannotBeRead) {
  app::Application application(sphere("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }, 60.0));
  const auto scene = application.snapshot().scene;
  QSignalSpy refused(&application, &app::Application::finished);
  emit application.window().openWanted("/nowhere/at/all.nrrd");
  ASSERT_TRUE(waitFor([&] { return refused.count() > 0; }, 10.0));
  EXPECT_EQ(refused.first().first().toInt(), 3);
  QTest::qWait(100);
  EXPECT_EQ(application.snapshot().scene, scene);
}

}  // namespace
