// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>

#include <QComboBox>
#include <QImage>
#include <QLocale>
#include <QScrollArea>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "app/window/edits/edit_controller.h"
#include "app/window/scan/loader.h"
#include "datasets/readers/nrrd/writer.h"
#include "tests/ui/edits/editing.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/style/scene_colours.h"
#include "ui/views/volume_view.h"
#include "ui/window/views.h"

namespace {

using Eigen::Vector3d;
using window::Editing;
using window::waitFor;

/// Whether a pixel shows what would go: amber over what is below it.
bool isAmber(QColor c) { return c.red() - c.blue() > 60; }

TEST_F(Editing, ACropBoxIsDraggedInSlicesAndInThreeD) {
  openBalls();
  const std::shared_ptr<const haptics::Volume> scan = application_->shown()->picture.volume;
  const QImage before = window::pictureAtRest(window().views().volume());
  EXPECT_TRUE(isThere({0, 0, 0}));
  EXPECT_TRUE(isThere(kSmallAt));
  window().views().setCross(Vector3d::Zero());
  click("cropTool");
  ui::SliceView& axial = slice(ui::Plane::Axial);
  const QPointF face = axial.projected({32, 0, 0});
  bool changed_while_dragging = true;
  drag(axial, {face, axial.projected({20, 0, 0}), axial.projected({-10, 0, 0})},
       [&] { changed_while_dragging = volume().crop.has_value(); });
  EXPECT_FALSE(changed_while_dragging);
  settle();
  ASSERT_TRUE(volume().crop);
  EXPECT_EQ(volume().crop->end[0], 22);
  EXPECT_EQ(volume().crop->first[0], 0);
  EXPECT_TRUE(window().windowTitle().contains("(edited)"));
  EXPECT_EQ(number("crop0High"), -10.0);
  EXPECT_EQ(window().findChild<QDoubleSpinBox*>("crop0High")->suffix(), " mm");
  // what stays ends at the face, to the touch too
  EXPECT_GT(felt({-10.3, 0, 0}), isovalue_);
  EXPECT_LT(felt({-9.7, 0, 0}), isovalue_);
  // in 3-D: the face towards S
  ui::VolumeView& view = window().views().volume();
  keepWindow("edit_crop_box");
  drag(view, {inSpace({-21, 0, 32}), inSpace({-21, 0, 20}), inSpace({-21, 0, 6})});
  settle();
  EXPECT_EQ(volume().crop->end[2], 38);
  // by its number
  type("crop1Low", "-5");
  EXPECT_EQ(volume().crop->first[1], 0);
  click("cropApply");
  EXPECT_EQ(volume().crop->first[1], 27);
  EXPECT_EQ(application_->editing().edits().size(), 3U);

  EXPECT_TRUE(isThere({-14, 0, 0}));
  EXPECT_FALSE(isThere({-5, 0, 0}));
  EXPECT_FALSE(isThere({-14, -9, 0}));
  EXPECT_FALSE(isThere({-14, 0, 10}));
  EXPECT_FALSE(isThere(kSmallAt));
  EXPECT_TRUE(isSeen({-14, 0, 0}));
  EXPECT_FALSE(isSeen({-4, 0, 0}));
  EXPECT_FALSE(isSeen(kSmallAt));
  // the voxels are the scan's own
  EXPECT_EQ(volume().voxels, scan->voxels);

  // the keys take it back, and it is as it was
  for (int n = 0; n < 3; ++n) undo();
  EXPECT_FALSE(volume().crop);
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
  click("cropTool");  // off
  EXPECT_LT(window::differing(before, window::pictureAtRest(view)), 0.001);
  expectTheSameEverywhere();
  redo();
  EXPECT_TRUE(volume().crop);
  EXPECT_TRUE(window().windowTitle().contains("(edited)"));
  QTest::keyClick(&window(), Qt::Key_Y, Qt::ControlModifier);
  settle();
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  click("resetEdits");
  EXPECT_TRUE(application_->editing().edits().empty());
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
}

TEST_F(Editing, EachFaceOfTheCropBoxHasAHandleInThreeDAndInTwoSlices) {
  openBalls();
  click("cropTool");
  window().views().setCross(Vector3d::Zero());
  // so that no handle lies beyond the view, or along the line of sight
  window().views().volume().camera()->Dolly(0.6);
  drag(window().views().volume(), {{100, 600}, {180, 660}});
  keepWindow("edit_crop_handles");
  constexpr double kBy_mm = 4.0;
  std::array<std::array<double, 2>, 3> ends{{{-32, 32}, {-32, 32}, {-32, 32}}};
  const ui::Plane without[] = {ui::Plane::Sagittal, ui::Plane::Coronal, ui::Plane::Axial};
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      double& end = ends[std::size_t(axis)][high];
      const auto pulled = [&](QWidget& view, const auto& project) {
        Vector3d handle;
        for (int a = 0; a < 3; ++a)
          handle[a] = 0.5 * (ends[std::size_t(a)][0] + ends[std::size_t(a)][1]);
        handle[axis] = end;
        Vector3d to = handle;
        to[axis] += high ? -kBy_mm : kBy_mm;
        drag(view, {project(handle), project(to)});
        settle();
        end = to[axis];
        const haptics::VoxelBox box = volume().bounds();
        for (std::size_t a = 0; a < 3; ++a) {
          EXPECT_EQ(double(box.first[a]) - 32.0, ends[a][0]) << "axis " << axis << high;
          EXPECT_EQ(double(box.end[a]) - 32.0, ends[a][1]) << "axis " << axis << high;
        }
      };
      pulled(window().views().volume(), [&](const Vector3d& p) { return inSpace(p); });
      for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal})
        if (plane != without[axis])
          pulled(slice(plane), [&](const Vector3d& p) { return slice(plane).projected(p); });
    }
  EXPECT_EQ(application_->editing().edits().size(), 18U);
  keepWindow("edit_crop_handles_pulled");
  expectTheSameEverywhere();
}

TEST_F(Editing, HandlesOfTheCropBoxAreWholeAndCanBeTakenAtTheBorderOfAView) {
  openBalls();
  click("cropTool");
  window().views().setCross(Vector3d::Zero());
  constexpr double kRoom = 8.0;  // px from a handle's middle to the border
  const auto kept = [](QPointF at, QRectF room) {
    room.adjust(kRoom, kRoom, -kRoom, -kRoom);
    return QPointF{std::clamp(at.x(), room.left(), room.right()),
                   std::clamp(at.y(), room.top(), room.bottom())};
  };
  // a disc of the handles' colour, to near its rim
  const auto isWhole = [](const QImage& image, QPointF at) {
    for (int n = 0; n < 16; ++n) {
      const double angle = n * std::numbers::pi / 8.0;
      const QPointF p = at + QPointF{std::cos(angle), std::sin(angle)} * 2.0;
      const QColor c = image.pixelColor(p.toPoint());
      if (std::abs(c.red() - ui::style::kOutline.red()) +
              std::abs(c.green() - ui::style::kOutline.green()) +
              std::abs(c.blue() - ui::style::kOutline.blue()) >
          60)
        return false;
    }
    return true;
  };
  const auto expectMoved = [&](int axis, bool high, QWidget& view, QPointF handle, QPointF by) {
    drag(view, {handle, handle + 0.5 * by, handle + by});
    settle();
    const haptics::VoxelBox box = volume().bounds();
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_EQ(box.first[a], a == std::size_t(axis) && !high ? 4 : 0) << "axis " << axis << high;
      EXPECT_EQ(box.end[a], a == std::size_t(axis) && high ? 60 : 64) << "axis " << axis << high;
    }
    undo();
    ASSERT_FALSE(volume().crop);
  };
  const ui::Plane without[] = {ui::Plane::Sagittal, ui::Plane::Coronal, ui::Plane::Axial};
  // the whole scan in the slices, and a part of it, whose faces lie beyond the view
  for (const double nearer : {1.0, 1.6})
    for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal}) {
      ui::SliceView& view = slice(plane);
      view.resetView();
      view.zoom(nearer, view.projected(Vector3d::Zero()));
      const QImage image = view.picture(1);
      window::keep(image, nearer > 1.0 ? "edit_crop_border_near" : "edit_crop_border");
      for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
          if (plane == without[axis]) continue;
          Vector3d face = Vector3d::Zero(), by = Vector3d::Zero();
          face[axis] = high ? 32 : -32;
          by[axis] = high ? -4 : 4;
          const QPointF handle = kept(view.projected(face), view.pictureRect());
          EXPECT_TRUE(isWhole(image, handle)) << int(plane) << axis << high << nearer;
          expectMoved(axis, high, view, handle,
                      view.projected(by) - view.projected(Vector3d::Zero()));
        }
    }
  // in 3-D, with the faces of four sides beyond the view
  ui::VolumeView& view = window().views().volume();
  view.setParallel(true);
  view.camera()->SetParallelScale(24.0);
  window::showCamera(view);
  window::pictureAtRest(view);
  const QImage image = view.picture(1);
  window::keep(image, "edit_crop_border_space");
  for (const int axis : {0, 2})
    for (const bool high : {false, true}) {
      Vector3d face = Vector3d::Zero(), by = Vector3d::Zero();
      face[axis] = high ? 32 : -32;
      by[axis] = high ? -4 : 4;
      // the letters stand at the edges
      const QPointF handle = kept(inSpace(face), QRectF(view.rect()).adjusted(28, 20, -28, -20));
      if (axis == 2) {
        EXPECT_FALSE(view.rect().contains(inSpace(face).toPoint()));
      }
      EXPECT_TRUE(isWhole(image, handle)) << axis << high;
      expectMoved(axis, high, view, handle, inSpace(by) - inSpace(Vector3d::Zero()));
    }
}

TEST_F(Editing, CropsToWhatTheSlicesShow) {
  openBalls();
  click("cropTool");
  for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal})
    slice(plane).zoom(4.0, slice(plane).projected(Vector3d::Zero()));
  click("cropToView");
  EXPECT_FALSE(volume().crop);
  click("cropApply");
  ASSERT_TRUE(volume().crop);
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_GT(volume().crop->first[a], 10) << a;
    EXPECT_LT(volume().crop->end[a], 54) << a;
  }
  // the box ends where the pictures do, to half a voxel
  ui::SliceView& axial = slice(ui::Plane::Axial);
  const double voxel = 1.0 / axial.mmPerPixel();
  const auto edge = [&](std::int64_t index) { return double(index) - 32.0; };
  const QRect picture = axial.pictureRect();
  EXPECT_NEAR(axial.projected({edge(volume().crop->first[0]), 0, 0}).x(), picture.left(),
              0.6 * voxel);
  EXPECT_NEAR(axial.projected({edge(volume().crop->end[0]), 0, 0}).x(), picture.right() + 1,
              0.6 * voxel);
  EXPECT_NEAR(axial.projected({0, edge(volume().crop->first[1]), 0}).y(), picture.top(),
              0.6 * voxel);
  click("cropReset");
  EXPECT_FALSE(volume().crop);
}

TEST_F(Editing, AClipPlaneIsPlacedTurnedFlippedAndCuts) {
  openBalls();
  const std::shared_ptr<const haptics::Volume> scan = application_->shown()->picture.volume;
  window().views().setCross({-12, 0, 2});
  click("planeTool");
  click("planeFromAxial");
  EXPECT_NEAR(number("planePosition"), 2.0, 0.1);
  EXPECT_NEAR(number("planeRaised"), 90.0, 0.1);
  EXPECT_EQ(number("planeTowards"), 0.0);
  keepWindow("edit_plane");
  click("planeFlip");
  EXPECT_NEAR(number("planeRaised"), -90.0, 0.1);
  EXPECT_EQ(number("planeTowards"), 0.0);
  click("planeApply");
  EXPECT_FALSE(isThere({-12, 0, -4}));
  EXPECT_TRUE(isThere({-12, 0, 8}));
  // the wall lies in the plane
  EXPECT_LT(felt({-12, 0, 1.8}), isovalue_);
  EXPECT_GT(felt({-12, 0, 2.2}), isovalue_);
  EXPECT_FALSE(isSeen({-12, 0, -6}));
  EXPECT_TRUE(isSeen({-12, 0, 8}));
  expectTheSameEverywhere();
  undo();
  EXPECT_EQ(0, std::memcmp(volume().voxels.get(), scan->voxels.get(),
                           std::size_t(scan->grid.voxelCount()) * 2));

  // the handles, in 3-D: one shifts it, the other turns it
  ui::VolumeView& view = window().views().volume();
  window().views().setCross({-12, 0, 2});
  click("planeFromAxial");
  drag(view, {inSpace({0, 0, 2}), inSpace({0, 0, 5}), inSpace({0, 0, 10})});
  EXPECT_NEAR(number("planePosition"), 10.0, 0.1);
  EXPECT_NEAR(number("planeRaised"), 90.0, 0.1);
  constexpr double kArm = 60.0;  // px from one to the other
  const QPointF shift = inSpace({0, 0, 10});
  drag(view, {shift + QPointF{0, -kArm}, shift + QPointF{0.5, -0.9} * kArm,
              shift + QPointF{std::numbers::sqrt2, -std::numbers::sqrt2} * (0.5 * kArm)});
  keepWindow("edit_plane_turned");
  EXPECT_NEAR(number("planeRaised"), 45.0, 3.0);
  EXPECT_NEAR(number("planeTowards"), 0.0, 10.0);
  click("planeAgain");

  // three clicks in one slice: two on a line that stands upright on it, the third on what goes
  ui::SliceView& coronal = slice(ui::Plane::Coronal);
  for (const double side : {1.0, -1.0})
    for (const double up : {1.0, -1.0}) {
      window().views().setCross({-12, 0, 2});
      for (const Vector3d& p :
           {Vector3d{-12, 0, 20 * up}, Vector3d{-12, 0, -20 * up}, Vector3d{-12 + 9 * side, 0, 0}})
        clickAt(coronal, coronal.projected(p));
      EXPECT_NEAR(std::abs(number("planeTowards")), side > 0.0 ? 0.0 : 180.0, 1.0) << side << up;
      EXPECT_NEAR(number("planeRaised"), 0.0, 1.0);
      EXPECT_NEAR(number("planePosition"), -12.0 * side, 0.2);
      click(side > 0.0 && up < 0.0 ? "planeApply" : "planeAgain");
    }
  // the second of them was cut
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_FALSE(isThere({-6, 0, 0}));
  EXPECT_TRUE(isThere({-18, 0, 0}));
  EXPECT_FALSE(isThere(kSmallAt));
  undo();

  // the handles in the slice: shifted to L, then turned from L to S
  window().views().setCross({-12, 0, 2});
  for (const Vector3d& p : {Vector3d{-12, 0, 20}, Vector3d{-12, 0, -20}, Vector3d{0, 0, 0}})
    clickAt(coronal, coronal.projected(p));
  drag(coronal, {coronal.projected({-12, 0, 0}), coronal.projected({-8, 0, 3})});
  EXPECT_NEAR(number("planePosition"), -8.0, 0.2);
  const double arm = kArm * coronal.mmPerPixel();
  drag(coronal, {coronal.projected({-8 + arm, 0, 0}), coronal.projected({-8 + arm, 0, arm}),
                 coronal.projected({-8, 0, arm})});
  EXPECT_NEAR(number("planeRaised"), 90.0, 1.0);
  type("planeRaised", "90");
  type("planePosition", "4");
  click("planeApply");
  EXPECT_TRUE(isThere({-12, 0, 0}));
  EXPECT_FALSE(isThere({-12, 0, 8}));
  undo();

  // three clicks on the surface: what is nearer goes, in whichever order they are set
  for (const bool turned : {true, false}) {
    click("planeAgain");
    const Vector3d p{-18, 0, -5}, q{-6, 0, -5}, r{-12, 0, 7};
    for (const Vector3d& at : {p, turned ? r : q, turned ? q : r}) clickAt(view, inSpace(at));
    EXPECT_TRUE(child<ui::NumberBox>("planePosition").isVisible());
    EXPECT_NEAR(number("planeTowards"), -90.0, 8.0) << "towards A, where the viewer is";
    EXPECT_NEAR(number("planeRaised"), 0.0, 8.0);
  }
  keepWindow("edit_plane_clicked");
  click("planeApply");
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_FALSE(isThere({-12, -13, 0}));
  EXPECT_TRUE(isThere({-12, 5, 0}));
  EXPECT_TRUE(isThere(kSmallAt + Vector3d{0, 2, 0}));

  // on one line there is no plane, and a sentence says so
  for (const double x : {-16.0, -12.0, -8.0}) clickAt(coronal, coronal.projected({x, 0, 0}));
  EXPECT_TRUE(message().contains("one line")) << message().toStdString();
}

TEST_F(Editing, AClipPlaneThatIsSeenFaceOnIsTurnedByAHandleBesideTheOther) {
  openBalls();
  ui::VolumeView& view = window().views().volume();
  click("planeTool");
  constexpr double kArm = 60.0;  // px
  const double degrees = 180.0 / std::numbers::pi;
  for (const bool flipped : {false, true}) {
    window().views().setCross(Vector3d::Zero());
    click("planeFromCoronal");
    if (flipped) click("planeFlip");
    const double side = number("planeTowards");  // towards A or P
    ASSERT_NEAR(std::abs(side), 90.0, 0.1);
    const QPointF shift = inSpace({0, 0, 0}), turn = shift + QPointF{0.0, -kArm};
    if (!flipped) keepWindow("edit_plane_face_on");
    // up and down, to the left and to the right: by the pointer's way over the arm
    for (const QPointF by : {QPointF{0, -30}, QPointF{0, 30}, QPointF{30, 0}, QPointF{-30, 0}}) {
      click("planeFromCoronal");
      if (flipped) click("planeFlip");
      drag(view, {turn, turn + 0.5 * by, turn + by});
      const double tilt = 30.0 / kArm * degrees;
      // the side towards the viewer, who is at A, follows the pointer: up is S, right is L
      const double facing = side < 0.0 ? 1.0 : -1.0;
      EXPECT_NEAR(number("planeRaised"),
                  by.y() != 0.0 ? -facing * std::copysign(tilt, by.y()) : 0.0, 0.5);
      const double towards = by.x() == 0.0 ? side : side + std::copysign(tilt, by.x());
      EXPECT_NEAR(number("planeTowards"), towards, 0.5) << by.x() << " " << by.y();
      EXPECT_NEAR(number("planePosition"), 0.0, 0.1);
    }
    if (!flipped) keepWindow("edit_plane_face_on_turned");
  }
}

TEST_F(Editing, APieceIsShownWithItsVolumeAndKeptOrRemoved) {
  openBalls();
  const std::shared_ptr<const haptics::Volume> scan = application_->shown()->picture.volume;
  click("piecesTool");
  const QImage plain = window::pictureAtRest(window().views().volume());
  clickAt(window().views().volume(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  const QString words = child<QLabel>("editPreview").text();
  const double cm3 = QLocale().toDouble(words.section(' ', 2, 2));
  EXPECT_NEAR(cm3, 4.0 / 3.0 * 3.14159 * 0.125, 0.05) << words.toStdString();
  // nothing has changed but what is drawn over it
  EXPECT_EQ(application_->shown()->picture.volume, scan);
  const QImage shown = window::pictureAtRest(window().views().volume());
  keepWindow("edit_piece");
  EXPECT_GT(window::differing(plain, shown), 0.002);
  EXPECT_TRUE(isAmber(shown.pixelColor(inSpace(kSmallAt).toPoint())));
  EXPECT_FALSE(isAmber(shown.pixelColor(inSpace(kLargeAt).toPoint())));
  // no larger than the piece: its edge is at 5 mm
  EXPECT_TRUE(isAmber(shown.pixelColor(inSpace(kSmallAt + Vector3d{4, 0, 0}).toPoint())));
  // beyond its rim, which goes with it
  EXPECT_FALSE(isAmber(shown.pixelColor(inSpace(kSmallAt + Vector3d{9, 0, 0}).toPoint())));
  for (const auto& [at, goes] : {std::pair{kSmallAt, true}, std::pair{kLargeAt, false}}) {
    window().views().setCross(at);
    for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal}) {
      const QImage cut = window::pictureOf(slice(plane));
      const QPoint beside = slice(plane).projected(at).toPoint() + QPoint{4, 4};
      EXPECT_EQ(isAmber(cut.pixelColor(beside)), goes) << at.transpose() << " " << int(plane);
    }
  }
  // "Remove" hatches the piece, "Keep only" all beside it
  const auto pointedAt = [&](const char* button) {
    QEvent enter(QEvent::Enter);
    QCoreApplication::sendEvent(&child(button), &enter);
    return std::pair{child<QLabel>("editPreview").text(),
                     window::pictureOf(slice(ui::Plane::Axial))};
  };
  window().views().setCross(kSmallAt);
  const auto [removing, goes] = pointedAt("removePiece");
  const auto [keeping, stays] = pointedAt("keepPiece");
  keepWindow("edit_keep_piece");
  QTest::qWait(50);  // the words may need another line
  EXPECT_EQ(child("cancelPreview").visibleRegion().boundingRect().size(),
            child("cancelPreview").size());
  EXPECT_NE(removing, keeping);
  EXPECT_TRUE(keeping.contains("stays"));
  // brighter and darker lines, so not one colour over all
  const auto hatchAt = [&](const QImage& image, const Vector3d& at) {
    const QPoint p = slice(ui::Plane::Axial).projected(at).toPoint();
    int least = 255, most = 0;
    for (int x = p.x() - 9; x <= p.x() + 9; ++x) {
      if (std::abs(x - p.x()) < 3) continue;  // the crosshair
      const QColor c = image.pixelColor(x, p.y() + 4);
      least = std::min(least, c.red() - c.blue());
      most = std::max(most, c.red() - c.blue());
    }
    return least > 10 && most - least > 25;
  };
  const Vector3d beside = kSmallAt + Vector3d{-16, 12, 0};
  EXPECT_TRUE(hatchAt(goes, kSmallAt));
  EXPECT_FALSE(hatchAt(goes, beside));
  EXPECT_FALSE(hatchAt(stays, kSmallAt));
  EXPECT_TRUE(hatchAt(stays, beside));
  click("removePiece");
  EXPECT_FALSE(isThere(kSmallAt));
  EXPECT_TRUE(isThere(kLargeAt));
  EXPECT_FALSE(isSeen(kSmallAt));
  expectTheSameEverywhere();
  // it does not come back when the isovalue falls
  const haptics::ScalarField& field = application_->shown()->scene->field;
  for (double x = kSmallAt.x() - 9.0; x < kSmallAt.x() + 9.0; x += 0.5)
    EXPECT_LT(field.value(field.indexOf(Vector3d{x, 0, 12} * 1e-3)), 5.0) << x;
  // the hand goes where it was
  const Vector3d tool = pulledTo(kSmallAt);
  EXPECT_LT((tool - kSmallAt).norm(), 1.0) << tool.transpose();
  pulledTo({16, -28, 12});
  undo();
  EXPECT_TRUE(isThere(kSmallAt));
  EXPECT_EQ(0, std::memcmp(volume().voxels.get(), scan->voxels.get(),
                           std::size_t(scan->grid.voxelCount()) * 2));
  EXPECT_GT((pulledTo(kSmallAt) - kSmallAt).norm(), 4.0);
  pulledTo({16, -28, 12});

  // in a slice, and kept
  window().views().setCross(kSmallAt);
  clickAt(slice(ui::Plane::Axial), slice(ui::Plane::Axial).projected(kSmallAt + Vector3d{1, 1, 0}));
  ASSERT_TRUE(previewed());
  click("keepPiece");
  EXPECT_TRUE(isThere(kSmallAt));
  EXPECT_FALSE(isThere(kLargeAt));
  expectTheSameEverywhere();
  // air is no piece
  clickAt(slice(ui::Plane::Axial), slice(ui::Plane::Axial).projected({-25, 25, 12}));
  EXPECT_TRUE(waitFor([&] { return messageIsShown(); }));
}

TEST_F(Editing, PiecesAreChosenAndTheScalpelIsLedByKeys) {
  openBalls();
  ui::SliceView& coronal = slice(ui::Plane::Coronal);
  const auto hints = [&] {
    QStringList words;
    for (const QLabel* hint : window().findChildren<QLabel*>("viewHint"))
      words << hint->accessibleName();
    return words;
  };
  // with a tool that cuts they say so once it can
  ASSERT_TRUE(waitFor([&] { return hints().join(' ').contains("Hold X: cuts."); }));
  const QStringList before = hints();
  click("piecesTool");
  for (const QString& hint : hints()) EXPECT_TRUE(hint.contains("piece")) << hint.toStdString();
  window().views().setCross(kSmallAt);
  QTest::keyClick(&coronal, Qt::Key_Return);
  ASSERT_TRUE(previewed());
  QTest::keyClick(&child("removePiece"), Qt::Key_Space);
  settle();
  EXPECT_FALSE(isThere(kSmallAt));
  EXPECT_TRUE(isThere(kLargeAt));

  // corner by corner, and the last one twice; one corner too many is taken back
  click("scalpelTool");
  for (const QString& hint : hints()) EXPECT_TRUE(hint.contains("outline")) << hint.toStdString();
  const auto corner = [&](double x, double z) {
    window().views().setCross({x, 0, z});
    QTest::keyClick(&coronal, Qt::Key_Return);
  };
  corner(-16, -4);
  corner(-8, -4);
  corner(-8, 4);
  corner(0, 20);
  QTest::keyClick(&coronal, Qt::Key_Backspace);
  corner(-16, 4);
  keepWindow("edit_corners");
  QTest::keyClick(&coronal, Qt::Key_Return);
  ASSERT_TRUE(previewed());
  EXPECT_GT(felt({-12, 0, 0}), isovalue_);
  for (const QString& hint : hints()) EXPECT_TRUE(hint.contains("cuts")) << hint.toStdString();
  // Escape keeps it, and the tool
  QTest::keyClick(&coronal, Qt::Key_Escape);
  EXPECT_FALSE(child<QLabel>("editPreview").isVisible());
  EXPECT_EQ(panel().tool(), ui::EditTool::Scalpel);
  for (const auto& [x, z] : {std::pair{-16, -4}, {-8, -4}, {-8, 4}, {-16, 4}, {-16, 4}})
    corner(x, z);
  ASSERT_TRUE(previewed());
  QTest::keyClick(&coronal, Qt::Key_Return);
  settle();
  EXPECT_FALSE(isThere({-12, 0, 0}));
  EXPECT_TRUE(isThere({-12, 0, 9}));
  EXPECT_TRUE(isThere({-4, 0, 0}));
  expectTheSameEverywhere();

  // in 3-D the middle of the picture is clicked; Escape puts the tool and its hints away
  undo();
  click("piecesTool");
  QTest::keyClick(&window().views().volume(), Qt::Key_Return);
  EXPECT_TRUE(previewed());
  QTest::keyClick(&window().views().volume(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return hints() == before; })) << hints().join('\n').toStdString();
}

TEST_F(Editing, NumbersOfTheCropBoxAreThoseOfPlacesElsewhere) {
  openBalls();
  click("cropTool");
  auto& low = child<ui::NumberBox>("crop0Low");
  auto& high = child<ui::NumberBox>("crop0High");
  EXPECT_EQ(low.text(), "-32.0 mm");
  EXPECT_EQ(high.text(), "32.0 mm");
  EXPECT_EQ(low.accessibleName(), "Box, x from");
  EXPECT_TRUE(child<QLabel>("cropAxes").text().startsWith("LPS"));
  type("crop0High", "-10");
  EXPECT_EQ(high.text(), "-10.0 mm");
  type("crop0High", "R 12");  // refused
  EXPECT_EQ(high.value(), -10.0);
}

TEST_F(Editing, NothingInThePanelIsCutAtItsSide) {
  openBalls();
  const QScrollArea* scroll = nullptr;  // the one that the panels of its tab stand in
  for (QWidget* above = &panel(); above != nullptr && scroll == nullptr;
       above = above->parentWidget())
    scroll = qobject_cast<QScrollArea*>(above);
  ASSERT_NE(scroll, nullptr);
  const auto fits = [&](const char* what) {
    QTest::qWait(20);
    EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width()) << what;
  };
  for (const char* tool : {"cropTool", "planeTool", "holderTool", "scalpelTool", "piecesTool"}) {
    click(tool);
    if (panel().tool() == ui::EditTool::Plane) click("planeFromAxial");
    fits(tool);
  }
  // the most that it shows: a piece, beside a scroll bar
  clickAt(window().views().volume(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  fits("a piece");
  click("removePiece");
  pulledTo({-12, -29, 0});
  pulledTo({-12, -5, 0});
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(child<QLabel>("editWait").isVisible());
  fits("a sentence that waits");
}

TEST_F(Editing, SmallPiecesAreShownAndRemoved) {
  openBalls();
  click("piecesTool");
  type("smallVolume", "0.1");
  click("showSmall");
  // both are larger: a sentence
  EXPECT_TRUE(waitFor([&] { return messageIsShown(); }));
  type("smallVolume", "1");
  click("showSmall");
  ASSERT_TRUE(previewed());
  EXPECT_TRUE(child<QLabel>("editPreview").text().contains("0.5") ||
              child<QLabel>("editPreview").text().contains("0,5"))
      << child<QLabel>("editPreview").text().toStdString();
  keepWindow("edit_small");
  click("cancelPreview");
  EXPECT_FALSE(child<QLabel>("editPreview").isVisible());
  EXPECT_TRUE(isThere(kSmallAt));
  click("showSmall");
  ASSERT_TRUE(previewed());
  click("applyRemoval");
  EXPECT_FALSE(isThere(kSmallAt));
  EXPECT_TRUE(isThere(kLargeAt));
}

TEST_F(Editing, TheScalpelHatchesSoftTissueTooAndSaysThatItGoes) {
  const auto path = std::filesystem::path(scans_.path().toStdString()) / "soft.nrrd";
  const auto bone = window::ball(kLargeAt * 1e-3, kLarge_mm * 1e-3);
  const auto scan = window::volumeOf(
      window::cubeGrid(64), haptics::ScalarType::Int16,
      [&](const haptics::Vec3& p) { return std::max(bone(p), p.z() < 0.0 ? 30.0 : 0.0); });
  ASSERT_TRUE(datasets::writeNrrd(*scan, path).has_value());
  open(path, 50.0);
  click("scalpelTool");
  window().views().setCross({-12, 0, -18});
  ui::SliceView& coronal = slice(ui::Plane::Coronal);
  const auto at = [&](double x, double z) { return coronal.projected(Vector3d{x, 0, z}); };
  const Vector3d soft{-12, 0, -20};
  const auto hatched = [&] {
    const QPoint middle = coronal.projected(soft).toPoint() + QPoint{8, 8};  // beside the crosshair
    return window::count(window::pictureOf(coronal).copy(QRect(middle, QSize{8, 8})),
                         [](QColor c) { return c.red() > c.blue() + 5; });
  };
  EXPECT_EQ(hatched(), 0);
  drag(coronal, {at(-20, -10), at(-4, -10), at(-4, -26), at(-20, -26), at(-20, -10)});
  ASSERT_TRUE(previewed());
  EXPECT_GT(hatched(), 16);  // the stripes
  const QString words = child<QLabel>("editPreview").text();
  EXPECT_TRUE(words.contains("soft tissue") && words.contains("cm³")) << words.toStdString();
  EXPECT_GT(felt(soft), 20.0);
  click("applyRemoval");
  settle();
  EXPECT_LT(felt(soft), 1.0);
}

TEST_F(Editing, AScalpelCutsAlongWhatIsDrawn) {
  openBalls();
  click("scalpelTool");
  const auto around = [&](auto&& project, double x, double z, double half) {
    std::vector<QPointF> way;
    for (int n = 0; n <= 24; ++n) {
      const double turn = n * 2.0 * 3.14159265 / 24.0;
      way.push_back(project(Vector3d{x + half * std::cos(turn), 0, z + half * std::sin(turn)}));
    }
    return way;
  };
  const auto space = [&](const Vector3d& p) { return inSpace(p); };
  const auto cut = [&] {
    ASSERT_TRUE(previewed());
    EXPECT_EQ(child("applyRemoval").text(), "Cut");
    click("applyRemoval");
    settle();
  };
  const auto cancelled = [&] {
    ASSERT_TRUE(previewed());
    keepWindow("edit_cut_preview");
    click("cancelPreview");
  };
  bool drawn = false;
  drag(window().views().volume(), around(space, -12, 0, 5), [&] {
    drawn = true;
    keepWindow("edit_lasso");
  });
  EXPECT_TRUE(drawn);
  // what it takes is shown, and nothing is cut
  const QImage plain = window::pictureAtRest(window().views().volume());
  cancelled();
  EXPECT_TRUE(isThere({-12, 0, 0}));
  EXPECT_GT(window::differing(window::pictureAtRest(window().views().volume()), plain), 0.002);
  drag(window().views().volume(), around(space, -12, 0, 5));
  cut();
  // through everything
  for (const double y : {-12.0, 0.0, 12.0}) EXPECT_FALSE(isThere({-12, y, 0})) << y;
  EXPECT_TRUE(isThere({-12, 0, 9}));
  EXPECT_FALSE(isSeen({-12, 0, 0}));
  EXPECT_TRUE(isSeen({-12, 0, 9}));
  expectTheSameEverywhere();
  pulledTo({-12, -29, 0});
  const Vector3d tool = pulledTo({-12, -2, 0});
  EXPECT_LT((tool - Vector3d{-12, -2, 0}).norm(), 1.0) << tool.transpose();
  pulledTo({-12, -29, 0});
  undo();
  // as deep as a number says
  type("scalpelDepth", "6");
  drag(window().views().volume(), around(space, -12, 0, 5));
  cut();
  EXPECT_FALSE(isThere({-12, -11, 0}));
  EXPECT_TRUE(isThere({-12, -5, 0}));
  // from the nearest surface, which is at -14
  EXPECT_LT(felt({-12, -8.4, 0}), isovalue_);
  EXPECT_GT(felt({-12, -7.6, 0}), isovalue_);
  keepWindow("edit_lasso_depth");
  undo();
  // on a slice, to both sides, and what is outside
  window().views().setCross({-12, 0, 0});
  ui::SliceView& coronal = slice(ui::Plane::Coronal);
  const auto flat = [&](const Vector3d& p) { return coronal.projected(p); };
  drag(coronal, around(flat, -12, 0, 5));
  cut();
  for (const double y : {-1.0, 1.0}) {
    EXPECT_FALSE(isThere({-12, 3 * y, 0})) << y;
    EXPECT_TRUE(isThere({-12, 8 * y, 0})) << y;
    EXPECT_LT(felt({-12, 5.7 * y, 0}), isovalue_) << y;
    EXPECT_GT(felt({-12, 6.3 * y, 0}), isovalue_) << y;
  }
  undo();
  type("scalpelDepth", "0");
  drag(coronal, around(flat, -12, 0, 8));
  ASSERT_TRUE(previewed());
  const QString inside = child<QLabel>("editPreview").text();
  // another side is shown at once
  child<QComboBox>("scalpelSide").setCurrentIndex(1);
  ASSERT_TRUE(waitFor([&] {
    return child<QLabel>("editPreview").isVisible() &&
           child<QLabel>("editPreview").text() != inside;
  }));
  cut();
  EXPECT_TRUE(isThere({-12, 5, 0}));
  EXPECT_FALSE(isThere({-12, 0, 11}));
  EXPECT_FALSE(isThere(kSmallAt));
}

}  // namespace
