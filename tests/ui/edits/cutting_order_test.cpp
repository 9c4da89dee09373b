// SPDX-License-Identifier: BSD-3-Clause
// Strokes among other edits: what was cut stays cut, and the order is that in which it was done.
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QThread>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/window/edits/edit_controller.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/session_recording.h"
#include "app/window/structures/structures_controller.h"
#include "datasets/edits/edited.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/ui/edits/cutting.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "ui/controls/number_box.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/slice_set.h"
#include "ui/views/volume_view.h"
#include "ui/window/loading.h"
#include "ui/window/menus.h"
#include "ui/window/views.h"

namespace {

using window::waitFor;

class CutsAmongEdits : public window::Cutting {
 protected:
  /// Whether there is material at a place in the axial slice; a replay cuts little by little.
  void expectSeen(bool there, const Eigen::Vector3d& p_mm) {
    window().views().slices().setFollowing(false);
    window().views().setCross(at(3.0));
    ui::SliceView& axial = slice(ui::Plane::Axial);
    const QPoint place = axial.projected(p_mm).toPoint();
    const auto seen = [&] { return axial.grab().toImage().pixelColor(place).blue(); };
    EXPECT_TRUE(waitFor([&] { return there ? seen() > 150 : seen() < 125; }))
        << seen() << " at " << p_mm.transpose();
  }
  void record(bool on) {
    auto& panel = window::panelOf<ui::RecordingPanel>(window());
    if (!on) path_ = application_->recording().present();
    QTest::mouseClick(panel.findChild<QPushButton*>("record"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] {
      return on ? application_->recording().isRecording()
                : application_->recording().present().empty();
    }));
  }
  void openReplay() {
    emit window().menus().openWanted(
        QString::fromStdString((path_.parent_path() / path_.stem()).string()));
    ASSERT_TRUE(waitFor([&] { return application_->replay() != nullptr; }));
  }

 private:
  std::filesystem::path path_;
};

// Cuts on while the window is busy, and neither sees the cuts nor takes what is made meanwhile.
void cutUnseen(haptics::Session& session) {
  for (int n = 0; n < 10; ++n) {
    session.holdCut(true);
    QThread::msleep(50);
  }
  session.holdCut(false);
}

TEST_F(CutsAmongEdits, AreTakenBackStrokeByStrokeOutOfContactAlone) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  const haptics::Volume* const scan = application_->shown()->volume().get();
  lift();
  const QImage first = window::pictureAtRest(window().views().volume());
  cut(-4.0, 6.0);
  lift();
  cut(0.0, 6.0);
  ASSERT_FALSE(HasFatalFailure());
  const std::uint64_t scene = application_->snapshot().scene;
  // in contact it waits
  ASSERT_GT(application_->snapshot().contacts, 0);
  QTest::mouseClick(&child("undoStroke"), Qt::LeftButton);
  QTest::qWait(300);
  EXPECT_EQ(strokes(), 2U);
  EXPECT_EQ(application_->snapshot().scene, scene);
  lift();
  settle();
  EXPECT_EQ(strokes(), 1U);
  auto& list = child<QListWidget>("cutStrokes");
  ASSERT_EQ(list.count(), 1);
  EXPECT_EQ(list.item(0)->text(), QString("Stroke 1: %1 mm³").arg(removed_mm3(), 0, 'f', 1));
  window().views().setCross(at(3.0));
  expectTheSameEverywhere();
  ASSERT_TRUE(isReady());
  redo();
  ASSERT_EQ(list.count(), 2);
  EXPECT_TRUE(list.item(0)->text().startsWith("Stroke 2: "));
  EXPECT_EQ(strokes(), 2U);
  undo();
  undo();
  EXPECT_EQ(strokes(), 0U);
  EXPECT_EQ(application_->shown()->volume().get(), scan);
  EXPECT_EQ(child<QLabel>("cutRemoved").text(), "Nothing was cut yet.");
  EXPECT_EQ(list.count(), 0);
  window().views().setCross(at(3.0));
  expectTheSameEverywhere();
  EXPECT_LT(window::differing(window::pictureAtRest(window().views().volume()), first), 0.002);
  // and it can be cut anew
  ASSERT_TRUE(isReady());
  cut(3.0, 4.0);
  EXPECT_EQ(strokes(), 1U);
}

TEST_F(CutsAmongEdits, AreKeptWhileAnotherLawIsPrepared) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  const std::uint64_t scene = application_->snapshot().scene;
  lift();
  pullTip(at(5.0));
  child<QCheckBox>("cutVibration").click();
  cutUnseen(application_->session());
  ASSERT_TRUE(waitFor([&] { return strokes() == 1; })) << state().toStdString();
  EXPECT_GT(removed_mm3(), 1.0);
  lift();
  settle();
  EXPECT_NE(application_->snapshot().scene, scene);
  window().views().setCross(at(1.0));
  expectTheSameEverywhere();
  EXPECT_TRUE(isReady());
}

TEST_F(CutsAmongEdits, UnderWayAreTheLastStrokeForAnUndo) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  cut(-6.0, 8.0);
  ASSERT_FALSE(HasFatalFailure());
  const double before = removed_mm3();
  pullTip(at(-6.0, 6.0));
  pullTip(at(5.0, 6.0));
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > before + 8.0; })) << state().toStdString();
  pullTip(at(-25.0, 6.0));
  ASSERT_EQ(application_->snapshot().contacts, 0);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  window::afterTicks(*application_, 300);
  EXPECT_EQ(strokes(), 1U);
  holdKey(false);
  settle();
  EXPECT_EQ(strokes(), 1U);
  EXPECT_FALSE(isThere(at(0.5, -6.0)));
  EXPECT_TRUE(isThere(at(0.5, 6.0)));
}

TEST_F(CutsAmongEdits, AreNotPutBackByAnEditThatWasBegunBefore) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  lift();
  pullTip(at(5.0));
  QTest::mouseClick(&child("cropTool"), Qt::LeftButton);
  child<ui::NumberBox>("crop0High").setValue(15.0);
  const std::uint64_t scene = application_->snapshot().scene;
  QTest::mouseClick(&child("cropApply"), Qt::LeftButton);
  ASSERT_TRUE(application_->editing().isBusy());
  cutUnseen(application_->session());
  ASSERT_TRUE(waitFor([&] { return application_->editing().hasStrokes(); }));
  window::afterTicks(*application_, 300);
  EXPECT_EQ(application_->snapshot().scene, scene);
  EXPECT_GT(application_->snapshot().contacts, 0);
  lift();
  settle();
  EXPECT_NE(application_->snapshot().scene, scene);
  EXPECT_EQ(strokes(), 1U);
  EXPECT_EQ(application_->editing().edits().size(), 2U);
  EXPECT_FALSE(isThere(at(0.5)));
  EXPECT_FALSE(isThere(at(0.5, 20.0)));
}

TEST_F(CutsAmongEdits, AreKeptWhenEditsAreCancelled) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  lift();
  pullTip(at(5.0));
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > 8.0; })) << state().toStdString();
  holdKey(false);
  while (!application_->editing().hasStrokes()) QCoreApplication::processEvents();
  emit window().loading().cancelWanted();
  settle();
  EXPECT_EQ(strokes(), 1U);
  EXPECT_FALSE(isThere(at(0.5)));
}

// The same scan with two burrs: what one has cut is not seen where the other was held.
TEST_F(CutsAmongEdits, AreSeenInTheScenesOfAReplayThatHaveThem) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  lift();
  record(true);
  ASSERT_FALSE(HasFatalFailure());
  window::afterTicks(*application_, 300);
  QTest::mouseClick(&child("cut_burr-6"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->shown()->tool.name == "burr-6"; }));
  ASSERT_TRUE(isReady());
  window::panelOf<ui::RecordingPanel>(window()).markAction()->trigger();
  cut(0.0, 30.0);
  ASSERT_FALSE(HasFatalFailure());
  lift();
  ui::VolumeView& view = window().views().volume();
  const auto coral = [&] {
    return window::count(window::pictureAtRest(view), window::cutColoured);
  };
  const int live = coral();
  EXPECT_GT(live, 60);
  record(false);
  openReplay();
  ASSERT_FALSE(HasFatalFailure());
  const ui::ReplayTrack& track = application_->replay()->track();
  const auto mark = std::ranges::find(track.marks, QString("mark"), &ui::ReplayMark::kind);
  ASSERT_NE(mark, track.marks.end());
  for (int round = 0; round < 2; ++round) {
    // before the first cut of its scene, and in the scene before
    for (const double uncut_at : {mark->time, track.begin}) {
      application_->replay()->seek(track.end);
      EXPECT_TRUE(waitFor([&] { return coral() > 60; })) << round;
      expectSeen(false, at(0.8, 1.0));
      application_->replay()->seek(uncut_at);
      EXPECT_TRUE(waitFor([&] { return coral() < 5; })) << round;
      expectSeen(true, at(0.8, 1.0));
    }
  }
  emit window().replayBar().closeWanted();
  ASSERT_TRUE(waitFor([&] { return application_->replay() == nullptr; }));
  EXPECT_NEAR(coral(), live, 0.1 * live);
  EXPECT_FALSE(isThere(at(0.5)));
  expectTheSameEverywhere();
}

TEST_F(CutsAmongEdits, LeaveEveryStructureThatWasChosenAndInAReplayThoseOfThen) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  lift();
  const auto scan = application_->shown()->volume();
  const auto openParts = [&](const char* name, double from_mm) {
    const auto labels = window::volumeOf(
        scan->grid, haptics::ScalarType::UInt8,
        [&](const haptics::Vec3& p_W) { return p_W.x() > from_mm * 1e-3 ? 1.0 : 2.0; });
    const auto path = std::filesystem::path(scans_.path().toStdString()) / name;
    ASSERT_TRUE(datasets::writeNrrd(*labels, path).has_value());
    const auto before = application_->structures().labels();
    application_->structures().open(path);
    ASSERT_TRUE(waitFor([&] {
      const auto now = application_->structures().labels();
      return now != nullptr && now != before;
    }));
  };
  const auto choose = [&](int row, bool never) {
    child<QTableWidget>("structures").selectRow(row);
    child<QComboBox>("structureCutting").setCurrentIndex(never ? 1 : 0);
  };
  const auto kept = [&] {
    std::vector<int> numbers;
    if (const auto* tissues = datasets::tissuesIn(*application_->shown()->volume()))
      for (const auto& part : tissues->parts()) numbers.push_back(part.structure);
    return numbers;
  };
  const auto settlesAt = [&](const std::vector<int>& numbers) {
    return waitFor([&] { return !application_->editing().isBusy() && kept() == numbers; });
  };
  openParts("halves.nrrd", 0.0);
  // the second before the first is an edit
  choose(0, true);
  ASSERT_TRUE(waitFor([&] { return application_->editing().isBusy(); }));
  choose(1, true);
  EXPECT_TRUE(settlesAt({0, 1}));
  choose(1, false);
  ASSERT_TRUE(settlesAt({0}));
  // tables alone tell these scenes apart
  record(true);
  ASSERT_FALSE(HasFatalFailure());
  choose(1, true);
  ASSERT_TRUE(settlesAt({0, 1}));
  choose(0, false);
  ASSERT_TRUE(settlesAt({1}));
  ASSERT_TRUE(isReady());
  cut(4.0, 14.0);
  ASSERT_FALSE(HasFatalFailure());
  lift();
  record(false);
  openReplay();
  ASSERT_FALSE(HasFatalFailure());
  application_->replay()->seek(application_->replay()->track().begin);
  expectSeen(true, at(0.8, 4.0));
  application_->replay()->seek(application_->replay()->track().end);
  expectSeen(false, at(0.8, 4.0));
  emit window().replayBar().closeWanted();
  ASSERT_TRUE(waitFor([&] { return application_->replay() == nullptr; }));
  // a choice in another file's structures leaves it what it is
  openParts("others.nrrd", 5.0);
  choose(0, true);
  EXPECT_TRUE(settlesAt({0, 1}));
}

}  // namespace
