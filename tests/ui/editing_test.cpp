// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "app/window/edited_volume.h"
#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/edit/edited.h"
#include "haptics/scene/scene.h"
#include "sphere_in_hand.h"
#include "ui/number_box.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/edit_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/volume_view.h"
#include "window_support.h"

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using window::waitFor;

constexpr double kLarge_mm = 14.0, kSmall_mm = 5.0;
const Vector3d kLargeAt{-12, 0, 0}, kSmallAt{16, 0, 12};  // mm

/// Two balls of 100 in a cube of 64 mm about the origin, as a file.
fs::path twoBalls(const QTemporaryDir& folder) {
  const fs::path path = fs::path(folder.path().toStdString()) / "balls.nrrd";
  const auto large = window::ball(kLargeAt * 1e-3, kLarge_mm * 1e-3);
  const auto small = window::ball(kSmallAt * 1e-3, kSmall_mm * 1e-3);
  const auto volume =
      window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                       [&](const haptics::Vec3& p_W) { return std::max(large(p_W), small(p_W)); });
  EXPECT_TRUE(datasets::writeNrrd(*volume, path).has_value());
  return path;
}

/// The program with a scan on view, and what a user does to it.
class Editing : public testing::Test {
 protected:
  void open(const fs::path& scan, double isovalue) {
    app::Arguments arguments = window::recordedSphere(recordings_, "mouse");
    arguments.load.phantom = {};
    arguments.load.path = scan;
    arguments.load.isovalue = isovalue;
    application_ = std::make_unique<app::Application>(arguments);
    application_->start();
    ASSERT_TRUE(waitFor([&] { return application_->snapshot().scene != 0; }, 120.0));
    // a shortcut is the active window's
    window().activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window(), 20'000));
    press("View", "Edit");
  }
  void openBalls() { open(twoBalls(scans_), 50.0); }

  ui::MainWindow& window() { return application_->window(); }
  ui::EditPanel& panel() { return *window().findChild<ui::EditPanel*>(); }
  const haptics::Volume& volume() { return *application_->shown()->picture.volume; }
  template <class T = QAbstractButton>
  T& child(const char* name) {
    T* found = window().findChild<T*>(name);
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  void press(const char* menu, const char* entry) {
    for (QAction* top : window().menuBar()->actions())
      if (top->text().remove('&') == menu)
        for (QAction* action : top->menu()->actions())
          if (action->text().remove('&') == entry) action->trigger();
  }
  void click(const char* button) {
    QTest::mouseClick(&child(button), Qt::LeftButton);
    settle();
  }
  void type(const char* number, const char* text) {
    auto& box = child<ui::NumberBox>(number);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
  }
  /// Waits until no edit is under way, and the views have drawn what is there.
  void settle() {
    ASSERT_TRUE(waitFor([&] { return !application_->editing().isBusy(); }, 60.0));
    QTest::qWait(60);
  }
  /// Keeps the window's picture. What is painted over the 3-D view is not in a grab of the window.
  void keepWindow(const char* name) {
    QImage whole = window::pictureOf(window());
    ui::VolumeView& view = window().view();
    QPainter{&whole}.drawImage(view.mapTo(&window(), QPoint{}), view.grabFramebuffer());
    window::keep(whole, name);
  }
  bool previewed() {
    return waitFor([&] { return child<QLabel>("editPreview").isVisible(); }, 30.0);
  }
  QString message() { return child<QLabel>("message").text(); }
  bool messageIsShown() { return child<QLabel>("message").isVisible(); }

  static void mouse(QWidget& view, QEvent::Type type, QPointF at, Qt::MouseButtons held) {
    QMouseEvent event(type, at, view.mapToGlobal(at),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &event);
  }
  /// A drag with the left button; `before_release` is called with the button still down.
  static void drag(QWidget& view, const std::vector<QPointF>& way,
                   const std::function<void()>& before_release = {}) {
    mouse(view, QEvent::MouseButtonPress, way.front(), Qt::LeftButton);
    for (const QPointF& at : way) mouse(view, QEvent::MouseMove, at, Qt::LeftButton);
    if (before_release) before_release();
    mouse(view, QEvent::MouseButtonRelease, way.back(), Qt::NoButton);
  }
  static void clickAt(QWidget& view, QPointF at) { drag(view, {at}); }
  ui::SliceView& slice(ui::Plane plane) { return window().slice(plane); }
  QPointF inSpace(const Vector3d& p_mm) { return window().view().projected(p_mm * 1e-3); }

  /// Whether there is something at a place, by all that can tell: the field that is touched, the
  /// slice through it, the mesh. Fails if they disagree.
  bool isThere(const Vector3d& p_mm) {
    const haptics::ScalarField& field = application_->shown()->scene->field;
    const bool felt = field.value(field.indexOf(p_mm * 1e-3)) >= isovalue_;
    for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal}) {
      window().setCross(p_mm + Vector3d::Constant(0.3));
      QTest::qWait(20);
      ui::SliceView& view = slice(plane);
      const QImage image = window::pictureOf(view);
      // beside the lines of the crosshair
      const QPointF at = view.projected(p_mm) + QPointF{-4, 4};
      const QColor seen = image.pixelColor(at.toPoint());
      EXPECT_EQ(seen.red() > 60, felt) << "slice " << int(plane) << " at " << p_mm.transpose();
    }
    return felt;
  }
  /// Whether the surface is drawn where this place is seen from in front.
  bool isSeen(const Vector3d& p_mm) {
    const QImage picture = window::pictureAtRest(window().view());
    return window::surfaceColoured(picture.pixelColor(inSpace(p_mm).toPoint()));
  }
  /// Where the tool comes to when a hand pulls it there; mm.
  Vector3d pulledTo(const Vector3d& p_mm) {
    haptics::Pose hand = application_->snapshot().X_WD;
    const Vector3d from = hand.translation();
    for (int n = 1; n <= 60; ++n) {
      hand.translation() = from + (p_mm * 1e-3 - from) * (n / 60.0);
      application_->session().pull(hand);
      QTest::qWait(15);
    }
    QTest::qWait(400);
    return application_->snapshot().X_WP.translation() * 1e3;
  }

  QTemporaryDir recordings_, scans_;
  std::unique_ptr<app::Application> application_;
  double isovalue_ = 50.0;
};

TEST_F(Editing, ACropBoxIsDraggedInSlicesAndInThreeD) {
  openBalls();
  const std::shared_ptr<const haptics::Volume> scan = application_->shown()->picture.volume;
  const QImage before = window::pictureAtRest(window().view());
  EXPECT_TRUE(isThere({0, 0, 0}));
  EXPECT_TRUE(isThere(kSmallAt));
  window().setCross(Vector3d::Zero());
  click("cropTool");
  keepWindow("edit_crop_begun");
  ui::SliceView& axial = slice(ui::Plane::Axial);
  const QPointF face = axial.projected({32, 0, 0});
  bool changed_while_dragging = true;
  drag(axial, {face, axial.projected({20, 0, 0}), axial.projected({-10, 0, 0})},
       [&] { changed_while_dragging = volume().crop.has_value(); });
  EXPECT_FALSE(changed_while_dragging);
  settle();
  ASSERT_TRUE(volume().crop);
  EXPECT_NEAR(double(volume().crop->end[0]), 22.0, 1.0);
  EXPECT_EQ(volume().crop->first[0], 0);
  EXPECT_TRUE(window().windowTitle().contains("(edited)"));
  EXPECT_NEAR(child<ui::NumberBox>("crop0High").value(), double(volume().crop->end[0]) - 32.0,
              0.06);
  // in 3-D: the face towards S
  const double middle = 0.5 * (-32.0 + double(volume().crop->end[0]) - 32.0);
  ui::VolumeView& view = window().view();
  keepWindow("edit_crop_box");
  drag(view, {inSpace({middle, 0, 32}), inSpace({middle, 0, 20}), inSpace({middle, 0, 6})});
  settle();
  EXPECT_NEAR(double(volume().crop->end[2]), 38.0, 1.0);
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
  for (int n = 0; n < 3; ++n) {
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    settle();
  }
  EXPECT_FALSE(volume().crop);
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
  click("cropTool");  // off
  EXPECT_LT(window::differing(before, window::pictureAtRest(view)), 0.001);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
  EXPECT_TRUE(volume().crop);
  QTest::keyClick(&window(), Qt::Key_Y, Qt::ControlModifier);
  settle();
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  click("resetEdits");
  EXPECT_TRUE(application_->editing().edits().empty());
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
  // no voxel is kept that no slice showed
  const QPointF left =
      slice(ui::Plane::Axial).projected({double(volume().crop->first[0]) - 32.0 + 1.0, 0, 0});
  EXPECT_GE(left.x(), slice(ui::Plane::Axial).pictureRect().left());
  click("cropReset");
  EXPECT_FALSE(volume().crop);
}

TEST_F(Editing, AClipPlaneIsPlacedTurnedFlippedAndCuts) {
  openBalls();
  const std::shared_ptr<const haptics::Volume> scan = application_->shown()->picture.volume;
  window().setCross({-12, 0, 2});
  click("planeTool");
  click("planeFromAxial");
  EXPECT_NEAR(child<ui::NumberBox>("planePosition").value(), 2.0, 0.1);
  EXPECT_NEAR(child<ui::NumberBox>("planeRaised").value(), 90.0, 0.1);
  keepWindow("edit_plane");
  click("planeFlip");
  EXPECT_NEAR(child<ui::NumberBox>("planeRaised").value(), -90.0, 0.1);
  click("planeApply");
  EXPECT_FALSE(isThere({-12, 0, -4}));
  EXPECT_TRUE(isThere({-12, 0, 8}));
  EXPECT_FALSE(isSeen({-12, 0, -6}));
  EXPECT_TRUE(isSeen({-12, 0, 8}));
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_EQ(0, std::memcmp(volume().voxels.get(), scan->voxels.get(),
                           std::size_t(scan->grid.voxelCount()) * 2));

  // three clicks in one slice: a line upright on it, and the side that goes
  click("planeAgain");
  ui::SliceView& coronal = slice(ui::Plane::Coronal);
  for (const Vector3d& p : {Vector3d{-12, 0, 20}, Vector3d{-12, 0, -20}, Vector3d{0, 0, 0}})
    clickAt(coronal, coronal.projected(p));
  EXPECT_NEAR(child<ui::NumberBox>("planeTowards").value(), 0.0, 1.0);
  // the handle that turns, in the same slice: from L to S
  const double arm = 60.0 / (coronal.projected({1, 0, 0}).x() - coronal.projected({0, 0, 0}).x());
  drag(coronal, {coronal.projected({-12 + arm, 0, 0}), coronal.projected({-12 + arm, 0, arm}),
                 coronal.projected({-12, 0, arm})});
  EXPECT_NEAR(child<ui::NumberBox>("planeRaised").value(), 90.0, 4.0);
  type("planeRaised", "90");
  type("planePosition", "4");
  click("planeApply");
  EXPECT_TRUE(isThere({-12, 0, 0}));
  EXPECT_FALSE(isThere({-12, 0, 8}));
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();

  // three clicks on the surface, seen from in front: what is nearer goes
  click("planeAgain");
  for (const Vector3d& p : {Vector3d{-18, 0, -5}, Vector3d{-6, 0, -5}, Vector3d{-12, 0, 7}})
    clickAt(window().view(), inSpace(p));
  EXPECT_TRUE(child<ui::NumberBox>("planePosition").isVisible());
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

TEST_F(Editing, APieceIsShownWithItsVolumeAndKeptOrRemoved) {
  openBalls();
  const std::shared_ptr<const haptics::Volume> scan = application_->shown()->picture.volume;
  click("piecesTool");
  const QImage plain = window::pictureAtRest(window().view());
  clickAt(window().view(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  const QString words = child<QLabel>("editPreview").text();
  const double cm3 = QLocale().toDouble(words.section(' ', 2, 2));
  EXPECT_NEAR(cm3, 4.0 / 3.0 * 3.14159 * 0.125, 0.05) << words.toStdString();
  // nothing has changed but what is drawn over it
  EXPECT_EQ(application_->shown()->picture.volume, scan);
  const QImage shown = window::pictureAtRest(window().view());
  keepWindow("edit_piece");
  EXPECT_GT(window::differing(plain, shown), 0.002);
  click("removePiece");
  EXPECT_FALSE(isThere(kSmallAt));
  EXPECT_TRUE(isThere(kLargeAt));
  EXPECT_FALSE(isSeen(kSmallAt));
  // it does not come back when the isovalue falls
  const haptics::ScalarField& field = application_->shown()->scene->field;
  for (double x = kSmallAt.x() - 9.0; x < kSmallAt.x() + 9.0; x += 0.5)
    EXPECT_LT(field.value(field.indexOf(Vector3d{x, 0, 12} * 1e-3)), 5.0) << x;
  // the hand goes where it was
  const Vector3d tool = pulledTo(kSmallAt);
  EXPECT_LT((tool - kSmallAt).norm(), 1.0) << tool.transpose();
  pulledTo({16, -28, 12});
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_TRUE(isThere(kSmallAt));
  EXPECT_EQ(0, std::memcmp(volume().voxels.get(), scan->voxels.get(),
                           std::size_t(scan->grid.voxelCount()) * 2));
  EXPECT_GT((pulledTo(kSmallAt) - kSmallAt).norm(), 4.0);
  pulledTo({16, -28, 12});

  // in a slice, and kept
  window().setCross(kSmallAt);
  clickAt(slice(ui::Plane::Axial), slice(ui::Plane::Axial).projected(kSmallAt + Vector3d{1, 1, 0}));
  ASSERT_TRUE(previewed());
  click("keepPiece");
  EXPECT_TRUE(isThere(kSmallAt));
  EXPECT_FALSE(isThere(kLargeAt));
  // air is no piece
  clickAt(slice(ui::Plane::Axial), slice(ui::Plane::Axial).projected({-25, 25, 12}));
  EXPECT_TRUE(waitFor([&] { return messageIsShown(); }, 10.0));
}

TEST_F(Editing, SmallPiecesAreShownAndRemoved) {
  openBalls();
  click("piecesTool");
  type("smallVolume", "0.1");
  click("showSmall");
  // both are larger: a sentence
  EXPECT_TRUE(waitFor([&] { return messageIsShown(); }, 10.0));
  type("smallVolume", "1");
  click("showSmall");
  ASSERT_TRUE(previewed());
  EXPECT_TRUE(child<QLabel>("editPreview").text().contains("0.5") ||
              child<QLabel>("editPreview").text().contains("0,5"))
      << child<QLabel>("editPreview").text().toStdString();
  EXPECT_TRUE(isThere(kSmallAt));
  click("cancelPreview");
  EXPECT_FALSE(child<QLabel>("editPreview").isVisible());
  click("showSmall");
  ASSERT_TRUE(previewed());
  click("applyRemoval");
  EXPECT_FALSE(isThere(kSmallAt));
  EXPECT_TRUE(isThere(kLargeAt));
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
  bool drawn = false;
  drag(window().view(), around(space, -12, 0, 5), [&] {
    drawn = true;
    keepWindow("edit_lasso");
  });
  EXPECT_TRUE(drawn);
  settle();
  // through everything
  for (const double y : {-12.0, 0.0, 12.0}) EXPECT_FALSE(isThere({-12, y, 0})) << y;
  EXPECT_TRUE(isThere({-12, 0, 9}));
  EXPECT_FALSE(isSeen({-12, 0, 0}));
  EXPECT_TRUE(isSeen({-12, 0, 9}));
  const Vector3d tool = pulledTo({-12, -2, 0});
  EXPECT_LT((tool - Vector3d{-12, -2, 0}).norm(), 1.0) << tool.transpose();
  pulledTo({-12, -29, 0});
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  // as deep as a number says
  type("scalpelDepth", "6");
  drag(window().view(), around(space, -12, 0, 5));
  settle();
  EXPECT_FALSE(isThere({-12, -11, 0}));
  EXPECT_TRUE(isThere({-12, -5, 0}));
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  // on a slice, to both sides, and what is outside
  window().setCross({-12, 0, 0});
  ui::SliceView& coronal = slice(ui::Plane::Coronal);
  const auto flat = [&](const Vector3d& p) { return coronal.projected(p); };
  drag(coronal, around(flat, -12, 0, 5));
  settle();
  EXPECT_FALSE(isThere({-12, 5, 0}));
  EXPECT_FALSE(isThere({-12, -5, 0}));
  EXPECT_TRUE(isThere({-12, 8, 0}));
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  type("scalpelDepth", "0");
  child<QComboBox>("scalpelSide").setCurrentIndex(1);
  drag(coronal, around(flat, -12, 0, 8));
  settle();
  EXPECT_TRUE(isThere({-12, 5, 0}));
  EXPECT_FALSE(isThere({-12, 0, 11}));
  EXPECT_FALSE(isThere(kSmallAt));
}

TEST_F(Editing, UndoWaitsUntilTheToolIsOutOfContactAndSaysSo) {
  openBalls();
  click("piecesTool");
  clickAt(window().view(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  click("removePiece");
  pulledTo({-12, -29, 0});
  pulledTo({-12, -5, 0});
  ASSERT_GT(application_->snapshot().contacts, 0);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  QTest::qWait(500);
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_EQ(child<QLabel>("editWait").text(), "Undo waits until the tool no longer touches.");
  EXPECT_TRUE(child<QLabel>("editWait").isVisible());
  keepWindow("edit_waits");
  // taken back
  QTest::mouseClick(&child("cancelEditWait"), Qt::LeftButton);
  EXPECT_FALSE(child<QLabel>("editWait").isVisible());
  EXPECT_FALSE(application_->editing().isBusy());
  // and again, until the hand lets go
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(child<QLabel>("editWait").isVisible());
  const haptics::Vec3 before = application_->snapshot().X_WP.translation();
  EXPECT_GT(application_->snapshot().felt_W.force.norm(), 0.0);
  pulledTo({-12, -29, 0});
  settle();
  EXPECT_TRUE(application_->editing().edits().empty());
  EXPECT_FALSE(child<QLabel>("editWait").isVisible());
  EXPECT_GT((application_->snapshot().X_WP.translation() - before).norm(), 5e-3);
}

TEST_F(Editing, AnEditLeavesToolAndCameraWhereTheyAre) {
  openBalls();
  window().view().camera()->Azimuth(20.0);
  pulledTo({-12, -29, 0});
  pulledTo({-12, -5, 0});
  ASSERT_GT(application_->snapshot().contacts, 0);
  const haptics::Vec3 before = application_->snapshot().X_WP.translation();
  const Vector3d eye{window().view().camera()->GetPosition()};
  click("piecesTool");
  clickAt(window().view(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  click("removePiece");
  QTest::qWait(300);
  EXPECT_LT((application_->snapshot().X_WP.translation() - before).norm(), 0.5e-3);
  EXPECT_EQ(application_->snapshot().scene, application_->shown()->scene->id);
  EXPECT_EQ((Vector3d{window().view().camera()->GetPosition()} - eye).norm(), 0.0);
  // Escape ends what the mouse was for, and the force
  QTest::keyClick(&window().view(), Qt::Key_Escape);
  EXPECT_EQ(panel().tool(), ui::EditTool::None);
  EXPECT_TRUE(waitFor(
      [&] { return application_->snapshot().force_state == haptics::ForceState::Ready; }, 5.0));
}

TEST_F(Editing, AnotherToolKeepsTheEditsAndAnotherVolumeDropsThem) {
  openBalls();
  application_->editing().restore({haptics::Crop{{{0, 0, 0}, {40, 64, 64}}},
                                   haptics::RemovePiece{haptics::Vec3{-12e-3, 0, 0}, 50.0}});
  settle();
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  EXPECT_FALSE(isThere(kLargeAt));
  EXPECT_TRUE(window().windowTitle().contains("(edited)"));
  const auto scene = application_->shown()->scene;
  emit window::panelOf<ui::DevicePanel>(window()).toolChosen("peg");
  ASSERT_TRUE(waitFor([&] { return application_->shown()->scene != scene; }, 60.0));
  QTest::qWait(100);
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  EXPECT_FALSE(isThere(kLargeAt));
  // an edit that cannot be made leaves what is there
  application_->editing().restore({haptics::RemovePiece{haptics::Vec3{28e-3, 28e-3, 28e-3}, 50.0}});
  settle();
  EXPECT_TRUE(messageIsShown());
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  emit window().phantomWanted("torus");
  ASSERT_TRUE(waitFor([&] { return application_->shown()->title.contains("torus"); }, 60.0));
  QTest::qWait(100);
  EXPECT_TRUE(application_->editing().edits().empty());
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
  EXPECT_FALSE(window().findChild<QAction*>("undo")->isEnabled());
}

TEST_F(Editing, TheEditedVolumeIsSavedAndTheInputIsNotWrittenOver) {
  openBalls();
  const fs::path input = fs::path(scans_.path().toStdString()) / "balls.nrrd";
  const auto input_time = fs::last_write_time(input);
  application_->editing().restore({haptics::Crop{{{10, 0, 5}, {40, 64, 60}}}});
  settle();
  EXPECT_TRUE(window().findChild<QAction*>("saveEdited")->isEnabled());
  emit window().saveEditedWanted(QString::fromStdString(input.string()));
  ASSERT_TRUE(waitFor([&] { return messageIsShown(); }, 20.0));
  EXPECT_TRUE(message().contains("is not written over")) << message().toStdString();
  EXPECT_EQ(fs::last_write_time(input), input_time);
  const fs::path out = fs::path(scans_.path().toStdString()) / "saved.nrrd";
  emit window().saveEditedWanted(QString::fromStdString(out.string()));
  ASSERT_TRUE(waitFor([&] { return message().contains("was saved"); }, 20.0));
  emit window().openWanted(QString::fromStdString(out.string()));
  ASSERT_TRUE(waitFor([&] { return volume().grid.dims[0] == 30; }, 60.0));
  EXPECT_EQ(volume().grid.dims, (std::array<std::int64_t, 3>{30, 64, 55}));
  QTest::qWait(100);
  EXPECT_TRUE(isThere({-12, 0, 0}));
  EXPECT_NEAR(volume().grid.origin.x(), -21.5e-3, 1e-9);
  EXPECT_NEAR(volume().grid.origin.z(), -26.5e-3, 1e-9);
}

TEST_F(Editing, AReplayShowsTheScanAsItWasThen) {
  openBalls();
  auto* record = window().findChild<QAbstractButton*>("record");
  ASSERT_NE(record, nullptr);
  QTest::mouseClick(record, Qt::LeftButton);
  QTest::qWait(700);
  application_->editing().restore({haptics::RemovePiece{kSmallAt * 1e-3, 50.0}});
  settle();
  QTest::qWait(700);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
  QTest::qWait(400);
  QTest::mouseClick(record, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !application_->recording().isRecording(); }, 20.0));
  const auto finished = [&]() -> fs::path {
    for (const auto& file : fs::directory_iterator(recordings_.path().toStdString()))
      if (file.path().extension() == ".palpate") return file.path();
    return {};
  };
  ASSERT_TRUE(waitFor([&] { return !finished().empty(); }, 30.0));
  QTest::qWait(300);
  emit window().recordingWanted(QString::fromStdString(finished().string()));
  ASSERT_NE(application_->replay(), nullptr);
  EXPECT_FALSE(panel().isEnabled());
  const double begin = application_->replay()->track().begin;
  EXPECT_TRUE(waitFor([&] { return isSeen(kSmallAt); }, 10.0));
  // after the edit it is gone, and comes back with the time
  emit window().replayBar().timeWanted(begin + 1.2);
  EXPECT_TRUE(waitFor([&] { return !isSeen(kSmallAt); }, 20.0)) << message().toStdString();
  emit window().replayBar().timeWanted(begin + 0.2);
  EXPECT_TRUE(waitFor([&] { return isSeen(kSmallAt); }, 20.0));
  emit window().replayBar().timeWanted(begin + 1.2);
  EXPECT_TRUE(waitFor([&] { return !isSeen(kSmallAt); }, 20.0));
  emit window().replayBar().closeWanted();
  EXPECT_TRUE(waitFor([&] { return isSeen(kSmallAt); }, 20.0));
  EXPECT_TRUE(panel().isEnabled());
}

TEST_F(Editing, NewerEditsWaitTheirTurn) {
  openBalls();
  for (int n = 1; n <= 55; ++n) {
    auto& number = child<ui::NumberBox>("crop0High");
    if (n == 1) QTest::mouseClick(&child("cropTool"), Qt::LeftButton);
    number.setValue(32.0 - 0.5 * n - 0.5 * (n % 2));
    if (n % 2 == 0) continue;
    QTest::mouseClick(&child("cropApply"), Qt::LeftButton);
  }
  settle();
  const auto edits = application_->editing().edits();
  EXPECT_GT(edits.size(), 20U);
  for (std::size_t n = edits.size(); n > 0; --n) {
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    if (n % 7 == 0) settle();
  }
  settle();
  EXPECT_TRUE(application_->editing().edits().empty());
  EXPECT_FALSE(volume().crop);
}

TEST_F(Editing, FiftyEditsAreTakenBackOneByOneToTheByte) {
  openBalls();
  constexpr int kEdits = 52;
  struct Was {
    std::optional<haptics::VoxelBox> crop;
    std::vector<char> voxels;
  };
  const auto now = [&] {
    const auto* bytes = static_cast<const char*>(volume().voxels.get());
    return Was{volume().crop, {bytes, bytes + volume().grid.voxelCount() * 2}};
  };
  std::vector<Was> was;
  for (int n = 0; n < kEdits; ++n) {
    was.push_back(now());
    if (n % 2 == 0) {
      if (n == 0 || panel().tool() != ui::EditTool::Crop) click("cropTool");
      child<ui::NumberBox>("crop0High").setValue(31.0 - 0.5 * n);
      click("cropApply");
    } else {
      if (panel().tool() != ui::EditTool::Plane) click("planeTool");
      window().setCross({0, 0, 14.0 - 0.5 * n});
      click("planeFromAxial");
      click("planeApply");
    }
    ASSERT_EQ(int(application_->editing().edits().size()), n + 1) << message().toStdString();
  }
  for (int n = kEdits; n-- > 0;) {
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return !application_->editing().isBusy(); }, 60.0));
    const Was then = now();
    EXPECT_EQ(then.crop, was[std::size_t(n)].crop) << n;
    EXPECT_TRUE(then.voxels == was[std::size_t(n)].voxels) << n;
  }
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
}

TEST_F(Editing, AnEditThatIsCancelledChangesNothing) {
  openBalls();
  click("planeTool");
  window().setCross({0, 0, 10});
  click("planeFromAxial");
  click("planeApply");
  const auto before = application_->shown()->picture.volume;
  window().setCross({0, 0, 0});
  click("planeFromAxial");
  QTest::mouseClick(&child("planeApply"), Qt::LeftButton);
  ASSERT_TRUE(application_->editing().isBusy());
  emit window().cancelWanted();
  settle();
  EXPECT_EQ(application_->shown()->picture.volume, before);
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_FALSE(messageIsShown()) << message().toStdString();
  EXPECT_TRUE(window().findChild<QAction*>("undo")->isEnabled());
  EXPECT_FALSE(window().findChild<QAction*>("redo")->isEnabled());
  // and the next is made
  click("planeFromAxial");
  click("planeApply");
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  EXPECT_FALSE(isThere({-12, 0, 3}));
}

/// A ball as a mesh file, mm.
fs::path ballFile(const QTemporaryDir& folder, double diameter_mm) {
  constexpr int kRings = 12, kAround = 24;
  const auto at = [&](int ring, int around) -> Vector3d {
    const double down = 3.14159265358979 * ring / kRings;
    const double turn = 2.0 * 3.14159265358979 * (around % kAround) / kAround;
    return Vector3d{std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn),
                    std::cos(down)} *
           (0.5 * diameter_mm);
  };
  const fs::path path = fs::path(folder.path().toStdString()) / "burr.stl";
  std::ofstream out{path};
  out << "solid burr\n";
  const auto triangle = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const Vector3d& p : {a, b, c}) out << "vertex " << p.transpose() << '\n';
    out << "endloop\nendfacet\n";
  };
  for (int ring = 0; ring < kRings; ++ring)
    for (int n = 0; n < kAround; ++n) {
      const Vector3d a = at(ring, n), b = at(ring + 1, n), c = at(ring + 1, n + 1);
      const Vector3d d = at(ring, n + 1);
      if (ring + 1 < kRings) triangle(a, b, c);
      if (ring > 0) triangle(a, c, d);
    }
  out << "endsolid burr\n";
  return path;
}

// What a surgeon does first: the holder goes, and the mastoid that it hid is touched with a burr.
TEST_F(Editing, TheHolderOfAScanIsRemovedAndTheMastoidBehindItTouched) {
  const fs::path scan = fs::path(PALPATE_SCANS) / "philips_head_phantom/bone_1mm";
  if (!fs::exists(scan)) GTEST_SKIP() << "NOT CHECKED: no scan with a holder here";
  // behind the left ear canal, seen in the slices: bone begins at x = 54.6, the holder's wall lies
  // at 99 to 102, in the way from the left
  const Vector3d mastoid{54.6, 130.0, 708.2};
  constexpr double kHolder_mm = 99.0, kBurr_mm = 4.0;
  isovalue_ = 300.0;
  const auto begin = std::chrono::steady_clock::now();
  int actions = 1;  // the folder was opened
  open(scan, isovalue_);
  ASSERT_FALSE(HasFatalFailure());
  ui::VolumeView& view = window().view();
  const auto act = [&](const auto& what) {
    ++actions;
    what();
  };
  act([&] {
    const auto scene = application_->shown()->scene;
    emit window::panelOf<ui::DevicePanel>(window()).toolFileChosen(
        QString::fromStdString(ballFile(scans_, kBurr_mm).string()), "mm");
    ASSERT_TRUE(waitFor([&] { return application_->snapshot().scene != scene->id; }, 60.0));
  });
  EXPECT_NEAR(application_->shown()->scene->tool.shell.radius, 0.5 * kBurr_mm * 1e-3, 0.2e-3);
  // a double click on a place brings the burr to what is seen there, and a hand presses it on
  const auto bring = [&] {
    const QPointF at = inSpace(mastoid);
    clickAt(view, at);
    mouse(view, QEvent::MouseButtonDblClick, at, Qt::LeftButton);
    mouse(view, QEvent::MouseButtonRelease, at, Qt::NoButton);
    QTest::qWait(1'500);
  };
  const auto press_on = [&] {
    const Vector3d burr = pulledTo(mastoid - Vector3d{2.0, 0, 0});
    std::printf("  the burr's middle comes to x = %.2f, y = %.2f, z = %.2f mm\n", burr.x(),
                burr.y(), burr.z());
    return burr;
  };
  act([&] { QTest::keyClick(&view, Qt::Key_3); });
  const double until_holder =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  // not counted: as it is without the edit
  window::pictureAtRest(view);
  bring();
  EXPECT_GT(press_on().x(), kHolder_mm);
  EXPECT_GT(application_->snapshot().contacts, 0);
  pulledTo({108.0, mastoid.y(), mastoid.z()});

  const auto again = std::chrono::steady_clock::now();
  act([&] { press("Edit", "Table and holder"); });
  EXPECT_EQ(panel().tool(), ui::EditTool::Holder);
  act([&] { click("showHolder"); });
  ASSERT_TRUE(previewed()) << message().toStdString();
  const QString words = child<QLabel>("editPreview").text();
  EXPECT_TRUE(words.contains("cm³")) << words.toStdString();
  keepWindow("edit_holder");
  act([&] { click("applyRemoval"); });
  ASSERT_EQ(application_->editing().edits().size(), 1U);
  window::pictureAtRest(view);
  keepWindow("edit_holder_gone");
  act(bring);
  Vector3d burr;
  act([&] { burr = press_on(); });
  EXPECT_GT(application_->snapshot().contacts, 0);
  // a ball that touches the bone there: half its diameter away
  EXPECT_LT((burr - mastoid).norm(), 0.5 * kBurr_mm + 2.0) << burr.transpose();
  EXPECT_GT(burr.x(), mastoid.x());
  keepWindow("edit_mastoid_touched");
  EXPECT_LT(actions, 12);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - again;
  std::printf("holder removed, mastoid touched: %d actions, %.1f s; %s\n", actions,
              until_holder + took.count(), words.toUtf8().constData());
}

// Not a check: prints how long edits of a large scan take, from wanting one to the new scene.
TEST_F(Editing, DISABLED_TimesOfEditsOfALargeScan) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  };
  {
    haptics::Grid grid = window::cubeGrid(512);
    grid.spacing *= 0.4;
    grid.origin *= 0.4;
    const auto large = window::ball({-25e-3, 0, 0}, 60e-3);
    const auto small = window::ball({70e-3, 0, 40e-3}, 20e-3);
    const auto scan =
        window::volumeOf(grid, haptics::ScalarType::Int16, [&](const haptics::Vec3& p) {
          return std::max(large(p), small(p)) * 20.0 + 40.0 * std::sin(p.x() * 5e3 + p.y() * 3e3);
        });
    const fs::path path = fs::path(scans_.path().toStdString()) / "large.nrrd";
    ASSERT_TRUE(datasets::writeNrrd(*scan, path).has_value());
    isovalue_ = 1000.0;
    open(path, isovalue_);
  }
  const haptics::Edit box = haptics::Crop{{{40, 40, 40}, {470, 480, 500}}};
  const haptics::Edit piece = haptics::RemovePiece{haptics::Vec3{70e-3, 0, 40e-3}, isovalue_};
  haptics::LassoCut lasso;
  for (int n = 0; n < 60; ++n)
    lasso.outline.push_back(
        {0.03 * std::cos(n * 6.2831853 / 60), 0.03 * std::sin(n * 6.2831853 / 60)});
  lasso.parallel = true;
  lasso.X_WC.translation() = haptics::Vec3{-25e-3, 0, 0.3};
  lasso.isovalue = isovalue_;
  const std::pair<const char*, haptics::Edit> all[] = {
      {"box", box}, {"lasso", lasso}, {"piece", piece}};
  for (int round = 0; round < 3; ++round) {
    for (const auto& [name, edit] : all) {
      const auto scene = application_->shown()->scene;
      const Clock::time_point begin = Clock::now();
      application_->editing().restore({edit});
      while (application_->shown()->scene == scene && since(begin) < 60'000.0)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
      std::printf("%-6s wanted to adopted: %.0f ms", name, since(begin));
      // its parts, one after the other, on this thread
      const auto scan = scene->volume->edited ? scene->volume->edited->scan : scene->volume;
      haptics::EditHistory history{scan};
      const ui::Picture before = ui::pictureOf(scan);
      const auto base = haptics::makeScene(scan, scene->tool).value();
      Clock::time_point part = Clock::now();
      const auto volume = history.apply(edit).value();
      std::printf("; edit %.0f", since(part));
      part = Clock::now();
      const auto built = haptics::makeScene(volume, scene->tool, {}, base.get());
      std::printf(", scene %.0f", since(part));
      part = Clock::now();
      const auto picture = ui::pictureOf(volume, before, volume->edited->changed);
      std::printf(", picture %.0f", since(part));
      part = Clock::now();
      const auto whole = ui::pictureOf(volume);
      std::printf(" (anew %.0f", since(part));
      part = Clock::now();
      const auto histogram = ui::histogramOf(*volume, 256);
      std::printf(", histogram %.0f) ms\n", since(part));
      const auto* a = static_cast<const float*>(picture.reduced->GetScalarPointer());
      const auto* b = static_cast<const float*>(whole.reduced->GetScalarPointer());
      EXPECT_TRUE(std::equal(a, a + picture.reduced->GetNumberOfPoints(), b));
      application_->editing().restore({});
      settle();
    }
  }
}

}  // namespace
