// SPDX-License-Identifier: BSD-3-Clause
// Structures while the tool moves: distances, how they are felt, recordings, reports, and what is
// found with a scan.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QLayout>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QTextBrowser>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/recording/felt_words.h"
#include "app/recording/recording.h"
#include "app/window/sessions/replay.h"
#include "app/window/sessions/session_recording.h"
#include "app/window/structures/report_controller.h"
#include "haptics/session.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/views/structures_window.h"
#include "tests/unit/datasets/dicom_label_bytes.h"
#include "ui/controls/elided_label.h"
#include "ui/controls/number_box.h"
#include "ui/dialogs/report_moments.h"
#include "ui/dialogs/series_browser.h"
#include "ui/style/scene_colours.h"
#include "ui/views/volume_view.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"

namespace {

using namespace structures;
using haptics::Vec3;

class StructuresTouch : public StructuresWindow {
 protected:
  QComboBox& feel() { return part<QComboBox>("structureFeel"); }
  void chooseFeel(ui::StructureFeel::Kind kind) {
    feel().setCurrentIndex(feel().findData(static_cast<int>(kind)));
  }
  QString status() { return part<QLabel>("statusLine").text(); }
  haptics::Nearness nearOf(std::uint8_t number) {
    for (const haptics::Nearness& near : application_->snapshot().near)
      if (near.structure == number) return near;
    return {.structure = 255};
  }
  bool isNear(std::uint8_t number) { return nearOf(number).structure == number; }
  void record(bool on) {
    auto& button = part<QAbstractButton>("record");
    QTest::mouseClick(&button, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return application_->recording().isRecording() == on; }));
  }
  std::filesystem::path recorded() {
    for (const auto& file : std::filesystem::directory_iterator(path("recordings").toStdString()))
      if (file.path().extension() == ".palpate") return file.path();
    return {};
  }
  /// The tip goes to this place.
  void bringTip(const Eigen::Vector3d& p_mm) {
    haptics::Pose X_WT = application_->snapshot().X_WP;
    X_WT.translation() =
        p_mm / ui::kMmPerM - X_WT.linear() * application_->shown()->scene->tool.shell.tip;
    application_->session().bring(X_WT, X_WT);
  }
  haptics::Vec3 tip() {
    return application_->snapshot().X_WP * application_->shown()->scene->tool.shell.tip;
  }
};

TEST_F(StructuresTouch, TheNearestIsToldInTheCardTheListAndTheStatusLine) {
  start();
  EXPECT_FALSE(status().contains("Nearest")) << status().toStdString();
  list().selectRow(0);
  part<QCheckBox>("watchStructure").click();
  list().selectRow(2);
  part<QCheckBox>("watchStructure").click();
  ASSERT_TRUE(waitFor([&] { return isNear(0) && isNear(2); }));
  // 7 mm before the nerve's surface, from the patient's left
  const Eigen::Vector3d place = kNerve + Eigen::Vector3d{11.0, 0.0, 0.0};
  bringTip(place);
  ASSERT_TRUE(waitFor([&] { return (tip() * ui::kMmPerM - place).norm() < 0.5; }));
  ASSERT_TRUE(waitFor([&] { return std::abs(nearOf(0).tip * ui::kMmPerM - 7.0) < 0.6; }))
      << nearOf(0).tip;
  // the other one is a ball, too, and farther
  const double other = (tip() * ui::kMmPerM - kSinus).norm() - 3.0;
  EXPECT_NEAR(nearOf(2).tip * ui::kMmPerM, std::min(other, 20.0), 0.6);
  const QString said = QLocale().toString(double(nearOf(0).nearest) * ui::kMmPerM, 'f', 1);
  ASSERT_TRUE(waitFor([&] { return status().contains("Nearest: " + QString(kSecret)); }))
      << status().toStdString();
  EXPECT_TRUE(status().contains(" mm")) << status().toStdString();
  EXPECT_TRUE(waitFor([&] { return list().item(0, 3)->text() == said + " mm"; }))
      << list().item(0, 3)->text().toStdString() << " " << said.toStdString();
  // a line leads from the tip to the structure, and has its length
  const auto wayNow = [&] { return structures().nearLine().way(); };
  ASSERT_TRUE(waitFor([&] {
    return wayNow() && wayNow()->words ==
                           QLocale().toString(double(nearOf(0).tip) * ui::kMmPerM, 'f', 1) + " mm";
  }));
  EXPECT_LT((wayNow()->tip_mm - tip() * ui::kMmPerM).norm(), 0.1);
  EXPECT_LT((wayNow()->structure_mm - (kNerve + Eigen::Vector3d{4.0, 0.0, 0.0})).norm(), 0.8);
  views().volume().lookFrom(ui::Side::Anterior);
  const auto isLine = [](QColor c) {
    const QColor line = ui::style::kMeasure;
    return std::abs(c.red() - line.red()) + std::abs(c.green() - line.green()) +
               std::abs(c.blue() - line.blue()) <
           60;
  };
  EXPECT_GT(window::count(views().volume().picture(1.0), isLine), 10);
  window::keep(views().volume().picture(1.0), "structures_near_line");
  // beside the force, in whatever form the card has
  const auto& card = part<QWidget>("forceCard");
  auto& large = part<QLabel>("nearness0");
  EXPECT_TRUE(waitFor([&] {
    return large.isVisible() && large.text().startsWith(said + " mm") &&
           card.rect().contains(QRect(large.mapTo(&card, QPoint{}), large.size()));
  })) << large.text().toStdString();
  window::keep(window::pictureOf(window()), "structures_near");
  // the distance stands there whole, and a long name gives way to it
  list().item(0, 2)->setText("Facial nerve, its vertical part (left)");
  const auto& name = part<ui::ElidedLabel>("nearnessName0");
  EXPECT_TRUE(waitFor([&] {
    return name.shownText().startsWith("Faci") && name.shownText().endsWith(QChar(0x2026));
  })) << name.shownText().toStdString();
  EXPECT_GE(name.shownText().size(), 5);
  EXPECT_TRUE(waitFor([&] { return name.toolTip().contains("vertical part (left)"); }))
      << name.toolTip().toStdString();
  const auto isWhole = [&] {
    return large.width() >= large.fontMetrics().horizontalAdvance(large.text()) &&
           card.rect().contains(QRect(large.mapTo(&card, QPoint{}), large.size()));
  };
  EXPECT_TRUE(isWhole()) << large.text().toStdString();
  list().item(0, 2)->setText(kSecret);
  // what is close is near, too: one limit takes the other with it
  part<ui::NumberBox>("closeFrom").setValue(9.0);
  EXPECT_EQ(part<ui::NumberBox>("nearFrom").value(), 9.0);
  part<ui::NumberBox>("nearFrom").setValue(1.0);
  EXPECT_EQ(part<ui::NumberBox>("closeFrom").value(), 1.0);
  EXPECT_EQ(structures().limits(), (ui::NearLimits{1.0, 1.0}));
  // closer than the limits, it says so in words
  part<ui::NumberBox>("nearFrom").setValue(20.0);
  EXPECT_TRUE(waitFor([&] { return status().contains(", near"); })) << status().toStdString();
  part<ui::NumberBox>("closeFrom").setValue(20.0);
  EXPECT_TRUE(waitFor([&] { return status().contains(", close"); })) << status().toStdString();
  EXPECT_TRUE(waitFor([&] { return large.text().endsWith(", close") && isWhole(); }))
      << large.text().toStdString();
  window::keep(window::pictureOf(window()), "structures_close");
  // the tool moves to the other one
  bringTip(kSinus + Eigen::Vector3d{-6.0, 0.0, 0.0});
  EXPECT_TRUE(waitFor([&] { return status().contains("Nearest: Structure 3"); }))
      << status().toStdString();
  // what is told no more is told nowhere
  for (const int row : {0, 2}) {
    list().selectRow(row);
    part<QCheckBox>("watchStructure").click();
  }
  EXPECT_TRUE(waitFor([&] { return !status().contains("Nearest"); })) << status().toStdString();
  EXPECT_EQ(list().item(2, 3)->text(), "");
  EXPECT_FALSE(wayNow());
  EXPECT_EQ(window::count(views().volume().picture(1.0), isLine), 0);
}

TEST_F(StructuresTouch, AreFeltAsTheUserChoosesAndRecordingsHaveIt) {
  using Kind = ui::StructureFeel::Kind;
  start();
  EXPECT_FALSE(feel().isEnabled());
  list().selectRow(0);
  EXPECT_TRUE(feel().isEnabled());
  EXPECT_TRUE(part<ui::NumberBox>("structureMargin").isHidden());
  EXPECT_TRUE(list().isColumnHidden(4));
  // the controls below keep their places, and the camera its own
  const auto& below = part<QPushButton>("structuresOn");
  const auto lookNow = [&] { return views().volume().viewAxes(); };
  // the panel is brought into view step by step
  const auto placeNow = [&] { return below.mapTo(&window(), QPoint{}); };
  QPoint at;
  for (int n = 0; n < 20 && placeNow() != at; ++n) {
    at = placeNow();
    window::afterTicks(*application_, 500);
  }
  const Eigen::Matrix3d look = lookNow();
  for (const Kind kind : {Kind::Softer, Kind::AsScan, Kind::Solid, Kind::NotThere, Kind::Guarded}) {
    chooseFeel(kind);
    QCoreApplication::processEvents();
    EXPECT_EQ(placeNow(), at) << static_cast<int>(kind);
  }
  EXPECT_EQ(lookNow(), look);
  EXPECT_EQ(list().item(0, 4)->text(), "Guarded");
  EXPECT_EQ(list().item(1, 4)->text(), "");
  EXPECT_FALSE(list().isColumnHidden(4));
  EXPECT_FALSE(part<ui::NumberBox>("structureMargin").isHidden());
  EXPECT_TRUE(part<ui::NumberBox>("structureStiffness").isHidden());
  EXPECT_TRUE(part<QCheckBox>("watchStructure").isChecked());
  ASSERT_TRUE(waitFor([&] { return structures().felt().contains("guarded"); }));
  part<ui::NumberBox>("structureMargin").setValue(6.0);
  part<ui::NumberBox>("structureGuard").setValue(3.0);
  window::keep(window::pictureOf(window()), "structures_guarded");
  ASSERT_TRUE(waitFor([&] { return isNear(0); }));

  record(true);
  // a force keeps the tool away: from the nerve's surface at the patient's left, 2 mm from it
  const Eigen::Vector3d place = kNerve + Eigen::Vector3d{6.0, 0.0, 0.0};
  bringTip(place);
  ASSERT_TRUE(waitFor([&] { return application_->snapshot().felt_W.force.norm() > 0.5; }));
  EXPECT_GT(application_->snapshot().felt_W.force.x(), 0.4);
  EXPECT_LT(application_->snapshot().felt_W.force.norm(), 3.1);
  window::keep(window::pictureOf(window()), "structures_guard_felt");
  chooseFeel(Kind::Softer);
  part<ui::NumberBox>("structureStiffness").setValue(120.0);
  ASSERT_TRUE(waitFor([&] { return structures().felt().contains("120"); }));
  window::afterTicks(*application_, 100);
  // told no more, it is felt as the scan has it
  part<QCheckBox>("watchStructure").click();
  EXPECT_EQ(structures().felt(), "");
  EXPECT_EQ(feel().currentData().toInt(), static_cast<int>(Kind::AsScan));
  window::afterTicks(*application_, 100);
  record(false);
  ASSERT_TRUE(waitFor([&] { return !recorded().empty(); }));

  const auto recording = app::Recording::open(recorded());
  ASSERT_TRUE(recording);
  std::vector<std::pair<std::string, bool>> felt;
  for (const app::RecordedEvent& event : recording->events())
    if (event.kind == app::kFeltEvent) felt.emplace_back(event.text, event.value.has_value());
  ASSERT_EQ(felt.size(), 4U);
  const auto first = nlohmann::json::parse(felt[0].first);
  EXPECT_TRUE(felt[0].second);  // since the beginning
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0]["number"], 1);
  EXPECT_EQ(first[0]["feel"], "guarded");
  EXPECT_DOUBLE_EQ(first[0]["margin"], 0.006);
  EXPECT_EQ(first[0]["most"], 3.0);
  EXPECT_EQ(nlohmann::json::parse(felt[1].first)[0]["feel"], "softer");
  EXPECT_EQ(nlohmann::json::parse(felt[2].first)[0]["stiffness"], 120.0);
  EXPECT_EQ(felt[3].first, "");
  EXPECT_FALSE(felt[1].second);

  // the numbers are there after another start, and nothing is felt otherwise
  application_->end();
  application_.reset();
  start();
  list().selectRow(1);
  EXPECT_EQ(feel().currentData().toInt(), static_cast<int>(Kind::AsScan));
  EXPECT_EQ(structures().felt(), "");
  EXPECT_EQ(part<ui::NumberBox>("structureMargin").value(), 6.0);
  EXPECT_EQ(part<ui::NumberBox>("structureGuard").value(), 3.0);
  EXPECT_EQ(part<ui::NumberBox>("structureStiffness").value(), 120.0);
}

TEST_F(StructuresTouch, ASolidOneIsNamedWhereItIsTouched) {
  start();
  list().selectRow(0);
  chooseFeel(ui::StructureFeel::Kind::Solid);
  ASSERT_TRUE(waitFor([&] { return isNear(0); }));
  EXPECT_EQ(structures().solidAt(kNerve + Eigen::Vector3d{0.0, -3.9, 0.0}), kSecret);
  EXPECT_EQ(structures().solidAt(kNerve + Eigen::Vector3d{0.0, -4.6, 0.0}), kSecret);
  EXPECT_EQ(structures().solidAt(kNerve + Eigen::Vector3d{0.0, -7.0, 0.0}), "");
  EXPECT_EQ(structures().solidAt(kCanal), "");
}

TEST_F(StructuresTouch, MemoryIsSaidBeforeItIsTakenAndRefusedWhereThereIsNone) {
  double free = 1e12;
  free_memory_ = [&free] { return free; };
  start("");
  const auto voxels = static_cast<double>(75 * 62 * 50);
  free = voxels - 1.0;
  QSignalSpy refused(&structures(), &app::StructuresController::refused);
  emit window().menus().structuresWanted(path("a.seg.nrrd"));
  ASSERT_EQ(refused.count(), 1);
  EXPECT_TRUE(message().contains("Structures: 232.5 kB of memory are needed"))
      << message().toStdString();
  EXPECT_EQ(list().rowCount(), 0);
  free = 1e12;
  QSignalSpy opened(&structures(), &app::StructuresController::opened);
  emit window().menus().structuresWanted(path("a.seg.nrrd"));
  const auto loading = [&] {
    QString all;
    for (const auto* label : window().findChildren<QLabel*>()) all += label->text() + '\n';
    return all;
  };
  EXPECT_TRUE(loading().contains("Reading the structures, 232.5 kB of memory"))
      << loading().toStdString();
  ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));

  // the ball of 4 mm, with 30 mm and a voxel of 0.8 mm on all sides
  list().selectRow(0);
  const std::int64_t bytes = structures().shown().looks[0].distance_bytes;
  const auto side = static_cast<double>(2 * 39 + 10);
  EXPECT_NEAR(static_cast<double>(bytes), 2.0 * side * side * side,
              0.1 * static_cast<double>(bytes));
  const QString size = QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
  EXPECT_EQ(part<QCheckBox>("watchStructure").text(), "Tell the distance (" + size + " of memory)");
  free = static_cast<double>(bytes);  // more is needed while it is made
  part<QCheckBox>("watchStructure").click();
  EXPECT_TRUE(message().contains("Distances to \"" + QString(kSecret) + "\": "))
      << message().toStdString();
  EXPECT_FALSE(part<QCheckBox>("watchStructure").isChecked());
  EXPECT_TRUE(structures().distances().empty());
  free = 1e12;
  part<QCheckBox>("watchStructure").click();
  ASSERT_TRUE(waitFor([&] { return structures().distances().size() == 1; }));
  EXPECT_EQ(static_cast<std::int64_t>(structures().distances().at(0).bytes()), bytes);
}

TEST_F(StructuresTouch, OfAStudyAreOfferedWithTheScanAndInTheList) {
  using namespace datasets::testing;
  const std::filesystem::path study = path("study").toStdString();
  std::filesystem::create_directories(study);
  const auto put = [&](const char* name, const std::string& bytes) {
    QFile file(QString::fromStdString((study / name).string()));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
  };
  for (int k = 0; k < 12; ++k) {
    DicomSlice slice{.instance = "1.2.3.4.5." + std::to_string(k + 1),
                     .position_mm = {0.0, 0.0, double(k)},
                     .rows = 16,
                     .columns = 16};
    for (int n = 0; n < 256; ++n) {
      const bool in = 4 <= n % 16 && n % 16 < 12 && 4 <= n / 16 && n / 16 < 12 && 3 <= k && k < 9;
      slice.pixels.push_back(in ? 1200 : -1000);
    }
    put(("ct" + std::to_string(k)).c_str(), bytesOf(slice));
  }
  SegmentObject object;
  object.columns = object.rows = 16;
  object.between_mm = object.thickness_mm = 1.0;
  object.segments = {{1, "canal"}};
  for (int k = 4; k < 7; ++k) {
    std::vector<int> values(256);
    values[5 * 16 + 6] = 1;
    object.frames.push_back({1, {0.0, 0.0, double(k)}, values});
  }
  put("segments.dcm", bytesOf(object));

  scan_ = "study";
  start("");
  auto& found = part<QPushButton>("foundStructures");
  EXPECT_TRUE(waitFor([&] { return !found.isHidden(); }));
  ASSERT_EQ(found.menu()->actions().size(), 1);
  EXPECT_EQ(found.menu()->actions()[0]->text(), "segments.dcm");
  window::keep(window::pictureOf(window()), "structures_found");
  QSignalSpy opened(&structures(), &app::StructuresController::opened);
  QSignalSpy refused(&structures(), &app::StructuresController::refused);
  found.menu()->actions()[0]->trigger();
  ASSERT_TRUE(waitFor([&] { return opened.count() + refused.count() == 1; }));
  ASSERT_EQ(opened.count(), 1) << message().toStdString();
  ASSERT_EQ(list().rowCount(), 1);
  EXPECT_EQ(list().item(0, 2)->text(), "canal");
  EXPECT_EQ(structures().shown().map->codeAt({6.0, 5.0, 5.0}), 1);
  EXPECT_EQ(structures().shown().map->codeAt({5.0, 6.0, 5.0}), 0);

  // and from the list of series
  part<QPushButton>("closeStructures").click();
  EXPECT_EQ(list().rowCount(), 0);
  emit window().menus().seriesWanted();
  auto* browser = window().findChild<ui::SeriesBrowser*>();
  ASSERT_NE(browser, nullptr);
  auto* table = browser->findChild<QTableWidget*>("series");
  ASSERT_EQ(table->rowCount(), 2);
  window::keep(window::pictureOf(*browser), "structures_series");
  EXPECT_EQ(table->item(1, 2)->text(), "segments.dcm");
  EXPECT_EQ(table->item(1, 3)->text(), "SEG");
  EXPECT_EQ(table->item(1, 6)->text(), "structures");
  auto* open = browser->findChild<QPushButton*>("load1");
  ASSERT_NE(open, nullptr);
  EXPECT_EQ(open->text(), "Open");
  open->click();
  ASSERT_TRUE(waitFor([&] { return opened.count() == 2; }));
  EXPECT_EQ(list().rowCount(), 1);
  browser->close();

  // another scan has none
  emit window().menus().phantomWanted("sphere");
  ASSERT_TRUE(
      waitFor([&] { return window().windowTitle().startsWith("sphere", Qt::CaseInsensitive); }));
  EXPECT_TRUE(found.isHidden());
}

TEST_F(StructuresTouch, ASessionIsReportedAndItsMomentsAreShown) {
  using Kind = ui::StructureFeel::Kind;
  start();
  list().selectRow(0);
  chooseFeel(Kind::Guarded);
  list().item(0, 2)->setText("my nerve");  // the user's own
  list().selectRow(1);
  part<QCheckBox>("watchStructure").click();
  ASSERT_TRUE(waitFor([&] { return isNear(0) && isNear(1); }));
  bringTip(kNerve + Eigen::Vector3d{14.0, 0.0, 0.0});
  window::afterTicks(*application_, 200);
  record(true);
  window::afterTicks(*application_, 300);
  bringTip(kNerve + Eigen::Vector3d{2.0, 0.0, 0.0});  // within
  ASSERT_TRUE(waitFor([&] { return nearOf(0).nearest < 0.0F; }));
  window::afterTicks(*application_, 200);
  bringTip(kNerve + Eigen::Vector3d{14.0, 0.0, 0.0});
  window::afterTicks(*application_, 300);
  record(false);
  ASSERT_TRUE(waitFor([&] { return !recorded().empty(); }));

  app::ReportController& reporting = application_->reporting();
  QSignalSpy finished(&reporting, &app::ReportController::finished);
  QSignalSpy pages(&reporting, &app::ReportController::pageWanted);
  const auto report = [&](const char* name) {
    finished.clear();
    reporting.reportTo(QString::fromStdString(recorded().filename().string()),
                       path(name).toStdString());
    EXPECT_TRUE(waitFor([&] { return finished.count() == 1; }));
    EXPECT_TRUE(finished.at(0).at(0).toBool()) << finished.at(0).at(1).toString().toStdString();
    QFile file(path(name));
    EXPECT_TRUE(file.open(QFile::ReadOnly));
    return file.readAll();
  };
  QTextBrowser browser;
  QDesktopServices::setUrlHandler("file", &browser, "setSource");
  const auto json = nlohmann::json::parse(report("report.json").toStdString());
  EXPECT_EQ(pages.count(), 0);
  const QByteArray page = report("report.html");
  EXPECT_EQ(pages.count(), 1);
  EXPECT_EQ(browser.source(), QUrl::fromLocalFile(path("report.html")));
  QDesktopServices::unsetUrlHandler("file");
  // the user's own name, and none of a file
  EXPECT_TRUE(page.contains("my nerve"));
  EXPECT_FALSE(page.contains("Canal") || page.contains("Doe"));
  window::keep(window::pictureOf(window()), "structures_reported");
  // what the recording itself says
  EXPECT_EQ(json["structures"].size(), 2U);

  auto* moments = window().findChild<ui::ReportMoments*>();
  ASSERT_NE(moments, nullptr);
  window::keep(window::pictureOf(*moments), "structures_moments");
  auto* rows = moments->findChild<QTableWidget*>("moments");
  int inside = -1;
  for (int row = 0; row < rows->rowCount(); ++row)
    if (rows->item(row, 1)->text().startsWith("Farthest inside my nerve")) inside = row;
  ASSERT_GE(inside, 0);
  EXPECT_TRUE(rows->findItems("which was guarded", Qt::MatchContains).size() == 1);
  // it opens the recording, and goes there
  emit rows->cellClicked(inside, 1);
  ASSERT_TRUE(waitFor([&] { return application_->replay() != nullptr; }));
  const auto nearest = [&] {
    for (const haptics::Nearness& near : application_->replay()->step().step.near)
      if (near.structure == 0) return double(near.nearest);
    return 1.0;
  };
  ASSERT_TRUE(waitFor([&] { return nearest() < 0.0; }));
  // no other step is deeper
  auto recording = app::Recording::open(recorded());
  ASSERT_TRUE(recording);
  double deepest = 1.0;
  ASSERT_TRUE(recording->forEach(-INFINITY, INFINITY, [&](const app::RecordedStep& step) {
    for (const haptics::Nearness& near : step.step.near)
      if (near.structure == 0) deepest = std::min(deepest, double(near.nearest));
    return true;
  }));
  EXPECT_NEAR(nearest(), deepest, 1e-6);
  // a replay tells the distances that were
  EXPECT_TRUE(waitFor([&] { return status().contains("inside"); })) << status().toStdString();
  window::keep(window::pictureOf(window()), "structures_moment_replayed");
}

}  // namespace
