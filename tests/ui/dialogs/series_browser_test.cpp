// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/series_browser.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPalette>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <vector>

#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/dialogs/part_question.h"
#include "ui/window/main_window.h"
#include "ui/window/touch_state.h"

namespace {

const QList<ui::SeriesRow> kRows{
    {.patient = "Doe Jane",
     .study = "Head",
     .series = "Scout",
     .modality = "CT",
     .dims = {512, 256, 1},
     .spacing_mm = {0.98, 0.98, 0.6},
     .verdict = ui::Verdict::Refused,
     .sentence = "The series is a scout view.",
     .faults = {"\"I10\": it is <b>cut off</b>.", "\"I20\": it is cut off."},
     .bytes = 262'144},
    {.patient = "Doe Jane",
     .study = "Head",
     .series = "Bone 1 mm, sharp",
     .modality = "CT",
     .dims = {512, 512, 361},
     .spacing_mm = {0.451171875, 0.451171875, 1.0},
     .verdict = ui::Verdict::Sound,
     .sentence = "One evenly spaced stack of 361 slices.",
     .bytes = 189'267'968},
    {.patient = "",
     .study = "",
     .series = "",
     .modality = "MR",
     .dims = {256, 256, 40},
     .spacing_mm = {1.0, 1.0, 2.5},
     .verdict = ui::Verdict::Correctable,
     .sentence = "The slices are tilted by 16.5 degrees.",
     .bytes = 5'242'880}};

QStringList headersOf(const ui::SeriesBrowser& browser) {
  QStringList headers;
  const auto* table = browser.findChild<QTableWidget*>("series");
  for (int column = 0; column < table->columnCount(); ++column)
    headers << table->horizontalHeaderItem(column)->text();
  return headers;
}

bool holdsText(const ui::SeriesBrowser& browser, const QString& text) {
  const auto* table = browser.findChild<QTableWidget*>("series");
  for (int row = 0; row < table->rowCount(); ++row)
    for (int column = 0; column < table->columnCount(); ++column)
      if (const auto* item = table->item(row, column))
        if (item->text().contains(text) || item->toolTip().contains(text)) return true;
  return false;
}

QImage slope(int width, int height) {
  QImage image(width, height, QImage::Format_Grayscale8);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.scanLine(y)[x] = static_cast<uchar>(x * 255 / width);
  return image;
}

QString detailsOf(const ui::SeriesBrowser& browser) {
  return browser.findChild<QPlainTextEdit*>("seriesDetails")->toPlainText();
}

TEST(SeriesBrowser, PatientsAreNotThereUntilTheyAreAskedFor) {
  ui::SeriesBrowser browser("CD", kRows);
  window::showAndWait(browser, {1000, 480});
  EXPECT_FALSE(headersOf(browser).contains("Patient"));
  EXPECT_FALSE(holdsText(browser, "Doe"));
  auto* names = browser.findChild<QCheckBox*>("showPatients");
  EXPECT_FALSE(names->isChecked());
  QTest::mouseClick(names, Qt::LeftButton, {}, {8, names->height() / 2});
  EXPECT_EQ(headersOf(browser).first(), "Patient");
  EXPECT_TRUE(holdsText(browser, "Doe Jane"));
  window::keep(window::pictureOf(browser), "series_browser_patients");
  QTest::mouseClick(names, Qt::LeftButton, {}, {8, names->height() / 2});
  EXPECT_FALSE(headersOf(browser).contains("Patient"));
  EXPECT_FALSE(holdsText(browser, "Doe"));
}

TEST(SeriesBrowser, SaysWhatEachSeriesIs) {
  ui::SeriesBrowser browser("CD", kRows);
  browser.showThumbnail(0, {});
  browser.showThumbnail(1, {.image = slope(72, 72)});
  window::showAndWait(browser, {1000, 480});
  for (const char* text : {"Bone 1 mm, sharp", "512 × 512 × 361", "0.4512 × 0.4512 × 1 mm", "sound",
                           "correctable", "refused", "189.3 MB", "MR", "no picture"})
    EXPECT_TRUE(holdsText(browser, QString::fromUtf8(text))) << text;
  EXPECT_FALSE(holdsText(browser, "0.98"));  // no spacing of what is refused
  const QImage image = window::pictureOf(browser);
  window::keep(image, "series_browser");
  // the thumbnail's bright end
  EXPECT_GT(window::count(image,
                          [](QColor c) {
                            return c.lightness() > 100 && c.lightness() < 200 && c.hue() == -1;
                          }),
            500);
}

TEST(SeriesBrowser, APictureOfAScanThatDoesNotSayHowItLiesSaysSo) {
  ui::SeriesBrowser browser("CD", kRows);
  browser.showThumbnail(1, {.image = slope(72, 72)});
  browser.showThumbnail(2, {.image = slope(72, 60), .sides_known = false});
  window::showAndWait(browser, {1000, 480});
  window::keep(window::pictureOf(browser), "series_browser_unknown_sides");
  auto* table = browser.findChild<QTableWidget*>("series");
  const auto coloured = [&](int row) {
    const QImage icon = table->item(row, 0)->icon().pixmap(ui::SeriesBrowser::kThumbnail).toImage();
    return window::count(icon, [](QColor c) { return c.saturation() > 60; });
  };
  EXPECT_EQ(coloured(1), 0);
  EXPECT_GT(coloured(2), 60);
  EXPECT_EQ(table->item(1, 0)->toolTip(), "");
  EXPECT_TRUE(table->item(2, 0)->toolTip().contains("left and right are unknown"));
  EXPECT_EQ(table->item(2, 0)->data(Qt::AccessibleTextRole).toString(),
            table->item(2, 0)->toolTip());
}

TEST(SeriesBrowser, LargeLettersAndADarkDesktopLeaveTheButtonsInSight) {
  const QFont font = QApplication::font();
  QFont large = font;
  large.setPointSizeF(14.4);
  QApplication::setFont(large);
  QPalette dark(QColor(0x30, 0x30, 0x30), QColor(0x24, 0x24, 0x24));
  ui::SeriesBrowser browser("CD", kRows);
  browser.setPalette(dark);
  browser.showThumbnail(1, {.image = slope(72, 50)});
  window::showAndWait(browser, browser.size());
  window::keep(window::pictureOf(browser), "series_browser_dark");
  for (const char* name : {"load1", "load2"}) {
    auto* load = browser.findChild<QPushButton*>(name);
    EXPECT_FALSE(load->visibleRegion().isEmpty()) << name;
    EXPECT_EQ(load->visibleRegion().boundingRect(), load->rect()) << name;
  }
  QApplication::setFont(font);
}

TEST(SeriesBrowser, OneClickLoadsAndEnterLoadsTheSelected) {
  ui::SeriesBrowser browser("CD", kRows);
  window::showAndWait(browser, {1000, 480});
  std::vector<int> wanted;
  QObject::connect(&browser, &ui::SeriesBrowser::loadWanted,
                   [&](int row) { wanted.push_back(row); });
  QTest::mouseClick(browser.findChild<QPushButton*>("load2"), Qt::LeftButton);
  EXPECT_EQ(wanted, std::vector<int>{2});
  // what can be loaded was selected first, so Enter alone is enough as well
  auto* table = browser.findChild<QTableWidget*>("series");
  table->selectRow(1);
  table->setFocus();
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_EQ(wanted, (std::vector<int>{2, 1}));
}

TEST(SeriesBrowser, ARefusedSeriesSaysWhyAndCannotBeLoaded) {
  ui::SeriesBrowser browser("CD", kRows);
  window::showAndWait(browser, {1000, 480});
  int wishes = 0;
  QObject::connect(&browser, &ui::SeriesBrowser::loadWanted, [&] { ++wishes; });
  EXPECT_EQ(detailsOf(browser), kRows[1].sentence);
  EXPECT_EQ(browser.findChild<QPushButton*>("load0"), nullptr);
  auto* table = browser.findChild<QTableWidget*>("series");
  const QPoint on_row = table->visualItemRect(table->item(0, 2)).center();
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, on_row);
  QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, on_row);
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_EQ(wishes, 0);
  // its files one by one, and as plain text
  EXPECT_EQ(detailsOf(browser),
            "The series is a scout view.\n\"I10\": it is <b>cut off</b>.\n"
            "\"I20\": it is cut off.");
}

TEST(SeriesBrowser, ThousandsOfVolumesAreListedToo) {
  ui::SeriesBrowser browser("Volumes", QList<ui::SeriesRow>(10'000, kRows[1]));
  window::showAndWait(browser, {1000, 480});
  for (int row = 0; row < 10'000; row += 100) browser.showThumbnail(row, {.image = slope(72, 72)});
  int wanted = -1;
  QObject::connect(&browser, &ui::SeriesBrowser::loadWanted, [&](int row) { wanted = row; });
  auto* table = browser.findChild<QTableWidget*>("series");
  table->selectRow(9'999);
  table->setFocus();
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_EQ(wanted, 9'999);
  auto* load = browser.findChild<QPushButton*>("load9998");
  ASSERT_NE(load, nullptr);
  QTest::mouseClick(load, Qt::LeftButton);
  EXPECT_EQ(wanted, 9'998);
}

TEST(SeriesBrowser, EscapeInItStillCutsTheForceOfMotors) {
  ui::MainWindow window;
  window.touch().setHand("omega.6", ui::Feel::Felt);
  window::showAndWait(window, {1240, 840});
  ui::SeriesBrowser browser("CD", kRows, &window);
  window::showAndWait(browser, {1000, 480});
  int wishes = 0;
  QObject::connect(&window.touch(), &ui::TouchState::forceOffWanted, [&] { ++wishes; });
  const auto press = [&] {
    wishes = 0;
    browser.show();
    QTest::keyClick(browser.findChild<QTableWidget*>("series"), Qt::Key_Escape);
    EXPECT_FALSE(browser.isVisible());
    return wishes > 0;
  };
  EXPECT_TRUE(press());
  window.touch().setHand("Mouse", ui::Feel::Shown);
  EXPECT_FALSE(press());
}

// 512 x 512 x 361 voxels of 2 bytes
constexpr ui::LargeVolume kBunny{
    .dims = {512, 512, 361}, .bytes = 189'267'968, .free_bytes = 100e6};

/// Answers the question that comes up next, by the word on a button; then the box, if it is one.
template <class F>
std::optional<ui::VoxelChoice> answered(const ui::LargeVolume& volume, F&& answer) {
  QTimer::singleShot(300, qApp, [answer] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    answer(*box);
  });
  return ui::askForPart(nullptr, "This series needs 237 MB of memory.", volume);
}

QAbstractButton* buttonOf(const QMessageBox& box, const QString& word) {
  for (QAbstractButton* button : box.buttons())
    if (button->text().contains(word)) return button;
  return nullptr;
}

TEST(PartQuestion, OffersEverySecondVoxelOrAsFewAsItTakes) {
  const auto second = answered(kBunny, [](QMessageBox& box) {
    window::keep(window::pictureOf(box), "part_question");
    auto* button = buttonOf(box, "second voxel");
    ASSERT_NE(button, nullptr);
    // 256 x 256 x 181 voxels
    EXPECT_TRUE(button->text().contains("23.7 MB")) << button->text().toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
  });
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->step, 2);
  EXPECT_FALSE(second->box.has_value());

  ui::LargeVolume little = kBunny;
  little.free_bytes = 9e6;
  const auto third = answered(little, [](QMessageBox& box) {
    EXPECT_EQ(buttonOf(box, "second"), nullptr);
    auto* button = buttonOf(box, "every 3rd voxel");
    ASSERT_NE(button, nullptr);
    // 171 x 171 x 121 voxels
    EXPECT_TRUE(button->text().contains("7.1 MB")) << button->text().toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
  });
  ASSERT_TRUE(third.has_value());
  EXPECT_EQ(third->step, 3);
  EXPECT_EQ(ui::stepThatFits({.dims = {4, 4, 4}, .bytes = 128, .free_bytes = 1.0}), std::nullopt);
}

TEST(PartQuestion, EnterAndEscapeReadNothing) {
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape})
    EXPECT_FALSE(answered(kBunny, [key](QMessageBox& box) { QTest::keyClick(&box, key); }));
}

TEST(PartQuestion, ABoxIsTheMiddleHalfAtFirstAndSaysItsSize) {
  const auto boxed = answered(kBunny, [](QMessageBox& question) {
    QTimer::singleShot(300, qApp, [] {
      auto* box = qobject_cast<ui::BoxDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      window::keep(window::pictureOf(*box), "box_dialog");
      const auto spin = [&](const char* name) { return box->findChild<ui::NumberBox*>(name); };
      auto* size = box->findChild<QLabel*>("boxSize");
      auto* read = box->findChild<QPushButton*>("readBox");
      EXPECT_EQ(spin("first0")->value(), 129);
      EXPECT_EQ(spin("last0")->value(), 384);
      EXPECT_TRUE(size->text().contains(QString::fromUtf8("256 × 256 × 181")))
          << size->text().toStdString();
      EXPECT_TRUE(size->text().contains("23.7 MB")) << size->text().toStdString();
      spin("first0")->setValue(385);
      EXPECT_FALSE(read->isEnabled());
      spin("first0")->setValue(1);
      spin("last0")->setValue(512);
      spin("first1")->setValue(1);
      spin("last1")->setValue(512);
      EXPECT_FALSE(read->isEnabled());  // 95 MB and what goes with them
      EXPECT_TRUE(size->text().contains("too much")) << size->text().toStdString();
      spin("first2")->setValue(11);
      spin("last2")->setValue(20);
      EXPECT_TRUE(read->isEnabled());
      QTest::mouseClick(read, Qt::LeftButton);
    });
    QTest::mouseClick(buttonOf(question, "box"), Qt::LeftButton);
  });
  ASSERT_TRUE(boxed && boxed->box);
  EXPECT_EQ(boxed->step, 1);
  EXPECT_EQ(boxed->box->first, (std::array<std::int64_t, 3>{0, 0, 10}));
  EXPECT_EQ(boxed->box->end, (std::array<std::int64_t, 3>{512, 512, 20}));
}

}  // namespace
