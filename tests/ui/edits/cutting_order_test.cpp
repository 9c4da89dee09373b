// SPDX-License-Identifier: BSD-3-Clause
// Strokes among other edits: what was cut stays cut, and the order is that in which it was done.
#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>
#include <QThread>
#include <algorithm>
#include <cstdint>

#include "app/window/edits/edit_controller.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/session_recording.h"
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

class CutsAmongEdits : public window::Cutting {};

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
  window().views().slices().setFollowing(false);
  window().views().setCross(at(3.0));
  const auto expectInSlice = [&](bool there) {
    ui::SliceView& axial = slice(ui::Plane::Axial);
    const QPoint place = axial.projected(at(0.8, 1.0)).toPoint();
    const auto grey = [&] { return axial.grab().toImage().pixelColor(place).blue(); };
    EXPECT_TRUE(waitFor([&] { return there ? grey() > 150 : grey() < 110; })) << grey();
  };
  auto& panel = window::panelOf<ui::RecordingPanel>(window());
  QTest::mouseClick(panel.findChild<QPushButton*>("record"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->recording().isRecording(); }));
  window::afterTicks(*application_, 300);
  QTest::mouseClick(&child("cut_burr-6"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->shown()->tool.name == "burr-6"; }));
  ASSERT_TRUE(isReady());
  panel.markAction()->trigger();
  cut(0.0, 30.0);
  ASSERT_FALSE(HasFatalFailure());
  lift();
  ui::VolumeView& view = window().views().volume();
  const auto coral = [&] {
    return window::count(window::pictureAtRest(view), window::cutColoured);
  };
  const int live = coral();
  EXPECT_GT(live, 60);
  const auto path = application_->recording().present();
  QTest::mouseClick(panel.findChild<QPushButton*>("record"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->recording().present().empty(); }));
  emit window().menus().openWanted(
      QString::fromStdString((path.parent_path() / path.stem()).string()));
  ASSERT_TRUE(waitFor([&] { return application_->replay() != nullptr; }));
  const ui::ReplayTrack& track = application_->replay()->track();
  const auto mark = std::ranges::find(track.marks, QString("mark"), &ui::ReplayMark::kind);
  ASSERT_NE(mark, track.marks.end());
  for (int round = 0; round < 2; ++round) {
    // before the first cut of its scene, and in the scene before
    for (const double uncut_at : {mark->time, track.begin}) {
      application_->replay()->seek(track.end);
      EXPECT_TRUE(waitFor([&] { return coral() > 60; })) << round;
      expectInSlice(false);
      application_->replay()->seek(uncut_at);
      EXPECT_TRUE(waitFor([&] { return coral() < 5; })) << round;
      expectInSlice(true);
    }
  }
  emit window().replayBar().closeWanted();
  ASSERT_TRUE(waitFor([&] { return application_->replay() == nullptr; }));
  EXPECT_NEAR(coral(), live, 0.1 * live);
  EXPECT_FALSE(isThere(at(0.5)));
  expectTheSameEverywhere();
}

}  // namespace
