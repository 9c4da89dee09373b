// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/number_box.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLocale>
#include <QPushButton>
#include <QTest>
#include <array>

#include "tests/ui/panelled_window.h"
#include "tests/ui/window_support.h"
#include "ui/dialogs/export_question.h"
#include "ui/dialogs/part_question.h"
#include "ui/panels/histogram_slider.h"
#include "ui/window/main_window.h"

namespace {

const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
const QLocale kGerman(QLocale::German, QLocale::Germany);

void replace(QAbstractSpinBox* box, const QString& text, bool paste) {
  box->selectAll();
  if (paste) {
    QApplication::clipboard()->setText(text);
    QTest::keyClick(box, Qt::Key_V, Qt::ControlModifier);
  } else {
    QTest::keyClicks(box, text);
  }
}

void enter(QAbstractSpinBox* box, const QString& text, bool paste = false) {
  replace(box, text, paste);
  QTest::keyClick(box, Qt::Key_Return);
}

/// From -1,024 to `greatest` HU.
ui::Picture scan(double greatest) {
  return ui::pictureOf(window::volumeOf(
      window::cubeGrid(8), haptics::ScalarType::Int32,
      [=](const haptics::Vec3& p) { return p.x() > 0.0 ? greatest : -1024.0; }, {.unit = "HU"}));
}

struct Typed {
  const char* text;
  std::optional<double> number;  ///< none: it is none, wherever it is typed
};
constexpr std::array<Typed, 13> kTyped{{{"0,5", 0.5},
                                        {"0.5", 0.5},
                                        {"120.5", 120.5},
                                        {"120,5", 120.5},
                                        {"-300,5", -300.5},
                                        {"12", 12.0},
                                        {"1.234,5", {}},
                                        {"1,234.5", {}},
                                        {"1,234,567", {}},
                                        {"1 234", {}},
                                        {"1e2", {}},
                                        {"5x", {}},
                                        {"", {}}}};

void takesNumbersAndNothingElse(const QWidget& place, int least_boxes) {
  const auto boxes = place.findChildren<QAbstractSpinBox*>();
  EXPECT_GE(boxes.size(), least_boxes);
  for (QAbstractSpinBox* each : boxes) {
    SCOPED_TRACE(each->objectName().toStdString());
    auto* box = qobject_cast<ui::NumberBox*>(each);
    ASSERT_NE(box, nullptr) << "a field of another kind";
    box->setEnabled(true);
    for (const QLocale& language : {kEnglish, kGerman}) {
      box->setLocale(language);
      for (const Typed& typed : kTyped)
        for (const bool paste : {false, true}) {
          SCOPED_TRACE(typed.text);
          box->setValue(box->minimum() + 1.0);
          const double before = box->value();
          const bool fits = typed.number && *typed.number >= box->minimum() &&
                            *typed.number <= box->maximum() &&
                            (box->decimals() > 0 || *typed.number == 12.0);
          enter(box, typed.text, paste);
          EXPECT_DOUBLE_EQ(box->value(), fits ? *typed.number : before)
              << language.name().toStdString();
        }
    }
  }
}

TEST(NumberBox, EveryFieldOfTheWindowTakesBothMarksAndNoOtherNumberComesOfWhatIsNone) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(scan(3000.0), 300.0, "scan");
  window::showAndWait(window, {1240, 840});
  takesNumbersAndNothingElse(window, 4);
}

TEST(NumberBox, EveryFieldOfTheDialogsDoes) {
  takesNumbersAndNothingElse(ui::ExportDialog(0.0, 200.0, window::exportFormats()), 3);
  takesNumbersAndNothingElse(
      ui::BoxDialog({.dims = {512, 512, 361}, .bytes = 200'000'000, .free_bytes = 1e9}), 6);
}

TEST(NumberBox, TheForceScaleIsHalfAndNotFive) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  auto* scale = window.findChild<QDoubleSpinBox*>("forceScale");
  scale->setLocale(kEnglish);
  enter(scale, "0,5");
  EXPECT_EQ(scale->value(), 0.5);
  EXPECT_EQ(scale->text(), "0.50");
  scale->setLocale(kGerman);
  enter(scale, "0.7");
  EXPECT_EQ(scale->value(), 0.7);
  EXPECT_EQ(scale->text(), "0,70");
  // outside the range: refused, and not cut down to its first digits
  enter(scale, "99");
  EXPECT_EQ(scale->value(), 0.7);
  EXPECT_EQ(scale->text(), "0,70");
}

TEST(NumberBox, AnIsovalueIsNeverTenTimesWhatWasTyped) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  auto* isovalue = window.findChild<QDoubleSpinBox*>("isovalueTyped");
  isovalue->setLocale(kGerman);
  panelled.show(scan(3000.0), 300.0, "scan");
  enter(isovalue, "120.5");
  EXPECT_EQ(isovalue->value(), 120.5);
  enter(isovalue, "-20,5 HU", true);
  EXPECT_EQ(isovalue->value(), -20.5);
  enter(isovalue, QString::fromUtf8("\u221230,5"), true);  // a minus as word processors write it
  EXPECT_EQ(isovalue->value(), -30.5);
  // so wide a range is chosen in whole numbers
  panelled.show(scan(60'000.0), 300.0, "scan");
  ASSERT_EQ(isovalue->decimals(), 0);
  enter(isovalue, "120.5");
  EXPECT_EQ(isovalue->value(), 300.0);
  enter(isovalue, "1205");
  EXPECT_EQ(isovalue->value(), 1205.0);
  EXPECT_EQ(isovalue->text(), "1205 HU");  // no group separator
}

TEST(NumberBox, AnIsovalueGoesByTensOfHounsfieldUnitsAndWithShiftByOnes) {
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
  panelled.show(scan(3000.0), 300.0, "scan");
  window::showAndWait(window, {1240, 840});
  auto* typed = window.findChild<QDoubleSpinBox*>("isovalueTyped");
  auto* slider = window.findChild<ui::HistogramSlider*>("isovalueSlider");
  for (QWidget* at : {static_cast<QWidget*>(typed), static_cast<QWidget*>(slider)}) {
    at->setFocus();
    QTest::keyClick(at, Qt::Key_Up);
    EXPECT_EQ(typed->value(), 310.0) << at->objectName().toStdString();
    QTest::keyClick(at, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(typed->value(), 309.0);
    QTest::keyClick(at, Qt::Key_Up, Qt::ShiftModifier);
    QTest::keyClick(at, Qt::Key_Down);
    EXPECT_EQ(typed->value(), 300.0);
  }
  window::keep(window::pictureOf(*slider), "isovalue_axis");
}

TEST(NumberBox, ADialogIsNotAcceptedWithWhatIsRefused) {
  ui::ExportDialog dialog(0.0, 83.5, window::exportFormats());
  window::showAndWait(dialog, dialog.sizeHint());
  auto* to = dialog.findChild<QDoubleSpinBox*>("exportTo");
  auto* agree = dialog.findChild<QPushButton*>("exportAgree");
  replace(to, "1.234,5", false);
  EXPECT_FALSE(agree->isEnabled());
  QTest::keyClick(to, Qt::Key_Return);
  EXPECT_TRUE(dialog.isVisible());  // Enter brought the old value back, and no more
  EXPECT_EQ(to->value(), 83.5);
  EXPECT_TRUE(agree->isEnabled());
  // what can be taken counts at once
  replace(to, "20,5", false);
  EXPECT_TRUE(agree->isEnabled());
  EXPECT_EQ(dialog.wish().to, 20.5);
}

}  // namespace
