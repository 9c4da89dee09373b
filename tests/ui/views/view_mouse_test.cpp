// SPDX-License-Identifier: BSD-3-Clause
// What mouse and keys do in the 3-D view: the camera, the tool, the sides, the cube.
#include <gtest/gtest.h>

#include <vtkCamera.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <numbers>
#include <optional>

#include "tests/ui/window_support.h"

namespace {

using haptics::Vec3;
using ui::MouseMode;
using ui::Side;

constexpr int kMouseSide = 400;

/// A view of a ball of 20 mm, with a tool in front of it, and what it was asked for.
class BallView {
 public:
  BallView() {
    view.setSurfaceWish(ui::SurfaceMode::Mesh);
    window::showAndWait(view, {kMouseSide, kMouseSide});
    view.show(ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                             window::ball(Vec3::Zero(), 0.020))),
              50.0);
    view.setTouched({.value = [](const Vec3& p) { return p.norm() < 0.020 ? 100.0 : 0.0; },
                     .firstMet = meetBall});
    view.show(window::octahedron(0.003));
    view.setMouseHand(true);
    view.resetCamera();  // from the front
    put({0.010, -0.030, 0.010});
    QObject::connect(&view, &ui::VolumeView::handPulled,
                     [this](const haptics::Pose& X) { pulled = X; });
  }

  static std::optional<ui::SurfacePlace> meetBall(const Vec3& from, const Vec3& to, double) {
    const Vec3 way = to - from;
    const double a = way.squaredNorm(), b = from.dot(way), c = from.squaredNorm() - 0.020 * 0.020,
                 root = b * b - a * c;
    if (root < 0.0) return {};
    const double at = (-b - std::sqrt(root)) / a;
    if (at < 0.0 || at > 1.0) return {};
    const Vec3 p = from + at * way;
    return ui::SurfacePlace{p, p.normalized()};
  }

  void put(const Vec3& p_W) {
    haptics::Snapshot snapshot;
    snapshot.X_WP.translation() = snapshot.X_WD.translation() = p_W;
    view.display(snapshot);
  }
  Vec3 eye() { return Vec3{view.camera()->GetPosition()}; }
  Vec3 focus() { return Vec3{view.camera()->GetFocalPoint()}; }
  void drag(QPointF from, QPointF by, Qt::MouseButton button, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, button, keys, from.toPoint());
    move(from + by, button, keys);
    QTest::mouseRelease(&view, button, keys, (from + by).toPoint());
  }
  /// QTest's moves carry no buttons: sends the event itself.
  void move(QPointF to, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, buttons, keys);
    QCoreApplication::sendEvent(&view, &event);
  }
  void wheel(QPointF at, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, {}, keys, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&view, &event);
  }

  ui::VolumeView view;
  std::optional<haptics::Pose> pulled;
};

TEST(ViewMouse, TurnsShiftsAndZoomsAtTheStart) {
  BallView ball;
  ASSERT_EQ(ball.view.mouseMode(), MouseMode::Look);
  const Vec3 eye = ball.eye(), focus = ball.focus();
  ball.drag({100, 330}, {60, 0}, Qt::LeftButton);
  EXPECT_LT((ball.focus() - focus).norm(), 1e-6);
  EXPECT_GT((ball.eye() - eye).norm(), 10.0);
  EXPECT_NEAR((ball.eye() - focus).norm(), (eye - focus).norm(), 1e-6);
  EXPECT_LT(ball.eye().x(), eye.x());  // what is dragged to the right comes from the left
  ball.view.resetCamera();
  ball.drag({100, 330}, {50, 0}, Qt::MiddleButton);
  EXPECT_NEAR(ball.view.projected(focus * 1e-3).x(), kMouseSide / 2 + 50.0, 0.5);
  ball.view.resetCamera();
  ball.drag({200, 200}, {0, -60}, Qt::RightButton);
  EXPECT_LT((ball.eye() - focus).norm(), 0.9 * (eye - focus).norm());
  EXPECT_FALSE(ball.pulled);
}

TEST(ViewMouse, TurnsShiftsAndZoomsByKeysToo) {
  BallView ball;
  const Vec3 eye = ball.eye(), focus = ball.focus();
  // what is in front goes where the arrow points, by 5 degrees
  QTest::keyClick(&ball.view, Qt::Key_Right);
  EXPECT_LT((ball.focus() - focus).norm(), 1e-6);
  EXPECT_LT(ball.eye().x(), eye.x() - 1.0);
  EXPECT_NEAR((ball.eye() - focus).normalized().dot((eye - focus).normalized()),
              std::cos(5.0 * std::numbers::pi / 180.0), 1e-6);
  QTest::keyClick(&ball.view, Qt::Key_Left);
  EXPECT_LT((ball.eye() - eye).norm(), 1e-6);
  QTest::keyClick(&ball.view, Qt::Key_Down);
  EXPECT_GT(ball.eye().z(), eye.z() + 1.0);
  QTest::keyClick(&ball.view, Qt::Key_Up);
  EXPECT_LT((ball.eye() - eye).norm(), 1e-6);
  // the picture comes from where the arrow points
  QTest::keyClick(&ball.view, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(ball.view.projected(focus * 1e-3).x(), kMouseSide / 2 - 24.0, 0.5);
  QTest::keyClick(&ball.view, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(ball.view.projected(focus * 1e-3).y(), kMouseSide / 2 - 24.0, 0.5);
  ball.view.resetCamera();
  const double far_mm = (ball.eye() - ball.focus()).norm();
  QTest::keyClick(&ball.view, Qt::Key_Plus, Qt::ShiftModifier);
  const double near_mm = (ball.eye() - ball.focus()).norm();
  EXPECT_NEAR(near_mm, far_mm / 1.1, 1e-3 * far_mm);
  QTest::keyClick(&ball.view, Qt::Key_Minus);
  EXPECT_NEAR((ball.eye() - ball.focus()).norm(), far_mm, 1e-3 * far_mm);
  EXPECT_FALSE(ball.pulled);
}

TEST(ViewMouse, ZoomsAtTheCursorWithAndWithoutPerspective) {
  BallView ball;
  for (const bool parallel : {false, true}) {
    SCOPED_TRACE(parallel ? "parallel" : "perspective");
    ball.view.resetCamera();
    ball.view.setParallel(parallel);
    const QPointF at = ball.view.projected({0.010, -0.0173205, 0.0});  // on the ball
    const auto met = BallView::meetBall({0.010, -0.1, 0.0}, {0.010, 0.1, 0.0}, 50.0);
    ASSERT_TRUE(met);
    const double before = std::abs(ball.view.projected({0.012, -0.0173205, 0.0}).x() - at.x());
    ball.wheel(at, 5);
    const QPointF after = ball.view.projected({0.010, -0.0173205, 0.0});
    EXPECT_LT(QLineF(after, at).length(), parallel ? 0.5 : 1.5);
    const double now = std::abs(ball.view.projected({0.012, -0.0173205, 0.0}).x() - after.x());
    EXPECT_NEAR(now / before, std::pow(1.1, 5), 0.05);
  }
}

TEST(ViewMouse, TakesHoldOfTheToolInAnyModeAndHidesBehindTheSurface) {
  BallView ball;
  const Vec3 tool{0.010, -0.030, 0.010};
  const QPointF at = ball.view.projected(tool);
  EXPECT_TRUE(ball.view.isOnTool(at));
  EXPECT_FALSE(ball.view.isOnTool(at + QPointF{80, 0}));
  ball.move(at, Qt::NoButton);
  EXPECT_EQ(ball.view.cursor().shape(), Qt::OpenHandCursor);
  const Vec3 eye = ball.eye();
  ball.drag(at, {40, 0}, Qt::LeftButton);
  ASSERT_TRUE(ball.pulled);
  EXPECT_GT(ball.pulled->translation().x(), 0.012);
  EXPECT_EQ((ball.eye() - eye).norm(), 0.0);
  ball.drag(at, {40, 0}, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_GT(Eigen::AngleAxisd(ball.pulled->linear()).angle(), 0.1);
  // behind the ball it is not seen, so it is not taken
  ball.put({0.0, 0.030, 0.0});
  EXPECT_FALSE(ball.view.isOnTool(ball.view.projected({0.0, 0.030, 0.0})));
  // and not where another hand holds it
  ball.put(tool);
  ball.view.setMouseHand(false);
  ball.put(tool);
  EXPECT_FALSE(ball.view.isOnTool(at));
}

TEST(ViewMouse, MovesAndTurnsTheToolByKeysWhileItHoldsIt) {
  BallView ball;
  ball.view.setMouseMode(MouseMode::Hand);
  const Vec3 start{0.010, -0.030, 0.010}, eye = ball.eye();
  // seen from the front: right is the patient's left, up the head, deeper the back
  struct {
    Qt::Key key;
    Vec3 way;
  } const keys[] = {{Qt::Key_Right, Vec3::UnitX()},  {Qt::Key_Left, -Vec3::UnitX()},
                    {Qt::Key_Up, Vec3::UnitZ()},     {Qt::Key_Down, -Vec3::UnitZ()},
                    {Qt::Key_PageUp, Vec3::UnitY()}, {Qt::Key_PageDown, -Vec3::UnitY()}};
  for (const auto& [key, way] : keys)
    for (const auto& [modifier, step] :
         {std::pair<Qt::KeyboardModifier, double>{Qt::NoModifier, 1e-3},
          {Qt::ControlModifier, 1e-4}}) {
      ball.pulled.reset();
      ball.view.placeHand(haptics::Pose(Eigen::Translation3d(start)));
      QTest::keyClick(&ball.view, key, modifier);
      ASSERT_TRUE(ball.pulled) << key;
      EXPECT_LT((ball.pulled->translation() - start - step * way).norm(), 1e-12) << key;
      EXPECT_TRUE(ball.pulled->linear().isIdentity(1e-12));
    }
  // what is in front turns the way of the arrow; the pages turn about the sight
  const double five = 5.0 * std::numbers::pi / 180.0;
  const std::pair<Qt::Key, Vec3> turns[] = {{Qt::Key_Right, Vec3::UnitZ()},
                                            {Qt::Key_Up, -Vec3::UnitX()},
                                            {Qt::Key_PageUp, Vec3::UnitY()}};
  for (const auto& [key, about] : turns) {
    ball.view.placeHand(haptics::Pose(Eigen::Translation3d(start)));
    QTest::keyClick(&ball.view, key, Qt::ShiftModifier);
    EXPECT_EQ(ball.pulled->translation(), start) << key;
    EXPECT_TRUE(
        ball.pulled->linear().isApprox(Eigen::AngleAxisd(five, about).toRotationMatrix(), 1e-9))
        << key << '\n'
        << ball.pulled->linear();
  }
  EXPECT_EQ((ball.eye() - eye).norm(), 0.0);  // the picture stays
  // without it the same keys turn the picture
  ball.view.setMouseMode(MouseMode::Look);
  ball.pulled.reset();
  QTest::keyClick(&ball.view, Qt::Key_Right);
  EXPECT_FALSE(ball.pulled);
  EXPECT_GT((ball.eye() - eye).norm(), 1.0);
}

TEST(ViewMouse, IsAHandInAModeOfItsOwnWithItsCursor) {
  BallView ball;
  QSignalSpy changed(&ball.view, &ui::VolumeView::mouseModeChanged);
  ball.view.setMouseMode(MouseMode::Hand);
  EXPECT_EQ(ball.view.mouseMode(), MouseMode::Hand);
  EXPECT_EQ(ball.view.cursor().shape(), Qt::OpenHandCursor);
  const Vec3 eye = ball.eye();
  ball.drag({60, 350}, {40, 0}, Qt::LeftButton);  // far from the tool
  ASSERT_TRUE(ball.pulled);
  EXPECT_EQ((ball.eye() - eye).norm(), 0.0);
  const double depth = ball.pulled->translation().y();
  ball.wheel({60, 350}, 1);
  EXPECT_NEAR(ball.pulled->translation().y(), depth + 0.002, 1e-9);
  ball.wheel({60, 350}, 1, Qt::ControlModifier);
  EXPECT_GT((ball.eye() - eye).norm(), 1.0);
  ball.drag({60, 350}, {40, 0}, Qt::RightButton);  // the picture still turns
  EXPECT_GT(std::abs(ball.eye().x() - eye.x()), 1.0);
  ball.view.setMouseMode(MouseMode::Look);
  EXPECT_EQ(changed.count(), 2);
  // without the mouse as the hand there is nothing to take, which the hint says
  ball.view.setMouseHand(false);
  EXPECT_TRUE(ball.view.hint().contains("G takes the tool only while the mouse is the hand"));
  ball.view.setMouseMode(MouseMode::Hand);
  EXPECT_EQ(ball.view.mouseMode(), MouseMode::Look);
}

TEST(ViewMouse, ADoubleClickOnTheSurfaceWishesTheToolThere) {
  BallView ball;
  std::optional<Vec3> place, normal;
  QObject::connect(&ball.view, &ui::VolumeView::toolWanted, [&](const Vec3& p, const Vec3& n) {
    place = p;
    normal = n;
  });
  for (const bool parallel : {false, true}) {
    place.reset();
    ball.view.setParallel(parallel);
    const Vec3 there{-0.008, -0.0175499, 0.005};
    QTest::mouseDClick(&ball.view, Qt::LeftButton, {}, ball.view.projected(there).toPoint());
    ASSERT_TRUE(place);
    EXPECT_LT((*place - there).norm(), 4e-4);
    EXPECT_GT(normal->dot(there.normalized()), 0.999);
  }
  place.reset();
  QTest::mouseDClick(&ball.view, Qt::LeftButton, {}, {5, 395});
  EXPECT_FALSE(place);
}

TEST(ViewMouse, LooksFromTheSixSidesByKeyAndCube) {
  BallView ball;
  const Qt::Key keys[] = {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_6};
  for (std::size_t i = 0; i < ui::kSides.size(); ++i) {
    const Side side = ui::kSides[i];
    SCOPED_TRACE(ui::letterOf(side).toStdString());
    QTest::keyClick(&ball.view, keys[i]);
    EXPECT_GT(ball.view.viewAxes().col(2).dot(ui::directionOf(side)), 0.999);
    EXPECT_GT(ball.view.viewAxes().col(1).dot(ui::upOf(side)), 0.999);
    // the cube's face towards the viewer is this side's
    const QRectF cube = ui::OrientationCube::placeIn(QSizeF(kMouseSide, kMouseSide));
    EXPECT_EQ(ui::OrientationCube::sideAt(cube.center(), cube, ball.view.viewAxes()), side);
  }
  // from obliquely, a click on each face that is seen goes to its side
  for (const Side side : {Side::Anterior, Side::Left, Side::Superior}) {
    ball.view.resetCamera();
    ball.view.camera()->Azimuth(35.0);
    ball.view.camera()->Elevation(30.0);
    ball.view.camera()->OrthogonalizeViewUp();
    const QRectF cube = ui::OrientationCube::placeIn(QSizeF(kMouseSide, kMouseSide));
    std::optional<QPoint> face;
    for (int y = int(cube.top()); y < cube.bottom(); ++y)
      for (int x = int(cube.left()); x < cube.right(); ++x)
        if (ui::OrientationCube::sideAt(QPointF(x, y), cube, ball.view.viewAxes()) == side)
          face = QPoint(x, y);
    ASSERT_TRUE(face) << ui::letterOf(side).toStdString();
    QTest::mouseClick(&ball.view, Qt::LeftButton, {}, *face);
    EXPECT_GT(ball.view.viewAxes().col(2).dot(ui::directionOf(side)), 0.999);
  }
  EXPECT_FALSE(ball.pulled);
}

TEST(ViewMouse, SwitchesThePerspectiveAtTheSameSizeAndResets) {
  BallView ball;
  const auto width = [&] {
    return ball.view.projected(ball.focus() * 1e-3 + Vec3{0.01, 0.0, 0.0}).x() -
           ball.view.projected(ball.focus() * 1e-3).x();
  };
  const double before = width();
  QTest::keyClick(&ball.view, Qt::Key_P);
  EXPECT_TRUE(ball.view.isParallel());
  EXPECT_NEAR(width(), before, 0.01);
  // a place nearer is as large as one behind
  EXPECT_NEAR(ball.view.projected({0.01, -0.03, 0.0}).x(),
              ball.view.projected({0.01, 0.03, 0.0}).x(), 1e-6);
  ball.wheel({200, 200}, 4);
  const double zoomed = width();
  QTest::keyClick(&ball.view, Qt::Key_P);
  EXPECT_NEAR(width(), zoomed, 0.01);
  QTest::keyClick(&ball.view, Qt::Key_R);
  EXPECT_NEAR(width(), before, 0.01);
}

TEST(ViewMouse, BringsToolAndCrosshairTogetherAndLooksFromTheToolByKeys) {
  BallView ball;
  QSignalSpy to_cross(&ball.view, &ui::VolumeView::toolToCrossWanted);
  QSignalSpy to_tool(&ball.view, &ui::VolumeView::crossToToolWanted);
  QTest::keyClick(&ball.view, Qt::Key_J);
  EXPECT_EQ(to_cross.count(), 1);
  EXPECT_EQ(to_tool.count(), 0);
  QTest::keyClick(&ball.view, Qt::Key_K);
  EXPECT_EQ(to_cross.count(), 1);
  EXPECT_EQ(to_tool.count(), 1);
  ball.put({0.030, 0.0, 0.0});
  QTest::keyClick(&ball.view, Qt::Key_T);
  EXPECT_GT(ball.view.viewAxes().col(2).x(), 0.7);  // from the patient's left
}

TEST(ViewMouse, LooksAlongTheTool) {
  BallView ball;
  haptics::Snapshot snapshot;
  snapshot.X_WP.translation() = Vec3{0.0, -0.03, 0.0};
  snapshot.X_WP.linear() =
      haptics::Quat::FromTwoVectors(Vec3::UnitZ(), Vec3{0.3, -1.0, 0.2}).toRotationMatrix();
  snapshot.X_WD = snapshot.X_WP;
  ball.view.display(snapshot);
  QTest::keyClick(&ball.view, Qt::Key_L);
  EXPECT_GT(ball.view.viewAxes().col(2).dot(snapshot.X_WP.linear().col(2)), 0.9999);
  const QPointF tip = ball.view.projected(snapshot.X_WP * Vec3{0.0, 0.0, -0.003});
  EXPECT_LT(QLineF(tip, {kMouseSide / 2.0, kMouseSide / 2.0}).length(), 1.0);
}

}  // namespace
