// SPDX-License-Identifier: BSD-3-Clause
// Strokes that are in no file are asked about before they are lost.
#include <QApplication>
#include <QKeyEvent>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTimer>
#include <cstdint>
#include <filesystem>

#include "app/view_file/view_file.h"
#include "app/window/edits/edit_controller.h"
#include "app/window/views/view_file_controller.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/ui/answers.h"
#include "tests/ui/edits/cutting.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "ui/views/volume_view.h"
#include "ui/window/views.h"

namespace {

using window::Cutting;
using window::waitFor;

// A stroke under way ends first, and counts.
TEST_F(Cutting, ThatIsInNoFileIsAskedAboutBeforeTheWindowCloses) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  const QString path = scans_.filePath("cut.palpate-view");
  lift();
  pullTip(at(5.0));
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > 15.0; })) << state().toStdString();
  EXPECT_EQ(strokes(), 0U);
  {
    const window::Answer answer("Cancel");
    window().close();
    EXPECT_TRUE(answer.said.contains("edits of this scan are not saved"))
        << answer.said.toStdString();
  }
  EXPECT_TRUE(window().isVisible());
  comeBack();
  ASSERT_TRUE(waitFor([&] { return strokes() == 1; }));
  settle();
  EXPECT_FALSE(application_->snapshot().cuts);
  EXPECT_FALSE(isThere(at(1.0)));
  window().views().setCross(at(3.0));
  expectTheSameEverywhere();
  lift();
  undo();
  EXPECT_TRUE(isThere(at(1.0)));
  redo();
  // one that is saved first is in the file
  holdKey(false);
  ASSERT_TRUE(isReady());
  pullTip(at(-6.0, 5.0));
  pullTip(at(5.0, 5.0));
  const double before = removed_mm3();
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > before + 3.0; })) << state().toStdString();
  EXPECT_EQ(strokes(), 1U);
  {
    const window::Answer answer("Save");
    const window::FileName name(path);
    window().close();
    EXPECT_TRUE(waitFor([&] { return !window().isVisible(); }));
  }
  EXPECT_EQ(app::readViewFile(path.toStdString())->edits.size(), 2U);
}

TEST_F(Cutting, ThatIsInNoFileIsAskedAboutBeforeAnotherScanTakesItsPlace) {
  const auto path = std::filesystem::path(scans_.path().toStdString()) / "another.nrrd";
  const auto another = window::volumeOf(window::cubeGrid(40), haptics::ScalarType::Int16,
                                        window::ball({0, 0, 0}, 0.012));
  ASSERT_TRUE(datasets::writeNrrd(*another, path).has_value());
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  const auto drop = [&] { emit window().dropped({QString::fromStdString(path.string())}); };
  const auto expectQuestion = [&](const char* button) {
    const window::Answer answer(button);
    drop();
    EXPECT_TRUE(waitFor([&] { return !answer.said.isEmpty(); }));
    EXPECT_TRUE(answer.said.contains("edits of this scan are not saved"))
        << answer.said.toStdString();
    comeBack();
  };
  lift();
  pullTip(at(5.0));
  holdKey(true);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > 15.0; })) << state().toStdString();
  EXPECT_EQ(strokes(), 0U);
  expectQuestion("Cancel");  // under way
  ASSERT_TRUE(waitFor([&] { return strokes() == 1; }));
  settle();
  EXPECT_FALSE(isThere(at(1.0)));
  // the key is down all the while
  QKeyEvent again(QEvent::KeyPress, Qt::Key_X, Qt::NoModifier, "x", true);
  window().views().volume().setFocus();
  QApplication::sendEvent(&window().views().volume(), &again);
  window::afterTicks(*application_, 300);
  EXPECT_FALSE(application_->snapshot().cuts);
  holdKey(false);
  expectQuestion("Cancel");  // ended
  settle();
  EXPECT_EQ(strokes(), 1U);
  EXPECT_FALSE(isThere(at(1.0)));
  EXPECT_TRUE(window().windowTitle().startsWith("plate"));
  // what is lost with the user's word is lost
  ASSERT_TRUE(isReady());
  holdKey(true);
  const double before = removed_mm3();
  pullTip(at(8.0));
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > before + 2.0; })) << state().toStdString();
  expectQuestion("Discard");
  holdKey(false);
  ASSERT_TRUE(waitFor([&] { return !window().windowTitle().startsWith("plate"); }));
  EXPECT_EQ(strokes(), 0U);
  EXPECT_EQ(application_->shown()->volume()->derivation, nullptr);
  emit window().dropped({scans_.filePath("plate.nrrd")});
  ASSERT_TRUE(waitFor([&] { return window().windowTitle().startsWith("plate"); }));
  ASSERT_TRUE(isReady());
  EXPECT_GE(felt(at(1.0)), isovalue_);
  // and one that is saved is not asked about
  cut(0.0, 5.0);
  ASSERT_FALSE(HasFatalFailure());
  QSignalSpy finished(&application_->viewFile(), &app::ViewFileController::finished);
  application_->viewFile().save(scans_.filePath("cut.palpate-view").toStdString(), false);
  ASSERT_TRUE(waitFor([&] { return finished.count() > 0; }));
  EXPECT_TRUE(finished[0][0].toBool());
  const window::Answer answer("Cancel");
  drop();
  EXPECT_TRUE(waitFor([&] { return !window().windowTitle().startsWith("plate"); }));
  EXPECT_TRUE(window().close());
  EXPECT_TRUE(answer.said.isEmpty()) << answer.said.toStdString();
}

// The button of a device is held on whatever window has the keys.
TEST_F(Cutting, RestsWhileAQuestionIsOpenAndUntilItsButtonWasReleased) {
  openWithBurr();
  ASSERT_FALSE(HasFatalFailure());
  lift();
  pullTip(at(5.0));
  std::uint64_t asked = 0;
  bool turned = false;
  QTimer held;
  QObject::connect(&held, &QTimer::timeout, [&] {
    application_->session().holdCut(true);
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    const haptics::Snapshot& now = application_->snapshot();
    if (question == nullptr) return;
    if (asked == 0) asked = now.tick;
    if (now.tick < asked + 100) return;  // the one on view may be from before
    turned = turned || now.cuts;
    if (now.tick > asked + 500) question->button(QMessageBox::Cancel)->click();
  });
  held.start(20);
  ASSERT_TRUE(waitFor([&] { return removed_mm3() > 10.0; })) << state().toStdString();
  window().close();
  EXPECT_NE(asked, 0U);
  EXPECT_FALSE(turned);
  EXPECT_TRUE(window().isVisible());
  ASSERT_TRUE(waitFor([&] { return strokes() == 1; }));
  settle();
  window::afterTicks(*application_, 300);
  EXPECT_FALSE(application_->snapshot().cuts);
  held.stop();
  application_->session().holdCut(false);
  window::afterTicks(*application_, 100);
  held.start(20);
  const double before = removed_mm3();
  pullTip(at(8.0));
  EXPECT_TRUE(waitFor([&] { return removed_mm3() > before + 1.0; })) << state().toStdString();
}

}  // namespace
