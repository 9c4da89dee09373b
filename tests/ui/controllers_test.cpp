// SPDX-License-Identifier: BSD-3-Clause
// Controllers of the window, each made without the others and without the application.
#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <vector>

#include "app/window/scan/kept_phantom.h"
#include "app/window/scan/start_pose.h"
#include "app/window/scan/tool_place.h"
#include "app/window/scan/touched_surface.h"
#include "app/window/touch/measurement_controller.h"
#include "app/window/views/picture_controller.h"
#include "datasets/phantoms/phantoms.h"
#include "resources/named_tools.h"
#include "tests/ui/panelled_window.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/controls/section.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/force_words.h"
#include "ui/panels/performance_panel.h"
#include "ui/panels/second_surface.h"
#include "ui/props/picture.h"
#include "ui/views/volume_view.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace {

using window::waitFor;

/// The phantom "sphere" with a tool, as the loader hands it over.
app::Loaded loadedSphere() {
  app::Loader loader([] { return 1e12; });
  std::optional<app::Loaded> loaded;
  QObject::connect(&loader, &app::Loader::loaded,
                   [&](const app::Loaded& result) { loaded = result; });
  loader.start({.phantom = "sphere"});
  EXPECT_TRUE(waitFor([&] { return loaded.has_value(); }));
  return loaded.value_or(app::Loaded{});
}

TEST(Controllers, APhantomIsKeptForTheNextStartOfTheSameBuild) {
  const QTemporaryDir folder;
  const std::filesystem::path file =
      std::filesystem::path(folder.path().toStdString()) / "a" / "demo";
  EXPECT_FALSE(app::keptPhantom(file, "build"));
  const auto made = datasets::makePhantom("demo");
  ASSERT_TRUE(made);
  app::keepPhantom(file, "build", *made);
  const auto kept = app::keptPhantom(file, "build");
  ASSERT_TRUE(kept);
  const haptics::Volume &is = kept->volume, &was = made->volume;
  EXPECT_EQ(is.grid.dims, was.grid.dims);
  EXPECT_EQ(is.grid.spacing, was.grid.spacing);
  EXPECT_EQ(is.grid.origin, was.grid.origin);
  EXPECT_EQ(is.grid.direction, was.grid.direction);
  ASSERT_EQ(is.type, was.type);
  const auto bytes = std::size_t(was.grid.voxelCount()) * haptics::sizeOf(was.type);
  EXPECT_EQ(std::memcmp(is.voxels.get(), was.voxels.get(), bytes), 0);
  EXPECT_EQ(std::tuple(is.least, is.greatest, is.unit, is.modality, is.orientation_known),
            std::tuple(was.least, was.greatest, was.unit, was.modality, was.orientation_known));
  EXPECT_EQ(std::tuple(kept->isovalue, kept->tool), std::tuple(made->isovalue, made->tool));

  // another build would make another one, perhaps
  EXPECT_FALSE(app::keptPhantom(file, "another build"));
  QFile stored(QString::fromStdString(file.string()));
  ASSERT_TRUE(stored.open(QFile::ReadWrite));
  const QByteArray whole = stored.readAll();
  const auto isTaken = [&](const QByteArray& changed) {
    stored.resize(0);
    stored.seek(0);
    stored.write(changed);
    stored.flush();
    return app::keptPhantom(file, "build").has_value();
  };
  QByteArray damaged = whole;
  damaged[damaged.size() / 2] = char(damaged[damaged.size() / 2] ^ 1);
  EXPECT_FALSE(isTaken(damaged));
  EXPECT_FALSE(isTaken(whole.first(whole.size() - 1)));
  EXPECT_FALSE(isTaken(QByteArray(whole).replace("\"dims\":[", "\"dims\":[-")));
  EXPECT_FALSE(isTaken(QByteArray(whole).replace("\"dims\":[", "\"dims\":[\"x\",")));
  EXPECT_FALSE(isTaken("{\"build\":\"build\"}\n"));
  EXPECT_FALSE(isTaken("\n"));
  EXPECT_TRUE(isTaken(whole));
}

TEST(Controllers, AToolAndAFieldAreWantedForTheVolumeOnView) {
  app::SharedState shared;
  ui::DevicePanel panel;
  QMenu entries;
  ui::SidePanel panels(entries);
  app::ToolController controller(panel, panels, shared);
  QSignalSpy wanted(&controller, &app::ToolController::wanted);
  emit panel.toolChosen("wrench");
  EXPECT_EQ(wanted.count(), 0);  // nothing is on view
  std::optional<app::LoadRequest> request;
  QObject::connect(&controller, &app::ToolController::wanted, &panel,
                   [&](const app::LoadRequest& given) { request = given; });
  shared.shown = loadedSphere();
  shared.settings.isovalue = 12.0;
  emit panel.toolChosen("wrench");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->tool->name, "wrench");
  EXPECT_EQ(request->keep->volume, shared.shown->volume());
  EXPECT_EQ(request->isovalue, 12.0);
  emit panel.fieldChosen("spline");
  EXPECT_EQ(wanted.count(), 2);
  EXPECT_EQ(request->tool->name, shared.shown->tool.name);
  EXPECT_EQ(shared.options.field, haptics::FieldKind::CubicSpline);
}

TEST(Controllers, TheToolInUseIsNotPreparedAnew) {
  app::SharedState shared;
  ui::DevicePanel panel;
  QMenu entries;
  ui::SidePanel panels(entries);
  app::ToolController controller(panel, panels, shared);
  QSignalSpy wanted(&controller, &app::ToolController::wanted);
  shared.shown = loadedSphere();
  shared.shown->tool = {.name = "probe"};
  controller.show();
  const auto click = [&](const char* tile) {
    QTest::mouseClick(panel.findChild<QToolButton*>(tile), Qt::LeftButton);
  };
  auto* probe = panel.findChild<QToolButton*>("tile-probe");
  EXPECT_TRUE(probe->isChecked());
  click("tile-probe");
  EXPECT_EQ(wanted.count(), 0);
  EXPECT_TRUE(probe->isChecked());
  // until another has come it can be had back
  click("tile-hook");
  click("tile-hook");
  EXPECT_EQ(wanted.count(), 1);
  click("tile-probe");
  EXPECT_EQ(wanted.count(), 2);
  controller.show();
  click("tile-probe");
  EXPECT_EQ(wanted.count(), 2);
  // a file that is chosen again is read again: it may have changed
  shared.shown->tool = {.name = "peg.obj", .file = "peg.obj"};
  controller.show();
  click("tile-peg.obj");
  EXPECT_EQ(wanted.count(), 2);
  emit panel.toolFileChosen("peg.obj", "mm");
  EXPECT_EQ(wanted.count(), 3);
}

TEST(Controllers, AHandIsOpenedWithTheSceneAndChangedUnlessARecordingIsOnView) {
  ui::MainWindow window;
  app::SharedState shared;
  app::HandController controller(window.views(), window.messages(), window.panels(), window.touch(),
                                 shared, "mouse", 700.0);
  QSignalSpy changed(&controller, &app::HandController::changed);
  QSignalSpy replay_end(&controller, &app::HandController::replayEndWanted);
  EXPECT_EQ(shared.settings.stiffness, 700.0);
  controller.reopen();
  EXPECT_FALSE(shared.session.isOpen());  // there is nothing to touch
  shared.shown = loadedSphere();
  shared.settings.isovalue = shared.shown->isovalue;
  controller.adopt(true, false);
  controller.resume();
  EXPECT_TRUE(shared.session.isOpen());
  EXPECT_EQ(controller.name(), "mouse");
  emit controller.panel().handChosen("tap");
  EXPECT_EQ(controller.name(), "tap");
  EXPECT_EQ(changed.count(), 2);
  // while a recording is on view the choice is kept for later
  shared.session.close();
  shared.replaying = true;
  emit controller.panel().handChosen("mouse");
  EXPECT_EQ(controller.name(), "mouse");
  EXPECT_EQ(changed.count(), 2);
  EXPECT_EQ(replay_end.count(), 1);
  EXPECT_FALSE(shared.session.isOpen());
}

TEST(Controllers, AnotherScanIsFeltFromZeroAndTheMouseComesAlong) {
  ui::MainWindow window;
  app::SharedState shared;
  app::HandController controller(window.views(), window.messages(), window.panels(), window.touch(),
                                 shared, "mouse", 700.0);
  shared.shown = loadedSphere();
  shared.settings.isovalue = shared.shown->isovalue;
  controller.adopt(true, false);
  controller.resume();
  std::vector<haptics::ForceSample> some(4096);
  std::vector<float> forces;
  const auto more = [&] {
    const std::size_t count = shared.session.forces(some);
    for (std::size_t n = 0; n < count; ++n) forces.push_back(some[n].force);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  };
  // pressed into the surface, with all of the force
  haptics::Pose X_WH = shared.shown->start;
  X_WH.translation() -= 0.014 * X_WH.translation().normalized();
  shared.session.pull(X_WH);
  haptics::Snapshot snapshot;
  ASSERT_TRUE(window::waitFor([&] {
    more();
    shared.session.latest(snapshot);
    return snapshot.force_state == haptics::ForceState::On && snapshot.felt_W.force.norm() > 0.5;
  }));
  const float pressed = static_cast<float>(snapshot.felt_W.force.norm());
  // of the other scan the tool begins behind the ball
  const auto old = shared.shown->scene;
  const auto other = haptics::makeScene(old->volume, haptics::Tool{old->tool});
  ASSERT_TRUE(other);
  shared.shown->scene = *other;
  haptics::Pose& start = shared.shown->start;
  const haptics::Vec3 about = start.translation().unitOrthogonal();
  start = Eigen::AngleAxisd(std::numbers::pi, about) * start;
  more();
  forces.clear();
  controller.adopt(true, false);
  while (forces.size() < 800) more();
  std::size_t other_scan = 0;  // the first tick in it
  while (other_scan < forces.size() && forces[other_scan] > 0.1F * pressed) ++other_scan;
  ASSERT_LT(other_scan, forces.size());
  for (std::size_t n = 0; n < forces.size(); ++n)
    ASSERT_LT(forces[n], n < other_scan ? 1.1F * pressed : 0.01F) << n;
  shared.session.latest(snapshot);
  EXPECT_LT((snapshot.X_WD.translation() - shared.shown->start.translation()).norm(), 1e-3);
}

TEST(Controllers, AnIsovalueIsShownAndTouchedOrOnlyShown) {
  ui::MainWindow window;
  app::SharedState shared;
  app::IsosurfaceController controller(window.views(), window.messages(), window.panels(), shared);
  QSignalSpy changed(&controller, &app::IsosurfaceController::changed);
  auto* typed = window.findChild<QDoubleSpinBox*>("isovalueTyped");
  EXPECT_FALSE(typed->isEnabled());
  shared.shown = loadedSphere();
  const double first = shared.settings.isovalue = shared.shown->isovalue;
  window.show(shared.shown->picture, first, "Sphere");
  controller.showScene(true);
  EXPECT_TRUE(typed->isEnabled());
  EXPECT_EQ(typed->value(), first);
  EXPECT_EQ(changed.count(), 0);
  // of a recording: seen, and not touched
  controller.show(shared.shown->picture, first + 4.0);
  EXPECT_EQ(typed->value(), first + 4.0);
  EXPECT_EQ(shared.settings.isovalue, first);
  EXPECT_EQ(changed.count(), 0);
  typed->setValue(first + 7.0);
  EXPECT_EQ(shared.settings.isovalue, first + 7.0);
  controller.set(first + 9.0);
  EXPECT_EQ(typed->value(), first + 9.0);
  EXPECT_EQ(shared.settings.isovalue, first + 9.0);
  // a preset of the View menu
  emit window.views().isovalueWanted(first);
  EXPECT_EQ(shared.settings.isovalue, first);
  EXPECT_EQ(changed.count(), 3);
  // another tool in the same volume: the isovalue stays
  controller.showScene(false);
  EXPECT_EQ(typed->value(), first);
}

TEST(Controllers, TheSecondSurfaceHasItsIsovalueAndItsOpacityInThePanelWhileThereIsOne) {
  ui::MainWindow window;
  app::SharedState shared;
  app::IsosurfaceController controller(window.views(), window.messages(), window.panels(), shared);
  shared.shown = loadedSphere();
  const double touched = shared.settings.isovalue = shared.shown->isovalue;
  window.show(shared.shown->picture, touched, "Sphere");
  controller.showScene(true);
  ui::VolumeView& view = window.views().volume();
  auto* row = window.findChild<ui::SecondSurface*>();
  auto* isovalue = window.findChild<ui::NumberBox*>("secondIsovalue");
  auto* opacity = window.findChild<ui::NumberBox*>("secondOpacity");
  const QList<QAction*> seconds = window.findChild<QMenu*>("secondSurface")->actions();
  EXPECT_TRUE(row->isHidden());
  seconds.last()->trigger();  // the present isovalue
  EXPECT_FALSE(row->isHidden());
  EXPECT_EQ(isovalue->value(), touched);
  EXPECT_EQ(opacity->value(), 38.0);
  opacity->setValue(70.0);
  EXPECT_EQ(view.secondOpacity(), 0.7);
  isovalue->setValue(touched + 5.0);
  EXPECT_EQ(view.surface().second(), touched + 5.0);
  EXPECT_EQ(shared.settings.isovalue, touched);
  // below the least value nothing is a surface
  isovalue->setValue(isovalue->minimum());
  EXPECT_GT(view.surface().second().value_or(-1e9), shared.shown->volume()->least);
  EXPECT_EQ(isovalue->value(), view.surface().second());
  seconds.first()->trigger();
  EXPECT_TRUE(row->isHidden());
}

TEST(Controllers, TheForceIsShownByThePictureAndPlotted) {
  ui::MainWindow window;
  app::SharedState shared;
  app::PictureController controller(window.views(), window.touch(), shared);
  window::showAndWait(window, {1240, 840});
  auto* plot = window.findChild<ui::ForcePlot*>("forcePlot");
  const auto shows = [&](float force) {
    return waitFor([&] { return plot->greatestForce() == force; });
  };
  controller.appendForces(std::vector<haptics::ForceSample>{{0.1, 1.5F, 0.0F}, {0.2, 2.5F, 0.0F}});
  EXPECT_TRUE(shows(2.5F));
  controller.clearForces();
  EXPECT_TRUE(shows(0.0F));
  haptics::Snapshot snapshot;
  snapshot.felt_W.force = {0.0, 3.0, 4.0};
  window.touch().display(snapshot);
  EXPECT_EQ(window.findChild<QLabel*>("forceNow")->text(), "5.00");
}

TEST(Controllers, PanelsAreSectionsOfTheirTabsInTheOrderOfTheirControllers) {
  window::Panelled panelled;
  app::MeasurementController measurement(panelled.window.panels(), panelled.shared);
  window::showAndWait(panelled.window, {1280, 900});
  const auto section = [&](const char* name) {
    auto* found = panelled.window.findChild<ui::Section*>(name);
    if (found == nullptr) throw std::logic_error(name);
    return found;
  };
  const auto isSeen = [&](const char* name) { return !section(name)->visibleRegion().isEmpty(); };
  // what is touched and with what is in front
  for (const char* name : {"surfaceSection", "toolSection", "performanceSection"})
    EXPECT_TRUE(isSeen(name)) << name;
  EXPECT_FALSE(isSeen("deviceSection"));
  EXPECT_LE(section("surfaceSection")->geometry().bottom(), section("toolSection")->y());
  EXPECT_LE(section("toolSection")->geometry().bottom(), section("performanceSection")->y());
  // figures for engineers are folded at first
  EXPECT_FALSE(section("surfaceSection")->folded());
  EXPECT_TRUE(section("performanceSection")->folded());
  // the tab of another task has its own
  QTest::mouseClick(panelled.window.findChild<QAbstractButton*>("deviceTab"), Qt::LeftButton);
  EXPECT_TRUE(isSeen("deviceSection"));
  EXPECT_FALSE(isSeen("surfaceSection"));
  // and the force is always beside the picture
  EXPECT_FALSE(panelled.window.findChild<QWidget*>("forceCard")->visibleRegion().isEmpty());
}

TEST(Controllers, TheCardOfTheForceHasRoomForEveryReasonAndKeepsItsSize) {
  using haptics::ForceReason, haptics::ForceState;
  window::Panelled panelled;
  window::showAndWait(panelled.window, {1280, 900});
  auto* card = panelled.window.findChild<QWidget*>("forceCard");
  auto* words = card->findChild<QLabel*>("touchNow");
  const QRect place = card->geometry();
  haptics::Snapshot snapshot;
  snapshot.policy = haptics::SchedulingPolicy::Ordinary;
  snapshot.force_state = ForceState::Armed;
  for (int n = static_cast<int>(ForceReason::NoReading);
       n <= static_cast<int>(ForceReason::Stalled); ++n) {
    snapshot.reason = static_cast<ForceReason>(n);
    panelled.window.touch().display(snapshot);
    ASSERT_TRUE(waitFor([&] {
      return words->text() == ui::sentenceFor(ForceState::Armed, snapshot.reason, {});
    })) << n;
    EXPECT_LE(words->heightForWidth(words->width()), words->height()) << n;
    EXPECT_EQ(card->geometry(), place) << n;
  }
  snapshot.force_state = ForceState::On;
  for (const int contacts : {0, 1, 7}) {
    snapshot.contacts = contacts;
    panelled.window.touch().display(snapshot);
    ASSERT_TRUE(waitFor([&] {
      // of no scan it says no intensity
      return words->text() == (contacts == 0 ? "Nothing is touched" : "Touching");
    }));
    EXPECT_EQ(card->geometry(), place);
  }
}

TEST(Controllers, TheCardSaysPlainlyWhatIsTouched) {
  ui::ForcePanel card;
  haptics::Snapshot snapshot;
  snapshot.contacts = 1;
  const auto says = [&](double value, const char* unit) {
    card.display(snapshot, ui::TouchedValue{value, unit});
    QStringList words;
    for (const auto* label : card.findChildren<QLabel*>()) words << label->text();
    return words.filter(QRegularExpression("^Touching")).value(0);
  };
  EXPECT_EQ(says(1988.4, ""), "Touching 1,990");
  EXPECT_EQ(says(0.012345, ""), "Touching 0.0123");
  EXPECT_EQ(says(-7.0, ""), "Touching -7.00");
  EXPECT_EQ(says(0.0, ""), "Touching 0");
  EXPECT_EQ(says(483.0, "HU"), "Touching bone, 480 HU");
}

TEST(Controllers, AFaceThatTheGridCutsOffIsWhatLiesThere) {
  // as much as anywhere, to the grid's edge
  const auto volume = window::volumeOf(window::cubeGrid(16), haptics::ScalarType::Int16,
                                       window::ball({0.0, 0.0, 0.008}, 0.006));
  const haptics::ScalarField field{volume};
  haptics::Vec3 u{8.0, 8.0, 15.0};
  const double inside = field.value(u);
  u.z() = 15.3;  // between the outermost voxels and the background
  EXPECT_LT(field.value(u), 0.9 * inside);
  EXPECT_EQ(app::valueBehind(field, volume->grid.worldOf(u)), inside);
}

TEST(Controllers, TheCardLeavesTheToolInSightAndFoldsToALine) {
  window::Panelled panelled;
  window::showAndWait(panelled.window, {1366, 768});
  panelled.show(ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                               window::ball(haptics::Vec3::Zero(), 0.020))),
                50.0, "Ball");
  ui::VolumeView& view = panelled.window.views().volume();
  view.resetCamera();
  auto* card = panelled.window.findChild<ui::ForcePanel*>("forceCard");
  const auto place = [&] {
    return QRect(view.mapFrom(&panelled.window, card->mapTo(&panelled.window, QPoint{})),
                 card->size());
  };
  const auto put = [&](QPointF at) {
    haptics::Snapshot snapshot;
    const haptics::Vec3 focus = haptics::Vec3{view.camera()->GetFocalPoint()} * 1e-3;
    const Eigen::Matrix3d axes = view.viewAxes();
    const double px_per_m =
        1e3 * (view.projected(focus + axes.col(0) * 1e-3).x() - view.projected(focus).x());
    const QPointF by = (at - view.projected(focus)) / px_per_m;
    snapshot.X_WP.translation() = focus + axes.col(0) * by.x() - axes.col(1) * by.y();
    snapshot.X_WD = snapshot.X_WP;
    panelled.window.views().display(snapshot);
    QTest::qWait(120);
    panelled.window.views().display(snapshot);
  };
  view.show(window::octahedron(0.002));
  panelled.window.views().show(window::octahedron(0.002));
  const QRect first = place();
  EXPECT_GT(first.center().x(), view.width() / 2);
  EXPECT_GT(first.center().y(), view.height() / 2);
  const QPoint corners[] = {first.center(),
                            {first.center().x(), 30 + view.height() / 4},
                            {view.width() - first.center().x(), first.center().y()}};
  for (const QPoint corner : corners) {
    put(corner);
    EXPECT_TRUE(view.isToolIn(QRect(corner - QPoint(9, 9), QSize(18, 18))));
    EXPECT_FALSE(view.isToolIn(place())) << corner.x() << ' ' << corner.y();
    EXPECT_GT(card->height(), 100);
    EXPECT_TRUE(view.rect().contains(place()));
  }
  // a tool that lies in every corner leaves room for a line alone, and no room is taken from it
  panelled.window.views().show(window::octahedron(0.018));
  put(QPointF(view.width() / 2.0, view.height() / 2.0));
  EXPECT_FALSE(view.isToolIn(place()));
  // the user folds it, which is remembered
  panelled.window.views().show(window::octahedron(0.002));
  put(QPointF(view.width() / 2.0, view.height() / 2.0));
  auto* fold = card->findChild<QAbstractButton*>("foldCard");
  QTest::mouseClick(fold, Qt::LeftButton);
  EXPECT_LT(card->height(), 50);
  EXPECT_TRUE(card->findChild<QLabel*>("forceLine")->isVisible());
  EXPECT_TRUE(card->findChild<QLabel*>("forceLine")->text().contains("Nothing is touched"));
  const QString state = panelled.window.views().state();
  QTest::mouseClick(fold, Qt::LeftButton);
  EXPECT_GT(card->height(), 100);
  panelled.window.views().restore(state);
  EXPECT_LT(card->height(), 50);
  panelled.window.views().reset();
  EXPECT_GT(card->height(), 100);
}

TEST(Controllers, TheToolWaitsInTheSightOfTheFirstPicture) {
  const app::Loaded loaded = loadedSphere();
  const haptics::Scene& scene = *loaded.scene;
  ui::MainWindow window;
  window::showAndWait(window, {1000, 700});
  window.show(loaded.picture, loaded.isovalue, "Sphere");
  const haptics::Vec3 towards = window.views().volume().viewAxes().col(2);
  const haptics::Vec3 tip = loaded.start * scene.tool.shell.tip;
  // pushed in along the sight, the tip meets the ball straight
  EXPECT_LT(tip.cross(towards).norm(), 1e-3);
  EXPECT_NEAR(tip.norm(), 0.028, 0.003);  // m: 8 mm off the ball
}

TEST(Controllers, TheToolWaitsInFrontOfASlabWithItsTip) {
  const app::Loaded loaded = loadedSphere();
  haptics::Volume slab = *loaded.volume();
  const auto middle = static_cast<std::int64_t>(slab.grid.dims[2] / 2);
  slab.crop = haptics::VoxelBox{{0, 0, middle - 4}, slab.grid.dims};
  slab.crop->end[2] = middle + 4;
  const haptics::Vec3 high = slab.grid.worldOf({0.0, 0.0, double(middle + 3)});
  auto drill = haptics::makeTool("drill", *resources::namedToolMesh("drill"));
  ASSERT_TRUE(drill);
  const auto scene =
      haptics::makeScene(std::make_shared<const haptics::Volume>(slab), std::move(*drill));
  ASSERT_TRUE(scene);
  const auto start = app::startPose(**scene, loaded.isovalue);
  ASSERT_TRUE(start);
  const haptics::Vec3 tip = *start * (*scene)->tool.shell.tip;
  // which is seen from above
  EXPECT_GT(tip.z(), high.z() + 0.004);
  EXPECT_LT(tip.z(), high.z() + 0.010);
  EXPECT_LT(std::hypot(tip.x(), tip.y()), 0.015);
  for (const haptics::Vec3& p : (*scene)->tool.shell.points)
    EXPECT_GT((*start * p).z(), high.z());  // nothing of it is beside the ball
}

TEST(Controllers, AMeasurementIsMadeAndEndedWithAReason) {
  ui::MainWindow window;
  app::SharedState shared;
  app::MeasurementController controller(window.panels(), shared);
  auto* button = window.findChild<QPushButton*>("measure");
  auto* details = window.findChild<QLabel*>("performanceDetails");
  EXPECT_FALSE(button->isEnabled());
  controller.resume();
  EXPECT_FALSE(button->isEnabled());  // there is nothing to measure
  shared.shown = loadedSphere();
  shared.settings.isovalue = shared.shown->isovalue;
  controller.showScene();
  ASSERT_TRUE(button->isEnabled());
  button->click();
  EXPECT_EQ(button->text(), "Cancel");
  controller.end("It was ended by the test.");
  EXPECT_EQ(details->text(), "It was ended by the test.");
  EXPECT_NE(button->text(), "Cancel");
  controller.end("There is none to end.");
  EXPECT_EQ(details->text(), "It was ended by the test.");
  controller.pause();
  EXPECT_FALSE(button->isEnabled());
  controller.resume();
  EXPECT_TRUE(button->isEnabled());
}

}  // namespace
