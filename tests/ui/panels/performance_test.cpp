// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/performance_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QObject>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <chrono>

#include "app/application.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/fitting_scroll.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"

namespace {

using window::sphereInHand;
using window::waitFor;

ui::Performance wrench() {
  ui::Performance p;
  p.conditions = "Touched with wrench.";
  p.present = {2'126, 31e-6, 82e-6, 0.214e-3, true};
  p.ticks = 4'000;
  p.budget = 0.2e-3;
  p.tried = {{1'000, 25e-6, 70e-6, 0.15e-3, true},
             {8'400, 40e-6, 0.13e-3, 0.22e-3, true},
             {60'000, 0.12e-3, 0.205e-3, 0.25e-3, true},
             {75'000, 0.2e-3, 0.23e-3, 0.4e-3, false}};
  p.most = 60'000;
  p.too_many = 75'000;
  p.dense = p.suggested = 8'400;
  p.suggested_spacing = 0.5e-3;
  p.voxel = 0.5e-3;
  p.live_ticks = 10'012;
  p.live_late = 3;
  return p;
}

TEST(Performance, TheWordsAreTheFigures) {
  ui::Performance p = wrench();
  EXPECT_EQ(ui::headlineOf(p).toStdString(),
            "2,126 points: longest tick 0.21 ms, no misses; up to 60,000 points on this machine.");
  const QString details = ui::detailsOf(p);
  for (const char* part : {"0.031 ms", "0.082 ms", "None of 4,000", "0.20 ms", "3 of 10,012",
                           "missed 0", "Touched with wrench."})
    EXPECT_TRUE(details.contains(part)) << part << " is not in: " << details.toStdString();
  EXPECT_TRUE(ui::suggestionOf(p).contains("8,400 points")) << ui::suggestionOf(p).toStdString();

  // another machine, other words
  p.missed = 2;
  p.cut = 1'200;
  p.lag = 0.0312e-3;
  p.present.carried = false;
  p.most = p.suggested = 1'000;
  p.suggested_spacing = 1.4e-3;
  EXPECT_TRUE(ui::headlineOf(p).contains("2 misses; up to 1,000 points"));
  EXPECT_TRUE(ui::detailsOf(p).contains("1,200 of 4,000"));
  EXPECT_TRUE(ui::detailsOf(p).contains("0.031 mm farther"));
  EXPECT_TRUE(ui::detailsOf(p).contains("more than this machine carries"));
  const QString suggestion = ui::suggestionOf(p);
  for (const char* part : {"1,000 points", "1.4 mm", "0.5 mm", "8,400"})
    EXPECT_TRUE(suggestion.contains(part)) << suggestion.toStdString();
  p.too_many.reset();
  EXPECT_TRUE(ui::headlineOf(p).contains("1,000 points and more"));
  p.most = 0;
  EXPECT_TRUE(ui::headlineOf(p).contains("not even 1,000"));
  EXPECT_TRUE(ui::suggestionOf(p).isEmpty());
  p.tried.clear();
  EXPECT_TRUE(ui::headlineOf(p).endsWith("2 misses."));
  // a tool that is dense enough stays as it is
  p = wrench();
  p.dense = p.suggested = 2'000;
  EXPECT_TRUE(ui::suggestionOf(p).contains("as it is"));
}

TEST(Performance, ThePanelMeasuresCancelsAndCanBeReadInFull) {
  auto& panel = *new ui::PerformancePanel;
  ui::FittingScroll room(&panel);  // as in the window
  window::showAndWait(room, {300, 560});
  auto* button = panel.findChild<QPushButton*>("measure");
  auto* progress = panel.findChild<QProgressBar*>("measureProgress");
  auto* headline = panel.findChild<QLabel*>("performanceHeadline");
  auto* plot = panel.findChild<ui::LoadPlot*>("loadPlot");
  QSignalSpy wanted(&panel, &ui::PerformancePanel::measureWanted),
      cancelled(&panel, &ui::PerformancePanel::cancelWanted);
  // nothing to measure with
  EXPECT_FALSE(button->isEnabled());
  EXPECT_FALSE(progress->isVisible());
  EXPECT_FALSE(plot->isVisible());
  panel.setReady(true);
  // by the keyboard as by the mouse
  panel.setFocus();
  EXPECT_EQ(panel.focusProxy(), button);
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_EQ(wanted.count(), 1);
  panel.showMeasuring();
  panel.showProgress(0.4);
  EXPECT_TRUE(progress->isVisible());
  EXPECT_EQ(progress->value(), 400);
  EXPECT_EQ(button->text(), "Cancel");
  // it can be cancelled also while another volume is being loaded
  panel.setReady(false);
  EXPECT_TRUE(button->isEnabled());
  panel.setReady(true);
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(wanted.count(), 1);
  EXPECT_EQ(cancelled.count(), 1);
  panel.showNothing("The measurement was cancelled.");
  EXPECT_EQ(panel.findChild<QLabel*>("performanceDetails")->text(),
            "The measurement was cancelled.");
  EXPECT_FALSE(progress->isVisible());
  EXPECT_NE(button->text(), "Cancel");

  const QImage empty = window::pictureOf(panel);
  panel.show(wrench());
  panel.showLeftOut({{"Rotation", "the tool is a sphere"}, {"Torque <b>", "a device without"}});
  QTest::qWait(50);
  const QImage light = window::pictureOf(panel);
  window::keep(light, "performance_panel");
  EXPECT_GT(window::differing(empty, light), 0.05);
  EXPECT_TRUE(plot->isVisible());
  for (const char* part : {"2,126 points", "75,000 points", "budget 0.20 ms"})
    EXPECT_TRUE(plot->accessibleDescription().contains(part));
  // every word has room: labels are as tall as their text at their width, and inside the scrolled
  QScrollArea* scroll = &room;
  for (const char* name :
       {"performanceHeadline", "performanceDetails", "performanceSuggestion", "leftOut"}) {
    auto* label = panel.findChild<QLabel*>(name);
    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << name;
    EXPECT_LE(label->mapTo(&panel, QPoint{label->width(), 0}).x(), panel.width()) << name;
    scroll->ensureWidgetVisible(label);
    EXPECT_FALSE(label->visibleRegion().isEmpty()) << name;
  }
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0);
  EXPECT_TRUE(panel.findChild<QLabel*>("leftOut")->text().contains("the tool is a sphere"));
  EXPECT_TRUE(headline->text().contains("2,126"));
  window::keep(window::pictureOf(panel), "performance_panel_end");

  // with nothing left out, it is not mentioned
  panel.showLeftOut({});
  EXPECT_FALSE(panel.findChild<QLabel*>("leftOut")->isVisible());
}

TEST(Performance, ThePlotIsDrawnInTheColoursOfADarkWindowToo) {
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
    ui::PerformancePanel panel;
    panel.setReady(true);
    panel.show(wrench());
    window::showAndWait(panel, {300, 560});
    const QImage image = window::pictureOf(panel);
    window::keep(image, "performance_panel_dark");
    const QImage plot = window::pictureOf(*panel.findChild<ui::LoadPlot*>("loadPlot"));
    // mostly ground, and writing on it
    EXPECT_GT(window::count(plot, [](QColor c) { return c.lightness() < 60; }),
              plot.width() * plot.height() / 2);
    EXPECT_GT(window::count(plot, [](QColor c) { return c.lightness() > 180; }), 200);
    // the present tool, the others
    EXPECT_GT(window::count(plot, [](QColor c) { return c.red() > 180 && c.blue() < 90; }), 20);
    EXPECT_GT(window::count(plot, [](QColor c) { return c.blue() > 180 && c.red() < 120; }), 50);
  }
  QApplication::setPalette(before);
}

/// The application with the sphere in hand, and the panel's parts.
struct Running {
  app::Application application;
  ui::PerformancePanel& panel{*application.window().findChild<ui::PerformancePanel*>()};
  QPushButton* button = panel.findChild<QPushButton*>("measure");
  QLabel* headline = panel.findChild<QLabel*>("performanceHeadline");
  QLabel* details = panel.findChild<QLabel*>("performanceDetails");
  QProgressBar* progress = panel.findChild<QProgressBar*>("measureProgress");

  explicit Running(const char* hand = "tap") : application(sphereInHand(hand)) {
    EXPECT_FALSE(button->isEnabled());
    application.start();
    EXPECT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
    for (QAction* action : application.window().findChildren<QAction*>())
      if (action->text() == "Performance") action->trigger();
    QTest::qWait(50);
  }
  void click() { QTest::mouseClick(button, Qt::LeftButton); }
  bool isUnderWay() {
    return waitFor([&] { return progress->value() > 0; }) && panel.isMeasuring();
  }
};

TEST(Performance, OneClickMeasuresThisMachineAndSaysSo) {
  Running running;
  ASSERT_TRUE(running.button->isVisible());
  ASSERT_TRUE(running.button->isEnabled());
  running.click();
  ASSERT_TRUE(running.isUnderWay());
  window::keep(window::pictureOf(running.application.window()), "performance_measuring");
  // the touch goes on meanwhile
  const auto tick = running.application.snapshot().tick;
  ASSERT_TRUE(waitFor([&] { return !running.panel.isMeasuring(); }));
  EXPECT_GT(running.application.snapshot().tick, tick);
  const QString words = running.headline->text();
  EXPECT_TRUE(words.startsWith("403 points: longest tick ")) << words.toStdString();
  EXPECT_TRUE(words.contains("on this machine")) << words.toStdString();
  EXPECT_TRUE(running.details->text().contains("the live loop began"))
      << running.details->text().toStdString();
  EXPECT_TRUE(running.details->text().contains("probe"));
  EXPECT_TRUE(running.panel.findChild<ui::LoadPlot*>("loadPlot")->isVisible());
  // and what this scene leaves out, with the reason
  EXPECT_TRUE(running.panel.findChild<QLabel*>("leftOut")->text().contains(
      "what was proven free stays so until the tool has moved that far"));
  EXPECT_TRUE(running.button->isEnabled());
  window::keep(window::pictureOf(running.application.window()), "performance_measured");
  std::printf(
      "%s\n%s\n%s\n", words.toUtf8().constData(),
      running.panel.findChild<QLabel*>("performanceSuggestion")->text().toUtf8().constData(),
      running.details->text().toUtf8().constData());
  // another tool: what was measured does not hold any more
  emit window::panelOf<ui::DevicePanel>(running.application.window()).toolChosen("wrench");
  EXPECT_TRUE(waitFor([&] { return !running.headline->isVisible(); }));
}

/// How often a widget was enabled or disabled.
struct Changes : QObject {
  int count = 0;
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::EnabledChange;
    return false;
  }
};

TEST(Performance, ItIsCancelledByTheButtonAnotherHandAndAnotherVolume) {
  Running running("mouse");
  running.click();
  ASSERT_TRUE(running.isUnderWay());
  running.click();
  EXPECT_FALSE(running.panel.isMeasuring());
  EXPECT_TRUE(running.details->text().contains("cancelled"));
  EXPECT_FALSE(running.headline->isVisible());
  // and is ready for the next, which the other does not disturb
  running.click();
  ASSERT_TRUE(running.isUnderWay());
  emit window::panelOf<ui::DevicePanel>(running.application.window()).handChosen("slide");
  EXPECT_FALSE(running.panel.isMeasuring());
  EXPECT_TRUE(running.details->text().contains("another hand"));

  running.click();
  ASSERT_TRUE(running.isUnderWay());
  const auto scene = running.application.snapshot().scene;
  emit running.application.window().menus().phantomWanted("torus");
  EXPECT_FALSE(running.panel.isMeasuring());
  EXPECT_FALSE(running.button->isEnabled());
  ASSERT_TRUE(waitFor([&] { return running.application.snapshot().scene > scene; }));
  EXPECT_TRUE(running.button->isEnabled());
  QTest::qWait(500);
  EXPECT_FALSE(running.headline->isVisible());
  // what cannot be loaded leaves the volume, and the button
  Changes changes;
  running.button->installEventFilter(&changes);
  emit running.application.window().menus().openWanted("/nowhere/at/all.nrrd");
  EXPECT_TRUE(waitFor([&] { return changes.count >= 2; }));
  EXPECT_TRUE(running.button->isEnabled());
}

TEST(Performance, ClosingTheWindowEndsItAndNothingHangs) {
  const auto begun = std::chrono::steady_clock::now();
  {
    Running running;
    running.click();
    ASSERT_TRUE(running.isUnderWay());
    running.application.window().close();
    EXPECT_FALSE(running.panel.isMeasuring());
    QTest::qWait(100);
    running.click();  // and again, to be ended by the destructor
    EXPECT_TRUE(running.panel.isMeasuring());
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  std::printf("closed after %.1f s\n", took.count());
}

}  // namespace
