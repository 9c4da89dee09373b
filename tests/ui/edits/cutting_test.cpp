// SPDX-License-Identifier: BSD-3-Clause
// A burr in the mouse's hand: what it cuts is seen while it is cut, and can be taken back.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkWeakPointer.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <variant>

#include "app/recording/cut_words.h"
#include "app/recording/recording.h"
#include "app/recording/replay.h"
#include "app/window/edits/edit_controller.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/sessions/export_controller.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/session_recording.h"
#include "app/window/structures/structures_controller.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/ui/edits/cutting.h"
#include "tests/ui/fake_program.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/panels/cut_panel.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/before_view.h"
#include "ui/views/volume_view.h"
#include "ui/window/menus.h"
#include "ui/window/screenshot.h"
#include "ui/window/views.h"

namespace {

using Eigen::Vector3d;
using window::cutColoured;
using window::Cutting;
using window::waitFor;

bool turningColoured(QColor c) {
  return c.red() > 150 && c.green() > 0.54 * c.red() && c.green() < 0.72 * c.red() &&
         c.blue() < 0.35 * c.red();
}

TEST_F(Cutting, IsSeenWhileItIsDoneAndIsThereForEyeAndHandAfterwards) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  ui::VolumeView& view = window().views().volume();
  const Vector3d inside = at(1.5);
  EXPECT_TRUE(isThere(inside));
  lift();
  pullTip(at(5.0));
  const QImage uncut = window::pictureAtRest(view);
  EXPECT_LT(window::count(uncut, turningColoured), 5);
  EXPECT_LT(window::count(uncut, cutColoured), 5);
  auto& still = *view.findChild<QTimer*>("still");
  still.setInterval(3'600'000);
  ASSERT_TRUE(view.isAtRest());
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > 25.0; })) << state().toStdString();
  // no edit yet, and the views show it
  EXPECT_EQ(strokes(), 0U);
  EXPECT_EQ(application_->editing().edits().size(), 0U);
  EXPECT_FALSE(view.isAtRest());  // as it is drawn in motion: without a graphics card
  // a window that is slow lets the burr rest now and then
  EXPECT_TRUE(waitFor([&] { return window::count(view.grabFramebuffer(), turningColoured) > 50; }));
  window().views().setCross(inside);
  ui::SliceView& axial = slice(ui::Plane::Axial);
  const auto greyAt = [&] {
    const QPoint at = axial.projected(inside).toPoint() + QPoint{2, -2};
    return axial.grab().toImage().pixelColor(at).red();
  };
  EXPECT_LT(greyAt(), 120);            // the isovalue is 127
  EXPECT_GE(felt(inside), isovalue_);  // of the volume on view
  holdKey(false);
  ASSERT_TRUE(waitFor([&] { return strokes() == 1; }));
  settle();
  EXPECT_FALSE(isThere(inside));
  window().views().setCross(at(3.0));
  expectTheSameEverywhere();
  EXPECT_LT(window::count(window::pictureAtRest(view), turningColoured), 5);
  // what was cut has its colour, until the user wants none
  lift();
  const QImage tinted = window::pictureAtRest(view);
  keepWindow("cut_one_stroke");
  EXPECT_GT(window::count(tinted, cutColoured), 60);
  child<QCheckBox>("cutTint").click();
  const QImage plain = window::pictureAtRest(view);
  EXPECT_LT(window::count(plain, cutColoured), 5);
  // and the pit stays
  EXPECT_GT(window::differing(plain, uncut), 0.001);
}

TEST_F(Cutting, IsHeardWhileTheBurrTurnsIfTheUserWantsIt) {
  const window::FakeProgram player("paplay", window::kKeepsWhatItReads);
  const auto loud = [&] {
    return player.written("heard").count('\0') < player.written("heard").size();
  };
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  cut(-6.0, 2.0);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_TRUE(player.written("called").isEmpty());  // off at first
  child<QCheckBox>("burrSound").click();
  ASSERT_TRUE(waitFor([&] { return !player.written("called").isEmpty(); }));
  EXPECT_FALSE(loud());
  cut(0.0, 4.0);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_TRUE(waitFor(loud));
  // it has ended, and with the next stroke it is there again
  const auto isQuiet = [&] {
    const QByteArray end = player.written("heard").right(9'600);
    return end.count('\0') == end.size();
  };
  EXPECT_TRUE(waitFor(isQuiet));
  window::keep(window::panelOf<ui::CutPanel>(window()).grab().toImage(), "cut_with_sound");
  const auto before = player.written("heard").size();
  cut(6.0, 2.0);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_TRUE(waitFor([&] { return player.written("heard").size() > before; }));
  child<QCheckBox>("burrSound").click();
  lift();
  cut(9.0, 1.0);
  EXPECT_EQ(player.written("called").count('\n'), 1);
}

TEST_F(Cutting, LeavesAStructureThatMayNotBeCutToTheVoxel) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  const auto scan = application_->shown()->volume();
  // the half at the patient's left
  const auto labels = window::volumeOf(scan->grid, haptics::ScalarType::UInt8,
                                       [](const haptics::Vec3& p_W) { return p_W.x() > 0.0; });
  const auto path = std::filesystem::path(scans_.path().toStdString()) / "half.nrrd";
  ASSERT_TRUE(datasets::writeNrrd(*labels, path).has_value());
  application_->structures().open(path);
  ASSERT_TRUE(waitFor([&] { return application_->structures().labels() != nullptr; }));
  child<QTableWidget>("structures").selectRow(0);
  QComboBox& cutting = child<QComboBox>("structureCutting");
  EXPECT_EQ(cutting.currentText(), "As its values say");
  cutting.setCurrentIndex(1);
  ASSERT_TRUE(waitFor([&] { return application_->editing().edits().size() == 1; }));
  settle();
  EXPECT_EQ(cutting.currentText(), "Never");
  EXPECT_EQ(child<QLabel>("cutTissues").text(), "Structures that may not be cut: 1.");
  EXPECT_FALSE(window().windowTitle().contains("edited"));  // nothing was taken away
  ASSERT_TRUE(isReady()) << state().toStdString();
  cut(0.0, 5.0);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_TRUE(window().windowTitle().contains("edited"));
  const auto left = application_->shown()->volume();
  const auto* const before = static_cast<const std::int16_t*>(scan->voxels.get());
  const auto* const after = static_cast<const std::int16_t*>(left->voxels.get());
  const auto* const kept = static_cast<const std::uint8_t*>(labels->voxels.get());
  std::int64_t gone = 0;
  for (std::int64_t n = 0; n < scan->grid.voxelCount(); ++n) {
    gone += after[n] < before[n];
    ASSERT_TRUE(kept[n] == 0 || after[n] == before[n]) << n;
  }
  EXPECT_GT(gone, 3);
  expectTheSameEverywhere();
  keepWindow("cut_beside_a_kept_structure");
  lift();
  undo();
  EXPECT_EQ(cutting.currentText(), "Never");
  undo();
  EXPECT_EQ(cutting.currentText(), "As its values say");
  EXPECT_FALSE(child<QLabel>("cutTissues").isVisibleTo(&window()));
}

TEST_F(Cutting, ATextureGetsNoOtherVoxelsThanThoseThatWereCut) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  ui::VolumeView& view = window().views().volume();
  window().resize(window().minimumSizeHint());  // fewer rays
  view.setSurfaceWish(ui::SurfaceMode::RayCast);
  lift();
  const QImage uncut = window::pictureAtRest(view);
  pullTip(at(5.0));
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > 3.0; })) << state().toStdString();
  holdKey(false);
  ASSERT_TRUE(waitFor([&] { return strokes() == 1; }));
  settle();
  lift();
  const QImage cut = window::pictureAtRest(view);
  window::keep(cut, "cut_ray_cast");
  EXPECT_GT(window::differing(cut, uncut), 0.001);
  EXPECT_LT(window::count(uncut, cutColoured), 5);
  EXPECT_GT(window::count(cut, cutColoured), 20);
  child<QCheckBox>("cutTint").click();
  const QImage plain = window::pictureAtRest(view);
  EXPECT_LT(window::count(plain, cutColoured), 5);
  // all of it anew
  window().views().replace(application_->shown()->picture);
  EXPECT_EQ(window::differing(window::pictureAtRest(view), plain, 2), 0.0);
}

/// Colours of the plate's front in a view, from place to place, and whether they lie by the pit.
struct FrontSeen {
  std::vector<QColor> by_pit, elsewhere;
};

FrontSeen frontSeen(const ui::VolumeView& view, const QImage& picture, double front_mm,
                    const ui::VolumeView& with_tool) {
  FrontSeen seen;
  for (double x = -20.0; x <= 20.0; x += 1.0)
    for (double z = -20.0; z <= 20.0; z += 1.0) {
      const QPoint at = view.projected(Vector3d{x, front_mm, z} * 1e-3).toPoint();
      if (with_tool.isToolIn(QRect(at, QSize(1, 1)).adjusted(-3, -3, 3, 3))) continue;
      const double away = std::hypot(x, z);
      if (away < 1.5) seen.by_pit.push_back(picture.pixelColor(at));
      if (away > 6.0) seen.elsewhere.push_back(picture.pixelColor(at));
    }
  return seen;
}

int apart(const std::vector<QColor>& a, const std::vector<QColor>& b) {
  int count = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    count += std::max({std::abs(a[n].red() - b[n].red()), std::abs(a[n].green() - b[n].green()),
                       std::abs(a[n].blue() - b[n].blue())}) > 24;
  return count;
}

TEST_F(Cutting, IsSeenBesideTheUneditedScanWithOneCamera) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  cut(0.0, 20.0);
  ASSERT_FALSE(HasFatalFailure());
  lift();
  ui::Views& views = window().views();
  ui::VolumeView& after = views.volume();
  const QSize alone = after.size();
  auto& wish = child<QCheckBox>("cutBeforeAfter");
  wish.click();
  ASSERT_TRUE(waitFor([&] { return views.before() != nullptr; }));
  ui::BeforeView& before = *views.before();
  EXPECT_TRUE(views.beforeAfter().isChecked());
  EXPECT_EQ(before.size(), after.size());
  EXPECT_LE(before.geometry().right(), after.geometry().left());
  EXPECT_NEAR(before.width() + after.width(), alone.width(), 8);
  // its voxels are the scan's
  EXPECT_EQ(before.picture().volume, app::scanOf(application_->shown()->volume()));
  EXPECT_NE(before.picture().volume, after.picture().volume);

  const auto expectDifferAtThePitAlone = [&](const char* name) {
    const FrontSeen was = frontSeen(before, window::pictureAtRest(before), kFront_mm, after);
    const FrontSeen is = frontSeen(after, window::pictureAtRest(after), kFront_mm, after);
    ASSERT_EQ(was.by_pit.size(), is.by_pit.size());
    ASSERT_GT(is.by_pit.size(), 2U) << name;
    ASSERT_GT(is.elsewhere.size(), 800U) << name;
    EXPECT_EQ(apart(was.by_pit, is.by_pit), int(is.by_pit.size())) << name;
    EXPECT_LT(apart(was.elsewhere, is.elsewhere), 0.01 * double(is.elsewhere.size())) << name;
    window::keep(ui::screenshotOf(window(), views, {.whole_window = true}), name);
  };
  expectDifferAtThePitAlone("before_after");
  // what was cut has its colour on one side alone
  EXPECT_GT(window::count(after.grabFramebuffer(), cutColoured), 30);
  EXPECT_LT(window::count(before.grabFramebuffer(), cutColoured), 5);
  // the picture of the 3-D view is of both
  const QImage both = ui::screenshotOf(window(), views, {.scale = 2});
  EXPECT_EQ(both.size(), views.spaceSize() * 2);
  EXPECT_LT(
      window::differing(both.copy(QRect(QPoint{}, before.size() * 2)), before.picture(2.0), 8),
      0.001);

  // the camera, moved in either
  const auto places = [](const ui::VolumeView& view) {
    ui::ViewLook look;
    view.tell(look);
    Eigen::Matrix<double, 11, 1> all;
    all << look.eye_mm, look.focus_mm, look.up, look.half_height_mm, double(look.parallel);
    return all;
  };
  for (ui::VolumeView* moved : std::initializer_list<ui::VolumeView*>{&before, &after}) {
    ui::VolumeView& other = moved == &after ? static_cast<ui::VolumeView&>(before) : after;
    const QPoint middle = moved->rect().center() + QPoint{40, 90};
    auto last = places(other);
    const auto expectMoved = [&](const char* what) {
      EXPECT_FALSE(places(other).isApprox(last, 1e-4)) << what;
      EXPECT_TRUE(places(other).isApprox(places(*moved), 1e-12)) << what;
      last = places(other);
    };
    QTest::mousePress(moved, Qt::RightButton, {}, middle);
    QTest::mouseMove(moved, middle + QPoint{10, -6});
    QTest::mouseRelease(moved, Qt::RightButton, {}, middle + QPoint{10, -6});
    expectMoved("zoom");
    QTest::mousePress(moved, Qt::MiddleButton, {}, middle);
    QTest::mouseMove(moved, middle + QPoint{10, -6});
    QTest::mouseRelease(moved, Qt::MiddleButton, {}, middle + QPoint{10, -6});
    expectMoved("shift");
    moved->setFocus();
    QTest::keyClick(moved, Qt::Key_Left);
    expectMoved("turn");
    QTest::keyClick(moved, Qt::Key_P);
    expectMoved("perspective");
    EXPECT_EQ(child<QAction>("parallel").isChecked(), moved->isParallel());
    QTest::keyClick(moved, Qt::Key_T);
    expectMoved("to the tool");
    QTest::keyClick(moved, Qt::Key_1);
    expectMoved("from the front");
  }
  // the isovalue of both, as it moves
  type("isovalueTyped", "35");
  EXPECT_EQ(before.surface().isovalue(), 35.0);
  EXPECT_EQ(after.surface().isovalue(), 35.0);
  // the tool stands straight before the pit
  for (int n = 0; n < 10; ++n) QTest::keyClick(&after, Qt::Key_Right);
  for (int n = 0; n < 5; ++n) QTest::keyClick(&after, Qt::Key_Down);
  expectDifferAtThePitAlone("before_after_35");
  type("isovalueTyped", "50");
  // at rest it is as fine as what is left
  QTest::keyClick(&before, Qt::Key_Left);
  before.grabFramebuffer();
  const vtkDataObject* const coarse = before.surface().mesh()->GetMapper()->GetInput();
  window::pictureAtRest(before);
  EXPECT_NE(before.surface().mesh()->GetMapper()->GetInput(), coarse);

  // for looking alone, but the force stops there too
  QSignalSpy cuts(&after, &ui::VolumeView::cutHeld), clutch(&after, &ui::VolumeView::clutchHeld);
  before.setFocus();
  const int released = int(cuts.count());
  QTest::keyPress(&before, Qt::Key_X);
  QTest::keyRelease(&before, Qt::Key_X);
  QTest::keyPress(&before, Qt::Key_C);
  QTest::keyRelease(&before, Qt::Key_C);
  EXPECT_EQ(cuts.count(), released);
  EXPECT_FALSE(application_->snapshot().cuts);
  QTest::keyClick(&before, Qt::Key_Space);
  EXPECT_TRUE(waitFor([&] { return child<QLabel>("stopped").text() == "Force stopped by Space"; }));

  // one stroke back: nothing differs any more
  undo();
  const FrontSeen was = frontSeen(before, window::pictureAtRest(before), kFront_mm, after);
  const FrontSeen is = frontSeen(after, window::pictureAtRest(after), kFront_mm, after);
  EXPECT_EQ(apart(was.by_pit, is.by_pit), 0);
  EXPECT_LT(apart(was.elsewhere, is.elsewhere), 0.01 * double(is.elsewhere.size()));

  // off: nothing is kept
  redo();
  const vtkWeakPointer<vtkImageData> reduced = before.picture().reduced.Get();
  const QPointer<ui::BeforeView> gone = &before;
  ASSERT_NE(reduced, nullptr);
  QTest::keyClick(&window(), Qt::Key_B, Qt::ControlModifier);
  EXPECT_EQ(gone, nullptr);
  EXPECT_EQ(views.before(), nullptr);
  EXPECT_EQ(reduced, nullptr);
  EXPECT_FALSE(wish.isChecked());
  EXPECT_EQ(after.size(), alone);
  EXPECT_TRUE(after.hasFocus());
  EXPECT_EQ(after.wordBoxes().size(), 5U);  // cube and letters, and no caption
}

// Strokes from before belong to the scene that is described; those that are taken back, to none.
TEST_F(Cutting, IsRecordedFromTheMiddleOnAndReplayedToTheBit) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  const auto scan = application_->shown()->volume();
  // a material from a value on, and one that is removed again
  child("addBand").click();
  child("addBand").click();
  window().findChildren<QToolButton*>("removeBand").front()->click();
  ASSERT_TRUE(
      waitFor([&] { return window().findChildren<QToolButton*>("removeBand").size() == 1; }));
  child<ui::NumberBox>("bandFrom").setValue(90.0);
  child<ui::NumberBox>("bandEnergy").setValue(1.5);
  EXPECT_FALSE(child("cutVibration").isChecked());
  child("cutVibration").click();
  ASSERT_TRUE(isReady());
  cut(-6.0, 9.0);
  ASSERT_FALSE(HasFatalFailure());
  const auto scene = application_->shown()->scene->id;
  auto& panel = window::panelOf<ui::RecordingPanel>(window());
  QTest::mouseClick(panel.findChild<QPushButton*>("record"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->recording().isRecording(); }));
  EXPECT_NE(application_->shown()->scene->id, scene);
  ASSERT_TRUE(isReady());
  cut(-2.0, 5.0);
  panel.markAction()->trigger();
  cut(2.0, 9.0);
  ASSERT_FALSE(HasFatalFailure());
  // placed anew in what is cut, as by a double click
  lift();
  application_->session().bring(application_->snapshot().X_WP, application_->snapshot().X_WD);
  ASSERT_TRUE(isReady());
  cut(0.0, 5.0);
  lift();
  undo();
  ASSERT_TRUE(isReady());
  cut(5.0, 9.0);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_EQ(strokes(), 4U);
  const auto path = application_->recording().present();
  QTest::mouseClick(panel.findChild<QPushButton*>("record"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->recording().present().empty(); }));
  auto recording = app::Recording::open(path.parent_path() / path.stem());
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->lostCount(), 0);
  EXPECT_EQ(recording->scenes().size(), 2U);
  int laws = 0;
  for (const app::RecordedEvent& event : recording->events()) {
    if (event.kind != app::kCutLawEvent) continue;
    ++laws;
    const auto law = app::lawFrom(event.text);
    ASSERT_TRUE(law);
    ASSERT_EQ(law->material.count, 2U);
    EXPECT_EQ(law->material.bands[1].from, 90.0);
    EXPECT_EQ(law->material.bands[1].energy, 1.5e9);
    EXPECT_EQ(law->vibration, 0.1);
  }
  EXPECT_GE(laws, 2);
  const auto difference = app::replay(
      *recording,
      [&](std::uint32_t id) -> std::shared_ptr<const haptics::Scene> {
        const app::RecordedScene* then = recording->scene(id);
        const auto volume = app::touchedAsRecorded(scan, *then, nullptr);
        EXPECT_TRUE(volume);
        return *haptics::makeScene(*volume, then->tool, then->options);
      },
      [](double) { return true; });
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->steps, recording->stepCount());
  EXPECT_EQ(difference->skipped, 0);
  EXPECT_EQ(difference->differing, 0) << difference->distance << " m";
  EXPECT_GT(difference->cuts, 100);
  EXPECT_EQ(difference->differing_cuts, 0);
  EXPECT_EQ(difference->carved_said, 2);  // at the mark and at the end
  EXPECT_EQ(difference->differing_carved, 0);

  // and the replay shows what was cut then, there and back
  const auto coral = [&] {
    return window::count(window().views().volume().grabFramebuffer(), cutColoured);
  };
  emit window().menus().openWanted(
      QString::fromStdString((path.parent_path() / path.stem()).string()));
  ASSERT_TRUE(waitFor([&] { return application_->replay() != nullptr; }));
  // before its beginning there was a stroke
  application_->replay()->seek(application_->replay()->track().begin);
  EXPECT_TRUE(waitFor([&] { return coral() > 20; }, 20.0)) << coral();
  window::pictureAtRest(window().views().volume());
  const int first = coral();
  for (int round = 0; round < 2; ++round) {
    application_->replay()->seek(application_->replay()->track().end);
    EXPECT_TRUE(waitFor([&] { return coral() > first + 60; }, 20.0)) << round << ": " << coral();
    EXPECT_TRUE(waitFor([&] { return child<QWidget>("replayWarning").isHidden(); }));
    application_->replay()->seek(application_->replay()->track().begin);
    EXPECT_TRUE(waitFor([&] { return coral() < first + 5; }, 20.0)) << round << ": " << coral();
  }
  window::keep(window().views().volume().grabFramebuffer(), "cut_replayed");
  emit window().replayBar().closeWanted();
  EXPECT_TRUE(waitFor([&] { return application_->replay() == nullptr; }));
  expectTheSameEverywhere();

  // and so do its exports: over the scan that was cut, and not without it
  const std::filesystem::path out = scans_.path().toStdString();
  const auto exported = [&](std::optional<std::size_t> table, const char* name, bool with_scan) {
    app::ExportRequest request{
        .recording = path.parent_path() / path.stem(), .out = out / name, .wish = {}};
    request.wish.table = table;
    // of a film its end: each frame is drawn
    request.wish.from = table ? recording->begin() : recording->end() - 0.3;
    request.wish.to = recording->end();
    if (with_scan) request.volume = scan;
    std::optional<QString> told;
    const auto ended =
        QObject::connect(&application_->exporting().task(), &app::ExportTask::finished,
                         &application_->window(), [&](bool, const QString& what) { told = what; });
    application_->exporting().exportTo(request);
    EXPECT_TRUE(waitFor([&] { return told.has_value(); }, 300.0)) << name;
    QObject::disconnect(ended);
    return told.value_or(QString{});
  };
  const auto holdsVoxels = [&](const char* name) {
    QFile file(QString::fromStdString((out / name).string()));
    return file.open(QIODevice::ReadOnly) && file.readAll().contains("voxel_removed");
  };
  constexpr std::size_t kHdf5 = 2;
  EXPECT_EQ(exported(kHdf5, "with.h5", true), "\"with.h5\" was exported.");
  EXPECT_TRUE(holdsVoxels("with.h5"));
  EXPECT_EQ(
      exported(kHdf5, "without.h5", false),
      "\"without.h5\" was exported. The voxels that were cut are left out: they need their scan "
      "on view.");
  EXPECT_FALSE(holdsVoxels("without.h5"));
  if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) GTEST_SKIP() << "ffmpeg is not there";
  EXPECT_EQ(exported(std::nullopt, "film.mp4", true), "\"film.mp4\" was exported.");
  const QString frames = scans_.filePath("frame%04d.png");
  ASSERT_EQ(QProcess::execute("ffmpeg", {"-v", "error", "-i", scans_.filePath("film.mp4"), frames}),
            0);
  const QStringList pictures =
      QDir(scans_.path()).entryList({"frame*.png"}, QDir::Files, QDir::Name);
  ASSERT_FALSE(pictures.isEmpty());
  const QImage last(scans_.filePath(pictures.last()));
  window::keep(last, "film_of_cuts");
  EXPECT_GT(window::count(last, cutColoured), 60);
}

}  // namespace
