// SPDX-License-Identifier: BSD-3-Clause
// The whole application opens what users drop on it: folders of several series, scans that the
// memory does not hold, places that were opened before.
#include <gtest/gtest.h>
#include <signal.h>
#include <QAbstractButton>
#include <QAction>

#include <vtkActor.h>
#include <vtkFeatureEdges.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "app/application.h"
#include "app/window/program/recent_places.h"
#include "app/window/scan/loader.h"
#include "app/window/views/view_file_controller.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/session.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/made_scans.h"
#include "tests/support/places.h"
#include "tests/support/turned_scan.h"
#include "tests/ui/window_support.h"
#include "ui/dialogs/series_browser.h"
#include "ui/panels/device_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/views.h"

namespace {

using window::waitFor;

using support::anyScans;

std::filesystem::path mixedSeries() {
  return anyScans() / "philips_head_phantom/mixed_series_one_folder";
}
std::filesystem::path tiltedSeries() {
  return anyScans() / "dicom_oddities/series_failing/gantrytilting";
}

class Opening : public testing::Test {
 protected:
  Opening() { QSettings().clear(); }
  ~Opening() override { qunsetenv("TMPDIR"); }

  app::Application& start(app::Arguments arguments = {}) {
    if (!arguments.load.path) arguments.load.phantom = "sphere";
    arguments.surface = ui::SurfaceMode::Mesh;
    arguments.notice = false;
    application_ = std::make_unique<app::Application>(std::move(arguments));
    application_->start();
    return *application_;
  }

  /// With the phantom on show.
  app::Application& started(app::Arguments arguments = {}) {
    app::Application& application = start(std::move(arguments));
    EXPECT_TRUE(waitFor([&] { return application.shown().has_value(); }));
    return application;
  }

  void open(const std::filesystem::path& path) {
    emit application_->window().menus().openWanted(QString::fromStdString(path.string()));
  }

  ui::SeriesBrowser* browser() const {
    for (auto* found : application_->window().findChildren<ui::SeriesBrowser*>())
      if (found->isVisible()) return found;
    return nullptr;
  }

  bool loadedBegins(const QString& title) {
    return waitFor([&] { return application_->window().windowTitle().startsWith(title); });
  }

  const haptics::Volume& volume() const { return *application_->shown()->picture.volume; }
  QString title() const { return application_->window().windowTitle(); }
  QString message() const {
    const auto* label = application_->window().findChild<QLabel*>("message");
    return label->isVisible() ? label->text() : QString();
  }

  void drop(const QList<std::filesystem::path>& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& path : paths)
      urls << QUrl::fromLocalFile(QString::fromStdString(path.string()));
    data.setUrls(urls);
    QDragEnterEvent enter({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&application_->window(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&application_->window(), &event);
  }

  /// The menu of recent places, as it is when it opens.
  QList<QAction*> places() {
    auto* menu = application_->window().findChild<QMenu*>("recent");
    emit menu->aboutToShow();
    QList<QAction*> places;
    for (QAction* action : menu->actions()) {
      if (action->isSeparator()) break;
      places << action;
    }
    return places;
  }

  QAction* action(const char* name) { return application_->window().findChild<QAction*>(name); }

  /// Answers the next question by a word on one of its buttons.
  void answerNext(const QString& word) {
    QTimer::singleShot(0, application_.get(), [this, word] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return answerNext(word);
      asked_ = box->text();
      for (QAbstractButton* button : box->buttons())
        if (button->text().contains(word)) return button->click();
      ADD_FAILURE() << "no such button";
      box->reject();
    });
  }

  std::unique_ptr<app::Application> application_;
  QString asked_;
};

TEST_F(Opening, AFolderOfSeveralSeriesIsListedAndOneClickLoadsTheRightOne) {
  started();
  open(mixedSeries());
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  auto* table = browser()->findChild<QTableWidget*>("series");
  ASSERT_EQ(table->rowCount(), 4);
  // pictures come by themselves, the last of them of what is stored in colour and has none
  const auto picture = [&](int row) {
    return table->item(row, 0)->icon().pixmap(72, 72).toImage().convertToFormat(
        QImage::Format_RGB32);
  };
  ASSERT_TRUE(waitFor([&] { return table->item(3, 0)->text() == "no picture"; }));
  for (const int row : {1, 2})
    EXPECT_GT(window::count(picture(row), [](QColor c) { return c.lightness() > 120; }), 100)
        << row;
  window::keep(window::pictureOf(*browser()), "series_browser_real");

  // a refused one says why, and Enter does nothing
  table->selectRow(3);
  auto* details = browser()->findChild<QPlainTextEdit*>("seriesDetails");
  EXPECT_TRUE(details->toPlainText().contains("colour")) << details->toPlainText().toStdString();
  QTest::keyClick(table, Qt::Key_Return);
  QTest::qWait(100);
  ASSERT_NE(browser(), nullptr);
  EXPECT_TRUE(title().startsWith("sphere"));

  for (const int row : {2, 1}) {
    QTest::mouseClick(browser()->findChild<QPushButton*>(QString("load%1").arg(row)),
                      Qt::LeftButton);
    EXPECT_EQ(browser(), nullptr);
    const auto wanted = datasets::readVolume(mixedSeries(), {.series = row});
    ASSERT_TRUE(wanted.has_value());
    const auto same = [&] {
      return volume().grid.dims == wanted->grid.dims &&
             std::memcmp(volume().voxels.get(), wanted->voxels.get(),
                         static_cast<std::size_t>(wanted->grid.voxelCount()) *
                             haptics::sizeOf(wanted->type)) == 0;
    };
    EXPECT_TRUE(waitFor(same)) << row;
    EXPECT_EQ(volume().grid.spacing, wanted->grid.spacing);
    EXPECT_TRUE(title().startsWith("mixed_series_one_folder: ")) << title().toStdString();
    // the list can be had again
    ASSERT_TRUE(action("seriesOfThisFolder")->isEnabled());
    action("seriesOfThisFolder")->trigger();
    ASSERT_NE(browser(), nullptr);
    table = browser()->findChild<QTableWidget*>("series");
    EXPECT_EQ(table->horizontalHeaderItem(0)->text(), "Middle slice");
  }
}

TEST_F(Opening, AFolderOfOneSoundSeriesLoadsAtOnceAndClosesAListThatIsOpen) {
  started();
  open(mixedSeries());
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  open(anyScans() / "philips_head_phantom/bone_1mm");
  ASSERT_TRUE(loadedBegins("bone_1mm —"));
  EXPECT_EQ(browser(), nullptr);
  EXPECT_EQ(volume().grid.dims, (std::array<std::int64_t, 3>{512, 512, 48}));
}

/// A series of small slices at these heights.
void writeSeries(const QTemporaryDir& folder, const char* number,
                 const std::vector<double>& heights_mm,
                 const std::vector<datasets::testing::Element>& more = {}) {
  for (std::size_t k = 0; k < heights_mm.size(); ++k) {
    datasets::testing::DicomSlice slice;
    slice.series += number;
    slice.instance += std::string(number) + "." + std::to_string(k + 1);
    slice.position_mm = {0, 0, heights_mm[k]};
    slice.rows = slice.columns = 8;
    for (int n = 0; n < 64; ++n) slice.pixels.push_back(std::int16_t(n % 8 < 4 ? -1000 : 500));
    const std::string bytes = edited(bytesOf(slice), more);
    QFile file(folder.filePath(QString("%1-%2").arg(number).arg(k)));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(bytes.data(), qint64(bytes.size()));
  }
}

TEST_F(Opening, TheListShowsTheFrontAboveHoweverTheFilesAreStored) {
  const QTemporaryDir folder;
  for (const auto& [name, bytes] : turned::frontFiles()) {
    QFile file(folder.filePath(QString::fromStdString(name)));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(bytes.data(), qint64(bytes.size()));
  }
  started();
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  auto* table = browser()->findChild<QTableWidget*>("series");
  ASSERT_EQ(table->rowCount(), 3);
  const auto pictureAt = [&](int row) {
    return table->item(row, 0)->icon().pixmap(ui::SeriesBrowser::kThumbnail).toImage();
  };
  const auto lightness = [&](int row, double x, double y) {
    const QImage seen = pictureAt(row);
    return seen.pixelColor(int(x * seen.width()), int(y * seen.height())).lightness();
  };
  const auto drawn = [&](int row) { return lightness(row, 0.3, 0.25) > 240; };
  EXPECT_TRUE(waitFor([&] { return drawn(0) && drawn(1) && drawn(2); }));
  window::keep(window::pictureOf(*browser()), "series_browser_turned");
  EXPECT_EQ(pictureAt(0), pictureAt(1));
  EXPECT_NEAR(lightness(0, 0.7, 0.25), 127, 6);
  EXPECT_LT(lightness(0, 0.3, 0.75), 15);
  EXPECT_TRUE(table->item(0, 0)->toolTip().isEmpty());
  EXPECT_TRUE(table->item(2, 0)->toolTip().contains("left and right are unknown"));
}

// The half of the slices that is solid ends with them. The tool stops there, and so does the eye.
TEST_F(Opening, TheSurfaceIsClosedWhereTheScanEnds) {
  const QTemporaryDir folder;
  writeSeries(folder, ".1", {0, 1, 2, 3});
  started();
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return !title().startsWith("sphere"); }));
  ui::VolumeView& view = application_->window().views().volume();
  window::pictureAtRest(view);
  auto* mapper = vtkPolyDataMapper::SafeDownCast(view.surface().mesh()->GetMapper());
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mapper->GetInput());
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  EXPECT_GT(mapper->GetInput()->GetNumberOfPolys(), 100);
  EXPECT_EQ(edges->GetOutput()->GetNumberOfLines(), 0);
}

TEST_F(Opening, SlicesBeginWithTheWindowThatTheSeriesStates) {
  const QTemporaryDir folder;
  writeSeries(folder, ".1", {0, 1, 2, 3},
              {{0x28, 0x1050, "DS", "-50\\40"},
               {0x28, 0x1051, "DS", "1200\\400"},
               {0x28, 0x1055, "LO", "WIDE\\SOFT"}});
  started();
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return !title().startsWith("sphere"); }));
  ui::SliceSet& slices = application_->window().views().slices();
  EXPECT_EQ(slices.grey().level, -50.0);
  EXPECT_EQ(slices.grey().width, 1200.0);
  const auto presets = slices.menu().findChild<QMenu*>("greyMenu")->actions();
  EXPECT_EQ(presets[0]->text(), "As in the file: WIDE (W 1200, L -50)");
  EXPECT_EQ(presets[1]->text(), "As in the file: SOFT (W 400, L 40)");
  // what was chosen stays when another tool is taken
  presets[1]->trigger();
  emit window::panelOf<ui::DevicePanel>(application_->window()).toolChosen("sphere");
  ASSERT_TRUE(waitFor([&] { return application_->shown()->tool.name == "sphere"; }));
  EXPECT_EQ(slices.grey().width, 400.0);
  action("greyReset")->trigger();
  EXPECT_EQ(slices.grey().width, 1200.0);
}

TEST_F(Opening, TheOnlySoundSeriesIsNotLoadedWithoutAWordAboutALargerOne) {
  const QTemporaryDir folder;
  writeSeries(folder, ".1", {0, 1, 2, 3});
  writeSeries(folder, ".2", {0, 1, 2, 4, 5, 6, 7, 8, 20, 21});
  started();
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  EXPECT_TRUE(title().startsWith("sphere"));
  auto* table = browser()->findChild<QTableWidget*>("series");
  ASSERT_EQ(table->rowCount(), 2);
  int lacking = table->item(0, 6)->text() == "in part" ? 0 : 1;
  EXPECT_EQ(table->item(1 - lacking, 6)->text(), "sound");
  EXPECT_EQ(table->currentRow(), 1 - lacking);
  EXPECT_EQ(table->item(lacking, 6)->text(), "in part");
  EXPECT_EQ(table->item(lacking, 4)->text(), QString::fromUtf8("8 × 8 × 5 of 10"));
  table->selectRow(lacking);
  auto* details = browser()->findChild<QPlainTextEdit*>("seriesDetails");
  EXPECT_TRUE(details->toPlainText().contains("from 4.0 to 8.0 mm"))
      << details->toPlainText().toStdString();
  window::keep(window::pictureOf(*browser()), "series_browser_in_part");

  auto* load = browser()->findChild<QPushButton*>(QString("load%1").arg(lacking));
  ASSERT_NE(load, nullptr);
  answerNext("Cancel");
  QTest::mouseClick(load, Qt::LeftButton);
  EXPECT_TRUE(asked_.contains("5 of the 10 slices")) << asked_.toStdString();
  EXPECT_TRUE(title().startsWith("sphere"));
  answerNext("largest unbroken part");
  QTest::mouseClick(load, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return title().contains("(5 of 10 slices)"); }))
      << title().toStdString() << message().toStdString();
  EXPECT_EQ(volume().grid.dims, (std::array<std::int64_t, 3>{8, 8, 5}));
  EXPECT_NEAR(volume().grid.origin.z(), 4e-3, 1e-12);
  EXPECT_EQ(volume().slices_left_out, 5);
}

TEST_F(Opening, TheSeriesOfAViewIsTakenWithoutAQuestion) {
  const QTemporaryDir folder, views;
  writeSeries(folder, ".1", {0, 1, 2, 3});
  writeSeries(folder, ".2", {0, 1, 2, 3, 4, 5});
  writeSeries(folder, ".3", {0, 1, 2, 4, 5, 6, 7, 8});  // in part
  started();
  const auto dims = [&] { return volume().grid.dims; };
  const QStringList saved{views.filePath("1.palpate-view"), views.filePath("3.palpate-view")};
  const auto choose = [&](std::int64_t slices, const QString& view) {
    open(folder.path().toStdString());
    ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
    auto* table = browser()->findChild<QTableWidget*>("series");
    EXPECT_TRUE(table->item(table->currentRow(), 4)->text().endsWith("× 6"));  // the largest
    for (int row = 0; row < table->rowCount(); ++row)
      if (table->item(row, 4)->text().startsWith(QString("8 × 8 × %1").arg(slices)))
        browser()->findChild<QPushButton*>(QString("load%1").arg(row))->click();
    ASSERT_TRUE(waitFor([&] { return dims()[2] == slices; }));
    QSignalSpy ended(&application_->viewFile(), &app::ViewFileController::finished);
    application_->viewFile().save(view.toStdString(), true);
    ASSERT_TRUE(waitFor([&] { return ended.count() > 0; }));
  };
  choose(4, saved[0]);
  answerNext("largest unbroken part");
  choose(5, saved[1]);
  for (const int slices : {4, 5}) {
    const auto& view = saved[slices - 4];
    if (slices == 5) answerNext("largest unbroken part");
    open(view.toStdString());
    EXPECT_TRUE(waitFor([&] { return dims()[2] == slices || browser() != nullptr; }));
    EXPECT_EQ(browser(), nullptr);
    EXPECT_EQ(dims()[2], slices);
  }
}

TEST_F(Opening, ASeriesAloneThatLacksSlicesOffersItsLargestPart) {
  const QTemporaryDir folder;
  writeSeries(folder, ".1", {0, 1, 2, 4, 5, 6, 7, 8});
  started();
  answerNext("largest unbroken part");
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return title().contains("(5 of 8 slices)"); }));
  EXPECT_EQ(browser(), nullptr);
}

TEST_F(Opening, ASmallerSeriesThatIsRefusedIsNoReasonToAsk) {
  const QTemporaryDir folder;
  writeSeries(folder, ".1", {0, 1, 2, 3});
  writeSeries(folder, ".2", {0, 1, 1});
  started();
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return !title().startsWith("sphere"); }));
  EXPECT_EQ(browser(), nullptr);
  EXPECT_EQ(volume().grid.dims[2], 4);
}

TEST_F(Opening, ACorrectableSeriesOfSeveralAsksFirst) {
  QTemporaryDir folder;
  for (const auto& [name, from] :
       {std::pair{"tilted", tiltedSeries()}, std::pair{"mixed", mixedSeries()}})
    std::filesystem::copy(from, std::filesystem::path(folder.path().toStdString()) / name);
  started();
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  auto* table = browser()->findChild<QTableWidget*>("series");
  int row = 0;
  for (int i = 0; i < table->rowCount(); ++i)
    if (table->item(i, 6)->text() == "correctable") row = i;
  ASSERT_EQ(table->item(row, 6)->text(), "correctable");
  auto* load = browser()->findChild<QPushButton*>(QString("load%1").arg(row));
  answerNext("Cancel");
  QTest::mouseClick(load, Qt::LeftButton);
  EXPECT_TRUE(asked_.contains("tilt")) << asked_.toStdString();
  ASSERT_NE(browser(), nullptr);  // to choose another
  EXPECT_TRUE(title().startsWith("sphere"));
  answerNext("Resample");
  QTest::mouseClick(load, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return title().contains("(resampled)"); }));
  EXPECT_TRUE(volume().resampled);
}

TEST_F(Opening, AViewWaitsUntilItIsSaidWhetherItsScanIsResampled) {
  const QTemporaryDir folder;
  const std::filesystem::path root = folder.path().toStdString();
  std::filesystem::copy(tiltedSeries(), root / "tilted");
  app::Application& application = started();
  answerNext("Resample");
  open(root / "tilted");
  ASSERT_TRUE(waitFor([&] { return title().contains("(resampled)"); }));
  QSignalSpy finished(&application.viewFile(), &app::ViewFileController::finished);
  application.viewFile().save(root / "tilted.palpate-view", true);
  ASSERT_TRUE(waitFor([&] { return finished.count() > 0; }));
  emit application.window().menus().phantomWanted("sphere");
  ASSERT_TRUE(loadedBegins("sphere"));
  asked_.clear();
  answerNext("Resample");
  emit application.window().menus().viewWanted(
      QString::fromStdString((root / "tilted.palpate-view").string()));
  ASSERT_TRUE(waitFor([&] { return finished.count() > 1; }));
  EXPECT_TRUE(finished[1][0].toBool());
  EXPECT_TRUE(asked_.contains("tilt")) << asked_.toStdString();
  EXPECT_TRUE(title().contains("(resampled)"));
}

TEST_F(Opening, FilesOfAStudyEachAreLoadedAsOneStackIfTheUserSaysSo) {
  QTemporaryDir folder;
  for (int k = 0; k < 4; ++k) {
    datasets::testing::DicomSlice slice;
    const std::string own = std::to_string(k + 1);
    slice.instance += "." + own;
    slice.series += "." + own;
    slice.position_mm = {0, 0, double(k)};
    slice.columns = slice.rows = 2;
    slice.pixels = {0, 100, 200, std::int16_t(300 + k)};
    std::ofstream(std::filesystem::path(folder.path().toStdString()) / own, std::ios::binary)
        << datasets::testing::edited(bytesOf(slice), {{0x20, 0xd, "UI", "1.9." + own}});
  }
  started();
  answerNext("Load as one stack");
  open(folder.path().toStdString());
  ASSERT_TRUE(waitFor([&] { return !title().startsWith("sphere"); }));
  EXPECT_TRUE(asked_.contains("4 files of 4 studies fit together")) << asked_.toStdString();
  EXPECT_EQ(volume().grid.dims[2], 4);
  EXPECT_FALSE(volume().resampled);
}

TEST_F(Opening, SeveralFilesOnTheCommandLineStandForTheirFolder) {
  app::Arguments arguments;
  for (const char* name : {"IM0003", "IM0005"})
    arguments.paths.append(QString::fromStdString((mixedSeries() / name).string()));
  start(std::move(arguments));
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  EXPECT_EQ(browser()->findChild<QTableWidget*>("series")->rowCount(), 4);
}

TEST_F(Opening, DroppedFilesOfOneFolderStandForTheFolderAndOthersAreSaid) {
  started();
  drop({mixedSeries() / "IM0003", mixedSeries() / "IM0005", mixedSeries() / "DIRFILE"});
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  EXPECT_EQ(browser()->findChild<QTableWidget*>("series")->rowCount(), 4);
  EXPECT_EQ(message(), "");
  // a single slice is enough for its series, and a folder may end with a slash
  drop({anyScans() / "philips_head_phantom/bone_1mm/I100"});
  ASSERT_TRUE(loadedBegins("I100 —"));
  EXPECT_EQ(volume().grid.dims[2], 48);
  drop({tiltedSeries().parent_path() / "slicecount/", mixedSeries()});
  EXPECT_TRUE(message().contains("only the first, \"slicecount\"")) << message().toStdString();
  ASSERT_TRUE(loadedBegins("slicecount —"));
}

TEST_F(Opening, WhatTheMemoryDoesNotHoldIsOfferedInPart) {
  app::Arguments arguments;
  arguments.free_memory = [] { return 1e6; };  // of 2.1 MB
  started(arguments);
  open(mixedSeries());
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  answerNext("second voxel");
  QTest::mouseClick(browser()->findChild<QPushButton*>("load1"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return title().contains("(every 2nd voxel)"); }));
  EXPECT_TRUE(asked_.contains("1 MB") || asked_.contains("1.0 MB")) << asked_.toStdString();
  EXPECT_EQ(volume().grid.dims, (std::array<std::int64_t, 3>{256, 256, 2}));
  EXPECT_NEAR(volume().grid.spacing.z(), 2e-3, 1e-9);

  // a box: the middle half along each axis, if nothing is changed
  const auto whole = datasets::readVolume(mixedSeries(), {.series = 1});
  ASSERT_TRUE(whole.has_value());
  action("seriesOfThisFolder")->trigger();
  answerNext("box");
  QTimer reads;  // the box, when the dialog for it has come after the question
  QObject::connect(&reads, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    auto* read = dialog == nullptr ? nullptr : dialog->findChild<QPushButton*>("readBox");
    if (read == nullptr) return;
    reads.stop();
    read->click();
  });
  reads.start(20);
  QTest::mouseClick(browser()->findChild<QPushButton*>("load1"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return title().contains("(a box)"); }));
  EXPECT_EQ(volume().grid.dims, (std::array<std::int64_t, 3>{256, 256, 2}));
  EXPECT_EQ(volume().grid.spacing, whole->grid.spacing);
  EXPECT_NEAR((volume().grid.origin - whole->grid.worldOf({128.0, 128.0, 1.0})).norm(), 0.0, 1e-12);

  action("seriesOfThisFolder")->trigger();
  answerNext("Cancel");
  asked_.clear();
  QTest::mouseClick(browser()->findChild<QPushButton*>("load2"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !asked_.isEmpty(); }));
  QTest::qWait(100);
  EXPECT_TRUE(title().contains("(a box)"));
}

/// A folder of a person's own beside one for temporary files.
struct Disk {
  Disk() {
    QDir(folder.path()).mkpath("tmp");
    QDir(folder.path()).mkpath("own");
    qputenv("TMPDIR", tmp().toUtf8());
  }
  QString tmp() const { return folder.path() + "/tmp"; }
  QString own() const { return folder.path() + "/own"; }
  QTemporaryDir folder;
};

TEST_F(Opening, PlacesAreOfferedAgainUntilTheyAreForgotten) {
  const Disk disk;
  const std::filesystem::path own = disk.own().toStdString();
  std::filesystem::copy(tiltedSeries().parent_path() / "slicecount", own / "one & two");
  std::filesystem::copy(anyScans() / "nrrd_oddities/derived_from_tooth/raw_le.nrrd",
                        own / "a.nrrd");
  // of another grid: what has that of the scan on view may be its structures, and the user is asked
  std::filesystem::copy(anyScans() / "nrrd_oddities/derived_from_tooth/ascii.nrrd",
                        std::filesystem::path(disk.tmp().toStdString()) / "t.nrrd");
  started();
  EXPECT_TRUE(places().isEmpty());
  // of a slice its folder is kept, of a volume the file, of a temporary one nothing
  for (const auto& entry : std::filesystem::directory_iterator(own / "one & two")) {
    open(entry.path());
    ASSERT_TRUE(loadedBegins(QString::fromStdString(entry.path().filename().string())));
  }
  open(own / "a.nrrd");
  ASSERT_TRUE(loadedBegins("a.nrrd"));
  open(std::filesystem::path(disk.tmp().toStdString()) / "t.nrrd");
  ASSERT_TRUE(loadedBegins("t.nrrd"));
  open(own / "nothing.nrrd");
  ASSERT_TRUE(waitFor([&] { return !message().isEmpty(); }));
  // what was refused, and what is still shown
  EXPECT_TRUE(message().startsWith("\"nothing.nrrd\" was not opened. ")) << message().toStdString();
  EXPECT_TRUE(message().endsWith(" Still shown: t.nrrd.")) << message().toStdString();
  ASSERT_EQ(places().size(), 2);
  EXPECT_EQ(places()[0]->toolTip(), disk.own() + "/a.nrrd");
  EXPECT_EQ(places()[1]->toolTip(), disk.own() + "/one & two");
  EXPECT_TRUE(places()[1]->isEnabled());

  places()[1]->trigger();
  ASSERT_TRUE(loadedBegins("one & two"));
  EXPECT_EQ(places()[0]->toolTip(), disk.own() + "/one & two");
  std::filesystem::remove(own / "a.nrrd");
  EXPECT_FALSE(places()[1]->isEnabled());

  // another run knows them
  started();
  EXPECT_EQ(places().size(), 2);
  action("forgetPlaces")->trigger();
  EXPECT_TRUE(places().isEmpty());
  EXPECT_FALSE(QSettings().contains("places/recent"));

  open(own / "one & two");
  ASSERT_TRUE(loadedBegins("one & two"));
  EXPECT_EQ(places().size(), 1);
  action("rememberPlaces")->trigger();
  EXPECT_TRUE(places().isEmpty());
  EXPECT_FALSE(QSettings().contains("places/recent"));
  open(own / "one & two");
  QSignalSpy adopted(application_.get(), &app::Application::adopted);
  ASSERT_TRUE(adopted.wait(60'000));
  EXPECT_TRUE(places().isEmpty());
}

TEST_F(Opening, TheNextScanIsLookedForWhereTheLastOneLay) {
  const Disk disk;
  const auto begins = [this] {
    QString folder;
    QTimer::singleShot(0, [&] {
      if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
        folder = dialog->directory().absolutePath();
        dialog->reject();
      }
    });
    action("openFile")->trigger();
    return folder;
  };
  started();
  // of two grids: what has that of the scan on view may be its structures, and the user is asked
  for (const auto& [name, of] : {std::pair<QString, const char*>{"one", "raw_le.nrrd"},
                                 std::pair<QString, const char*>{"other", "ascii.nrrd"}}) {
    const QString folder = disk.own() + '/' + name;
    QDir(disk.own()).mkpath(name);
    const QString scan = folder + '/' + name + ".nrrd";
    std::filesystem::copy(anyScans() / "nrrd_oddities/derived_from_tooth" / of, scan.toStdString());
    drop({scan.toStdString()});
    ASSERT_TRUE(loadedBegins(name + ".nrrd"));
    EXPECT_EQ(begins(), QDir(folder).absolutePath());
  }
  // and at the next start, where nothing of it is open
  started();
  EXPECT_EQ(begins(), QDir(disk.own() + "/other").absolutePath());
}

TEST_F(Opening, TheNewestEightPlacesAreKept) {
  const Disk disk;
  QStringList places;
  for (int i = 0; i < 12; ++i) places = app::withPlace(places, QString("/scan%1").arg(i));
  places = app::withPlace(places, "/scan7");
  ASSERT_EQ(places.size(), 8);
  EXPECT_EQ(places.mid(0, 3), (QStringList{"/scan7", "/scan11", "/scan10"}));
  EXPECT_EQ(app::withPlace(places, disk.tmp()), places);
  EXPECT_EQ(app::withPlace(places, {}), places);
  EXPECT_TRUE(app::isTemporary(disk.tmp()));
  EXPECT_FALSE(app::isTemporary(disk.own()));
}

TEST_F(Opening, AfterAKillTheWindowIsEmptyAndNothingIsAsked) {
  const Disk disk;
  const QString scan = disk.own() + "/scan.nrrd";
  std::filesystem::copy(anyScans() / "nrrd_oddities/derived_from_tooth/raw_le.nrrd",
                        scan.toStdString());
  // the program itself, with the preferences of these tests
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  const QString settings = QSettings().fileName();
  environment.insert("XDG_CONFIG_HOME", QFileInfo(QFileInfo(settings).path()).path());
  program.setProcessEnvironment(environment);
  program.start(QString::fromStdString(places::built("app/palpate")),
                {scan, "--no-notice", "--surface", "mesh"});
  ASSERT_TRUE(program.waitForStarted());
  const auto known = [&] {
    QFile file(settings);
    return file.open(QFile::ReadOnly) && file.readAll().contains("scan.nrrd");
  };
  const bool loaded = waitFor(known);
  program.kill();
  program.waitForFinished();
  ASSERT_TRUE(loaded);
  EXPECT_EQ(program.exitStatus(), QProcess::CrashExit);

  app::Arguments arguments;
  arguments.notice = false;
  arguments.surface = ui::SurfaceMode::Mesh;
  application_ = std::make_unique<app::Application>(arguments);
  int dialogs = 0;
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout,
                   [&] { dialogs += QApplication::activeModalWidget() != nullptr; });
  watch.start(20);
  application_->start();
  QTest::qWait(1500);
  EXPECT_EQ(dialogs, 0);
  EXPECT_EQ(browser(), nullptr);
  EXPECT_EQ(title(), "Palpate");
  EXPECT_EQ(places().size(), 1);  // it is offered, and not opened
}

TEST_F(Opening, AnArchiveIsListedAndLeavesNothingBehind) {
  const QTemporaryDir temporary, made;
  const QString archive = made.filePath("disk.tar");
  ASSERT_EQ(QProcess::execute(
                "tar", {"-cf", archive, "-C", QString::fromStdString(mixedSeries().string()), "."}),
            0);
  qputenv("TMPDIR", temporary.path().toLocal8Bit());
  started();
  drop({archive.toStdString()});
  ASSERT_TRUE(waitFor([&] { return browser() != nullptr; }));
  EXPECT_FALSE(QDir(temporary.path()).isEmpty());
  QTest::mouseClick(browser()->findChild<QPushButton*>("load1"), Qt::LeftButton);
  ASSERT_TRUE(loadedBegins("disk.tar: ")) << title().toStdString();
  const auto wanted = datasets::readVolume(mixedSeries(), {.series = 1});
  ASSERT_TRUE(wanted.has_value());
  EXPECT_EQ(volume().grid.dims, wanted->grid.dims);
  application_.reset();
  EXPECT_TRUE(QDir(temporary.path()).isEmpty());
}

// Whether it is structures of the scan on view is still being looked at.
TEST_F(Opening, WhatIsDroppedOrOpenedAsAnotherScanComesOnViewIsOpenedToo) {
  const auto scan = anyScans() / "philips_head_phantom/bone_1mm";
  for (const bool dropped : {true, false}) {
    app::Application& application = started();
    QObject once;
    QObject::connect(&application, &app::Application::adopted, &once, [&] {
      QObject::disconnect(&application, nullptr, &once, nullptr);
      if (dropped)
        drop({scan});
      else
        open(scan);
    });
    const QString before = title();
    emit application.window().menus().phantomWanted("torus");
    ASSERT_TRUE(waitFor([&] { return title() != before; }));
    const QString torus = title();
    EXPECT_TRUE(waitFor([&] { return title() != torus; }));
    EXPECT_EQ(application.shown()->place.filename(), scan.filename());
  }
}

}  // namespace
