// SPDX-License-Identifier: BSD-3-Clause
// What is painted, and what it costs, while nothing moves and while the hand does. Any paint makes
// Qt compose the whole window anew, 3-D view and all.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QMap>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <ctime>

#include "app/application.h"
#include "app/window/sessions/replay.h"
#include "haptics/session.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/state_chip.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/side_panel.h"
#include "ui/window/views.h"

namespace {

using window::recordedSphere;
using window::waitFor;

/// Counts paints by the widget's name, or its class where it has none, and the rounds in which a
/// window was composed anew, however many widgets were painted in it.
class Paints : public QObject {
 public:
  Paints() { qApp->installEventFilter(this); }
  bool eventFilter(QObject* target, QEvent* event) override {
    if (event->type() == QEvent::UpdateRequest) round_counted_ = false;
    if (event->type() == QEvent::Paint) {
      rounds_ += !round_counted_;
      round_counted_ = true;
      const QString name = target->objectName();
      ++counts_[name.isEmpty() ? QString(target->metaObject()->className()) : name];
      if (const auto* label = qobject_cast<QLabel*>(target); label && name == "statusLine")
        countNews(status_, label->text());
      if (const auto* chip = qobject_cast<ui::StateChip*>(target); chip && name == "forceStateBar")
        countNews(chip_, chip->text() + chip->detail());
    }
    return false;
  }
  int all() const {
    int sum = 0;
    for (const int count : counts_) sum += count;
    return sum;
  }
  int rounds() const { return rounds_; }
  int news() const { return news_; }
  int of(const char* name) const { return counts_.value(name); }
  std::string words() const {
    QStringList words;
    for (auto it = counts_.begin(); it != counts_.end(); ++it)
      words << QString("%1 %2").arg(it.key()).arg(it.value());
    return words.join(", ").toStdString();
  }

 private:
  void countNews(QString& had, const QString& words) {
    news_ += words != had;
    had = words;
  }

  QMap<QString, int> counts_;
  QString status_, chip_;
  int news_ = 0, rounds_ = 0;
  bool round_counted_ = false;
};

struct Cost {
  double seconds = 0.0;
  int paints = 0, rounds = 0;
  double cpu = 0.0;  ///< of a core, all threads
  int status = 0, news = 0,
      view = 0;  ///< news: other words in the status line or the chip of the force
  std::string words;
};

double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Over so many seconds, and until the 3-D view was painted so often.
Cost costOf(double least_seconds, const char* what, int least_views = 0) {
  const Paints paints;
  const double before = cpuSeconds();
  QElapsedTimer clock;
  clock.start();
  waitFor([&] {
    return 1e-3 * double(clock.elapsed()) >= least_seconds && paints.of("view") >= least_views;
  });
  const double seconds = 1e-3 * double(clock.elapsed());
  const Cost cost{.seconds = seconds,
                  .paints = paints.all(),
                  .rounds = paints.rounds(),
                  .cpu = (cpuSeconds() - before) / seconds,
                  .status = paints.of("statusLine"),
                  .news = paints.news(),
                  .view = paints.of("view"),
                  .words = paints.words()};
  std::printf("%s: %.1f %% of a core, %.1f paints a second in %d rounds (%s)\n", what,
              100.0 * cost.cpu, cost.paints / seconds, cost.rounds, cost.words.c_str());
  return cost;
}

/// Waits until nothing was painted for a while.
void awaitRest() {
  for (int n = 0; n < 100; ++n) {
    const Paints paints;
    QTest::qWait(400);
    if (paints.all() == 0) return;
  }
}

// a busy machine has news of its servo loop: the chip and the card are painted with it
constexpr int kHandful = 2, kOfNews = 2;  // rounds
constexpr double kQuiet = 0.15;           // of a core; it is 2 to 3 %, and was 90

TEST(Idle, NothingIsPaintedWhereNothingMoves) {
  const QTemporaryDir recordings;
  app::Application application(recordedSphere(recordings, "mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::VolumeView& view = application.window().views().volume();
  view.setMouseMode(ui::MouseMode::Hand);
  // into the surface, and there the hand rests
  for (int i = 0; i < 20 && application.snapshot().felt_W.force.norm() < 1.0; ++i) {
    QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 120}, {}, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
    window::afterTicks(application, 200);
  }
  ASSERT_GT(application.snapshot().felt_W.force.norm(), 0.3);
  QTest::qWait(int(1e3 * ui::ForcePlot::kSeconds));  // until the plot shows rest alone
  awaitRest();
  const Cost cost = costOf(6.0, "at rest");
  EXPECT_LE(cost.rounds, kHandful + kOfNews * cost.news) << cost.words;
  EXPECT_LT(cost.cpu, kQuiet) << cost.words;
  for (const char* name : {"recordTab", "deviceTab", "scanTab", "touchTab"}) {
    application.window().findChild<QAbstractButton*>(name)->click();
    awaitRest();
    const Cost raised = costOf(2.0, name);
    EXPECT_LE(raised.rounds, kHandful + kOfNews * raised.news) << name << ": " << raised.words;
  }
}

TEST(Idle, OfAMovingHandOnlyWhatChangedIsPainted) {
  const QTemporaryDir recordings;
  app::Application application(recordedSphere(recordings, "slide"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
  QTest::qWait(1'000);
  const auto& plot = *application.window().findChild<ui::ForcePlot*>("forcePlot");
  int drawn = plot.drawings();
  const Cost moving = costOf(4.0, "sliding", 2);
  EXPECT_GT(moving.view, 1);
  EXPECT_GT(plot.drawings(), drawn);
  EXPECT_LE(plot.drawings(), drawn + moving.seconds * 20 + 2) << moving.words;
  EXPECT_LE(moving.status, moving.seconds * 10 + 2) << moving.words;

  ui::RecordingPanel& panel = *application.window().findChild<ui::RecordingPanel*>();
  auto* record = panel.findChild<QPushButton*>("record");
  application.window().panels().reveal(&panel);
  QTest::mouseClick(record, Qt::LeftButton);
  QTest::qWait(1'000);
  drawn = plot.drawings();
  const Cost recording = costOf(2.0, "recording");
  EXPECT_LE(plot.drawings(), drawn + recording.seconds * 20 + 2) << recording.words;
  QTest::mouseClick(record, Qt::LeftButton);
  auto* list = panel.findChild<QTableWidget*>("recordings");
  ASSERT_TRUE(waitFor([&] {
    return list->rowCount() == 1 &&
           std::filesystem::exists(recordings.filePath("session-0001.palpate").toStdString());
  }));
  QTest::qWait(500);
  list->selectRow(0);
  QTest::mouseClick(panel.findChild<QPushButton*>("openRecording"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application.replay() != nullptr; }));
  awaitRest();
  const Cost paused = costOf(2.0, "replay, paused");
  EXPECT_LE(paused.rounds, 2) << paused.words;
}

}  // namespace
