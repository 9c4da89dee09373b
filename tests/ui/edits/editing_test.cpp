// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkWeakPointer.h>

#include <QAction>
#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QThread>
#include <QTimer>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "app/window/edits/edit_controller.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/loader.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/session_recording.h"
#include "datasets/edits/edited.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/support/places.h"
#include "tests/ui/edits/editing.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/edit_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/before_view.h"
#include "ui/views/volume_view.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/screenshot.h"
#include "ui/window/views.h"

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using window::Editing;
using window::waitFor;

TEST_F(Editing, UndoAndRedoWaitUntilTheToolIsOutOfContactAndSaySo) {
  openBalls();
  click("piecesTool");
  clickAt(window().views().volume(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  click("removePiece");
  const Vector3d apart{-12, -29, 0}, in_contact{-12, -5, 0};
  const auto wait = [&] { return child<QLabel>("editWait").text(); };
  const auto waits = [&] { return child<QLabel>("editWait").isVisible(); };
  const auto undoWanted = [&] { QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier); };
  pulledTo(apart);
  pulledTo(in_contact);
  ASSERT_GT(application_->snapshot().contacts, 0);
  undoWanted();
  ASSERT_TRUE(waitFor(waits));
  window::afterTicks(*application_, 300);
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_EQ(wait(), "Undo waits until the tool no longer touches.");
  EXPECT_TRUE(waits());
  keepWindow("edit_waits");
  // taken back
  QTest::mouseClick(&child("cancelEditWait"), Qt::LeftButton);
  EXPECT_FALSE(waits());
  EXPECT_FALSE(application_->editing().isBusy());
  // a window that was busy for a while does not take its silence for a tool out of contact
  QThread::msleep(300);
  undoWanted();
  EXPECT_TRUE(waits());
  QThread::msleep(300);
  window::afterTicks(*application_, 300);
  EXPECT_TRUE(waits());
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  // until the hand lets go
  const haptics::Vec3 before = application_->snapshot().X_WP.translation();
  EXPECT_GT(application_->snapshot().felt_W.force.norm(), 0.0);
  pulledTo(apart);
  settle();
  EXPECT_TRUE(application_->editing().edits().empty());
  EXPECT_FALSE(waits());
  EXPECT_GT((application_->snapshot().X_WP.translation() - before).norm(), 5e-3);
  // redo, too
  pulledTo(in_contact);
  ASSERT_GT(application_->snapshot().contacts, 0);
  QTest::keyClick(&window(), Qt::Key_Y, Qt::ControlModifier);
  ASSERT_TRUE(waitFor(waits));
  window::afterTicks(*application_, 300);
  EXPECT_EQ(wait(), "Redo waits until the tool no longer touches.");
  EXPECT_TRUE(waits());
  EXPECT_TRUE(application_->editing().edits().empty());
  pulledTo(apart);
  settle();
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_FALSE(waits());
}

TEST_F(Editing, AButtonLiftsTheToolSoThatAnUndoNeedNotWait) {
  openBalls();
  click("piecesTool");
  clickAt(window().views().volume(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  click("removePiece");
  settle();
  pulledTo({-12, -29, 0});
  pulledTo({-12, -5, 0});
  ASSERT_GT(application_->snapshot().contacts, 0);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  auto& lift = child<QPushButton>("liftTool");
  ASSERT_TRUE(waitFor([&] { return lift.isVisible(); }));
  EXPECT_EQ(child<QLabel>("editWaits").text(), "Undo waits until the tool no longer touches.");
  lift.click();
  EXPECT_TRUE(waitFor([&] { return application_->editing().edits().empty(); }));
  settle();
  EXPECT_FALSE(lift.isVisible());
  EXPECT_EQ(application_->snapshot().contacts, 0);
  EXPECT_TRUE(isThere(kSmallAt));
}

// An undo that began out of contact is not adopted under a tool that has come to touch meanwhile.
TEST_F(Editing, AnUndoThatBeganWaitsAgainBeforeItIsAdopted) {
  openBalls();
  click("piecesTool");
  clickAt(window().views().volume(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  click("removePiece");
  pulledTo({-12, -22, 0});
  // into contact while the window is busy: no snapshot is looked at
  haptics::Pose hand = application_->snapshot().X_WD;
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(child<QLabel>("editWait").isVisible());
  for (int n = 0; n < 60; ++n) {
    hand.translation().y() += 17e-3 / 60;
    application_->session().pull(hand);
    QThread::msleep(10);
  }
  haptics::Snapshot pressed;
  for (int n = 0; n < 10'000 && pressed.contacts == 0; ++n) {
    application_->session().latest(pressed);
    QThread::msleep(5);
  }
  ASSERT_GT(pressed.contacts, 0);
  EXPECT_TRUE(waitFor([&] { return child<QLabel>("editWait").isVisible(); }));
  EXPECT_GT(application_->snapshot().contacts, 0);
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  pulledTo({-12, -29, 0});
  settle();
  EXPECT_TRUE(application_->editing().edits().empty());
}

TEST_F(Editing, TheUneditedScanStandsBesideWhatIsLeftInEveryModeAndUntilAnotherScanComes) {
  openBalls();
  ASSERT_FALSE(HasFatalFailure());
  ui::Views& views = window().views();
  ui::VolumeView& after = views.volume();
  QAction& wish = child<QAction>("beforeAfter");
  // of a scan from which nothing was taken there is no second picture
  wish.trigger();
  ASSERT_NE(views.before(), nullptr);
  EXPECT_EQ(views.before()->picture().reduced, after.picture().reduced);
  wish.trigger();
  EXPECT_EQ(views.before(), nullptr);
  application_->editing().restore({datasets::RemovePiece{kSmallAt * 1e-3, 50.0}});
  settle();
  wish.trigger();
  // a second thought while its picture is made
  wish.trigger();
  wish.trigger();
  ASSERT_TRUE(waitFor([&] { return views.before() != nullptr; }));
  ui::BeforeView& before = *views.before();
  const auto expectWordsApart = [&](const std::string& name) {
    // in each the sides are named
    for (const ui::VolumeView* view :
         std::initializer_list<const ui::VolumeView*>{&before, &after}) {
      const std::vector<QRectF> words = view->wordBoxes();
      EXPECT_GE(words.size(), 5U) << name;  // a caption and four letters
      for (std::size_t a = 0; a < words.size(); ++a) {
        EXPECT_TRUE(QRectF(view->rect()).contains(words[a])) << name << ' ' << a;
        for (std::size_t b = 0; b < a; ++b)
          EXPECT_FALSE(words[a].intersects(words[b])) << name << ' ' << a << ' ' << b;
      }
    }
  };
  const auto expectBoth = [&](const std::string& name) {
    // layouts come to rest in more than one step
    QImage was, is;
    do {
      was = window::pictureAtRest(before);
      is = window::pictureAtRest(after);
    } while (was.size() != after.size() || is.size() != after.size());
    EXPECT_EQ(before.surface().mode(), after.surface().mode()) << name;
    const auto colourAt = [&](const QImage& image, const Vector3d& p_mm) {
      return image.pixelColor(inSpace(p_mm).toPoint());
    };
    EXPECT_TRUE(window::surfaceColoured(colourAt(was, kSmallAt))) << name;
    EXPECT_FALSE(window::surfaceColoured(colourAt(is, kSmallAt))) << name;
    for (const double z : {-8.0, 0.0, 8.0}) {
      const Vector3d place = kLargeAt + Vector3d{-4.0, -8.0, z};
      EXPECT_TRUE(window::surfaceColoured(colourAt(was, place))) << name;
      EXPECT_NEAR(colourAt(was, place).red(), colourAt(is, place).red(), 12) << name;
    }
    expectWordsApart(name);
    window::keep(ui::screenshotOf(window(), views, {.whole_window = true}), name.c_str());
  };
  for (const auto mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    const std::string name = mode == ui::SurfaceMode::Mesh ? "beside_mesh" : "beside_ray_cast";
    after.setSurfaceWish(mode);
    expectBoth(name);
    child<QAction>("slices_large").trigger();
    ASSERT_TRUE(waitFor([&] { return before.geometry().bottom() < after.geometry().top(); }));
    EXPECT_EQ(before.size(), after.size());
    expectBoth(name + "_column");
    child<QAction>("volume_large").trigger();
    ASSERT_TRUE(waitFor([&] { return before.geometry().bottom() >= after.geometry().top(); }));
    const QSize large = window().size();
    const QSize least = window().minimumSizeHint();
    const auto resize = [&](const QSize& size) {
      const QSize was = before.size();
      window().resize(size);
      return waitFor([&] { return before.size() != was && before.size() == after.size(); });
    };
    ASSERT_TRUE(resize(least));
    expectBoth(name + "_narrow");
    ASSERT_TRUE(resize(large));
  }
  // as small as the two can be, without a cube
  after.parentWidget()->resize(after.parentWidget()->minimumSizeHint());
  EXPECT_EQ(before.wordBoxes().size(), 5U);
  expectWordsApart("beside_least");
  // nothing of it is left when another scan comes
  const auto scan = before.picture().volume;
  const vtkWeakPointer<vtkImageData> reduced = before.picture().reduced.Get();
  window::discardWhenAsked(window());
  emit window().menus().phantomWanted("sphere");
  ASSERT_TRUE(waitFor([&] { return app::scanOf(application_->shown()->volume()) != scan; }));
  EXPECT_EQ(views.before(), nullptr);
  EXPECT_FALSE(wish.isChecked());
  EXPECT_EQ(reduced, nullptr);
  window::pictureAtRest(after);
  // the window may end with it
  wish.trigger();
  ASSERT_NE(views.before(), nullptr);
  window::pictureAtRest(*views.before());
}

TEST_F(Editing, AnEditLeavesToolAndCameraWhereTheyAre) {
  openBalls();
  window().views().volume().camera()->Azimuth(20.0);
  pulledTo({-12, -29, 0});
  pulledTo({-12, -5, 0});
  ASSERT_GT(application_->snapshot().contacts, 0);
  const haptics::Vec3 before = application_->snapshot().X_WP.translation();
  const Vector3d eye{window().views().volume().camera()->GetPosition()};
  click("piecesTool");
  clickAt(window().views().volume(), inSpace(kSmallAt));
  ASSERT_TRUE(previewed());
  click("removePiece");
  EXPECT_TRUE(
      waitFor([&] { return application_->snapshot().scene == application_->shown()->scene->id; }));
  window::afterTicks(*application_, 200);
  EXPECT_LT((application_->snapshot().X_WP.translation() - before).norm(), 0.5e-3);
  EXPECT_EQ((Vector3d{window().views().volume().camera()->GetPosition()} - eye).norm(), 0.0);
  // Escape ends what the mouse was for, and the next one the force
  QTest::keyClick(&window().views().volume(), Qt::Key_Escape);
  EXPECT_EQ(panel().tool(), ui::EditTool::None);
  window::afterTicks(*application_, 50);
  EXPECT_NE(application_->snapshot().force_state, haptics::ForceState::Ready);
  QTest::keyClick(&window().views().volume(), Qt::Key_Escape);
  EXPECT_TRUE(
      waitFor([&] { return application_->snapshot().force_state == haptics::ForceState::Ready; }));
  // another scan is touched again
  window::discardWhenAsked(window());
  emit window().menus().phantomWanted("sphere");
  EXPECT_TRUE(waitFor([&] {
    return application_->snapshot().scene == application_->shown()->scene->id &&
           application_->snapshot().force_state == haptics::ForceState::On;
  }));
}

TEST_F(Editing, AnotherToolKeepsTheEditsAndAnotherVolumeDropsThem) {
  openBalls();
  application_->editing().restore({datasets::Crop{{{0, 0, 0}, {40, 64, 64}}},
                                   datasets::RemovePiece{haptics::Vec3{-12e-3, 0, 0}, 50.0}});
  settle();
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  EXPECT_FALSE(isThere(kLargeAt));
  EXPECT_TRUE(window().windowTitle().contains("(edited)"));
  const auto scene = application_->shown()->scene;
  emit window::panelOf<ui::DevicePanel>(window()).toolChosen("peg");
  ASSERT_TRUE(waitFor([&] { return application_->shown()->scene != scene; }));
  QTest::qWait(100);
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  EXPECT_FALSE(isThere(kLargeAt));
  // an edit that cannot be made leaves what is there
  application_->editing().restore(
      {datasets::RemovePiece{haptics::Vec3{28e-3, 28e-3, 28e-3}, 50.0}});
  settle();
  EXPECT_TRUE(messageIsShown());
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  window::discardWhenAsked(window());
  emit window().menus().phantomWanted("torus");
  ASSERT_TRUE(waitFor([&] { return application_->shown()->title.contains("torus"); }));
  QTest::qWait(100);
  EXPECT_TRUE(application_->editing().edits().empty());
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
  EXPECT_FALSE(window().findChild<QAction*>("undo")->isEnabled());
}

TEST_F(Editing, TheEditedVolumeIsSavedAndTheInputIsNotWrittenOver) {
  openBalls();
  const fs::path input = fs::path(scans_.path().toStdString()) / "balls.nrrd";
  const auto input_time = fs::last_write_time(input);
  application_->editing().restore({datasets::Crop{{{10, 0, 5}, {40, 64, 60}}}});
  settle();
  EXPECT_TRUE(window().findChild<QAction*>("saveEdited")->isEnabled());
  emit window().menus().saveEditedWanted(QString::fromStdString(input.string()));
  ASSERT_TRUE(waitFor([&] { return messageIsShown(); }));
  EXPECT_TRUE(message().contains("is not written over")) << message().toStdString();
  EXPECT_EQ(fs::last_write_time(input), input_time);
  const fs::path out = fs::path(scans_.path().toStdString()) / "saved.nrrd";
  emit window().menus().saveEditedWanted(QString::fromStdString(out.string()));
  ASSERT_TRUE(waitFor([&] { return child<QLabel>("done").text().contains("was saved"); }));
  window::discardWhenAsked(window());
  emit window().menus().openWanted(QString::fromStdString(out.string()));
  ASSERT_TRUE(waitFor([&] { return volume().grid.dims[0] == 30; }));
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
  window::afterTicks(*application_, 300);
  application_->editing().restore({datasets::RemovePiece{kSmallAt * 1e-3, 50.0}});
  settle();
  window::afterTicks(*application_, 300);
  undo();
  window::afterTicks(*application_, 300);
  QTest::mouseClick(record, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !application_->recording().isRecording(); }));
  const auto finished = [&]() -> fs::path {
    for (const auto& file : fs::directory_iterator(recordings_.path().toStdString()))
      if (file.path().extension() == ".palpate") return file.path();
    return {};
  };
  ASSERT_TRUE(waitFor([&] { return !finished().empty(); }));
  QTest::qWait(300);
  emit window().menus().recordingWanted(QString::fromStdString(finished().string()));
  ASSERT_TRUE(waitFor([&] { return application_->replay() != nullptr; }));
  EXPECT_FALSE(panel().isEnabled());
  window().views().setCross(kSmallAt);
  // the picture at rest, the slices and the contour in them
  const auto shows = [&](bool small) {
    const haptics::ScalarField field{window().views().volume().picture().volume};
    expectSlicesShow([&](const Vector3d& p_mm) { return field.value(field.indexOf(p_mm * 1e-3)); });
    EXPECT_EQ(isSeen(kSmallAt), small);
    EXPECT_TRUE(isSeen(kLargeAt));
  };
  const auto seen = [&] { return window().views().volume().picture().volume; };
  const ui::ReplayTrack& track = application_->replay()->track();
  std::vector<double> edits;
  for (const ui::ReplayMark& mark : track.marks)
    if (mark.kind == "edit") edits.push_back(mark.time);
  ASSERT_EQ(edits.size(), 2U);
  const double before = 0.5 * (track.begin + edits[0]), after = 0.5 * (edits[0] + edits[1]);
  const auto scan = application_->shown()->picture.volume;
  ASSERT_EQ(seen(), scan);
  shows(true);
  // after the edit it is gone, and comes back with the time
  emit window().replayBar().timeWanted(after);
  ASSERT_TRUE(waitFor([&] { return seen() != scan; })) << message().toStdString();
  shows(false);
  keepWindow("edit_replayed");
  emit window().replayBar().timeWanted(before);
  ASSERT_TRUE(waitFor([&] { return seen() == scan; }));
  shows(true);
  emit window().replayBar().timeWanted(after);
  ASSERT_TRUE(waitFor([&] { return seen() != scan; }));
  shows(false);
  emit window().replayBar().closeWanted();
  EXPECT_EQ(seen(), scan);
  shows(true);
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
      window().views().setCross({0, 0, 14.0 - 0.5 * n});
      click("planeFromAxial");
      click("planeApply");
    }
    ASSERT_EQ(int(application_->editing().edits().size()), n + 1) << message().toStdString();
  }
  for (int n = kEdits; n-- > 0;) {
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return !application_->editing().isBusy(); }));
    const Was then = now();
    EXPECT_EQ(then.crop, was[std::size_t(n)].crop) << n;
    EXPECT_TRUE(then.voxels == was[std::size_t(n)].voxels) << n;
  }
  EXPECT_FALSE(window().windowTitle().contains("(edited)"));
}

TEST_F(Editing, TheTouchDoesNotWaitForThePicture) {
  openBalls();
  std::vector<bool> together;
  const auto look = [&] {
    together.push_back(application_->shown()->volume() ==
                       window().views().volume().picture().volume);
  };
  QObject::connect(&application_->editing(), &app::EditController::edited, &window(), look);
  QObject::connect(&application_->editing(), &app::EditController::pictured, &window(), look);
  application_->editing().restore({datasets::Crop{{{0, 0, 0}, {64, 64, 40}}}});
  settle();
  EXPECT_EQ(together, (std::vector<bool>{false, true}));
  expectTheSameEverywhere();
}

TEST_F(Editing, AnEditThatIsCancelledChangesNothing) {
  openBalls();
  click("planeTool");
  window().views().setCross({0, 0, 10});
  click("planeFromAxial");
  click("planeApply");
  const auto before = application_->shown()->picture.volume;
  window().views().setCross({0, 0, 0});
  click("planeFromAxial");
  QTest::mouseClick(&child("planeApply"), Qt::LeftButton);
  ASSERT_TRUE(application_->editing().isBusy());
  emit window().loading().cancelWanted();
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
  const datasets::Edit box = datasets::Crop{{{40, 40, 40}, {470, 480, 500}}};
  const datasets::Edit piece = datasets::RemovePiece{haptics::Vec3{70e-3, 0, 40e-3}, isovalue_};
  datasets::LassoCut lasso;
  for (int n = 0; n < 60; ++n)
    lasso.outline.push_back(
        {0.03 * std::cos(n * 6.2831853 / 60), 0.03 * std::sin(n * 6.2831853 / 60)});
  lasso.parallel = true;
  lasso.X_WC.translation() = haptics::Vec3{-25e-3, 0, 0.3};
  lasso.isovalue = isovalue_;
  const std::pair<const char*, datasets::Edit> all[] = {
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
      const auto scan = scene->volume->derivation ? scene->volume->derivation->scan : scene->volume;
      datasets::EditHistory history{scan};
      const ui::Picture before = ui::pictureOf(scan);
      const auto base = haptics::makeScene(scan, scene->tool).value();
      Clock::time_point part = Clock::now();
      const auto volume = history.apply(edit).value();
      std::printf("; edit %.0f", since(part));
      part = Clock::now();
      const auto built = haptics::makeScene(volume, scene->tool, {}, base.get());
      std::printf(", scene %.0f", since(part));
      part = Clock::now();
      const auto picture = ui::pictureOf(volume, before, volume->derivation->changed);
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
