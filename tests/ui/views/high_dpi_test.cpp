// SPDX-License-Identifier: BSD-3-Clause
// A screen of twice the pixels: all of them are used, and the mouse meets what is drawn. ctest runs
// these, and the suites of slices, marks and mouse, with QT_SCALE_FACTOR=2.
#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QTest>
#include <cmath>

#include "app/application.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;

class HighDpi : public ::testing::Test {
 protected:
  void SetUp() override {
    if (qGuiApp->devicePixelRatio() != 2.0) GTEST_SKIP() << "NOT RUN: QT_SCALE_FACTOR is not 2";
  }
};

ui::Picture ballPictureOf(double radius) {
  return ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                        window::ball(Vec3::Zero(), radius)));
}

TEST_F(HighDpi, TheSurfaceIsDrawnAtTheScreensPixelsWhereItIs) {
  for (const ui::SurfaceMode mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    ui::VolumeView view;
    view.setSurfaceWish(mode);
    window::showAndWait(view, {300, 240});
    view.show(ballPictureOf(0.020), 50.0);
    view.resetCamera();
    window::rest(view);
    const QImage image = view.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    ASSERT_EQ(image.size(), view.size() * 2);
    const QPointF middle = view.projected(Vec3::Zero()) * 2.0;
    const double radius = 2.0 * (view.projected({0.020, 0.0, 0.0}).x() - middle.x() / 2.0);
    const QPointF seen = window::centroid(image, window::surfaceColoured);
    EXPECT_LT(QLineF(seen, middle).length(), 3.0);
    // perspective shows a little more than the great circle
    const double area = window::count(image, window::surfaceColoured);
    EXPECT_NEAR(area / (M_PI * radius * radius), 1.03, 0.06);
    // at the rim, pixels within one of the widget's differ
    EXPECT_GT(window::neighboursApart(image, image.rect()), 60);
    // the letter of the patient's left at the right edge, as large as on another screen
    const auto yellow = [](QColor c) { return c.red() > 170 && c.green() > 130 && c.blue() < 90; };
    EXPECT_GT(window::count(image.copy(540, 200, 60, 80), yellow), 80);
  }
}

TEST_F(HighDpi, ASliceIsCutAtTheScreensPixels) {
  ui::SliceView view(ui::Plane::Axial);
  view.show(ballPictureOf(0.020));
  view.setGrey({.level = 50.0, .width = 100.0});
  view.setCross({25.0, 25.0, 0.0});
  window::showAndWait(view, {300, 240});
  const QImage image = view.grab().toImage();
  ASSERT_EQ(image.size(), view.size() * 2);
  EXPECT_GT(window::neighboursApart(image, QRect(view.projected({-22.0, 3.0, 0.0}).toPoint() * 2,
                                                 view.projected({-3.0, 22.0, 0.0}).toPoint() * 2)),
            40);
}

TEST_F(HighDpi, ACopiedPictureHasTheScreensPixels) {
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(window::waitFor([&] { return application.snapshot().scene != 0; }));
  ui::VolumeView& view = application.window().views().volume();
  window::pictureAtRest(view);
  application.window().findChild<QAction*>("copyPicture")->trigger();
  EXPECT_EQ(QGuiApplication::clipboard()->image().size(), view.size() * 2);
}

}  // namespace
