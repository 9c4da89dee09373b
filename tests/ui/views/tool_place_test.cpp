// SPDX-License-Identifier: BSD-3-Clause
// The tool comes to where the user points: outside the surface, along its normal, without a jump of
// the force.
#include "app/window/scan/tool_place.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "app/window/scan/touched_surface.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/session.h"
#include "tests/ui/sessions/hand_device.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

using haptics::Pose;
using haptics::Vec3;
using window::waitFor;

haptics::Tool burr(double radius) {
  std::vector<Vec3> points;
  for (int n = 0; n < 300; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / 300.0, r = std::sqrt(1.0 - z * z);
    points.emplace_back(radius * r * std::cos(2.4 * n), radius * r * std::sin(2.4 * n), radius * z);
  }
  // and a shaft
  for (int n = 0; n < 60; ++n) points.emplace_back(0.0, 0.0, radius + 0.001 * n);
  return {.name = "burr", .mesh = {}, .shell = *haptics::makeShell(points)};
}

std::shared_ptr<const haptics::Scene> sceneOf(const std::function<double(const Vec3&)>& intensity,
                                              double burr_radius) {
  return *haptics::makeScene(
      window::volumeOf(window::cubeGrid(80), haptics::ScalarType::Int16, intensity),
      burr(burr_radius));
}

bool isLegal(const haptics::Scene& scene, double isovalue, const Pose& X) {
  haptics::Budget unlimited = haptics::Budget::counted(1'000'000'000);
  return haptics::legal(haptics::Isosurface{scene.field, isovalue}, scene.tool.shell, X, unlimited);
}

TEST(ToolPlace, StandsJustOffTheSurfaceAlongItsNormal) {
  const auto scene = sceneOf(window::ball(Vec3::Zero(), 0.025), 0.002);
  int placed = 0;
  for (const Vec3& way : {Vec3{0.0, -1.0, 0.0}, Vec3{1.0, 0.2, 0.3}, Vec3{-0.4, 0.5, -0.7}}) {
    const Vec3 normal = way.normalized();
    const Pose now = haptics::poseOf({0.0, -0.035, 0.0}, haptics::Quat{0.8, 0.2, -0.5, 0.1});
    const auto X = app::poseAt(*scene, 50.0, {0.025 * normal, normal}, now);
    ASSERT_TRUE(X);
    EXPECT_TRUE(isLegal(*scene, 50.0, *X));
    EXPECT_GT(X->linear().col(2).dot(normal), 0.9999);
    const Vec3 tip = *X * scene->tool.shell.tip;
    EXPECT_GT(tip.norm(), 0.025);
    EXPECT_LT(tip.norm(), 0.0275);  // m
    EXPECT_LT((tip.normalized() - normal).norm(), 1e-3);
    ++placed;
  }
  EXPECT_EQ(placed, 3);
}

TEST(ToolPlace, LeansWhereTheNormalLeavesNoRoomAndNeverGoesThroughAWall) {
  // a slot of 12 mm between two plates, open towards the front: the normal of a plate leads the
  // shaft into the other
  const auto slot = [](const Vec3& p) {
    return std::abs(p.x()) > 0.006 && p.y() > -0.020 ? 100.0 : 0.0;
  };
  const auto scene = sceneOf(slot, 0.0015);
  const auto X =
      app::poseAt(*scene, 50.0, {{0.006, -0.010, 0.0}, -Vec3::UnitX()}, Pose::Identity());
  ASSERT_TRUE(X);
  EXPECT_TRUE(isLegal(*scene, 50.0, *X));
  const Vec3 tip = *X * scene->tool.shell.tip;
  EXPECT_GT(tip.x(), -0.006);  // still in the slot
  EXPECT_LT(tip.x(), 0.006);
  EXPECT_LT((tip - Vec3{0.006, -0.010, 0.0}).norm(), 0.008);
  // in a closed hole there is none
  const auto hole = [](const Vec3& p) { return p.norm() < 0.0012 ? 0.0 : 100.0; };
  EXPECT_FALSE(app::poseAt(*sceneOf(hole, 0.0015), 50.0, {{0.0012, 0.0, 0.0}, -Vec3::UnitX()},
                           Pose::Identity()));
}

TEST(ToolPlace, FindsTheNearestSurfaceFromBothSides) {
  const auto scene = sceneOf(window::ball(Vec3::Zero(), 0.025), 0.002);
  for (const double r : {0.015, 0.030}) {
    const auto place = app::nearestSurface(*scene, 50.0, {0.0, -r, 0.0});
    ASSERT_TRUE(place) << r;
    EXPECT_NEAR(place->p_W.norm(), 0.025, 3e-4);
    EXPECT_LT(place->p_W.y(), -0.023);
    EXPECT_GT(place->normal_W.dot(place->p_W.normalized()), 0.99);
  }
  EXPECT_FALSE(app::nearestSurface(*scene, 50.0, {0.0, -0.058, 0.0}));
}

/// Largest force, and largest rise of it in a tick, over so many ticks. No event is handled
/// meanwhile: the window would take the samples.
std::pair<double, double> forcesFor(app::Application& application, std::size_t ticks) {
  std::vector<haptics::ForceSample> some(4096);
  std::vector<double> all;
  while (all.size() < ticks) {
    const std::size_t count = application.session().forces(some);
    for (std::size_t n = 0; n < count; ++n) all.push_back(some[n].force);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  double steepest = 0.0, greatest = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    greatest = std::max(greatest, all[i]);
    if (i > 0) steepest = std::max(steepest, all[i] - all[i - 1]);
  }
  return {greatest, steepest};
}

TEST(ToolPlace, TheMouseComesThereWithItsHandAndRestsOnTheSurface) {
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.load.tool = app::ToolSource{.name = "sphere"};
  app::Application application(arguments);
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::VolumeView& view = application.window().views().volume();
  window::afterTicks(application, 300);
  view.lookFrom(ui::Side::Left);
  window::pictureAtRest(view);
  const Vec3 before = application.snapshot().X_WP.translation();
  const QPointF middle(view.width() * 0.5 + 20.0, view.height() * 0.5 - 15.0);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, middle.toPoint());
  // from the very tick on
  const auto [greatest, steepest] = forcesFor(application, 1'300);
  EXPECT_GT(greatest, 0.02);  // N: it rests on the surface
  EXPECT_LT(greatest, 0.5);
  EXPECT_LT(steepest, 0.02);
  ASSERT_TRUE(
      waitFor([&] { return (application.snapshot().X_WP.translation() - before).norm() > 0.005; }));
  const haptics::Snapshot& now = application.snapshot();
  // from the left: the tool is in front of what is seen, its tip towards it
  EXPECT_GT(now.X_WP.translation().x(), before.x() + 0.005);
  EXPECT_GT(now.contacts, 0);
  EXPECT_LT((now.X_WP.translation() - now.X_WD.translation()).norm(), 5e-4);
  const auto touched = app::touchedSurfaceOf(application.shown()->scene);
  const Vec3 tip = now.X_WP * application.shown()->scene->tool.shell.tip;
  const auto met =
      touched.firstMet(tip, tip - 0.01 * now.X_WP.linear().col(2), application.shown()->isovalue);
  ASSERT_TRUE(met);
  EXPECT_LT((met->p_W - tip).norm(), 0.003);
  EXPECT_GT(met->normal_W.dot(now.X_WP.linear().col(2)), 0.99);
  EXPECT_LT(QLineF(view.projected(met->p_W), middle).length(), 3.0);
  // the hand goes on from there
  view.setMouseMode(ui::MouseMode::Hand);
  for (int i = 0; i < 3; ++i) {
    QWheelEvent wheel(middle, view.mapToGlobal(middle), {}, {0, 120}, {}, {}, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&view, &wheel);
  }
  EXPECT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.3; }));
  EXPECT_GT(application.snapshot().places[0].p_W[0], before.x());
  // out of a contact, elsewhere, while the mouse still holds it: no jump
  view.lookFrom(ui::Side::Anterior);
  window::afterTicks(application, 100);
  const Vec3 pressed = application.snapshot().X_WP.translation();
  QTest::mouseDClick(&view, Qt::LeftButton, {},
                     QPoint(view.width() / 2 - 20, view.height() / 2 + 20));
  EXPECT_LT(forcesFor(application, 900).second, 0.05);
  ASSERT_TRUE(waitFor(
      [&] { return (application.snapshot().X_WP.translation() - pressed).norm() > 0.005; }));
  window::afterTicks(application, 200);
  EXPECT_LT(application.snapshot().felt_W.force.norm(), 0.5);
  // of a spring that is none the hand goes no farther than a few millimetres
  emit window::panelOf<ui::DevicePanel>(application.window()).stiffnessChanged(0.0);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, QPoint(view.width() / 2, view.height() / 2));
  window::afterTicks(application, 300);
  const haptics::Snapshot& soft = application.snapshot();
  EXPECT_LT((soft.X_WD.translation() - soft.X_WP.translation()).norm(), 0.010);
}

TEST(ToolPlace, AClickInASliceAndTheCrosshairAndASimulatedHand) {
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.load.tool = app::ToolSource{.name = "sphere"};
  app::Application application(arguments);
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::MainWindow& window = application.window();
  ui::SliceView& axial = window.views().slice(ui::Plane::Axial);
  const haptics::Scene& scene = *application.shown()->scene;
  const auto tip = [&] { return Vec3{application.snapshot().X_WP * scene.tool.shell.tip}; };
  // the middle of the patient's left half, inside: to the nearest surface
  const Vec3 before = tip();
  const haptics::Grid& grid = application.shown()->picture.volume->grid;
  const Vec3 middle = grid.worldOf(
      0.5 * Vec3(double(grid.dims[0] - 1), double(grid.dims[1] - 1), double(grid.dims[2] - 1)));
  const auto surface =
      app::touchedSurfaceOf(application.shown()->scene)
          .firstMet(middle + Vec3{0.2, 0.0, 0.0}, middle, application.shown()->isovalue);
  ASSERT_TRUE(surface);
  const Vec3 inside = surface->p_W - Vec3{0.004, 0.0, 0.0};
  QTest::mouseDClick(&axial, Qt::LeftButton, {}, axial.projected(inside * ui::kMmPerM).toPoint());
  ASSERT_TRUE(waitFor([&] { return (tip() - before).norm() > 0.005; }));
  EXPECT_LT((tip() - surface->p_W).norm(), 0.006);
  // the crosshair comes to the tool, and the tool to the crosshair
  const auto entry = [&](const char* name) { window.findChild<QAction*>(name)->trigger(); };
  entry("crossToTool");
  EXPECT_LT((window.views().cross_mm() * 1e-3 - tip()).norm(), 1e-3);
  const Vec3 open = surface->p_W + Vec3{0.010, 0.0, 0.003};
  window.views().setCross(open * ui::kMmPerM);
  entry("toolToCross");
  EXPECT_TRUE(waitFor([&] { return (tip() - open).norm() < 1e-4; }));
  // a simulated hand taps there from now on
  emit window::panelOf<ui::DevicePanel>(window).handChosen("tap");
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  window.views().setCross(inside * ui::kMmPerM);
  entry("toolToCross");
  EXPECT_TRUE(waitFor([&] {
    return application.snapshot().contacts > 0 && (tip() - surface->p_W).norm() < 0.008;
  }));
}

TEST(ToolPlace, ADeviceStaysInTheHandWhileItsMappingMoves) {
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.load.tool = app::ToolSource{.name = "sphere"};
  app::Application application(arguments);
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  const auto handle = std::make_shared<window::Handle>();
  ASSERT_TRUE(application.session().open(std::make_unique<window::HandDevice>(handle)));
  application.session().arm();
  ASSERT_TRUE(waitFor([&] {
    return application.snapshot().force_state == haptics::ForceState::On ||
           application.snapshot().force_state == haptics::ForceState::Armed ||
           application.snapshot().force_state == haptics::ForceState::Ramping;
  }));
  const Vec3 held = handle->led();
  const Vec3 before = application.snapshot().X_WP.translation();
  ui::VolumeView& view = application.window().views().volume();
  view.lookFrom(ui::Side::Left);
  const std::size_t first = handle->written.load();
  QTest::mouseDClick(&view, Qt::LeftButton, {}, QPoint(view.width() / 2, view.height() / 2));
  ASSERT_TRUE(
      waitFor([&] { return (application.snapshot().X_WP.translation() - before).norm() > 0.005; }));
  window::afterTicks(application, 100);
  EXPECT_EQ(handle->led(), held);
  EXPECT_EQ(handle->pushesSince(first), 0);
  const Vec3 there = application.snapshot().X_WP.translation();
  EXPECT_LT((application.snapshot().X_WD.translation() - there).norm(), 1e-6);
  // 3 mm of the hand, away from the surface, are 3 mm of the tool
  handle->lead(held + Vec3{0.003, 0.0, 0.0});
  ASSERT_TRUE(waitFor([&] { return handle->arrived(); }));
  window::afterTicks(application, 100);
  EXPECT_NEAR((application.snapshot().X_WD.translation() - there).norm(),
              0.003 * application.session().inForce().position_scale, 1e-5);
  application.session().close();
}

/// Answers dialogs as they come.
class Answers : public QObject {
 public:
  explicit Answers(QString path) : path_(std::move(path)) {
    connect(&timer_, &QTimer::timeout, this, &Answers::answer);
    timer_.start(50);
  }
  QStringList seen;
  QString offered;   ///< what the picture was offered of at first
  QString proposed;  ///< the name of the file
  bool agree = true;
  bool whole_window = false;
  int scale = 1;

 private:
  void answer() {
    QWidget* open = QApplication::activeModalWidget();
    if (auto* file = qobject_cast<QFileDialog*>(open)) {
      seen << "file";
      proposed = file->findChild<QLineEdit*>("fileNameEdit")->text();
      // typed: selecting a file here failed at times
      file->findChild<QLineEdit*>("fileNameEdit")->setText(path_);
      QMetaObject::invokeMethod(file, "accept");
    } else if (auto* box = qobject_cast<QMessageBox*>(open)) {
      seen << box->text();
      for (QAbstractButton* button : box->buttons())
        if ((box->buttonRole(button) == QMessageBox::AcceptRole) == agree) return button->click();
    } else if (auto* dialog = qobject_cast<QDialog*>(open)) {
      seen << "wish";
      auto* of = dialog->findChild<QComboBox*>("pictureOf");
      offered = of->currentText();
      if (whole_window) of->setCurrentIndex(1);
      dialog->findChild<QComboBox*>("pictureScale")->setCurrentIndex(scale - 1);
      dialog->accept();
    }
  }
  QString path_;
  QTimer timer_;
};

TEST(ToolPlace, APictureIsSavedWhereAskedAndCopied) {
  const QTemporaryDir folder;
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  window::pictureAtRest(application.window().views().volume());
  Answers answers(folder.filePath("picture.png"));
  const QSize size =
      application.window().views().volume().size();  // before it is told that it is saved
  application.window().findChild<QAction*>("savePicture")->trigger();
  EXPECT_EQ(answers.seen, QStringList({"wish", "file"}));  // a phantom is nobody
  EXPECT_TRUE(QRegularExpression(R"(^palpate 3-D view \d{4}-\d\d-\d\d \d\d\.\d\d\.png$)")
                  .match(answers.proposed)
                  .hasMatch())
      << answers.proposed.toStdString();
  const QImage saved(folder.filePath("picture.png"));
  ASSERT_EQ(saved.size(), size);
  application.window().findChild<QAbstractButton*>("doneClose")->click();
  QTest::qWait(100);  // the views have its room again
  EXPECT_TRUE(saved.textKeys().isEmpty());
  EXPECT_GT(window::count(saved, window::surfaceColoured), 2'000);
  application.window().findChild<QAction*>("copyPicture")->trigger();
  EXPECT_EQ(QGuiApplication::clipboard()->image().size(), saved.size());
}

TEST(ToolPlace, APictureOfOneSliceIsSavedByMouseAndKeys) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("slice.png");
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::MainWindow& window = application.window();
  window::pictureAtRest(window.views().volume());
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 120'000));
  // a distance in the slice, so that it has something to say
  ui::SliceView& axial = window.views().slice(ui::Plane::Axial);
  axial.setFocus();
  QTest::keyClick(&axial, Qt::Key_D);
  const QPoint middle = axial.pictureRect().center();
  for (const int x : {-30, 30})
    QTest::mouseClick(&axial, Qt::LeftButton, {}, middle + QPoint{x, 30});
  window.views().volume().setFocus();
  QTest::qWait(200);
  const QImage shown = window::pictureOf(axial);
  const QSize size = axial.size();  // before it is told that a picture is saved

  Answers answers(path);
  const auto take = [&](const auto& ask) {
    answers.seen.clear();
    QFile::remove(path);
    window.activateWindow();  // without a window manager nobody does after a dialog
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window, 120'000));
    ask();
    EXPECT_EQ(answers.seen, QStringList({"wish", "file"}));  // a phantom is nobody
    window.findChild<QAbstractButton*>("doneClose")->click();
    QTest::qWait(100);  // the views have its room again
    return QImage(path);
  };
  // the menu of the slice offers that slice
  QMenu& menu = window.views().slices().menu();
  auto* entry = menu.findChild<QAction*>("saveSlicePicture");
  const auto choose = [&] {
    ASSERT_TRUE(waitFor([&] { return menu.isVisible(); }));
    QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(entry).center());
  };
  const QImage one = take([&] {
    QTest::mouseClick(&axial, Qt::RightButton, {}, middle);
    choose();
  });
  EXPECT_EQ(answers.offered, "Slice: Axial");
  ASSERT_EQ(one.size(), size);
  EXPECT_TRUE(one.textKeys().isEmpty());
  // letters, lines, marks and words as they are on the screen, where there may be a frame of the
  // focus and a value under the pointer too
  EXPECT_LT(window::differing(one, shown, 24), 0.01);  // it says "Not for treatment", too
  EXPECT_LT(window::differing(one.copy(axial.pictureRect()), shown.copy(axial.pictureRect()), 24),
            0.004);
  take([&] {
    QTest::mouseClick(window.views()
                          .slice(ui::Plane::Coronal)
                          .parentWidget()
                          ->findChild<QToolButton*>("viewMenu"),
                      Qt::LeftButton);
    choose();
  });
  EXPECT_EQ(answers.offered, "Slice: Coronal");

  // the key offers the view that has the focus, and the picture may be larger
  answers.scale = 4;
  const QImage four = take([&] {
    axial.setFocus();
    QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  });
  EXPECT_EQ(answers.offered, "Slice: Axial");
  ASSERT_EQ(four.size(), axial.size() * 4);
  window::keep(four, "picture_slice");
  const QImage small = four.scaled(axial.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  EXPECT_LT(window::differing(small, shown, 80), 0.02);
  EXPECT_GT(window::neighboursApart(four, four.rect()), 400);  // cut at its own pixels
  answers.scale = 1;
  window.views().volume().setFocus();
  const QImage space =
      take([&] { QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier); });
  EXPECT_EQ(answers.offered, "3-D view");
  EXPECT_EQ(space.size(), window.views().volume().size());
  // from the View menu, with the 3-D view in use: a slice
  take([&] { entry->trigger(); });
  EXPECT_EQ(answers.offered, "Slice: Axial");
  // what has no place in the window is not offered
  take([&] { window.findChild<QAction*>("one")->trigger(), entry->trigger(); });
  EXPECT_EQ(answers.offered, "3-D view");
}

TEST(ToolPlace, APictureThatMayShowAFaceIsAskedFor) {
  const QTemporaryDir folder;
  const std::filesystem::path scan = folder.filePath("head.nrrd").toStdString();
  // a bone of 1000 HU in flesh of 0 HU, as large as a face
  const auto bone = window::ball(Vec3::Zero(), 0.015), flesh = window::ball(Vec3::Zero(), 0.028);
  ASSERT_TRUE(datasets::writeNrrd(
      *window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                        [&](const Vec3& p) { return -1000.0 + 10.0 * flesh(p) + 10.0 * bone(p); },
                        {.unit = "HU"}),
      scan));
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.load.phantom = {};
  arguments.load.path = scan;
  arguments.load.isovalue = 300.0;
  app::Application application(arguments);
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::VolumeView& view = application.window().views().volume();
  window::pictureAtRest(view);
  const QString path = folder.filePath("picture.png");
  Answers answers(path);
  const auto take = [&](const char* entry) {
    answers.seen.clear();
    application.window().findChild<QAction*>(entry)->trigger();
    return answers.seen;
  };
  const QString warning = "This picture may show a face.";
  EXPECT_EQ(take("savePicture"), QStringList({"wish", "file"}));  // bone alone
  EXPECT_TRUE(QFile::remove(path));
  // the second surface counts as well, and no is no
  view.setSecondSurface(-300.0);
  answers.agree = false;
  QGuiApplication::clipboard()->clear();
  EXPECT_EQ(take("savePicture"), QStringList({"wish", warning}));
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_EQ(take("copyPicture"), QStringList({warning}));
  EXPECT_TRUE(QGuiApplication::clipboard()->image().isNull());
  answers.agree = true;
  EXPECT_EQ(take("savePicture"), QStringList({"wish", warning, "file"}));
  EXPECT_TRUE(QFile::exists(path));
  // and so does the surface that is felt
  view.setSecondSurface({});
  window::panelOf<ui::IsosurfacePanel>(application.window()).choose(-300.0);
  EXPECT_EQ(take("copyPicture"), QStringList({warning}));
  EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
  // and, whatever the isovalue, a slice
  window::panelOf<ui::IsosurfacePanel>(application.window()).choose(300.0);
  EXPECT_TRUE(QFile::remove(path));
  const auto use = [&](QWidget& used) {
    application.window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&application.window(), 120'000));
    used.setFocus();
  };
  use(application.window().views().slice(ui::Plane::Sagittal));
  EXPECT_EQ(take("savePicture"), QStringList({"wish", warning, "file"}));
  EXPECT_EQ(answers.offered, "Slice: Sagittal");
  use(view);
  // also in a picture of the window
  EXPECT_TRUE(QFile::remove(path));
  answers.whole_window = true;
  EXPECT_EQ(take("savePicture"), QStringList({"wish", warning, "file"}));
  EXPECT_TRUE(QFile::remove(path));
  application.window().findChild<QAction*>("one")->trigger();
  ASSERT_FALSE(application.window().views().showsSlices());
  EXPECT_EQ(take("savePicture"), QStringList({"wish", "file"}));
}

}  // namespace
