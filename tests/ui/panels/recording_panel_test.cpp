// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/recording_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <functional>

#include "tests/ui/panelled_window.h"
#include "tests/ui/window_support.h"
#include "ui/controls/time_words.h"
#include "ui/panels/replay_bar.h"
#include "ui/style/look.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/side_panel.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace {

using State = ui::RecordingStatus::State;

ui::RecordingStatus running() {
  return {.state = State::Recording,
          .elapsed = 83.24,
          .samples = 83'240,
          .bytes = 21'400'000,
          .room = 412.7 * 3600.0};
}

const QList<ui::PastRecording> kPast{
    {"a", "session-7", 605.04, "drill", 152'000'000, true},
    {"b", "session-6", 0.0, "", 3'000'000, false},
    {"c", "second <b>try</b> with the probe, slowly along the rim", 12.0, "probe", 2'900'000, true},
};

struct Panel {
  ui::RecordingPanel panel;
  QPushButton* record = panel.findChild<QPushButton*>("record");
  QPushButton* mark = panel.findChild<QPushButton*>("mark");
  QLineEdit* note = panel.findChild<QLineEdit*>("markNote");
  QTableWidget* list = panel.findChild<QTableWidget*>("recordings");
  QPushButton* open = panel.findChild<QPushButton*>("openRecording");
  QPushButton* save = panel.findChild<QPushButton*>("exportRecording");
  QPushButton* remove = panel.findChild<QPushButton*>("deleteRecording");

  Panel() {
    panel.setReady(true);
    window::showAndWait(panel, {300, 460});
  }
  QLabel* label(const char* name) const { return panel.findChild<QLabel*>(name); }
  void click(QAbstractButton* button) { QTest::mouseClick(button, Qt::LeftButton); }
  void choose(int row) {
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(row, 0)).center());
  }
};

/// Every label that is seen has room for its words.
void expectLegible(const QWidget& parent) {
  int seen = 0;
  for (const QLabel* label : parent.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    ++seen;
    const int wanted =
        label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    EXPECT_GE(label->height(), wanted) << label->text().toStdString();
    if (!label->wordWrap()) {
      EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
    }
    EXPECT_LE(label->mapTo(&parent, QPoint{label->width(), 0}).x(), parent.width())
        << label->text().toStdString();
  }
  EXPECT_GT(seen, 3);
}

TEST(RecordingPanel, TimesAreWrittenAsMinutesAndSeconds) {
  EXPECT_EQ(ui::clockTime(0.0, 1), "0:00.0");
  EXPECT_EQ(ui::clockTime(59.94, 1), "0:59.9");
  EXPECT_EQ(ui::clockTime(59.96, 1), "1:00.0");
  EXPECT_EQ(ui::clockTime(83.2404, 3), "1:23.240");
  EXPECT_EQ(ui::clockTime(7'384.0, 0), "123:04");
  EXPECT_EQ(ui::clockTime(-1.0, 1), "0:00.0");
  EXPECT_EQ(ui::clockTime(std::nan(""), 1), QString::fromUtf8("–"));
  EXPECT_EQ(ui::clockTime(1e300, 1), "16666666:40.0");
}

TEST(RecordingPanel, SaysHowTheRecordingComesAlong) {
  Panel p;
  QSignalSpy wanted(&p.panel, &ui::RecordingPanel::recordWanted);
  EXPECT_EQ(p.label("recordState")->text(), "Not recording");
  p.click(p.record);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted.takeFirst().at(0).toBool());
  EXPECT_FALSE(p.record->isChecked());  // it is told when it records

  p.panel.show(running());
  p.panel.show(kPast);
  EXPECT_EQ(p.label("recordState")->text(), "Recording");
  EXPECT_EQ(p.label("recordElapsed")->text(), "1:23.2");
  EXPECT_EQ(p.label("recordSamples")->text(), "83,240");
  EXPECT_EQ(p.label("recordGaps")->text(), "0");
  EXPECT_EQ(p.label("recordSize")->text(), "21.4 MB");
  EXPECT_EQ(p.label("recordRoom")->text(), "room for 412 h");
  EXPECT_FALSE(p.label("recordLost")->isVisible());
  EXPECT_TRUE(p.record->isChecked());
  const QImage calm = window::pictureOf(p.panel);
  window::keep(calm, "recording_panel");
  expectLegible(p.panel);
  p.click(p.record);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_FALSE(wanted.takeFirst().at(0).toBool());
  EXPECT_TRUE(p.record->isChecked());

  // what is not as it should be is said in words and seen in colour
  const auto amber = [](QColor c) { return c.rgb() == ui::style::kDark.attention_ground.rgb(); };
  EXPECT_EQ(window::count(calm, amber), 0);
  ui::RecordingStatus status = running();
  status.gaps = 1'204;
  status.room = 8.9 * 60.0;
  p.panel.show(status);
  EXPECT_TRUE(p.label("recordLost")->text().contains("1,204 samples were lost"));
  EXPECT_EQ(p.label("recordRoom")->text(), "room for 8 min");
  const QImage warned = window::pictureOf(p.panel);
  window::keep(warned, "recording_panel_gaps");
  EXPECT_GT(window::count(warned, amber), 2'000);
  expectLegible(p.panel);

  status = running();
  status.state = State::Finishing;
  p.panel.show(status);
  EXPECT_FALSE(p.record->isEnabled());
  EXPECT_TRUE(p.label("recordState")->text().startsWith("Finishing"));
  status.state = State::Stopped;
  status.failure = "The disk is full; make room and record again.";
  p.panel.show(status);
  EXPECT_EQ(p.label("recordState")->text(),
            "Stopped by itself: The disk is full; make room and record again.");
  EXPECT_TRUE(p.record->isEnabled());
  EXPECT_EQ(p.record->text(), "&Record");
  const QImage stopped = window::pictureOf(p.panel);
  window::keep(stopped, "recording_panel_stopped");
  EXPECT_GT(window::count(stopped, amber), 1'000);
  expectLegible(p.panel);
  p.panel.show(ui::RecordingStatus{});
  EXPECT_EQ(p.label("recordElapsed")->text(), "0:00.0");
  EXPECT_EQ(window::count(window::pictureOf(p.panel), amber), 0);

  // without a session nothing can begin, but what has begun can end
  p.panel.setReady(false);
  EXPECT_FALSE(p.record->isEnabled());
  p.panel.show(running());
  EXPECT_TRUE(p.record->isEnabled());
}

TEST(RecordingPanel, WhenItBeganAndWhichScanItIsAreStatedOnlyIfThatIsSwitchedOn) {
  Panel p;
  auto* when = p.panel.findChild<QCheckBox*>("recordWhen");
  ASSERT_NE(when, nullptr);
  EXPECT_FALSE(p.panel.states().when || p.panel.states().scan);
  EXPECT_TRUE(when->toolTip().contains("who the patient is"));
  QTest::mouseClick(when, Qt::LeftButton, {}, {8, when->height() / 2});
  EXPECT_TRUE(p.panel.states().when && !p.panel.states().scan);
  auto* scan = p.panel.findChild<QCheckBox*>("recordScan");
  ASSERT_NE(scan, nullptr);
  EXPECT_TRUE(scan->toolTip().contains("recognises it"));
  QTest::mouseClick(scan, Qt::LeftButton, {}, {8, scan->height() / 2});
  EXPECT_TRUE(p.panel.states().when && p.panel.states().scan);
  p.panel.show(running());  // too late
  EXPECT_FALSE(when->isEnabled() || scan->isEnabled());
  p.panel.show(ui::RecordingStatus{});
  EXPECT_TRUE(when->isEnabled() && scan->isEnabled() && p.panel.states().when);
}

TEST(RecordingPanel, RoomIsRoundedDown) {
  Panel p;
  const auto words = [&](double seconds) {
    ui::RecordingStatus status = running();
    status.room = seconds;
    p.panel.show(status);
    return p.label("recordRoom")->text().toStdString();
  };
  EXPECT_EQ(words(-5.0), "room for 0 min");
  EXPECT_EQ(words(3'599.0), "room for 59 min");
  EXPECT_EQ(words(3'600.0), "room for 1.0 h");
  EXPECT_EQ(words(9.99 * 3'600.0), "room for 9.9 h");
  EXPECT_EQ(words(10.9 * 3'600.0), "room for 10 h");
}

TEST(RecordingPanel, ButtonAndEnterSetAMarkWithItsNote) {
  Panel p;
  QSignalSpy marks(&p.panel, &ui::RecordingPanel::markWanted);
  EXPECT_TRUE(p.note->placeholderText().contains("no names"));
  EXPECT_FALSE(p.mark->isEnabled());
  EXPECT_FALSE(p.note->isEnabled());
  p.panel.show(running());
  p.note->setFocus();
  QTest::keyClicks(p.note, "Rim, mm");
  QTest::keyClick(p.note, Qt::Key_Return);
  ASSERT_EQ(marks.count(), 1);
  EXPECT_EQ(marks.takeFirst().at(0).toString(), "Rim, mm");
  EXPECT_EQ(p.note->text(), "");
  EXPECT_TRUE(p.label("marked")->text().startsWith("Marked at 1:23."));
  // where it lies, and not where the time was last told
  QTest::qWait(800);
  QTest::keyClicks(p.note, "  hole ");
  p.click(p.mark);
  p.click(p.mark);
  ASSERT_EQ(marks.count(), 2);
  EXPECT_EQ(marks.at(0).at(0).toString(), "hole");
  EXPECT_GE(p.label("marked")->text(), "Marked at 1:24.0");
  EXPECT_EQ(marks.at(1).at(0).toString(), "");
  // the confirmation goes by itself, when it was there for long enough to be read
  EXPECT_NE(p.label("marked")->text(), "");
  auto* confirmation = p.panel.findChild<QTimer*>("confirmation");
  ASSERT_TRUE(confirmation->isActive());
  EXPECT_GE(confirmation->interval(), 3'000);
  confirmation->start(1);
  EXPECT_TRUE(window::waitFor([&] { return p.label("marked")->text().isEmpty(); }));
}

TEST(RecordingPanel, TheListOpensExportsRecoversAndAsksBeforeItDeletes) {
  Panel p;
  QSignalSpy opened(&p.panel, &ui::RecordingPanel::openWanted),
      exported(&p.panel, &ui::RecordingPanel::exportWanted),
      recovered(&p.panel, &ui::RecordingPanel::recoverWanted),
      deleted(&p.panel, &ui::RecordingPanel::deleteWanted);
  for (const QPushButton* button : {p.open, p.save, p.remove}) EXPECT_FALSE(button->isEnabled());
  p.panel.show(kPast);
  ASSERT_EQ(p.list->rowCount(), 3);
  const auto lines = [&](int row) { return p.list->item(row, 0)->text().split('\n'); };
  ASSERT_EQ(lines(0).size(), 3);
  EXPECT_EQ(lines(0)[0], "session-7");
  EXPECT_EQ(lines(0)[2], QString::fromUtf8("10:05.0 · drill · 152.0 MB"));
  EXPECT_EQ(lines(1)[2], QString::fromUtf8("unfinished · 3.0 MB"));
  p.choose(0);
  EXPECT_EQ(p.open->text(), "Open");
  p.click(p.open);
  p.click(p.save);
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(opened.at(0).at(0).toString(), "a");
  ASSERT_EQ(exported.count(), 1);
  EXPECT_EQ(exported.at(0).at(0).toString(), "a");

  // an unfinished one is recovered in place of opened, and not exported
  p.choose(1);
  EXPECT_EQ(p.open->text(), "Recover");
  EXPECT_FALSE(p.save->isEnabled());
  p.click(p.open);
  ASSERT_EQ(recovered.count(), 1);
  EXPECT_EQ(recovered.at(0).at(0).toString(), "b");
  EXPECT_EQ(opened.count(), 1);

  // Enter in the list
  p.choose(2);
  QTest::keyClick(p.list, Qt::Key_Return);
  ASSERT_EQ(opened.count(), 2);
  EXPECT_EQ(opened.at(1).at(0).toString(), "c");

  const auto answer = [&](const std::function<void(QMessageBox&)>& how) {
    QTimer::singleShot(200, &p.panel, [how] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      EXPECT_TRUE(box->text().contains("<b>try</b>")) << box->text().toStdString();
      EXPECT_EQ(box->textFormat(), Qt::PlainText);
      window::keep(window::pictureOf(*box), "recording_delete");
      how(*box);
    });
    p.click(p.remove);
  };
  answer([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Return); });
  answer([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Escape); });
  EXPECT_EQ(deleted.count(), 0);
  answer([](QMessageBox& box) {
    for (QAbstractButton* button : box.buttons())
      if (button->text().contains("Delete")) QTest::mouseClick(button, Qt::LeftButton);
  });
  ASSERT_EQ(deleted.count(), 1);
  EXPECT_EQ(deleted.at(0).at(0).toString(), "c");

  // what was selected stays so in another order, and nothing takes the place of what is gone
  p.panel.show(QList<ui::PastRecording>{kPast[2], kPast[0], kPast[1]});
  p.click(p.open);
  EXPECT_EQ(opened.last().at(0).toString(), "c");
  p.panel.show(QList<ui::PastRecording>{kPast[0], kPast[1]});
  for (const QPushButton* button : {p.open, p.save, p.remove}) EXPECT_FALSE(button->isEnabled());
}

TEST(RecordingPanel, ARecordingHasALabelADateAndACurve) {
  Panel p;
  QSignalSpy labelled(&p.panel, &ui::RecordingPanel::labelChanged);
  auto* label = p.panel.findChild<QLineEdit*>("recordingLabel");
  EXPECT_FALSE(label->isEnabled());
  QList<ui::PastRecording> past = kPast;
  past[0].changed = QDateTime({2026, 3, 4}, {5, 6});
  past[0].label = "first try";
  p.panel.show(past);
  EXPECT_EQ(p.list->item(0, 0)->text().section('\n', 0, 0), "first try (session-7)");
  EXPECT_EQ(p.list->item(0, 0)->text().section('\n', 1, 1),
            QLocale().toString(past[0].changed, QLocale::ShortFormat));
  p.choose(0);
  EXPECT_EQ(label->text(), "first try");
  p.panel.window()->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(p.panel.window(), 120'000));
  label->setFocus();
  label->selectAll();
  QTest::keyClicks(label, "Rim  of the <b>window</b>");
  EXPECT_EQ(labelled.count(), 0);
  // told anew meanwhile, what is being typed stays
  p.panel.show(past);
  EXPECT_EQ(label->text(), "Rim  of the <b>window</b>");
  QTest::keyClick(label, Qt::Key_Return);
  ASSERT_EQ(labelled.count(), 1);
  EXPECT_EQ(labelled.at(0).at(0).toString(), "a");
  EXPECT_EQ(labelled.at(0).at(1).toString(), "Rim of the <b>window</b>");
  EXPECT_TRUE(p.list->item(0, 0)->text().startsWith("Rim of the <b>window</b> (session-7)"));
  QTest::keyClick(label, Qt::Key_Return);
  EXPECT_EQ(labelled.count(), 1);
  p.choose(2);
  EXPECT_EQ(label->text(), "");

  // the force is drawn to its own greatest: what is not a number is a gap
  QList<float> curve(64, 1.0F);
  for (int i = 0; i < 32; ++i) curve[i] = 2.5F;
  for (int i = 48; i < 64; ++i) curve[i] = std::nanf("");
  p.panel.showCurve("a", curve);
  p.panel.showCurve("gone", curve);
  EXPECT_EQ(p.list->item(0, 1)->data(Qt::AccessibleTextRole).toString(), "force up to 2.5 N");
  EXPECT_EQ(p.list->item(2, 1)->data(Qt::AccessibleTextRole).toString(), "force not known");
  QTest::qWait(30);
  window::keep(window::pictureOf(p.panel), "recording_list");
  const QImage list = window::pictureOf(*p.list->viewport());
  const auto solid = [&](int row, int from, int to) {
    const QRect cell = p.list->visualItemRect(p.list->item(row, 1));
    const QRect part(cell.left() + cell.width() * from / 4, cell.top(),
                     cell.width() * (to - from) / 4, cell.height());
    return window::count(list.copy(part),
                         [](QColor c) { return c.rgb() == ui::style::colours().solid.rgb(); });
  };
  EXPECT_GT(solid(0, 0, 2), 2 * solid(0, 2, 3));
  EXPECT_GT(solid(0, 2, 3), 20);
  EXPECT_LT(solid(0, 3, 4), 40);
  EXPECT_EQ(solid(2, 0, 4), 0);
}

/// The main window with its panel and bar.
struct Whole {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  ui::RecordingPanel& panel = *new ui::RecordingPanel;  // the window's

  Whole() {
    // as RecordingController does
    window.panels().add(&panel, "Recording", "Recor&ding", "recordingSection", ui::Tab::Record);
    window.addAction(panel.markAction());
    window::showAndWait(window, {1280, 900});
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window, 120'000));
  }
  QAction* action(const char* text) const {
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text() == QString::fromUtf8(text)) return action;
    return nullptr;
  }
};

TEST(RecordingPanel, MSetsAMarkFromAnywhereInTheWindowWhileItRecords) {
  Whole w;
  const auto* record = w.panel.findChild<QPushButton*>("record");
  EXPECT_TRUE(record->visibleRegion().isEmpty());  // another tab is in front
  QSignalSpy marks(&w.panel, &ui::RecordingPanel::markWanted);
  w.window.views().volume().setFocus();
  QTest::keyClick(&w.window.views().volume(), Qt::Key_M);
  EXPECT_EQ(marks.count(), 0);
  w.panel.show(running());
  QTest::keyClick(&w.window.views().volume(), Qt::Key_M);
  EXPECT_EQ(marks.count(), 1);
  QTest::keyClick(&w.window.views().slice(ui::Plane::Axial), Qt::Key_M);
  EXPECT_EQ(marks.count(), 2);

  // in the note it is a letter
  w.action("Recor&ding")->trigger();
  QTest::qWait(50);
  ASSERT_FALSE(record->visibleRegion().isEmpty());
  auto* note = w.panel.findChild<QLineEdit*>("markNote");
  note->setFocus();
  QTest::keyClicks(note, "mm");
  EXPECT_EQ(note->text(), "mm");
  EXPECT_EQ(marks.count(), 2);
  // and goes along with a mark that is set from elsewhere
  w.window.views().volume().setFocus();
  QTest::keyClick(&w.window.views().volume(), Qt::Key_M);
  ASSERT_EQ(marks.count(), 3);
  EXPECT_EQ(marks.last().at(0).toString(), "mm");
  w.panel.show(ui::RecordingStatus{});
  QTest::keyClick(&w.window.views().volume(), Qt::Key_M);
  EXPECT_EQ(marks.count(), 3);
}

TEST(RecordingPanel, EscapeInItAndInTheBarCutsTheForceAndSpaceInTheViewToo) {
  Whole w;
  int wishes = 0;
  QObject::connect(&w.window.touch(), &ui::TouchState::forceOffWanted, [&] { ++wishes; });
  const auto wished = [&] { return std::exchange(wishes, 0) > 0; };
  w.panel.setReady(true);
  w.panel.show(running());
  w.action("Recor&ding")->trigger();
  w.window.replayBar().show(ui::ReplayTrack{.begin = 0.0, .end = 10.0});
  QSignalSpy played(&w.window.replayBar(), &ui::ReplayBar::playWanted);
  QTest::qWait(50);
  for (QWidget* focus :
       {static_cast<QWidget*>(w.panel.findChild<QLineEdit*>("markNote")),
        static_cast<QWidget*>(w.panel.findChild<QTableWidget*>("recordings")),
        static_cast<QWidget*>(w.panel.findChild<QPushButton*>("record")),
        static_cast<QWidget*>(&w.window.replayBar().timeline()),
        static_cast<QWidget*>(w.window.replayBar().findChild<QWidget*>("replayPlay")),
        static_cast<QWidget*>(w.window.replayBar().findChild<QWidget*>("replaySpeed"))}) {
    focus->setFocus();
    QTest::keyClick(focus, Qt::Key_Escape);
    EXPECT_TRUE(wished()) << focus->objectName().toStdString();
  }
  EXPECT_TRUE(w.window.replayBar().isVisible());
  w.window.views().volume().setFocus();
  QTest::keyClick(&w.window.views().volume(), Qt::Key_Space);
  EXPECT_TRUE(wished());
  EXPECT_EQ(played.count(), 0);
  // a click on play leaves the focus where it was
  auto* play = w.window.replayBar().findChild<QWidget*>("replayPlay");
  QTest::mouseClick(play, Qt::LeftButton);
  EXPECT_EQ(played.count(), 1);
  EXPECT_EQ(QApplication::focusWidget(), &w.window.views().volume());
  played.clear();
  w.window.replayBar().setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_FALSE(wished());
  EXPECT_EQ(played.count(), 1);
  // nor, with motors, does the question before deleting swallow it
  w.window.touch().setHand("omega.6", ui::Feel::Felt);
  w.panel.show(kPast);
  w.panel.findChild<QTableWidget*>("recordings")->selectRow(0);
  QTimer::singleShot(200, &w.window, [] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    QTest::keyClick(box, Qt::Key_Escape);
  });
  QTest::mouseClick(w.panel.findChild<QPushButton*>("deleteRecording"), Qt::LeftButton);
  EXPECT_TRUE(wished());
}

TEST(RecordingPanel, StandsInItsTabAndNothingIsCutOff) {
  Whole w;
  EXPECT_FALSE(w.panel.isVisible());
  EXPECT_FALSE(w.window.replayBar().isVisible());
  w.panel.setReady(true);
  w.panel.show(running());
  w.panel.show(kPast);
  w.action("Recor&ding")->trigger();
  QTest::qWait(50);
  window::keep(window::pictureOf(w.window), "recording_window");
  EXPECT_EQ(w.window.size(), QSize(1280, 900));
  expectLegible(w.panel);
  for (const char* name : {"record", "mark", "openRecording", "exportRecording", "reportRecording",
                           "deleteRecording"}) {
    auto* button = w.panel.findChild<QPushButton*>(name);
    EXPECT_GE(button->width(), button->minimumSizeHint().width()) << name;
    EXPECT_EQ(button->visibleRegion().boundingRect().size(), button->size()) << name;
  }
}

TEST(RecordingPanel, TheMenuAsksForAFileOfARecording) {
  Whole w;
  const QTemporaryDir folder;
  for (const char* name : {"/one.palpate", "/two.nrrd"}) {
    QFile file(folder.path() + name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  }
  QSignalSpy wanted(&w.window.menus(), &ui::Menus::recordingWanted),
      scans(&w.window.menus(), &ui::Menus::openWanted);
  QTimer::singleShot(300, &w.window, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog));
    EXPECT_EQ(dialog->nameFilters(), QStringList{"Recordings (*.palpate)"});
    dialog->setDirectory(folder.path());
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    name->setFocus();
    name->setText(folder.path() + "/one.palpate");
    QTest::keyClick(name, Qt::Key_Return);
  });
  QTimer::singleShot(120'000, &w.window, [] {
    if (auto* left = QApplication::activeModalWidget()) left->close();
  });
  w.window.findChild<QAction*>("openRecordingFile")->trigger();
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted.at(0).at(0).toString().endsWith("/one.palpate"));
  EXPECT_EQ(scans.count(), 0);
}

}  // namespace
