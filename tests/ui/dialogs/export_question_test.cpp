// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/export_question.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>
#include <QTimer>
#include <functional>

#include "tests/ui/window_support.h"
#include "ui/window/main_window.h"
#include "ui/window/touch_state.h"

namespace {

using Camera = ui::ExportWish::Film::Camera;

// neither end is a whole millisecond
constexpr double kBegin = 0.0004, kEnd = 83.5124567;

template <class T>
T* part(const ui::ExportDialog& dialog, const char* name) {
  return dialog.findChild<T*>(name);
}

void type(QDoubleSpinBox* spin, const char* text) {
  spin->setFocus();
  spin->selectAll();
  QTest::keyClicks(spin, text);
  QTest::keyClick(spin, Qt::Key_Tab);
}

/// Asks, and does that with the dialog.
std::optional<ui::ExportWish> answered(const std::function<void(ui::ExportDialog&)>& how,
                                       QWidget* parent = nullptr) {
  QTimer::singleShot(300, qApp, [how] {
    auto* dialog = qobject_cast<ui::ExportDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    how(*dialog);
  });
  QTimer gives_up;
  QObject::connect(&gives_up, &QTimer::timeout, [] {
    if (auto* left = QApplication::activeModalWidget()) left->close();
  });
  gives_up.start(120'000);
  return ui::askForExport(parent, kBegin, kEnd, window::exportFormats());
}

void agree(const ui::ExportDialog& dialog) {
  QTest::mouseClick(part<QPushButton>(dialog, "exportAgree"), Qt::LeftButton);
}

TEST(ExportQuestion, AllOfItAtEveryStepUnlessSaidOtherwise) {
  const auto wish = answered([](ui::ExportDialog& dialog) {
    window::keep(window::pictureOf(dialog), "export_question");
    const QString range = part<QLabel>(dialog, "exportRange")->text();
    EXPECT_TRUE(range.contains("All of it: 1:23.512")) << range.toStdString();
    EXPECT_TRUE(part<QRadioButton>(dialog, "exportEveryStep")->isVisible());
    EXPECT_FALSE(part<QComboBox>(dialog, "filmSize")->isVisible());
    EXPECT_FALSE(part<QDoubleSpinBox>(dialog, "exportRate")->isEnabled());
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  ASSERT_TRUE(wish.has_value());
  EXPECT_EQ(wish->table, 0U);
  EXPECT_EQ(wish->from, kBegin);
  EXPECT_EQ(wish->to, kEnd);
  EXPECT_FALSE(wish->rate.has_value());
  EXPECT_TRUE(wish->contacts);
}

TEST(ExportQuestion, APartOfItAtARateWithoutContacts) {
  const auto wish = answered([](ui::ExportDialog& dialog) {
    part<QComboBox>(dialog, "exportFormat")->setFocus();
    QTest::keyClick(part<QComboBox>(dialog, "exportFormat"), Qt::Key_Down);
    type(part<QDoubleSpinBox>(dialog, "exportFrom"), "12.25");
    type(part<QDoubleSpinBox>(dialog, "exportTo"), "20");
    QTest::mouseClick(part<QRadioButton>(dialog, "exportAtRate"), Qt::LeftButton, {}, {8, 8});
    ASSERT_TRUE(part<QDoubleSpinBox>(dialog, "exportRate")->isEnabled());
    type(part<QDoubleSpinBox>(dialog, "exportRate"), "250");
    QTest::mouseClick(part<QCheckBox>(dialog, "exportContacts"), Qt::LeftButton, {}, {8, 8});
    agree(dialog);
  });
  ASSERT_TRUE(wish.has_value());
  EXPECT_EQ(wish->table, 1U);
  EXPECT_EQ(wish->from, 12.25);
  EXPECT_EQ(wish->to, 20.0);
  ASSERT_TRUE(wish->rate.has_value());
  EXPECT_EQ(*wish->rate, 250.0);
  EXPECT_FALSE(wish->contacts);
}

TEST(ExportQuestion, AFilmHasCameraSizeAndFrames) {
  const auto wish = answered([](ui::ExportDialog& dialog) {
    auto* formats = part<QComboBox>(dialog, "exportFormat");
    ASSERT_EQ(formats->itemText(2), "MCAP");
    formats->setFocus();
    QTest::keyClick(formats, Qt::Key_End);
    QTest::qWait(50);
    EXPECT_FALSE(part<QRadioButton>(dialog, "exportEveryStep")->isVisible());
    EXPECT_FALSE(part<QCheckBox>(dialog, "exportContacts")->isVisible());
    for (const char* name : {"filmCamera", "filmSize", "filmRate"}) {
      auto* choice = part<QComboBox>(dialog, name);
      ASSERT_TRUE(choice->isVisible());
      ASSERT_EQ(choice->count(), 2);
      choice->setFocus();
      QTest::keyClick(choice, Qt::Key_Down);
    }
    for (const char* name : {"filmFigures", "filmSlices"})
      QTest::mouseClick(part<QCheckBox>(dialog, name), Qt::LeftButton, {}, {8, 8});
    type(part<QDoubleSpinBox>(dialog, "exportTo"), "10");
    const QString range = part<QLabel>(dialog, "exportRange")->text();
    EXPECT_TRUE(range.contains("600 pictures")) << range.toStdString();
    window::keep(window::pictureOf(dialog), "export_question_film");
    agree(dialog);
  });
  ASSERT_TRUE(wish.has_value());
  EXPECT_FALSE(wish->table);
  EXPECT_EQ(wish->film.camera, Camera::Fixed);
  EXPECT_EQ(wish->film.width, 1920);
  EXPECT_EQ(wish->film.height, 1080);
  EXPECT_EQ(wish->film.frames_per_second, 60);
  EXPECT_FALSE(wish->film.figures);
  EXPECT_TRUE(wish->film.slices);
  EXPECT_EQ(wish->to, 10.0);
}

TEST(ExportQuestion, AnEmptyRangeCannotBeChosen) {
  const auto wish = answered([](ui::ExportDialog& dialog) {
    auto* from = part<QDoubleSpinBox>(dialog, "exportFrom");
    auto* to = part<QDoubleSpinBox>(dialog, "exportTo");
    auto* yes = part<QPushButton>(dialog, "exportAgree");
    type(from, "30");
    type(to, "20");
    EXPECT_FALSE(yes->isEnabled());
    EXPECT_TRUE(part<QLabel>(dialog, "exportRange")->text().contains("does not come after"));
    window::keep(window::pictureOf(dialog), "export_question_empty");
    type(to, "30");
    EXPECT_FALSE(yes->isEnabled());
    type(to, "30.001");
    EXPECT_TRUE(yes->isEnabled());
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  EXPECT_FALSE(wish.has_value());
  // one step is a recording too
  const ui::ExportDialog one(4.0, 4.0, window::exportFormats());
  EXPECT_TRUE(part<QPushButton>(one, "exportAgree")->isEnabled());
  EXPECT_EQ(one.wish().from, 4.0);
  EXPECT_EQ(one.wish().to, 4.0);
}

TEST(ExportQuestion, EscapeInItCutsTheForceOfMotors) {
  ui::MainWindow window;
  window.touch().setHand("omega.6", ui::Feel::Felt);
  window::showAndWait(window, {1240, 840});
  int wishes = 0;
  QObject::connect(&window.touch(), &ui::TouchState::forceOffWanted, [&] { ++wishes; });
  const auto wish = answered(
      [](ui::ExportDialog& dialog) {
        QTest::keyClick(part<QDoubleSpinBox>(dialog, "exportFrom"), Qt::Key_Escape);
      },
      &window);
  EXPECT_FALSE(wish.has_value());
  EXPECT_GT(wishes, 0);
}

}  // namespace
