// SPDX-License-Identifier: BSD-3-Clause
// The surface on view as a file: what is asked, what is said before, and what is written.
#include "ui/dialogs/surface_question.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/window/edits/edit_controller.h"
#include "datasets/edits/edit.h"
#include "tests/ui/edits/editing.h"
#include "tests/ui/window_support.h"

namespace {

class SurfaceQuestion : public window::Editing {
 protected:
  /// Asks from the menu, does that with the dialog, and names the file.
  void exportSurface(const std::function<void(ui::SurfaceDialog&)>& how, const QString& file) {
    QTimer::singleShot(0, qApp, [this, how, file] {
      auto* dialog = qobject_cast<ui::SurfaceDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      how(*dialog);
      auto* agree = dialog->findChild<QPushButton*>("surfaceAgree");
      ASSERT_TRUE(window::waitFor([&] { return agree->isEnabled(); }));
      said_ = dialog->findChild<QLabel*>("surfaceSize")->text();
      agree->click();
    });
    // what is asked afterwards
    QTimer answers;
    QObject::connect(&answers, &QTimer::timeout, qApp, [this, file] {
      QWidget* open = QApplication::activeModalWidget();
      if (auto* box = qobject_cast<QMessageBox*>(open)) {
        asked_ = box->text();
        for (QAbstractButton* button : box->buttons())
          if (box->buttonRole(button) == QMessageBox::AcceptRole) return button->click();
      } else if (auto* files = qobject_cast<QFileDialog*>(open)) {
        EXPECT_TRUE(files->testOption(QFileDialog::DontUseNativeDialog));
        files->findChild<QLineEdit*>("fileNameEdit")->setText(file);
        QMetaObject::invokeMethod(files, "accept");
      }
    });
    answers.start(50);
    child<QAction>("exportSurface").trigger();
  }

  /// The number of triangles of a binary STL, and its header.
  std::pair<std::uint32_t, QByteArray> stl(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.constData() + 80, 4);
    EXPECT_EQ(bytes.size(), 84 + 50 * qsizetype(count));
    return {count, bytes.first(80)};
  }

  bool isDone(const QString& name) {
    return window::waitFor([&] { return child<QLabel>("done").text().contains(name); });
  }

  QTemporaryDir out_;
  QString said_, asked_;
};

TEST_F(SurfaceQuestion, WritesWhatWasAskedForAndSaysItsSizeBefore) {
  openBalls();
  const QString all = out_.filePath("all.stl"), one = out_.filePath("one.stl");
  exportSurface(
      [](ui::SurfaceDialog& dialog) {
        EXPECT_FALSE(dialog.findChild<QCheckBox*>("surfaceRemoved")->isEnabled());
      },
      all);
  ASSERT_TRUE(isDone("all.stl"));
  EXPECT_TRUE(asked_.contains("face")) << asked_.toStdString();
  const auto [triangles, header] = stl(all);
  EXPECT_TRUE(said_.contains("triangles")) << said_.toStdString();
  EXPECT_TRUE(said_.contains(QLocale().toString(triangles))) << said_.toStdString();
  EXPECT_TRUE(header.contains("SPACE=LPS")) << header.constData();

  exportSurface(
      [](ui::SurfaceDialog& dialog) {
        dialog.findChild<QComboBox*>("surfacePieces")->setCurrentIndex(1);
        dialog.findChild<QComboBox*>("surfaceFrame")->setCurrentIndex(1);
      },
      one);
  ASSERT_TRUE(isDone("one.stl"));
  const auto [fewer, ras] = stl(one);
  EXPECT_LT(fewer, triangles);
  EXPECT_GT(fewer, triangles / 2);
  EXPECT_TRUE(ras.contains("SPACE=RAS")) << ras.constData();
}

TEST_F(SurfaceQuestion, RemovedPartsAreLeftOutUnlessAskedFor) {
  openBalls();
  const QString whole = out_.filePath("whole.stl"), cropped = out_.filePath("cropped.stl");
  exportSurface([](ui::SurfaceDialog&) {}, whole);
  ASSERT_TRUE(isDone("whole.stl"));
  application_->editing().restore({datasets::Crop{{{0, 0, 0}, {64, 64, 32}}}});
  settle();
  exportSurface(
      [](ui::SurfaceDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QCheckBox*>("surfaceRemoved")->isEnabled());
      },
      cropped);
  ASSERT_TRUE(isDone("cropped.stl"));
  EXPECT_NE(stl(cropped).first, stl(whole).first);
  const QString before = out_.filePath("before.stl");
  exportSurface(
      [](ui::SurfaceDialog& dialog) {
        dialog.findChild<QCheckBox*>("surfaceRemoved")->setChecked(true);
      },
      before);
  ASSERT_TRUE(isDone("before.stl"));
  EXPECT_EQ(stl(before).first, stl(whole).first);
}

TEST_F(SurfaceQuestion, WithoutASurfaceThereIsASentenceAndNoFile) {
  ui::SurfaceDialog dialog("at 7", {".stl", ".obj"}, false);
  auto* agree = dialog.findChild<QPushButton*>("surfaceAgree");
  EXPECT_FALSE(agree->isEnabled());
  dialog.showSize(12, {684, 20'000'000});
  EXPECT_TRUE(agree->isEnabled());
  dialog.findChild<QComboBox*>("surfaceFormat")->setCurrentIndex(1);
  EXPECT_TRUE(dialog.findChild<QLabel*>("surfaceSize")->text().contains("20 MB"));
  dialog.showProblem("There is none.");
  EXPECT_FALSE(agree->isEnabled());
  EXPECT_EQ(dialog.findChild<QLabel*>("surfaceSize")->text(), "There is none.");
}

}  // namespace
