// SPDX-License-Identifier: BSD-3-Clause
#include "ui/slice_view.h"

#include <gtest/gtest.h>

#include <QTest>
#include <QWheelEvent>

#include "window_support.h"

namespace {

using haptics::Mat3;
using haptics::Vec3;
using ui::Plane;

// a bright ball on the patient's left, another half as bright towards the front and the head
double marked(const Vec3& p_W) {
  return window::ball({0.018, 0.0, 0.0}, 0.006)(p_W) +
         0.5 * window::ball({0.0, -0.016, 0.014}, 0.005)(p_W);
}

struct Axes {
  const char* name;
  Mat3 direction;
};

std::vector<Axes> someAxes() {
  Mat3 permuted, left_handed, sagittal, oblique = Mat3::Identity();
  permuted << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  left_handed = Vec3{1.0, 1.0, -1.0}.asDiagonal();
  sagittal << 0, 0, -1, 1, 0, 0, 0, -1, 0;  // right-handed, as a sagittal series lies
  oblique = Eigen::AngleAxisd(0.5, Vec3{1.0, 2.0, 0.5}.normalized()).toRotationMatrix() *
            Vec3{-1.0, 1.0, 1.0}.asDiagonal();
  return {{"identity", Mat3::Identity()},
          {"permuted", permuted},
          {"left-handed", left_handed},
          {"sagittal", sagittal},
          {"oblique and left-handed", oblique}};
}

ui::Picture marker(const Mat3& direction, bool orientation_known = true) {
  return ui::pictureOf(window::volumeOf(window::cubeGrid(64, direction), haptics::ScalarType::Int16,
                                        marked, {.orientation_known = orientation_known}));
}

bool bright(QColor c) { return c.saturation() < 20 && c.red() > 200; }
bool letter(QColor c) { return c.red() > 170 && c.green() > 130 && c.blue() < 90; }

TEST(SliceView, ShowsTheLeftMarkerUnderTheLetterLWhicheverWayTheVoxelsLie) {
  for (const Axes& axes : someAxes()) {
    SCOPED_TRACE(axes.name);
    const ui::Picture picture = marker(axes.direction);
    for (const Plane plane : {Plane::Axial, Plane::Coronal}) {
      ui::SliceView view(plane);
      view.show(picture);
      view.setGrey({.level = 50.0, .width = 100.0});
      view.setCross(Eigen::Vector3d::Zero());
      window::showAndWait(view, {300, 300});
      const QImage image = window::pictureOf(view);
      window::keep(image, "slice_marker");
      const QPointF at = window::centroid(image, bright);
      const QPointF expected = view.projected({18.0, 0.0, 0.0});
      EXPECT_NEAR(at.x(), expected.x(), 3.0);  // px; the crosshair cuts the ball's symmetry
      EXPECT_NEAR(at.y(), expected.y(), 3.0);
      EXPECT_GT(at.x(), 170.0);  // the radiological convention: left is on the right
      EXPECT_EQ(ui::lettersOf(plane)[1], "L");
      // and an L is painted on that edge
      EXPECT_GT(window::count(image.copy(270, 130, 30, 40), letter), 10);
    }
    // front and head: the fainter ball, on the sagittal picture
    ui::SliceView view(Plane::Sagittal);
    view.show(picture);
    view.setGrey({.level = 25.0, .width = 50.0});
    view.setCross({0.0, 0.0, 0.0});
    window::showAndWait(view, {300, 300});
    const QPointF at = window::centroid(window::pictureOf(view), bright);
    EXPECT_LT(at.x(), 130.0);  // front on the left
    EXPECT_LT(at.y(), 130.0);  // head up
    EXPECT_EQ(ui::lettersOf(Plane::Sagittal)[0], "A");
    EXPECT_EQ(ui::lettersOf(Plane::Sagittal)[2], "S");
  }
}

TEST(SliceView, ShowsNoLettersWhereTheFileDoesNotGiveTheOrientation) {
  ui::SliceView view(Plane::Axial);
  view.show(marker(Mat3::Identity(), false));
  view.setGrey({.level = 50.0, .width = 100.0});
  window::showAndWait(view, {300, 300});
  EXPECT_EQ(window::count(window::pictureOf(view), letter), 0);
}

TEST(SliceView, MovesTheCrosshairToAClickAndThroughTheSlicesWithTheWheel) {
  ui::SliceView view(Plane::Coronal);
  view.show(marker(Mat3::Identity()));
  view.setCross({0.0, 5.0, 0.0});
  window::showAndWait(view, {300, 300});
  Eigen::Vector3d cross = Eigen::Vector3d::Zero();
  QObject::connect(&view, &ui::SliceView::crossMoved, [&](const Eigen::Vector3d& p) { cross = p; });
  const Eigen::Vector3d wanted{10.0, 5.0, -12.0};
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.projected(wanted).toPoint());
  EXPECT_LT((cross - wanted).norm(), 0.3);  // mm: a pixel is 0.23

  view.setCross(wanted);
  QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 240}, {}, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  EXPECT_NEAR(cross.y(), 7.0, 1e-9);  // two notches of 1 mm
}

}  // namespace
