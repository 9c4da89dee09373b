// SPDX-License-Identifier: BSD-3-Clause
// Views saved and opened again: over the same scan, another one, and on another installation.
#include <gtest/gtest.h>

#include <vtkCamera.h>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <filesystem>

#include "app/application.h"
#include "app/recording/volume_hash.h"
#include "app/window/edits/edit_controller.h"
#include "app/window/scan/loader.h"
#include "app/window/views/marks_controller.h"
#include "app/window/views/view_file_controller.h"
#include "datasets/edits/edit_history.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/ui/answers.h"
#include "tests/ui/views/marked_scan.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "ui/controls/number_box.h"
#include "ui/views/volume_view.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/touch_state.h"
#include "ui/window/view_gap.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;
using ui::MeasureKind;
using window::Answer;
using window::FileName;
using window::waitFor;

namespace fs = std::filesystem;

/// The installation of somebody: a folder of its own for the key.
class Installation {
 public:
  Installation() : before_(qgetenv("XDG_DATA_HOME")) { use(); }
  ~Installation() {
    if (before_.isEmpty())
      qunsetenv("XDG_DATA_HOME");
    else
      qputenv("XDG_DATA_HOME", before_);
  }
  void use() const { qputenv("XDG_DATA_HOME", folder_.path().toLocal8Bit()); }

 private:
  QByteArray before_;
  QTemporaryDir folder_;
};

/// A window that saves and opens views.
struct FiledViews : window::MarkedScan {
  app::ViewFileController files{window.views(),
                                window.messages(),
                                window.loading(),
                                window.menus(),
                                shared,
                                controller,
                                true};

  FiledViews() {
    QObject::connect(&files, &app::ViewFileController::isovalueWanted, &isosurface,
                     &app::IsosurfaceController::set);
  }
  bool save(const fs::path& path, bool with_place = false) {
    QSignalSpy finished(&files, &app::ViewFileController::finished);
    files.save(path, with_place);
    waitFor([&] { return finished.count() > 0; });
    return finished.count() == 1 && finished[0][0].toBool();
  }
  bool open(const fs::path& path) {
    QSignalSpy finished(&files, &app::ViewFileController::finished);
    files.open(path);
    waitFor([&] { return finished.count() > 0; });
    return finished.count() == 1 && finished[0][0].toBool();
  }
  QString message() { return window.findChild<QLabel*>("message")->text(); }
};

std::shared_ptr<const haptics::Volume> ballAt(double x_mm, int n = 48, double top = 1.0) {
  const auto ball = window::ball({x_mm * 1e-3, 0.0, 0.0}, 0.012);
  return window::volumeOf(window::cubeGrid(n), haptics::ScalarType::Int16,
                          [=](const Vec3& p) { return top * ball(p); });
}

std::vector<ui::Measure> someMarks() {
  return {{MeasureKind::Distance, "Width", {{-5.25, 1, 2}, {10, 1, 2}}},
          {MeasureKind::Note, "thin wall", {{3, -7, 5}}}};
}

TEST(ViewFiles, AViewComesBackOverTheSameScan) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("mine.palpate-view").toStdString();
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  window::showAndWait(views.window, {1240, 840});
  views.measures().replace(someMarks());
  views.window.views().setCross({4, 5, 6});
  emit views.slice(ui::Plane::Axial).greyChanged({.level = 33.0, .width = 44.0});
  views.isosurface.set(61.0);
  views.window.views().volume().lookFromTool();
  views.window.views().volume().camera()->Azimuth(25.0);
  views.slice(ui::Plane::Coronal).zoom(3.0, {100.0, 80.0});
  views.window.views().layout().arrange(ui::Arrangement::FourUp);
  const ui::ViewLook look = views.window.views().look();
  ASSERT_TRUE(views.save(path)) << views.message().toStdString();

  // another start of the program, with the same scan read again
  FiledViews later;
  later.show(ballAt(0.0), 50.0);
  window::showAndWait(later.window, {1240, 840});
  later.measures().replace({{MeasureKind::Point, "mine", {{0, 0, 0}}}});
  double isovalue = 0.0;
  QObject::connect(&later.isosurface, &app::IsosurfaceController::changed,
                   [&](double s) { isovalue = s; });
  ASSERT_TRUE(later.open(path)) << later.message().toStdString();
  ASSERT_EQ(later.measures().all().size(), 2U);
  EXPECT_EQ(later.measures().all()[0].text, "Width");
  EXPECT_EQ(later.measures().all()[1].kind, MeasureKind::Note);
  EXPECT_LT((later.measures().all()[0].places_mm[0] - Eigen::Vector3d{-5.25, 1, 2}).norm(), 1e-9);
  EXPECT_EQ(isovalue, 61.0);
  const ui::ViewLook again = later.window.views().look();
  EXPECT_LT((again.eye_mm - look.eye_mm).norm(), 1e-6);
  EXPECT_LT((again.focus_mm - look.focus_mm).norm(), 1e-6);
  EXPECT_LT((again.up - look.up).norm(), 1e-9);
  EXPECT_LT((again.cross_mm - Eigen::Vector3d{4, 5, 6}).norm(), 1e-9);
  EXPECT_EQ(again.grey_level, 33.0);
  EXPECT_EQ(again.grey_width, 44.0);
  EXPECT_EQ(again.layout.arrangement, ui::Arrangement::FourUp);
  EXPECT_NEAR(again.slices[1].zoom, 3.0, 1e-9);
  EXPECT_LT((again.slices[1].shift_mm - look.slices[1].shift_mm).norm(), 1e-9);
  // what was marked before is not lost
  ASSERT_TRUE(later.measures().canRestore());
  later.measures().restore();
  EXPECT_EQ(later.measures().all().size(), 3U);
  window::pictureAtRest(later.window.views().volume());
  window::keep(window::pictureOf(later.window), "view_opened");
}

TEST(ViewFiles, WhatEachViewShowsComesBackToThePixel) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("mine.palpate-view").toStdString();
  const auto scan = window::volumeOf(
      window::cubeGrid(48), haptics::ScalarType::Int16,
      [](const Vec3& p) { return 2000.0 - 3000.0 * p.norm() / 0.02; }, {.unit = "HU"});
  haptics::Snapshot tool;
  tool.X_WP.linear() = Eigen::AngleAxisd(0.4, Vec3::UnitX()).toRotationMatrix();
  tool.X_WP.translation() = tool.X_WD.translation() = Vec3{0.003, -0.026, 0.002};
  tool.X_WD.linear() = tool.X_WP.linear();
  const auto open = [&](FiledViews& views) {
    views.show(scan, 300.0);
    window::showAndWait(views.window, {1240, 840});
    views.window.views().display(tool);
    views.window.touch().display(tool);
  };
  const auto entry = [](FiledViews& views, const char* name) {
    return views.window.findChild<QAction*>(name);
  };
  const auto thick = [](FiledViews& views) {
    for (QAction* action : views.window.findChild<QMenu*>("slabMenu")->actions())
      if (action->text().startsWith("10")) return action;
    return static_cast<QAction*>(nullptr);
  };
  const auto second = [](FiledViews& views) {
    return views.window.findChild<QMenu*>("secondSurface")->actions()[2];  // skin
  };
  FiledViews views;
  open(views);
  for (const char* name : {"four_up", "nearest", "slabMean", "showOblique", "obliqueAlong"})
    entry(views, name)->trigger();
  thick(views)->trigger();
  // vessels, then another isovalue: the colours stay
  views.window.findChild<QMenu*>("tissuePresets")->actions()[3]->trigger();
  views.isosurface.set(250.0);
  second(views)->trigger();
  views.window.findChild<ui::NumberBox*>("secondOpacity")->setValue(70.0);
  ui::SliceView& with_tool = views.slice(ui::Plane::Oblique);
  with_tool.scroll(3);
  with_tool.zoom(2.0, {60.0, 60.0});
  const QList<ui::ViewGap*> gaps = views.window.findChildren<ui::ViewGap*>();
  for (ui::ViewGap* gap : gaps)
    if (gap->isVisible()) {
      emit gap->moved(40);
      break;
    }
  ASSERT_TRUE(views.save(path)) << views.message().toStdString();
  const QString borders = views.window.views().layout().borders();

  FiledViews later;
  open(later);
  ASSERT_NE(later.window.views().layout().borders(), borders);
  ASSERT_TRUE(later.open(path)) << later.message().toStdString();
  EXPECT_EQ(later.window.views().layout().borders(), borders);
  for (const char* name :
       {"four_up", "nearest", "slabMean", "showOblique", "obliqueAlong", "colourByTissue"})
    EXPECT_TRUE(entry(later, name)->isChecked()) << name;
  EXPECT_TRUE(thick(later)->isChecked());
  EXPECT_TRUE(second(later)->isChecked());
  EXPECT_EQ(later.window.views().volume().surface().second(),
            views.window.views().volume().surface().second());
  EXPECT_EQ(later.window.views().volume().secondOpacity(), 0.7);
  EXPECT_EQ(later.window.findChild<ui::NumberBox*>("secondOpacity")->value(), 70.0);
  later.window.views().display(tool);
  later.window.touch().display(tool);
  // what tells of the saved file takes its room from the views
  views.window.findChild<QAbstractButton*>("doneClose")->click();
  for (FiledViews* shown : {&views, &later}) {
    window::pictureOf(shown->window);
    for (ui::SliceView* slice : shown->window.views().slices().slices()) window::rest(*slice);
  }
  for (const ui::Plane plane :
       {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal, ui::Plane::Oblique}) {
    later.slice(plane).clearFocus();
    views.slice(plane).clearFocus();
    EXPECT_EQ(later.slice(plane).size(), views.slice(plane).size()) << int(plane);
    EXPECT_LT(window::differing(later.slice(plane).picture(1), views.slice(plane).picture(1), 8),
              1e-4)
        << int(plane);
  }
  const QImage was = window::pictureAtRest(views.window.views().volume());
  const QImage is = window::pictureAtRest(later.window.views().volume());
  EXPECT_LT(window::differing(is, was, 8), 1e-3);
  const QImage shown = window::pictureOf(later.window);
  window::keep(shown, "view_whole_look");
  window::keep(is, "view_whole_look_space");

  // a view that was alone is alone again, and a file without a second surface takes it away
  views.window.findChild<QMenu*>("secondSurface")->actions().first()->trigger();
  entry(views, "colourIvory")->trigger();
  views.slice(ui::Plane::Sagittal).parentWidget()->findChild<QToolButton*>("maximise")->click();
  ASSERT_TRUE(views.save(path));
  ASSERT_TRUE(later.open(path)) << later.message().toStdString();
  EXPECT_TRUE(later.slice(ui::Plane::Sagittal).isVisible());
  EXPECT_FALSE(later.window.views().volume().isVisible());
  EXPECT_FALSE(later.window.views().volume().surface().second());
  EXPECT_TRUE(entry(later, "colourIvory")->isChecked());
  EXPECT_TRUE(later.window.findChild<QMenu*>("secondSurface")->actions().first()->isChecked());
  entry(later, "maximiseView")->trigger();
  EXPECT_TRUE(later.window.views().volume().isVisible());
  EXPECT_EQ(later.window.views().layout().arrangement(), ui::Arrangement::FourUp);
}

TEST(ViewFiles, AFileOfAnEarlierVersionIsRefusedAndSaysSo) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("old.palpate-view").toStdString();
  QFile file(QString::fromStdString(path.string()));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"palpate_view\": 1, \"edits\": []}");
  file.close();
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  EXPECT_FALSE(views.open(path));
  EXPECT_TRUE(views.message().contains("earlier Palpate")) << views.message().toStdString();
}

TEST(ViewFiles, HoldNoPathAndNoNameUnlessThePlaceIsToBeRemembered) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  FiledViews views;
  QDir(folder.path()).mkdir("Somebody");
  views.show(ballAt(0.0), 50.0, "Somebody^Jane",
             fs::path(folder.path().toStdString()) / "Somebody/s.nrrd");
  ASSERT_TRUE(views.save(path));
  const auto text = [&] {
    QFile file(QString::fromStdString(path.string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  EXPECT_FALSE(text().contains("Somebody"));
  EXPECT_FALSE(text().contains(folder.path().toUtf8()));
  ASSERT_TRUE(views.save(path, true));
  EXPECT_TRUE(text().contains("\"Somebody/s.nrrd\""));
  EXPECT_FALSE(text().contains(folder.path().toUtf8()));  // relative
}

TEST(ViewFiles, AnotherScanIsRefusedAndNothingChanges) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  window::showAndWait(views.window, {1240, 840});
  views.measures().replace(someMarks());
  ASSERT_TRUE(views.save(path));

  // another geometry: the sentence says which one the file wants
  FiledViews small;
  small.show(ballAt(0.0, 40), 50.0);
  EXPECT_FALSE(small.open(path));
  EXPECT_TRUE(small.message().contains("48 x 48 x 48 voxels of 1 x 1 x 1 mm (int16)"))
      << small.message().toStdString();
  EXPECT_TRUE(small.message().contains("40 x 40 x 40")) << small.message().toStdString();
  EXPECT_TRUE(small.measures().all().empty());

  // the same geometry, other voxels
  FiledViews moved;
  moved.show(ballAt(3.0), 50.0);
  moved.measures().replace({{MeasureKind::Point, "mine", {{0, 0, 0}}}});
  EXPECT_FALSE(moved.open(path));
  EXPECT_TRUE(moved.message().contains("another scan")) << moved.message().toStdString();
  ASSERT_EQ(moved.measures().all().size(), 1U);
  EXPECT_EQ(moved.measures().all()[0].text, "mine");
  EXPECT_FALSE(moved.measures().canRestore());

  // a damaged file
  const fs::path damaged = folder.filePath("b.palpate-view").toStdString();
  {
    QFile file(QString::fromStdString(damaged.string()));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"palpate_view\": 2}");
  }
  EXPECT_FALSE(moved.open(damaged));
  EXPECT_TRUE(moved.message().contains("\"edits\" is missing") ||
              moved.message().contains("\"scan\" is missing"))
      << moved.message().toStdString();
  EXPECT_EQ(moved.measures().all().size(), 1U);
}

TEST(ViewFiles, OnAnotherInstallationTheUserIsAsked) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  {
    FiledViews views;
    views.show(ballAt(0.0), 50.0);
    views.measures().replace(someMarks());
    ASSERT_TRUE(views.save(path));
  }
  const Installation elsewhere;
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  window::showAndWait(views.window, {1240, 840});
  {
    Answer answer("Cancel");
    EXPECT_FALSE(views.open(path));
    EXPECT_TRUE(answer.said.contains("another installation")) << answer.said.toStdString();
    EXPECT_TRUE(answer.said.contains("48 x 48 x 48")) << answer.said.toStdString();
  }
  EXPECT_TRUE(views.measures().all().empty());
  {
    Answer answer("Open it");
    EXPECT_TRUE(views.open(path));
  }
  EXPECT_EQ(views.measures().all().size(), 2U);
  // another geometry is refused there without a question
  views.show(ballAt(0.0, 40), 50.0);
  Answer answer("Open it");
  EXPECT_FALSE(views.open(path));
  EXPECT_TRUE(answer.said.isEmpty());
}

TEST(ViewFiles, EditsAreAskedForAndTheRestFollowsTheEditedVolume) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  const auto scan = ballAt(0.0);
  const std::vector<datasets::Edit> edits{datasets::Crop{{{0, 0, 10}, {48, 48, 40}}}};
  const auto cropped = datasets::edited(scan, edits).value();
  FiledViews views;
  views.show(cropped, 50.0);
  views.measures().replace(someMarks());
  ASSERT_TRUE(views.save(path)) << views.message().toStdString();
  FiledViews later;
  later.show(scan, 50.0);
  // a program that cannot edit refuses them
  EXPECT_FALSE(later.open(path));
  EXPECT_TRUE(later.message().contains("edits")) << later.message().toStdString();
  EXPECT_TRUE(later.measures().all().empty());
  std::vector<datasets::Edit> wanted;
  QObject::connect(&later.files, &app::ViewFileController::editsWanted,
                   [&](const std::vector<datasets::Edit>& asked) {
                     wanted = asked;
                     QTimer::singleShot(0, &later.window, [&] {
                       later.show(datasets::edited(scan, wanted).value(), 50.0);
                       later.files.showScene(true);
                     });
                   });
  EXPECT_TRUE(later.open(path)) << later.message().toStdString();
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(datasets::textOf(wanted[0]), datasets::textOf(edits[0]));
  EXPECT_EQ(later.measures().all().size(), 2U);
  // over the same edits nothing is asked for; the marks of the scan stayed with it
  wanted.clear();
  EXPECT_TRUE(later.open(path));
  EXPECT_TRUE(wanted.empty());
}

TEST(ViewFiles, TheDialogWarnsOfNamesAndOffersTheRelativePath) {
  const Installation here;
  const QTemporaryDir folder;
  FiledViews views;
  views.show(ballAt(0.0), 50.0, "A scan", fs::path(folder.path().toStdString()) / "s.nrrd");
  window::showAndWait(views.window, {1240, 840});
  QString warning;
  bool by_default = true;
  QTimer::singleShot(300, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    window::keep(window::pictureOf(*dialog), "view_save_dialog");
    warning = dialog->findChild<QLabel*>("notesWarning")->text();
    auto* remember = dialog->findChild<QCheckBox*>("rememberScan");
    by_default = remember->isChecked();
    remember->click();
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    name->setText(folder.filePath("chosen"));
    QTest::keyClick(name, Qt::Key_Return);
  });
  QSignalSpy finished(&views.files, &app::ViewFileController::finished);
  views.files.askAndSave();
  ASSERT_TRUE(waitFor([&] { return finished.count() > 0; }));
  EXPECT_TRUE(finished[0][0].toBool());
  EXPECT_TRUE(warning.contains("do not name the patient")) << warning.toStdString();
  EXPECT_FALSE(by_default);
  const auto read = app::readViewFile(folder.filePath("chosen.palpate-view").toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->place, "s.nrrd");
}

TEST(ViewFiles, TheScanIsFoundWhereItWasOpenBefore) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  views.measures().replace(someMarks());
  ASSERT_TRUE(views.save(path));
  const auto hash = app::readViewFile(path)->hash;
  FiledViews later;
  later.show(ballAt(3.0), 50.0);  // the same geometry, and another scan
  later.files.setKnown({.place = [&](const app::VolumeHash& sought) {
    return sought == hash ? fs::path(folder.path().toStdString()) : fs::path{};
  }});
  fs::path opened;
  QObject::connect(&later.files, &app::ViewFileController::scanWanted, [&](const fs::path& wanted) {
    opened = wanted;
    later.show(ballAt(0.0), 50.0);
    later.files.showScene(true);
  });
  EXPECT_TRUE(later.open(path)) << later.message().toStdString();
  EXPECT_EQ(opened, fs::path(folder.path().toStdString()));
  EXPECT_EQ(later.measures().all().size(), 2U);
}

TEST(ViewFiles, AScanThatIsNotFoundCanBeChosen) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  QFile(folder.filePath("s.nrrd")).open(QIODevice::WriteOnly);
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  views.measures().replace(someMarks());
  ASSERT_TRUE(views.save(path));
  FiledViews later;
  later.show(ballAt(0.0, 40), 50.0);
  window::showAndWait(later.window, {1240, 840});
  EXPECT_FALSE(later.open(path));
  auto* choose = later.window.findChild<QPushButton*>("takeOffer");
  ASSERT_TRUE(choose->isVisible());
  EXPECT_EQ(choose->text(), "Choose the scan…");
  fs::path opened;
  QObject::connect(&later.files, &app::ViewFileController::scanWanted, [&](const fs::path& wanted) {
    opened = wanted;
    later.show(ballAt(0.0), 50.0);
    later.files.showScene(true);
  });
  QTimer answers;
  QObject::connect(&answers, &QTimer::timeout, [&] {
    if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
      menu->setActiveAction(menu->actions()[1]);
      QTest::keyClick(menu, Qt::Key_Return);
    } else if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(folder.filePath("s.nrrd"));
      QMetaObject::invokeMethod(dialog, "accept");
    }
  });
  answers.start(50);
  QSignalSpy finished(&later.files, &app::ViewFileController::finished);
  choose->click();
  EXPECT_TRUE(waitFor([&] { return finished.count() > 0; }));
  EXPECT_EQ(opened.filename(), "s.nrrd");
  EXPECT_EQ(later.measures().all().size(), 2U) << later.message().toStdString();
}

TEST(ViewFiles, TheToolOfAFileIsFoundByItsHash) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("a.palpate-view").toStdString();
  const fs::path tool = folder.filePath("mine.obj").toStdString();
  const fs::path other = folder.filePath("other.obj").toStdString();
  for (const fs::path& file : {tool, other}) {
    QFile made(QString::fromStdString(file.string()));
    ASSERT_TRUE(made.open(QIODevice::WriteOnly));
    made.write(file.filename().string().c_str());
  }
  FiledViews views;
  views.show(ballAt(0.0), 50.0);
  views.shared.shown->tool = {.name = "mine",
                              .file = tool,
                              .unit = "cm",
                              .hash = app::hashOfFile(tool, app::installationKey().value())};
  ASSERT_TRUE(views.save(path));
  FiledViews later;
  later.show(ballAt(0.0), 50.0);
  std::vector<fs::path> known{other};
  later.files.setKnown({.tools = [&] { return known; }});

  app::ToolSource wanted;
  QObject::connect(&later.files, &app::ViewFileController::toolWanted,
                   [&](const app::ToolSource& source) { wanted = source; });
  EXPECT_TRUE(later.open(path));
  EXPECT_TRUE(waitFor([&] { return later.message().contains("comes from a file"); }));
  EXPECT_FALSE(wanted.file);
  known.push_back(tool);
  EXPECT_TRUE(later.open(path));
  EXPECT_TRUE(waitFor([&] { return wanted.file == tool; }));
  EXPECT_EQ(wanted.unit, "cm");
  // the search ends when another volume comes
  wanted = {};
  QObject::connect(&later.files, &app::ViewFileController::finished,
                   [&] { later.files.showScene(true); });
  EXPECT_TRUE(later.open(path));
  QTest::qWait(200);
  EXPECT_FALSE(wanted.file);
}

TEST(ViewFiles, SavingAgainAsksNothingAndTheFirstNameNamesNobody) {
  const Installation here;
  const QTemporaryDir folder;
  FiledViews views;
  views.show(ballAt(0.0), 50.0, "Somebody^Jane",
             fs::path(folder.path().toStdString()) / "Somebody.nrrd");
  window::showAndWait(views.window, {1240, 840});
  QString proposed;
  int dialogs = 0;
  QTimer::singleShot(300, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    ++dialogs;
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    proposed = name->text();
    name->setText(folder.filePath("chosen"));
    QTest::keyClick(name, Qt::Key_Return);
  });
  const auto save = [&] {
    QSignalSpy finished(&views.files, &app::ViewFileController::finished);
    views.window.findChild<QAction*>("saveView")->trigger();
    return waitFor([&] { return finished.count() > 0; });
  };
  ASSERT_TRUE(save());
  static const QRegularExpression form(
      R"(^(CT|Scan) \d{4}-\d\d-\d\d \d\d\.\d\d\.\d\d\.palpate-view$)");
  EXPECT_TRUE(form.match(proposed).hasMatch()) << proposed.toStdString();
  views.measures().replace(someMarks());
  ASSERT_TRUE(save());
  EXPECT_EQ(dialogs, 1);
  EXPECT_EQ(app::readViewFile(folder.filePath("chosen.palpate-view").toStdString())->marks.size(),
            2U);
}

TEST(ViewFiles, ClosingAsksAboutMarksThatAreInNoFile) {
  const Installation here;
  const QTemporaryDir folder;
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ui::MainWindow& window = application.window();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  QSignalSpy closing(&window, &ui::MainWindow::closing);
  application.marks().measures().replace(someMarks());
  {
    Answer answer("Cancel");
    window.close();
    EXPECT_TRUE(answer.said.contains("marks of this scan are not saved"))
        << answer.said.toStdString();
  }
  EXPECT_TRUE(window.isVisible());
  EXPECT_EQ(closing.count(), 0);
  // Enter means Cancel
  QTimer::singleShot(300, [] {
    window::keep(window::pictureOf(*QApplication::activeModalWidget()), "unsaved_question");
    QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Return);
  });
  window.close();
  EXPECT_TRUE(window.isVisible());
  // saved first: it closes when the file is there, and asks no more
  const QString path = folder.filePath("mine.palpate-view");
  {
    Answer answer("Save");
    const FileName name(path);
    window.close();
    EXPECT_TRUE(waitFor([&] { return !window.isVisible(); }));
  }
  EXPECT_EQ(closing.count(), 1);
  const auto read = app::readViewFile(path.toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->marks.size(), 2U);
}

TEST(ViewFiles, NothingIsAskedWhereNothingIsLostOrASignalEndsTheProgram) {
  const Installation here;
  {
    app::Application application(window::sphereInHand("mouse"));
    application.start();
    ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
    EXPECT_TRUE(application.window().close());
  }
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  application.marks().measures().replace(someMarks());
  QSignalSpy closing(&application.window(), &ui::MainWindow::closing);
  // with the question open, too
  QTimer::singleShot(500, [&] {
    EXPECT_NE(QApplication::activeModalWidget(), nullptr);
    application.end();
    for (QWidget* dialog = QApplication::activeModalWidget(); dialog != nullptr; dialog = nullptr)
      dialog->close();  // as the end of the program's loops does
  });
  application.window().close();
  EXPECT_EQ(closing.count(), 1);
  EXPECT_FALSE(application.window().isVisible());
  EXPECT_FALSE(application.session().isOpen());
}

TEST(ViewFiles, AnotherScanAsksAboutEditsAndNotAboutMarks) {
  const Installation here;
  const QTemporaryDir folder;
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  const auto title = [&] { return application.window().windowTitle(); };
  const auto open = [&](const char* phantom) {
    const QString before = title();
    emit application.window().menus().phantomWanted(phantom);
    return [&, before] { return waitFor([&] { return title() != before; }); };
  };
  application.marks().measures().replace(someMarks());
  EXPECT_TRUE(open("demo")());
  EXPECT_TRUE(application.marks().measures().all().empty());
  EXPECT_TRUE(open("sphere")());
  EXPECT_EQ(application.marks().measures().all().size(), 2U);

  const auto edited = [&] { return application.shown()->picture.volume->derivation != nullptr; };
  application.editing().restore({datasets::Crop{{{0, 0, 10}, {64, 64, 60}}}});
  ASSERT_TRUE(waitFor(edited));
  const QString cropped = title();
  {
    Answer answer("Cancel");
    emit application.window().menus().phantomWanted("demo");
    EXPECT_TRUE(waitFor([&] { return !answer.said.isEmpty(); }));
    EXPECT_TRUE(answer.said.contains("edits of this scan are not saved"))
        << answer.said.toStdString();
    EXPECT_FALSE(answer.said.contains("marks"));
  }
  QTest::qWait(200);
  EXPECT_TRUE(edited());
  EXPECT_EQ(title(), cropped);
  {
    Answer answer("Save");
    const FileName name(folder.filePath("cropped.palpate-view"));
    emit application.window().menus().phantomWanted("demo");
    EXPECT_TRUE(waitFor([&] { return title() != cropped; }));
  }
  EXPECT_FALSE(edited());
  const auto read = app::readViewFile(folder.filePath("cropped.palpate-view").toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->edits.size(), 1U);
  // the marks of the sphere were saved with it; nothing is left to ask about
  EXPECT_TRUE(application.window().close());
}

TEST(ViewFiles, AFileThatKnowsItsScanOpensItFromTheCommandLineAndByDrop) {
  const Installation here;
  const QTemporaryDir folder;
  const fs::path root = folder.path().toStdString();
  const auto ball = ballAt(0.0);
  fs::create_directory(root / "scans");
  ASSERT_TRUE(datasets::writeNrrd(*ball, root / "scans/ball.nrrd"));
  const fs::path path = root / "ball.palpate-view";
  {
    app::Arguments arguments = window::sphereInHand("mouse");
    arguments.load = {.path = root / "scans/ball.nrrd"};
    app::Application application(arguments);
    application.start();
    ASSERT_TRUE(waitFor([&] { return application.shown().has_value(); }));
    application.marks().measures().replace(someMarks());
    QSignalSpy finished(&application.viewFile(), &app::ViewFileController::finished);
    application.viewFile().save(path, true);
    ASSERT_TRUE(waitFor([&] { return finished.count() > 0; }));
    ASSERT_TRUE(finished[0][0].toBool());
  }
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.load = {.path = path};
  app::Application application(arguments);
  QSignalSpy finished(&application.viewFile(), &app::ViewFileController::finished);
  application.start();
  ASSERT_TRUE(waitFor([&] { return finished.count() > 0; }));
  EXPECT_TRUE(finished[0][0].toBool());
  ASSERT_TRUE(application.shown());
  EXPECT_EQ(application.shown()->place.filename(), "ball.nrrd");
  EXPECT_EQ(application.marks().measures().all().size(), 2U);

  application.marks().measures().clear();
  emit application.window().dropped({QString::fromStdString(path.string())});
  ASSERT_TRUE(waitFor([&] { return finished.count() > 1; }));
  EXPECT_TRUE(finished[1][0].toBool());
  EXPECT_EQ(application.marks().measures().all().size(), 2U);
  // the scan is gone: the sentence tells what the file wants
  fs::remove(root / "scans/ball.nrrd");
  emit application.window().menus().phantomWanted("sphere");
  ASSERT_TRUE(waitFor([&] { return application.shown()->place.empty(); }));
  emit application.window().dropped({QString::fromStdString(path.string())});
  ASSERT_TRUE(waitFor([&] { return finished.count() > 2; }));
  EXPECT_FALSE(finished[2][0].toBool());
  EXPECT_TRUE(application.window().findChild<QLabel*>("message")->text().contains("48 x 48 x 48"));
}

}  // namespace
