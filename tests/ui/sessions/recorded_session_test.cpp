// SPDX-License-Identifier: BSD-3-Clause
// A session is recorded in the window, and gone through again.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCryptographicHash>
#include <QDateTime>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <tuple>

#include "app/application.h"
#include "app/recording/database.h"
#include "app/recording/recorder.h"
#include "app/recording/replay.h"
#include "app/view_file/view_file.h"
#include "app/window/program/recent_places.h"
#include "app/window/scan/loader.h"
#include "app/window/sessions/export_controller.h"
#include "app/window/sessions/force_curve.h"
#include "app/window/sessions/recordings.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/session_recording.h"
#include "app/window/views/marks_controller.h"
#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/session.h"
#include "tests/support/sentence.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/dialogs/export_question.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/volume_view.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/views.h"

namespace {

using window::recordedSphere;
using window::waitFor;

namespace fs = std::filesystem;

template <class W>
W* child(QWidget& parent, const char* name) {
  W* found = parent.findChild<W*>(name);
  EXPECT_NE(found, nullptr) << name;
  return found;
}

std::vector<fs::path> filesIn(const QTemporaryDir& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder.path().toStdString()))
    files.push_back(entry.path());
  return files;
}

/// Waits until the file that is recorded has more than so many steps.
bool isWritten(app::Application& application, qint64 steps) {
  const QObject listener;
  qint64 written = 0;
  QObject::connect(&application.recording(), &app::SessionRecording::statusChanged, &listener,
                   [&](const ui::RecordingStatus& status) { written = status.samples; });
  return waitFor([&] { return written > steps; });
}

/// Touches, records until at least so many steps are in the file, with a mark, and stops.
void recordSome(app::Application& application, const QTemporaryDir& folder, qint64 steps) {
  ui::RecordingPanel& panel = *application.window().findChild<ui::RecordingPanel*>();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
  QTest::mouseClick(child<QPushButton>(panel, "record"), Qt::LeftButton);
  ASSERT_TRUE(application.recording().isRecording());
  ASSERT_TRUE(waitFor(
      [&] { return !application.recording().isRecording() || filesIn(folder).size() >= 2; }));
  qint64 written = 0;
  QObject::connect(&application.recording(), &app::SessionRecording::statusChanged, &panel,
                   [&](const ui::RecordingStatus& status) {
                     written = std::max(written, status.samples);
                     EXPECT_EQ(status.gaps, 0);
                   });
  ASSERT_TRUE(waitFor([&] { return written > steps / 2; }));
  panel.findChild<QLineEdit*>("markNote")->setText("a rough place");
  panel.markAction()->trigger();
  ASSERT_TRUE(waitFor([&] { return written > steps; }));
  window::keep(window::pictureOf(application.window()), "recording");
  QTest::mouseClick(child<QPushButton>(panel, "record"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] {
    const auto files = filesIn(folder);
    return files.size() == 1 && files.front().extension() == ".palpate";
  }));
  QObject::disconnect(&application.recording(), nullptr, &panel, nullptr);
  QTest::qWait(100);
}

TEST(RecordedSession, IsRecordedMarkedAndReplayedToTheBit) {
  const QTemporaryDir folder;
  app::Application application(recordedSphere(folder));
  application.start();
  recordSome(application, folder, 2000);
  if (HasFatalFailure()) return;
  // the hand was not disturbed
  EXPECT_TRUE(application.session().isOpen());
  auto recording = app::Recording::open(filesIn(folder).front());
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_GT(recording->stepCount(), 2000);
  EXPECT_EQ(recording->lostCount(), 0);
  ASSERT_EQ(recording->scenes().size(), 1U);
  EXPECT_TRUE(recording->scenes().front().hash);
  for (const char* only_if_wanted : {"began_unix_ns", "voxels_sha256"})
    EXPECT_EQ(recording->about().find(only_if_wanted), std::string::npos);
  int marks = 0, hands = 0, cameras = 0;
  for (const app::RecordedEvent& event : recording->events()) {
    marks += event.kind == "mark" && event.text == "a rough place";
    hands += event.kind == "hand" && event.text == "slide";
    cameras += event.kind == "camera" && app::cameraFrom(event.text).has_value();
  }
  EXPECT_EQ(marks, 1);
  EXPECT_EQ(hands, 1);
  EXPECT_GE(cameras, 1);
  const auto difference = app::replay(
      *recording,
      [&](std::uint32_t id) {
        const app::RecordedScene* then = recording->scene(id);
        return *haptics::makeScene(application.shown()->picture.volume, then->tool, then->options);
      },
      [](double) { return true; });
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->steps, recording->stepCount());
  EXPECT_EQ(difference->differing, 0) << difference->distance << " m";
}

/// What the user is asked when the first recording is to become a film, and says no to.
QString askedBeforeAFilm(app::Application& application, bool slices = false) {
  QString asked;
  bool ended = false;
  QTimer answers;
  QObject::connect(&answers, &QTimer::timeout, [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (auto* wish = qobject_cast<ui::ExportDialog*>(dialog)) {
      auto* formats = child<QComboBox>(*wish, "exportFormat");
      formats->setCurrentIndex(formats->count() - 1);
      child<QCheckBox>(*wish, "filmSlices")->setChecked(slices);
      child<QPushButton>(*wish, "exportAgree")->click();
    } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
      asked = box->text() + ' ' + box->informativeText();
      box->reject();
      ended = true;
    } else if (dialog != nullptr) {
      dialog->close();  // where to write it: nothing was asked
      ended = true;
    }
  });
  answers.start(50);
  ui::RecordingPanel& panel = *application.window().findChild<ui::RecordingPanel*>();
  auto* list = child<QTableWidget>(panel, "recordings");
  EXPECT_TRUE(waitFor([&] { return list->rowCount() == 1; }));
  list->selectRow(0);
  QTest::mouseClick(child<QPushButton>(panel, "exportRecording"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return ended; }));
  return asked;
}

TEST(RecordedSession, AFilmOfAScanWarnsOfAFaceWhateverToolAndField) {
  const QTemporaryDir folder, scans;
  const fs::path scan = fs::path(scans.path().toStdString()) / "head.nrrd";
  const auto volume = window::volumeOf(
      window::cubeGrid(80), haptics::ScalarType::Int16,
      [](const haptics::Vec3& p) { return p.norm() < 30e-3 ? 100.0 : -1000.0; }, {.unit = "HU"});
  ASSERT_TRUE(datasets::writeNrrd(*volume, scan));
  app::Arguments arguments = recordedSphere(folder, "tap");
  arguments.load.phantom = {};
  arguments.load.path = scan;
  arguments.load.isovalue = -300.0;
  app::Application application(arguments);
  application.start();
  recordSome(application, folder, 300);
  if (HasFatalFailure()) return;
  EXPECT_TRUE(askedBeforeAFilm(application).contains("face"));
  const QString title = application.window().windowTitle();
  ui::DevicePanel& panel = window::panelOf<ui::DevicePanel>(application.window());
  for (const auto& change : {std::function([&] { emit panel.toolChosen("wrench"); }),
                             std::function([&] { emit panel.fieldChosen("spline"); })}) {
    QSignalSpy adopted(&application, &app::Application::adopted);
    change();
    ASSERT_TRUE(adopted.wait(60'000));
    EXPECT_TRUE(askedBeforeAFilm(application).contains("face"));
    EXPECT_EQ(application.window().windowTitle(), title);
  }
  // with another volume on view there is no surface of the recording's to show
  QSignalSpy adopted(&application, &app::Application::adopted);
  emit application.window().menus().phantomWanted("torus");
  ASSERT_TRUE(adopted.wait(60'000));
  EXPECT_TRUE(askedBeforeAFilm(application).startsWith("This film will show the tool alone."));
}

TEST(RecordedSession, AFilmOfBoneWarnsOfAFaceInItsSlices) {
  const QTemporaryDir folder, scans;
  const fs::path scan = fs::path(scans.path().toStdString()) / "head.nrrd";
  const auto volume = window::volumeOf(
      window::cubeGrid(80), haptics::ScalarType::Int16,
      [](const haptics::Vec3& p) { return p.norm() < 30e-3 ? 1000.0 : -1000.0; }, {.unit = "HU"});
  ASSERT_TRUE(datasets::writeNrrd(*volume, scan));
  app::Arguments arguments = recordedSphere(folder, "tap");
  arguments.load.phantom = {};
  arguments.load.path = scan;
  app::Application application(arguments);
  application.start();
  recordSome(application, folder, 300);
  if (HasFatalFailure()) return;
  EXPECT_EQ(askedBeforeAFilm(application), "");
  EXPECT_TRUE(askedBeforeAFilm(application, true).contains("without slices"));
  // nor is bone seen alone under a second surface of skin
  application.window().views().volume().setSecondSurface(-300.0);
  EXPECT_TRUE(askedBeforeAFilm(application).contains("second surface"));
}

TEST(RecordedSession, IsGoneThroughInTheWindow) {
  const QTemporaryDir folder;
  app::Application application(recordedSphere(folder));
  application.start();
  recordSome(application, folder, 1500);
  if (HasFatalFailure()) return;
  ui::MainWindow& window = application.window();
  auto* list = child<QTableWidget>(*window.findChild<ui::RecordingPanel*>(), "recordings");
  ASSERT_TRUE(waitFor([&] { return list->rowCount() == 1; }));
  list->selectRow(0);
  QTest::mouseClick(child<QPushButton>(*window.findChild<ui::RecordingPanel*>(), "openRecording"),
                    Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application.replay() != nullptr; }));
  EXPECT_TRUE(window.replayBar().isVisible());
  EXPECT_FALSE(application.session().isOpen());
  // wherever one goes, the tool is where it was
  app::Replay& replay = *application.replay();
  const double begin = replay.track().begin, length = replay.track().end - begin;
  QPointF last;
  for (const double share : {0.1, 0.5, 0.95}) {
    const double time = begin + share * length;
    emit window.replayBar().timeWanted(time);
    ASSERT_TRUE(waitFor([&] {
      return std::abs(1e-9 * double(replay.step().step.time_ns) - time) < 0.1;
    })) << share;
    const haptics::Step& step = replay.step().step;
    window.views().volume().lookFromTool();
    const QImage picture = window::pictureAtRest(window.views().volume());
    const QPointF seen = window::centroid(picture, window::proxyColoured);
    const QPointF expected = window.views().volume().projected(step.X_WP.translation());
    EXPECT_LT(std::hypot(seen.x() - expected.x(), seen.y() - expected.y()), 8.0) << share;
  }
  window::keep(window::pictureOf(window), "replay");
  // a tick, and back
  const auto sequence = replay.step().step.sequence;
  emit window.replayBar().stepWanted(1);
  EXPECT_EQ(replay.step().step.sequence, sequence + 1);
  emit window.replayBar().stepWanted(-300);
  EXPECT_EQ(replay.step().step.sequence, sequence - 299);
  // played, it gets on as fast as time
  emit window.replayBar().timeWanted(begin);
  ASSERT_TRUE(waitFor([&] { return 1e-9 * double(replay.step().step.time_ns) < begin + 1e-6; }));
  const auto first = replay.step().step.time_ns;
  const auto played = [&] { return 1e-9 * double(replay.step().step.time_ns - first); };
  QElapsedTimer clock;
  clock.start();
  emit window.replayBar().playWanted(true);
  EXPECT_TRUE(waitFor([&] { return played() > 0.8; }));
  // a busy machine has drawn the last of it a while ago
  EXPECT_GT(played(), 0.2 * 1e-3 * double(clock.elapsed()));
  EXPECT_LT(played(), 1e-3 * double(clock.elapsed()) + 0.1);
  emit window.replayBar().playWanted(false);
  // over another volume it says so
  EXPECT_FALSE(window.replayBar().findChild<QLabel*>("replayWarning")->isVisible());
  emit window.menus().phantomWanted("torus");
  ASSERT_TRUE(waitFor([&] { return application.shown()->title.contains("torus"); }));
  EXPECT_NE(application.replay(), nullptr);
  const auto* warning = child<QLabel>(window.replayBar(), "replayWarning");
  EXPECT_TRUE(warning->isVisible());
  EXPECT_TRUE(
      warning->text().contains("64 x 64 x 64 voxels of 1 x 1 x 1 mm (int16), this one "
                               "72 x 72 x 40 voxels"))
      << warning->text().toStdString();
  EXPECT_FALSE(application.session().isOpen());
  // closed, the hand is at work again
  emit window.replayBar().closeWanted();
  EXPECT_EQ(application.replay(), nullptr);
  EXPECT_FALSE(window.replayBar().isVisible());
  EXPECT_TRUE(
      waitFor([&] { return application.snapshot().scene == application.shown()->scene->id; }));
}

TEST(RecordedSession, OverVoxelsThatAreOthersInTheSamePlaceSaysSo) {
  const QTemporaryDir folder, scans;
  const fs::path path = fs::path(scans.path().toStdString()) / "ball.nrrd";
  // two scans that lie alike: only the hash tells them apart
  const auto written = [&](double radius) {
    const auto volume = window::volumeOf(window::cubeGrid(40), haptics::ScalarType::Int16,
                                         window::ball(haptics::Vec3::Zero(), radius));
    // as another program does: this one does not write over a scan that it has read
    const fs::path beside = path.parent_path() / "beside.nrrd";
    if (!datasets::writeNrrd(*volume, beside)) return false;
    fs::rename(beside, path);
    return true;
  };
  ASSERT_TRUE(written(0.014));
  app::Arguments arguments = recordedSphere(folder);
  arguments.load.phantom = {};
  arguments.load.path = path;
  arguments.load.isovalue = 50.0;
  app::Application application(arguments);
  application.start();
  recordSome(application, folder, 600);
  if (HasFatalFailure()) return;
  ui::MainWindow& window = application.window();
  emit window.menus().recordingWanted(QString::fromStdString(filesIn(folder).front().string()));
  ASSERT_TRUE(waitFor([&] { return application.replay() != nullptr; }));
  QTest::qWait(500);
  auto* warning = child<QLabel>(window.replayBar(), "replayWarning");
  EXPECT_FALSE(warning->isVisible());
  const auto touched = [&] { return child<QLabel>(window, "touchNow")->text(); };
  emit window.replayBar().timeWanted(application.replay()->track().end);
  EXPECT_TRUE(waitFor([&] { return touched().startsWith("Touching "); }))
      << touched().toStdString();
  const auto before = application.shown()->picture.volume;
  ASSERT_TRUE(written(0.012));
  emit window.menus().openWanted(QString::fromStdString(path.string()));
  ASSERT_TRUE(waitFor([&] { return application.shown()->picture.volume != before; }));
  EXPECT_TRUE(app::liesLike(*before, *application.shown()->picture.volume));
  EXPECT_TRUE(waitFor([&] { return warning->isVisible(); }));
  EXPECT_TRUE(warning->text().contains("both have 40 x 40 x 40 voxels"))
      << warning->text().toStdString();
  EXPECT_TRUE(warning->text().contains("the voxels differ")) << warning->text().toStdString();
  // the values of this one were not touched
  EXPECT_TRUE(waitFor([&] { return touched() == "Touching"; })) << touched().toStdString();
}

/// A finished recording: a step a millisecond, its force [N] a thousandth of its time [s].
void writeRamp(const fs::path& path, int steps) {
  auto recorder = app::Recorder::create(path, {"test", "a build", "a machine"});
  ASSERT_TRUE(recorder) << sentence(recorder.error());
  (*recorder)->ring().start({});
  for (int i = 0; i < steps; ++i) {
    while ((*recorder)->ring().full()) QTest::qWait(1);
    haptics::Step step;
    step.sequence = std::uint64_t(i) + 1;
    step.time_ns = i * std::int64_t{1'000'000};
    step.sent_W.force = haptics::Vec3(1e-6 * i, 0.0, 0.0);
    ASSERT_TRUE((*recorder)->ring().push(step));
  }
  ASSERT_TRUE((*recorder)->finish());
}

std::unique_ptr<app::Replay> opened(const fs::path& path) {
  auto beginning = app::Replay::read(path, std::atomic<bool>{false});
  EXPECT_TRUE(beginning) << sentence(beginning.error());
  return std::make_unique<app::Replay>(std::move(**beginning), path);
}

TEST(RecordedSession, WhereverOneGoesTheStepsAreReadInTheBackground) {
  const QTemporaryDir place;
  const fs::path path = fs::path(place.path().toStdString()) / "long.palpate";
  ASSERT_NO_FATAL_FAILURE(writeRamp(path, 60'000));
  const auto replay = opened(path);
  const auto millisecond = [&] { return replay->step().step.time_ns / 1'000'000; };
  EXPECT_EQ(millisecond(), 0);
  // what has not been read is not there at once; of many wishes the last one counts
  for (const double time : {55.0, 20.0, 42.0}) replay->seek(time);
  EXPECT_EQ(millisecond(), 0);
  ASSERT_TRUE(waitFor([&] { return millisecond() == 42'000; }));
  const auto forces = replay->forces(30.0, 42.0);
  ASSERT_EQ(forces.size(), 10'000U);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    ASSERT_NEAR(forces[i].time, 32.001 + 1e-3 * double(i), 1e-9);
    ASSERT_NEAR(forces[i].force, 1e-3 * forces[i].time, 1e-6);
  }
  // step by step, over the ends of blocks
  replay->stepBy(-5'000);
  ASSERT_TRUE(waitFor([&] { return millisecond() == 37'000; }));
  replay->stepBy(1);
  EXPECT_EQ(millisecond(), 37'001);
  replay->stepBy(-100'000);
  ASSERT_TRUE(waitFor([&] { return millisecond() == 0; }));
  replay->stepBy(30'000);
  replay->stepBy(30'000);
  ASSERT_TRUE(waitFor([&] { return millisecond() == 59'999; }));
  EXPECT_EQ(replay->forces(0.0, 60.0).size(), 9'999U);
}

TEST(RecordedSession, APartThatCannotBeReadIsNamedWhereOneGoesToIt) {
  const QTemporaryDir place;
  const fs::path path = fs::path(place.path().toStdString()) / "damaged.palpate";
  ASSERT_NO_FATAL_FAILURE(writeRamp(path, 30'000));
  {
    auto database = app::Database::open(path, app::Database::Mode::Recover);
    ASSERT_TRUE(database);
    ASSERT_TRUE(database->run("UPDATE step SET data = x'0102' WHERE from_ns > 15000000000"));
  }
  const auto replay = opened(path);
  QSignalSpy failed(replay.get(), &app::Replay::failed);
  replay->seek(5.0);
  ASSERT_TRUE(waitFor([&] { return replay->step().step.time_ns == 5'000'000'000; }));
  for (int i = 1; i <= 2; ++i) {
    replay->seek(25.0);
    ASSERT_TRUE(waitFor([&] { return failed.count() == i; }));
    EXPECT_EQ(replay->step().step.time_ns, 5'000'000'000);
  }
  replay->seek(6.0);
  ASSERT_TRUE(waitFor([&] { return replay->step().step.time_ns == 6'000'000'000; }));
  EXPECT_EQ(failed.count(), 2);
}

TEST(RecordedSession, TheListNamesTheScanOfARecordingWhereItIsKnownHere) {
  const QTemporaryDir folder;
  const app::Recordings recordings(folder.path().toStdString());
  const auto scene =
      haptics::makeScene(window::volumeOf(window::cubeGrid(16), haptics::ScalarType::Int16,
                                          window::ball(haptics::Vec3::Zero(), 0.005)),
                         *haptics::makeTool("octahedron", window::octahedron(0.003)));
  ASSERT_TRUE(scene);
  app::VolumeHash hash{};
  hash.back() = 7;
  const fs::path path = recordings.next();
  auto recorder = app::Recorder::create(path, {"test", "a build", "a machine"});
  ASSERT_TRUE(recorder);
  (*recorder)->describe(*scene, "");
  (*recorder)->identify((*scene)->id, hash);
  (*recorder)->ring().start({});
  haptics::Step step;
  ASSERT_TRUE((*recorder)->ring().push(step));
  ASSERT_TRUE((*recorder)->finish());
  const std::atomic<bool> goes_on = false;
  const QStringList places{QString::fromStdString(app::hexOf(hash)) + " /a b/Erika.nrrd"};
  const auto listed = [&](const QStringList& known) {
    return recordings.list({}, goes_on, app::namesOf(known));
  };
  EXPECT_EQ(listed(places).value(0).scan, "Erika.nrrd");
  EXPECT_EQ(listed({}).value(0).scan, "another scan");
  ui::RecordingPanel panel;
  panel.show(listed(places));
  EXPECT_TRUE(panel.findChild<QTableWidget*>("recordings")->item(0, 0)->text().contains("Erika"));
  QFile file(QString::fromStdString(path.string()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_FALSE(file.readAll().contains("Erika"));
}

TEST(RecordedSession, ALabelAndACurveStandInTheListAndInNoFileOfARecording) {
  const QTemporaryDir place;
  const fs::path folder = fs::path(place.path().toStdString()) / "recordings";
  fs::create_directory(folder);
  const app::Recordings recordings(folder);
  const auto written = [&](const fs::path& path, int steps) {
    auto recorder = app::Recorder::create(path, {"test", "a build", "a machine"});
    ASSERT_TRUE(recorder) << sentence(recorder.error());
    (*recorder)->ring().start({});
    for (int i = 0; i < steps; ++i) {
      haptics::Step step;
      step.sequence = std::uint64_t(i) + 1;
      step.time_ns = i * 1'000'000;
      step.sent_W.force =
          haptics::Vec3((i < steps / 2 ? 0.5 : 2.0) * (i % 2 == 0 ? 0.25 : 1.0), 0.0, 0.0);
      ASSERT_TRUE((*recorder)->ring().push(step));
    }
    ASSERT_TRUE((*recorder)->finish());
  };
  const fs::path path = recordings.next();
  written(path, 400);
  if (HasFatalFailure()) return;
  const std::atomic<bool> goes_on = false;
  QList<ui::PastRecording> listed = recordings.list({}, goes_on);
  ASSERT_EQ(listed.size(), 1);
  EXPECT_EQ(listed[0].label, "");
  ASSERT_TRUE(listed[0].changed.isValid());
  EXPECT_LT(std::abs(listed[0].changed.secsTo(QDateTime::currentDateTime())), 600);
  ASSERT_TRUE(recordings.setLabel(listed[0].id, "Rim of the window"));
  EXPECT_EQ(recordings.list({}, goes_on)[0].label, "Rim of the window");
  // beside the folder, for the user alone, and nowhere in it
  const fs::path labels = fs::path(place.path().toStdString()) / "recordings-labels.json";
  ASSERT_TRUE(fs::exists(labels));
  EXPECT_EQ(fs::status(labels).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  for (const auto& entry : fs::directory_iterator(folder)) {
    QFile file(QString::fromStdString(entry.path().string()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_FALSE(file.readAll().contains("Rim of the window"));
  }
  app::ForceCurves curves;
  QList<float> most;
  QObject::connect(&curves, &app::ForceCurves::read, &curves,
                   [&](const QString&, const QList<float>& read) { most = read; });
  curves.want(folder, {listed[0].id});
  ASSERT_TRUE(waitFor([&] { return !most.isEmpty(); }));
  ASSERT_EQ(most.size(), qsizetype(app::ForceCurves::kIntervals));
  EXPECT_FLOAT_EQ(most.first(), 0.5F);
  EXPECT_FLOAT_EQ(most.last(), 2.0F);
  EXPECT_EQ(curves.of(listed[0].id), most);
  // a number that is used again brings no label
  fs::remove(path);
  EXPECT_EQ(recordings.next(), path);
  written(path, 4);
  EXPECT_EQ(recordings.list({}, goes_on)[0].label, "");
}

TEST(RecordedSession, IsExportedBehindTheWindow) {
  const QTemporaryDir folder, exports;
  app::Application application(recordedSphere(folder));
  application.start();
  recordSome(application, folder, 1500);
  if (HasFatalFailure()) return;
  app::ExportRequest request{.recording = filesIn(folder).front(), .out = {}, .wish = {}};
  request.wish.from = 0.0;
  request.wish.to = 1.0;
  request.volume = application.shown()->picture.volume;
  request.wish.film.width = 320;
  request.wish.film.height = 240;
  int ended = 0;
  bool well = false;
  QObject::connect(&application.exporting().task(), &app::ExportTask::finished, &application,
                   [&](bool done, const QString&) {
                     ++ended;
                     well = done;
                   });
  int number = 0;
  for (const auto& [table, name] : {std::pair<std::optional<std::size_t>, const char*>{0, "e.csv"},
                                    {1, "bids"},
                                    {2, "e.h5"},
                                    {3, "e.mcap"},
                                    {std::nullopt, "film"}}) {
    request.wish.table = table;
    request.out = fs::path(exports.path().toStdString()) / name;
    application.exporting().exportTo(request);
    ASSERT_TRUE(waitFor([&] { return ended > number; })) << name;
    EXPECT_TRUE(well) << name
                      << child<QLabel>(application.window(), "message")->text().toStdString();
    ++number;
  }
  // the touch went on
  EXPECT_TRUE(application.session().isOpen());
  EXPECT_GE(filesIn(exports).size(), 8U);
  // cancelled, nothing is left of it
  request.out = fs::path(exports.path().toStdString()) / "cancelled";
  application.exporting().exportTo(request);
  emit application.window().loading().cancelWanted();
  ASSERT_TRUE(waitFor([&] { return ended > number; }));
  EXPECT_FALSE(well);
  for (const fs::path& file : filesIn(exports))
    EXPECT_EQ(file.string().find("cancelled"), std::string::npos) << file;
}

/// Clicks this button of the next questions.
struct Pressed {
  explicit Pressed(const char* button) {
    QObject::connect(&timer, &QTimer::timeout, [this, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      ++asked;
      for (QAbstractButton* choice : box->buttons())
        if (choice->text().remove('&').startsWith(button)) return choice->click();
    });
    timer.start(20);
  }
  QTimer timer;
  int asked = 0;
};

TEST(RecordedSession, AFilmThatIsMadeIsFinishedBehindAWindowThatCloses) {
  const QTemporaryDir folder, exports;
  const auto begin = [&](app::Application& application, const char* name) {
    app::ExportRequest request{.recording = filesIn(folder).front(), .out = {}, .wish = {}};
    request.wish.from = 0.0;
    request.wish.to = 0.5;
    request.wish.table = std::nullopt;
    request.volume = application.shown()->picture.volume;
    request.wish.film.width = 320;
    request.wish.film.height = 240;
    request.out = fs::path(exports.path().toStdString()) / name;
    application.exporting().exportTo(request);
  };
  {
    app::Application application(recordedSphere(folder));
    application.start();
    recordSome(application, folder, 600);
    if (HasFatalFailure()) return;
    begin(application, "film");
    QSignalSpy finished(&application, &app::Application::finished);
    {
      Pressed pressed("Cancel");
      application.window().close();
      EXPECT_EQ(pressed.asked, 1);
    }
    EXPECT_TRUE(application.window().isVisible());
    EXPECT_TRUE(application.session().isOpen());
    Pressed pressed("Finish");
    application.window().close();
    EXPECT_EQ(pressed.asked, 1);
    EXPECT_FALSE(application.window().isVisible());
    EXPECT_FALSE(application.session().isOpen());
    EXPECT_EQ(finished.count(), 0);
    EXPECT_TRUE(waitFor([&] { return finished.count() > 0; }));
    EXPECT_GE(filesIn(exports).size(), 2U);
  }
  QGuiApplication::setQuitOnLastWindowClosed(true);
  for (const fs::path& file : filesIn(exports)) fs::remove(file);
  app::Application application(recordedSphere(folder));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  begin(application, "stopped");
  Pressed pressed("Stop");
  application.window().close();
  EXPECT_FALSE(application.window().isVisible());
  EXPECT_TRUE(waitFor([&] { return !application.exporting().task().isRunning(); }));
  EXPECT_TRUE(filesIn(exports).empty());
}

TEST(RecordedSession, AnExportAsksBeforeItWritesOverAnyOfItsFiles) {
  const QTemporaryDir folder, exports;
  app::Application application(recordedSphere(folder));
  application.start();
  recordSome(application, folder, 300);
  if (HasFatalFailure()) return;
  ui::RecordingPanel& panel = *application.window().findChild<ui::RecordingPanel*>();
  auto* list = child<QTableWidget>(panel, "recordings");
  EXPECT_TRUE(waitFor([&] { return list->rowCount() == 1; }));
  list->selectRow(0);
  application.marks().measures().replace({{ui::MeasureKind::Note, "thin wall", {{3, -7, 5}}}});
  // the file of that name, and one of the several
  for (const auto& [format, name, there] : {std::tuple{0, "a.csv", "a.csv"},
                                            {0, "b.csv", "b.columns.json"},
                                            {1, "a", "a_events.json"},
                                            {1, "b", "b_motion.tsv"},
                                            {2, "a.h5", "a.h5"},
                                            {3, "a.mcap", "a.mcap"},
                                            {4, "a.mp4", "a.mp4"},
                                            {4, "b.mp4", "b.frames.csv"}}) {
    const fs::path file = fs::path(exports.path().toStdString()) / there;
    std::ofstream(file) << "mine";
    QString asked;
    bool ended = false, warned = false;
    QTimer answers;
    QObject::connect(&answers, &QTimer::timeout, [&, format = format, name = name] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (auto* wish = qobject_cast<ui::ExportDialog*>(dialog)) {
        child<QComboBox>(*wish, "exportFormat")->setCurrentIndex(format);
        child<QPushButton>(*wish, "exportAgree")->click();
      } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
        asked = box->text();
        box->reject();
        ended = true;
      } else if (auto* where = qobject_cast<QFileDialog*>(dialog)) {
        if (ended) return where->reject();
        warned = where->findChild<QLabel*>("notesWarning") != nullptr;
        where->findChild<QLineEdit*>("fileNameEdit")->setText(exports.filePath(name));
        QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
      }
    });
    answers.start(30);
    QTest::mouseClick(child<QPushButton>(panel, "exportRecording"), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return ended && QApplication::activeModalWidget() == nullptr; }))
        << there;
    EXPECT_FALSE(asked.isEmpty()) << there;
    EXPECT_EQ(warned, format == 4) << there;  // a film shows notes
    EXPECT_EQ(fs::file_size(file), 4U) << there;
    EXPECT_FALSE(application.exporting().task().isRunning()) << there;
  }
}

/// The first recording as a film, as its dialogs make it.
void filmFirst(app::Application& application, const fs::path& film) {
  ui::RecordingPanel& panel = *application.window().findChild<ui::RecordingPanel*>();
  auto* list = child<QTableWidget>(panel, "recordings");
  EXPECT_TRUE(waitFor([&] { return list->rowCount() == 1; }));
  list->selectRow(0);
  bool ended = false;
  const QObject listener;
  QObject::connect(&application.exporting().task(), &app::ExportTask::finished, &listener,
                   [&](bool done, const QString& words) {
                     EXPECT_TRUE(done) << words.toStdString();
                     ended = true;
                   });
  QTimer answers;
  QObject::connect(&answers, &QTimer::timeout, [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (auto* wish = qobject_cast<ui::ExportDialog*>(dialog)) {
      auto* formats = child<QComboBox>(*wish, "exportFormat");
      formats->setCurrentIndex(formats->count() - 1);
      child<QPushButton>(*wish, "exportAgree")->click();
    } else if (auto* where = qobject_cast<QFileDialog*>(dialog)) {
      answers.stop();
      where->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(film.string()));
      QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
    }
  });
  answers.start(30);
  QTest::mouseClick(child<QPushButton>(panel, "exportRecording"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return ended; }));
}

/// The first frame of a film.
QImage firstFrame(const fs::path& film) {
  constexpr int kWide = 640, kHigh = 480;
  QProcess reader;
  reader.start("ffmpeg", {"-v", "error", "-i", QString::fromStdString(film.string()), "-frames:v",
                          "1", "-vf", "scale=640:480", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"});
  EXPECT_TRUE(reader.waitForFinished(60'000));
  const QByteArray bytes = reader.readAllStandardOutput();
  if (bytes.size() != 3 * kWide * kHigh) return {};
  return QImage(reinterpret_cast<const uchar*>(bytes.constData()), kWide, kHigh, 3 * kWide,
                QImage::Format_RGB888)
      .copy();
}

TEST(RecordedSession, AFilmHasMarksAndSecondSurfaceOfTheViewOnTheirOwnScanAlone) {
  if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) GTEST_SKIP() << "ffmpeg is not there";
  const QTemporaryDir folder, films;
  const auto path = [&](const char* name) { return fs::path(films.path().toStdString()) / name; };
  app::Application application(recordedSphere(folder));
  application.start();
  recordSome(application, folder, 100);
  if (HasFatalFailure()) return;
  const auto markColoured = [](QColor c) {
    return c.red() > c.green() + 40 && c.blue() > c.green() + 40 && c.red() > 120;
  };
  const auto brightness = [](const QImage& image) {
    qint64 sum = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    return double(sum) / (image.width() * image.height());
  };
  filmFirst(application, path("bare.mp4"));
  const QImage bare = firstFrame(path("bare.mp4"));
  ASSERT_FALSE(bare.isNull());
  EXPECT_EQ(window::count(bare, markColoured), 0);
  ui::VolumeView& view = application.window().views().volume();
  const haptics::Volume& volume = *application.shown()->picture.volume;
  // a larger ball about the first
  view.setSecondSurface(0.8 * application.shown()->isovalue + 0.2 * volume.least);
  view.setSecondOpacity(1.0);
  const std::vector<ui::Measure> marks{
      {ui::MeasureKind::Distance, "across", {{-25, -25, 0}, {25, -25, 20}}}};
  application.marks().measures().replace(marks);
  filmFirst(application, path("marked.mp4"));
  const QImage marked = firstFrame(path("marked.mp4"));
  ASSERT_FALSE(marked.isNull());
  window::keep(marked, "film_marked");
  EXPECT_GT(window::count(marked, markColoured), 20);
  EXPECT_GT(std::abs(brightness(marked) - brightness(bare)), 1.0);
  // beside another scan they would stand at wrong places
  QSignalSpy adopted(&application, &app::Application::adopted);
  {
    const Pressed pressed("Discard");
    emit application.window().menus().phantomWanted("torus");
    ASSERT_TRUE(adopted.wait(60'000));
  }
  application.marks().measures().replace(marks);
  {
    const Pressed agreed("Make the film");
    filmFirst(application, path("another.mp4"));
  }
  EXPECT_EQ(window::count(firstFrame(path("another.mp4")), markColoured), 0);
  application.marks().measures().clear();
}

TEST(RecordedSession, ThatWasNeverFinishedIsOfferedAtTheNextStart) {
  const QTemporaryDir folder;
  {
    auto recorder = app::Recorder::create(
        fs::path(folder.path().toStdString()) / "session-0001.palpate", {"test", "", ""});
    ASSERT_TRUE(recorder);
    haptics::Step step;
    (*recorder)->ring().start({});
    (*recorder)->ring().push(step);
  }
  app::Application application(recordedSphere(folder, "mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  ui::MainWindow& window = application.window();
  EXPECT_TRUE(
      waitFor([&] { return child<QLabel>(window, "message")->text().contains("session-0001"); }));
  auto* list = child<QTableWidget>(*window.findChild<ui::RecordingPanel*>(), "recordings");
  ASSERT_TRUE(waitFor([&] { return list->rowCount() == 1; }));
  list->selectRow(0);
  QTest::mouseClick(child<QPushButton>(*window.findChild<ui::RecordingPanel*>(), "openRecording"),
                    Qt::LeftButton);
  EXPECT_TRUE(waitFor(
      [&] { return fs::exists(fs::path(folder.path().toStdString()) / "session-0001.palpate"); }));
}

TEST(RecordedSession, ThatWasNeverFinishedIsAsLargeAsItsLogIs) {
  const QTemporaryDir folder;
  const fs::path part = fs::path(folder.path().toStdString()) / "session-0001.palpate.part";
  std::ofstream(part) << "head";
  std::ofstream(part.string() + "-wal") << "what was recorded";
  const auto listed =
      app::Recordings(folder.path().toStdString()).list({}, std::atomic<bool>{false});
  ASSERT_EQ(listed.size(), 1);
  EXPECT_EQ(listed[0].bytes, 4 + 17);
}

TEST(RecordedSession, EndsWholeWhenTheWindowClosesAndStatesWhichScanItIsWhereThatIsWanted) {
  const QTemporaryDir folder;
  QByteArray voxels;
  {
    app::Application application(recordedSphere(folder));
    application.start();
    ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
    const haptics::Volume& scan = *application.shown()->picture.volume;
    voxels = QCryptographicHash::hash(
        QByteArrayView{static_cast<const char*>(scan.voxels.get()),
                       qsizetype(scan.grid.voxelCount() * haptics::sizeOf(scan.type))},
        QCryptographicHash::Sha256);
    auto* panel = application.window().findChild<ui::RecordingPanel*>();
    child<QCheckBox>(*panel, "recordScan")->setChecked(true);
    emit panel->recordWanted(true);
    ASSERT_TRUE(isWritten(application, 300));
    application.window().close();
  }
  ASSERT_EQ(filesIn(folder).size(), 1U);
  const auto recording = app::Recording::open(filesIn(folder).front());
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_GT(recording->stepCount(), 300);
  const auto about = nlohmann::json::parse(recording->about());
  EXPECT_EQ(about.value("voxels_sha256", ""), voxels.toHex().toStdString());
  EXPECT_EQ(about.value("program", ""), "palpate");
  EXPECT_FALSE(about.contains("began_unix_ns"));
}

TEST(RecordedSession, GoesOnThroughAnotherToolVolumeAndHand) {
  const QTemporaryDir folder;
  app::Application application(recordedSphere(folder));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
  ui::MainWindow& window = application.window();
  emit window.findChild<ui::RecordingPanel*>()->recordWanted(true);
  ASSERT_TRUE(isWritten(application, 0));
  emit window::panelOf<ui::DevicePanel>(window).toolChosen("drill");
  ASSERT_TRUE(waitFor([&] { return application.shown()->tool.name == "drill"; }));
  window::afterTicks(application, 300);
  emit window.menus().phantomWanted("torus");
  ASSERT_TRUE(waitFor([&] { return application.shown()->title.contains("torus"); }));
  window::afterTicks(application, 300);
  emit window::panelOf<ui::DevicePanel>(window).handChosen("tap");
  window::afterTicks(application, 300);
  window.close();
  ASSERT_EQ(filesIn(folder).size(), 1U);
  const auto recording = app::Recording::open(filesIn(folder).front());
  ASSERT_TRUE(recording) << sentence(recording.error());
  ASSERT_GE(recording->scenes().size(), 3U);
  EXPECT_EQ(recording->scenes()[1].tool.name, "drill");
  EXPECT_NE(recording->scenes().back().volume.grid.dims, haptics::Grid{}.dims);
  int scenes = 0, hands = 0;
  for (const app::RecordedEvent& event : recording->events()) {
    scenes += event.kind == "scene";
    hands += event.kind == "hand";
  }
  EXPECT_GE(scenes, 3);
  EXPECT_GE(hands, 3);
}

}  // namespace
