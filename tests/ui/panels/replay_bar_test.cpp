// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_bar.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <cmath>
#include <limits>

#include "tests/ui/window_support.h"
#include "ui/panels/recording_panel.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

// 2.5 s to 102.5 s: that times are not shares, nor begin at nought, is in every test
ui::ReplayTrack track() {
  ui::ReplayTrack track{.begin = 2.5, .end = 102.5};
  track.marks = {{72.5, "mark", {}, "the <b>rim</b> & hole"},
                 {2.5, "isovalue", 300.0},
                 {22.5, "stiffness", 1500.0},
                 {32.5, "scene", 2.0},
                 {42.5, "force", 4.0},
                 {52.5, "gap", 12.0},
                 {92.5, "something new", 4.0, "words"}};
  for (int i = 0; i < 1'000; ++i) {
    const double t = i * 0.1;
    const auto force = static_cast<float>(std::max(0.0, 2.0 * std::sin(t * 0.3)));
    track.force_least.push_back(0.8F * force);
    track.force_most.push_back(force);
  }
  return track;
}

struct Bar {
  ui::ReplayBar bar;
  ui::ReplayTimeline& line = bar.timeline();

  explicit Bar(int width = 900) {
    window::showAndWait(bar, {width, 120});
    bar.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&bar, 120'000));
    bar.show(track());
    QTest::qWait(30);
  }
  QToolButton* button(const char* name) const { return bar.findChild<QToolButton*>(name); }
  /// Where a time ought to be drawn: 44 pixels from the left to 7 from the right.
  double place(double time) const { return 44.0 + (time - 2.5) / 100.0 * (line.width() - 51.0); }
  QPoint at(double time) const { return {qRound(place(time)), line.height() / 2}; }
};

/// Where the one upright line of the text's colour stands, in the rows where nothing else is drawn.
double lineIn(const QImage& picture) {
  const QColor text = QGuiApplication::palette().color(QPalette::Text);
  const QImage top = picture.copy(3, 0, picture.width() - 6, 2);
  return 3.0 +
         window::centroid(
             top, [&](QColor c) { return std::abs(c.lightness() - text.lightness()) < 60; }, 2)
             .x();
}

bool isMark(QColor c) { return c.blue() > 200 && c.red() < 110 && c.green() < 170; }
bool isSetting(QColor c) { return c.green() > 140 && c.red() < 100 && c.blue() < 130; }
bool isLoss(QColor c) { return c.red() > 200 && c.green() < 100 && c.blue() < 100; }
bool isForce(QColor c) {
  return c.red() > 180 && c.blue() > 110 && c.red() > c.blue() + 25 && c.green() > c.blue() + 8;
}

TEST(ReplayBar, TheLineIsWhereTheTimeSays) {
  Bar b;
  for (const double time : {2.5, 15.0, 52.5, 77.123, 102.5}) {
    b.bar.setTime(time);
    const double expected = b.place(time);
    EXPECT_NEAR(b.line.xOf(time), expected, 1e-9);
    EXPECT_NEAR(lineIn(window::pictureOf(b.line)), expected, 1.0) << time;
  }
  EXPECT_EQ(b.bar.findChild<QLabel*>("replayTime")->text(), "1:42.500 / 1:42.500");
  b.bar.setTime(3.001);
  EXPECT_EQ(b.bar.findChild<QLabel*>("replayTime")->text(), "0:03.001 / 1:42.500");
  // what is outside stays in the picture
  b.bar.setTime(-40.0);
  EXPECT_NEAR(lineIn(window::pictureOf(b.line)), 44.0, 1.0);
  b.bar.setTime(1e9);
  EXPECT_NEAR(lineIn(window::pictureOf(b.line)), b.line.width() - 7.0, 1.0);
  EXPECT_NEAR(b.line.timeAt(b.line.xOf(61.7)), 61.7, 1e-9);
}

TEST(ReplayBar, ATickIsAtItsTimeInTheColourOfItsKind) {
  Bar b;
  b.line.clearFocus();  // its frame has the colour of notes
  b.bar.setTime(102.5);
  const QImage heads = window::pictureOf(b.line).copy(0, 0, b.line.width(), 15);
  EXPECT_NEAR(window::centroid(heads, isMark).x(), b.place(72.5), 1.0);
  EXPECT_NEAR(window::centroid(heads, isLoss).x(), b.place(52.5), 1.0);
  // each of the two settings in a picture of its own
  const auto setting = [&](double time) {
    const int left = qRound(b.place(time)) - 6;
    return left + window::centroid(heads.copy(left, 0, 12, 15), isSetting).x();
  };
  EXPECT_NEAR(setting(22.5), b.place(22.5), 1.0);
  EXPECT_NEAR(setting(2.5), b.place(2.5), 1.0);
  // none where nothing was
  EXPECT_EQ(window::count(heads.copy(qRound(b.place(80.0)), 0, 60, 15),
                          [](QColor c) { return isMark(c) || isLoss(c) || isSetting(c); }),
            0);
}

TEST(ReplayBar, ATickSaysWhatItIs) {
  Bar b;
  const auto words = [&](double time) { return b.line.wordsAt(b.place(time) + 2.0).toStdString(); };
  EXPECT_EQ(words(2.5), "0:02.500  Isovalue 300");
  EXPECT_EQ(words(22.5), "0:22.500  Stiffness 1,500 N/m");
  EXPECT_EQ(words(42.5), "0:42.500  Force: On");
  EXPECT_EQ(words(52.5), "0:52.500  Gap: samples lost 12");
  EXPECT_EQ(words(72.5), "1:12.500  Mark: the <b>rim</b> & hole");
  EXPECT_EQ(words(92.5), "1:32.500  something new 4: words");
  EXPECT_EQ(words(62.5), "");

  // as it was typed, never as markup
  const QPoint place = b.at(72.5);
  QHelpEvent help(QEvent::ToolTip, place, b.line.mapToGlobal(place));
  QApplication::sendEvent(&b.line, &help);
  EXPECT_TRUE(QToolTip::text().contains("&lt;b&gt;rim&lt;/b&gt; &amp; hole"))
      << QToolTip::text().toStdString();
  QHelpEvent nothing(QEvent::ToolTip, b.at(62.5), b.line.mapToGlobal(b.at(62.5)));
  QApplication::sendEvent(&b.line, &nothing);
  EXPECT_TRUE(QToolTip::text().contains("samples lost")) << QToolTip::text().toStdString();
  QToolTip::hideText();

  // many at one place, and a note as long as a book
  ui::ReplayTrack crowded{.begin = 0.0, .end = 10.0};
  for (int i = 0; i < 5'000; ++i) crowded.marks.push_back({5.0, "mark", {}, QString(9'000, 'x')});
  b.bar.show(crowded);
  const QString all = b.line.wordsAt(b.line.xOf(5.0));
  EXPECT_EQ(all.count('\n'), 8);
  EXPECT_TRUE(all.endsWith("4992 more")) << all.right(40).toStdString();
  EXPECT_LT(all.size(), 2'000);
}

TEST(ReplayBar, LateTicksAreDimAndShortAndHideNothing) {
  Bar b;
  ui::ReplayTrack busy{.begin = 0.0, .end = 100.0};
  busy.marks = {{50.0, "gap", 3.0}, {50.0, "late", 1.0}};
  for (int i = 0; i < 300; ++i) busy.marks.push_back({20.0 + 0.1 * i, i % 2 ? "late" : "missed"});
  b.bar.show(busy);
  b.line.clearFocus();
  b.bar.setTime(100.0);
  const QImage picture = window::pictureOf(b.line);
  window::keep(picture, "replay_late");
  const auto isDim = [](QColor c) { return c.rgb() == ui::style::colours().dim.rgb(); };
  const int from = qRound(b.line.xOf(20.0)), to = qRound(b.line.xOf(49.0));
  // at the foot of the curve, where the axis of time begins
  EXPECT_GT(window::count(picture.copy(from, picture.height() - 21, to - from, 4), isDim), 100);
  // and nothing of them above, nor anything red: that is for what was lost
  const QImage above = picture.copy(from, 0, to - from, picture.height() - 25);
  EXPECT_EQ(window::count(above, isDim), 0);
  EXPECT_EQ(window::count(picture.copy(from, 0, to - from, picture.height()), isLoss), 0);
  EXPECT_GT(window::count(picture.copy(to, 0, 40, 15), isLoss), 5);
  EXPECT_TRUE(b.line.wordsAt(b.line.xOf(30.0)).contains("late"));
  // one lies below the line of what was lost at the same time
  const int lost = int(b.line.xOf(50.0));
  EXPECT_EQ(window::count(picture.copy(lost, picture.height() - 20, 1, 3), isDim), 0);
  // and all lie below the force, however small it is
  const auto forceSeen = [&](const ui::ReplayTrack& track) {
    b.bar.show(track);
    b.bar.setTime(100.0);
    return window::count(window::pictureOf(b.line).copy(from, 0, to - from, picture.height()),
                         isForce);
  };
  ui::ReplayTrack touched{.begin = 0.0, .end = 100.0};
  touched.force_least.assign(1'000, 0.0F);
  touched.force_most.assign(1'000, 0.3F);
  touched.force_most[900] = 4.0F;
  const int without = forceSeen(touched);
  EXPECT_GT(without, to - from - 10);
  touched.marks = busy.marks;
  EXPECT_EQ(forceSeen(touched), without);
}

TEST(ReplayBar, TheAxesHaveNumbers) {
  Bar b;
  b.bar.setTime(102.5);
  // words have soft edges
  const auto isDim = [](QColor c) {
    const QColor dim = ui::style::colours().dim;
    return std::abs(c.red() - dim.red()) < 50 && std::abs(c.blue() - dim.blue()) < 50;
  };
  const QImage picture = window::pictureOf(b.line);
  window::keep(picture, "replay_axes");
  const int top = 15, foot = picture.height() - 16;
  // nought at the foot and a round number of newtons at the top, left of the curve
  EXPECT_GT(window::count(picture.copy(0, top - 8, 42, 16), isDim), 5);
  EXPECT_GT(window::count(picture.copy(0, foot - 8, 42, 16), isDim), 2);
  EXPECT_EQ(window::count(picture.copy(0, top + 10, 42, foot - top - 20), isDim), 0);
  // times that a clock has stand below it: 2.5 s to 102.5 s, each 10 s at this width
  const QImage times = picture.copy(0, foot + 1, picture.width(), 2);
  EXPECT_GT(window::count(times.copy(qRound(b.place(10.0)) - 2, 0, 5, 2), isDim), 0);
  EXPECT_EQ(window::count(times.copy(qRound(b.place(10.0)) + 4, 0, 40, 2), isDim), 0);
  EXPECT_GT(window::count(times.copy(qRound(b.place(100.0)) - 2, 0, 5, 2), isDim), 0);
  const QImage words = picture.copy(0, foot + 5, picture.width(), 11);
  for (const double time : {10.0, 50.0})
    EXPECT_GT(window::count(words.copy(qRound(b.place(time)) - 15, 0, 30, 11), isDim), 10) << time;
  // a recording of a moment, and one of a day
  for (const double length : {0.02, 86'400.0}) {
    b.bar.show(ui::ReplayTrack{.begin = 0.0, .end = length});
    const QImage axis = window::pictureOf(b.line).copy(0, foot, picture.width(), 16);
    EXPECT_GT(window::count(axis, isDim), 5) << length;
    EXPECT_LT(window::count(axis, isDim), 2'500) << length;
  }
}

TEST(ReplayBar, MarksAreListedAndEachIsGoneTo) {
  Bar b;
  auto* marks = b.bar.findChild<QComboBox*>("replayMarks");
  ASSERT_EQ(marks->count(), 1);
  EXPECT_EQ(marks->currentIndex(), -1);
  EXPECT_EQ(marks->placeholderText(), "Marks (1)");
  EXPECT_EQ(marks->itemText(0), "1:12.5  the <b>rim</b> & hole");
  ui::ReplayTrack three{.begin = 2.0, .end = 100.0};
  three.marks = {{70.0, "mark", {}, QString(900, 'x')},
                 {5.0, "mark"},
                 {6.0, "isovalue", 300.0},
                 {60.0, "mark", {}, "two\nlines"}};
  b.bar.show(three);
  ASSERT_EQ(marks->count(), 3);
  EXPECT_EQ(marks->itemText(0), "0:05.0");
  EXPECT_EQ(marks->itemText(1), "1:00.0  two lines");
  EXPECT_LT(marks->itemText(2).size(), 80);
  std::vector<double> wished;
  QObject::connect(&b.bar, &ui::ReplayBar::timeWanted, [&](double t) { wished.push_back(t); });
  marks->setFocus();
  QTest::keyClick(marks, Qt::Key_Down);
  QTest::keyClick(marks, Qt::Key_End);
  EXPECT_EQ(wished, (std::vector<double>{5.0, 70.0}));
  EXPECT_EQ(marks->currentIndex(), -1);
  b.bar.show(ui::ReplayTrack{.begin = 0.0, .end = 1.0});
  EXPECT_FALSE(marks->isEnabled());
  EXPECT_EQ(marks->placeholderText(), "No marks");
}

TEST(ReplayBar, ClickAndDragWishTimes) {
  Bar b;
  std::vector<double> wished;
  QObject::connect(&b.bar, &ui::ReplayBar::timeWanted, [&](double t) { wished.push_back(t); });
  const double pixel = 100.0 / (b.line.width() - 51.0);  // s
  QTest::mousePress(&b.line, Qt::LeftButton, {}, b.at(30.0));
  ASSERT_EQ(wished.size(), 1U);
  EXPECT_NEAR(wished[0], 30.0, pixel);
  for (const double time : {31.0, 45.0, 60.0, 20.0}) {
    QTest::mouseMove(&b.line, b.at(time));
    ASSERT_FALSE(wished.empty());
    EXPECT_NEAR(wished.back(), time, pixel);
    // the line is at the mouse, whatever time is told meanwhile
    b.bar.setTime(90.0);
    EXPECT_NEAR(lineIn(window::pictureOf(b.line)), b.place(time), 1.5);
  }
  // beyond the widget the ends are wished, and no more
  QTest::mouseMove(&b.line, {-200, 10});
  EXPECT_EQ(wished.back(), 2.5);
  QTest::mouseMove(&b.line, {b.line.width() + 50, 10});
  EXPECT_EQ(wished.back(), 102.5);
  QTest::mouseRelease(&b.line, Qt::LeftButton, {}, b.at(80.0));
  EXPECT_NEAR(lineIn(window::pictureOf(b.line)), b.place(90.0), 1.5);
  const std::size_t count = wished.size();
  QTest::mouseMove(&b.line, b.at(50.0));
  QTest::mouseClick(&b.line, Qt::RightButton, {}, b.at(40.0));
  EXPECT_EQ(wished.size(), count);
}

TEST(ReplayBar, KeysAndButtonsPlayStepAndClose) {
  Bar b;
  QSignalSpy played(&b.bar, &ui::ReplayBar::playWanted),
      stepped(&b.bar, &ui::ReplayBar::stepWanted), times(&b.bar, &ui::ReplayBar::timeWanted),
      closed(&b.bar, &ui::ReplayBar::closeWanted), speeds(&b.bar, &ui::ReplayBar::speedChosen);
  b.bar.setFocus();
  ASSERT_TRUE(b.line.hasFocus());
  QTest::keyClick(&b.line, Qt::Key_Space);
  QTest::keyClick(&b.line, Qt::Key_Right);
  QTest::keyClick(&b.line, Qt::Key_Left);
  ASSERT_EQ(played.count(), 1);
  EXPECT_TRUE(played.at(0).at(0).toBool());
  ASSERT_EQ(stepped.count(), 2);
  EXPECT_EQ(stepped.at(0).at(0).toInt(), 1);
  EXPECT_EQ(stepped.at(1).at(0).toInt(), -1);
  QTest::keyClick(&b.line, Qt::Key_End);
  QTest::keyClick(&b.line, Qt::Key_Home);
  ASSERT_EQ(times.count(), 2);
  EXPECT_EQ(times.at(0).at(0).toDouble(), 102.5);
  EXPECT_EQ(times.at(1).at(0).toDouble(), 2.5);

  EXPECT_EQ(b.button("replayPlay")->text(), "Play");
  b.bar.setPlaying(true);
  EXPECT_EQ(b.button("replayPlay")->text(), "Pause");
  QTest::mouseClick(b.button("replayPlay"), Qt::LeftButton);
  EXPECT_FALSE(played.last().at(0).toBool());
  QTest::mouseClick(b.button("replayBack"), Qt::LeftButton);
  EXPECT_EQ(stepped.last().at(0).toInt(), -1);
  QTest::mouseClick(b.button("replayForward"), Qt::LeftButton);
  EXPECT_EQ(stepped.last().at(0).toInt(), 1);
  // on a button the arrows are ticks too
  b.button("replayPlay")->setFocus();
  QTest::keyClick(b.button("replayPlay"), Qt::Key_Left);
  EXPECT_EQ(stepped.count(), 5);
  EXPECT_TRUE(b.button("replayPlay")->hasFocus());
  QTest::mouseClick(b.button("replayClose"), Qt::LeftButton);
  EXPECT_EQ(closed.count(), 1);

  auto* speed = b.bar.findChild<QComboBox*>("replaySpeed");
  EXPECT_EQ(b.bar.speed(), 1.0);
  QStringList offered;
  for (int i = 0; i < speed->count(); ++i) offered << speed->itemData(i).toString();
  EXPECT_EQ(offered.join(' '), "0.1 0.25 0.5 1 2 5 10");
  speed->setFocus();
  QTest::keyClick(speed, Qt::Key_Down);
  ASSERT_EQ(speeds.count(), 1);
  EXPECT_EQ(speeds.at(0).at(0).toDouble(), 2.0);
}

TEST(ReplayBar, TheShortestPeakOfForceIsSeen) {
  Bar b;
  ui::ReplayTrack track{.begin = 0.0, .end = 100.0};
  track.force_least.assign(100'000, 0.0F);
  track.force_most.assign(100'000, 0.1F);
  track.force_most[25'000] = 4.0F;
  track.force_most[60'000] = std::numeric_limits<float>::quiet_NaN();
  track.force_least[60'001] = -std::numeric_limits<float>::infinity();
  b.bar.show(track);
  b.bar.setTime(100.0);
  const QImage picture = window::pictureOf(b.line);
  window::keep(picture, "replay_peak");
  // the upper half holds the peak and nothing else of that colour
  const QImage upper = picture.copy(0, 16, picture.width(), picture.height() / 2 - 16);
  EXPECT_NEAR(window::centroid(upper, isForce).x(), b.line.xOf(25.0), 1.5);
  // without any force, or without anything at all
  track.force_most.assign(100'000, 0.0F);
  b.bar.show(track);
  EXPECT_EQ(window::count(window::pictureOf(b.line), isForce), 0);
  b.bar.show(ui::ReplayTrack{.begin = 5.0, .end = 5.0, .marks = {{5.0, "mark"}}});
  b.bar.setTime(5.0);
  EXPECT_NEAR(lineIn(window::pictureOf(b.line)), 44.0, 1.0);
  EXPECT_EQ(b.line.timeAt(400.0), 5.0);
}

TEST(ReplayBar, WarnsAndStandsBelowTheViews) {
  ui::MainWindow window;
  window::showAndWait(window, {1280, 900});
  ui::ReplayBar& bar = window.replayBar();
  EXPECT_FALSE(bar.isVisible());
  bar.show(track());
  bar.showWarning("The volume shown is not the one that was recorded.");
  bar.setTime(40.123);
  bar.setPlaying(true);
  QTest::qWait(50);
  window::keep(window::pictureOf(window), "replay_window");
  EXPECT_EQ(window.size(), QSize(1280, 900));
  auto* warning = bar.findChild<QLabel*>("replayWarning");
  EXPECT_TRUE(warning->isVisible());
  EXPECT_GE(
      bar.mapTo(&window, QPoint{}).y(),
      window.views().volume().mapTo(&window, QPoint{0, window.views().volume().height()}).y());
  for (const QWidget* part : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    EXPECT_GE(part->width(), part->minimumSizeHint().width());
    EXPECT_TRUE(bar.rect().contains(part->geometry())) << part->objectName().toStdString();
  }
  // another recording is not warned of
  bar.show(track());
  EXPECT_FALSE(warning->isVisible());
  EXPECT_EQ(bar.findChild<QToolButton*>("replayPlay")->text(), "Play");
  bar.hide();
  QTest::qWait(30);
  EXPECT_GT(window.views().volume().height(), 400);
}

TEST(ReplayBar, IsDrawnInTheColoursOfADarkWindowToo) {
  const QPalette before = QApplication::palette();
  QPalette dark;
  dark.setColor(QPalette::Window, QColor(45, 45, 48));
  dark.setColor(QPalette::WindowText, Qt::white);
  dark.setColor(QPalette::Base, QColor(30, 30, 32));
  dark.setColor(QPalette::Text, Qt::white);
  dark.setColor(QPalette::Button, QColor(60, 60, 64));
  dark.setColor(QPalette::ButtonText, Qt::white);
  dark.setColor(QPalette::Mid, QColor(90, 90, 94));
  QApplication::setPalette(dark);
  {
    Bar b;
    b.line.clearFocus();
    b.bar.setTime(40.0);
    window::keep(window::pictureOf(b.bar), "replay_bar_dark");
    const QImage picture = window::pictureOf(b.line);
    EXPECT_GT(window::count(picture, [](QColor c) { return c.lightness() < 60; }),
              picture.width() * picture.height() / 2);
    EXPECT_NEAR(lineIn(picture), b.line.xOf(40.0), 1.0);
    EXPECT_NEAR(window::centroid(picture.copy(0, 3, picture.width(), 12), isMark).x(),
                b.line.xOf(72.5), 1.0);
    ui::RecordingPanel panel;
    panel.setReady(true);
    panel.show({.state = ui::RecordingStatus::State::Recording, .elapsed = 3.0, .gaps = 2});
    window::showAndWait(panel, {300, 460});
    window::keep(window::pictureOf(panel), "recording_panel_dark");
  }
  QApplication::setPalette(before);
}

}  // namespace
