// SPDX-License-Identifier: BSD-3-Clause
// The log and the report of a crash, as the window shows them.
#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "app/application.h"
#include "app/log/log.h"
#include "tests/support/scratch_folder.h"
#include "tests/ui/window_support.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"

namespace {

using window::waitFor;

class CrashWindow : public testing::Test {
 protected:
  ~CrashWindow() override { app::log::close(); }
  app::Arguments arguments() const {
    app::Arguments arguments;
    arguments.notice = false;
    arguments.state = folder_.folder();
    arguments.recordings = folder_.folder();
    arguments.surface = ui::SurfaceMode::Mesh;
    return arguments;
  }
  std::string allOfTheLog() const {
    std::string text;
    for (const std::string& line : app::log::lines(folder_.folder(), 1'000)) text += line + '\n';
    return text;
  }
  support::ScratchFolder folder_;
};

QDialog* dialogOf(app::Application& application, const char* name) {
  return application.window().findChild<QDialog*>(name);
}

TEST_F(CrashWindow, ACrashIsOfferedShownCopiedAndDeleted) {
  folder_.write("crash-a.raw", "palpate-crash 1\nversion 0.1.0\nsession 1-1\nsignal b\nat - 0 1\n");
  app::Application application(arguments());
  application.start();
  auto* offer = application.window().findChild<QLabel*>("offer");
  ASSERT_NE(offer, nullptr);
  ASSERT_TRUE(waitFor([&] { return offer->isVisible(); }));
  EXPECT_EQ(offer->text(), "Palpate ended unexpectedly last time.");
  window::keep(window::pictureOf(application.window()), "crash_offer");
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"crash-report.txt"});

  QTest::mouseClick(application.window().findChild<QPushButton*>("takeOffer"), Qt::LeftButton);
  EXPECT_FALSE(offer->isVisible());
  QDialog* shown = dialogOf(application, "crashReport");
  ASSERT_NE(shown, nullptr);
  EXPECT_TRUE(shown->isVisible());
  const QString text = shown->findChild<QPlainTextEdit*>()->toPlainText();
  EXPECT_TRUE(text.startsWith("Palpate 0.1.0, build")) << text.toStdString();
  EXPECT_TRUE(text.contains("Ended by signal 11, SIGSEGV")) << text.toStdString();
  window::keep(window::pictureOf(*shown), "crash_report");
  QTest::mouseClick(shown->findChild<QPushButton*>("copyText"), Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), text);
  QTest::mouseClick(shown->findChild<QPushButton*>("deleteText"), Qt::LeftButton);
  EXPECT_TRUE(folder_.names().empty());
  EXPECT_TRUE(waitFor([&] { return dialogOf(application, "crashReport") == nullptr; }));
}

TEST_F(CrashWindow, WithoutACrashNothingIsOffered) {
  folder_.write("crash-b.raw", "palpate-crash 1\nversion 0.1.0\nsession 1-1\n");  // was killed
  app::Application application(arguments());
  application.start();
  ASSERT_TRUE(waitFor([&] { return folder_.names().empty(); }));
  QTest::qWait(200);
  EXPECT_FALSE(application.window().findChild<QLabel*>("offer")->isVisible());
}

TEST_F(CrashWindow, TheLogSaysWhatWasDoneAndNamesNobody) {
  ASSERT_TRUE(app::log::open(folder_.folder(), app::log::Level::Info));
  const auto file = folder_.write("PLNT^Jane.nrrd", "NRRD0004\ntype: PLNTTYPE\n\n");
  {
    app::Arguments with = arguments();
    with.load.phantom = "sphere";
    app::Application application(std::move(with));
    application.start();
    ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
    emit application.window().menus().openWanted(QString::fromStdString(file.string()));
    ASSERT_TRUE(waitFor([&] { return allOfTheLog().find(" not-opened ") != std::string::npos; }));
    ASSERT_TRUE(waitFor([&] { return application.snapshot().tick > 100; }));

    application.window().findChild<QAction*>("showLog")->trigger();
    QDialog* shown = dialogOf(application, "log");
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(shown->findChild<QPlainTextEdit*>()->toPlainText().toStdString(), allOfTheLog());
    EXPECT_TRUE(shown->findChild<QPlainTextEdit*>()->isReadOnly());
    EXPECT_EQ(shown->findChild<QPushButton*>("deleteText"), nullptr);
    window::keep(window::pictureOf(*shown), "log");
    shown->close();
    application.window().close();
  }
  const std::string text = allOfTheLog();
  EXPECT_NE(text.find(" info graphics opengl_major="), std::string::npos) << text;
  EXPECT_NE(text.find(" info scan-opened from=phantom columns="), std::string::npos) << text;
  EXPECT_NE(text.find(" warning not-opened id=header-"), std::string::npos) << text;
  EXPECT_NE(text.find(" info servo ticks="), std::string::npos) << text;
  EXPECT_EQ(text.find("PLNT"), std::string::npos) << text;
  EXPECT_EQ(text.find("Jane"), std::string::npos) << text;
  EXPECT_EQ(text.find(folder_.folder().string()), std::string::npos) << text;
}

TEST_F(CrashWindow, WithoutALogTheMenuSaysSo) {
  app::Application application(arguments());
  application.start();
  application.window().findChild<QAction*>("showLog")->trigger();
  EXPECT_EQ(dialogOf(application, "log"), nullptr);
  auto* message = application.window().findChild<QLabel*>("message");
  ASSERT_NE(message, nullptr);
  EXPECT_TRUE(message->text().startsWith("There is no log"));
}

}  // namespace
